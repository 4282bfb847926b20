// Cycles 251 to 254, pockets and slots: the tool goes to their start position and to their end position. The cutting
// moves are missing, which is reported.
#include "cycles/hole_cycle.hpp"

namespace heidenhain {
namespace {

struct KlartextPocketCycle {
  static constexpr auto spec =
      hole_cycle("KlartextPocketCycleSyntax", "Cycles 251 to 254 pockets and slots: where they begin and end.");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0186",
                     "cycle {0} moves only to its beginning and its end: what it machines is missing from the path"),
  };

  HoleCycle cycle_{{251, "CYCL251"}, {252, "CYCL252"}, {253, "CYCL253"}, {254, "CYCL254"}};
  ig::Signal said_{"CycleDefinition.~Said", ig::read | ig::write, ig::Life::modal};

  ig::Status build(ig::Block& b) const { return cycle_.run(b, *this); }

  std::optional<double> prepare(ig::Block& b, HoleRun& c) const {
    const auto depth = cycle_.needed(b, c, 201);
    if (!depth || !cycle_.levels(b, c, *depth)) return std::nullopt;
    // A slot whose centre is not the tool's position ends with the tool at one of its ends.
    const double place = cycle_.get_or(b, 367, 0);
    if (c.number >= 253 && place != 0) {
      b.report(ig::diag("HEI-0178"), ig::Where::block(), static_cast<double>(c.number), std::string_view("Q367"),
               place);
      return std::nullopt;
    }
    if (!b.is_raised(said_)) b.report(ig::diag("HEI-0186"), ig::Where::block(), static_cast<double>(c.number));
    b.raise(said_);
    return 4;
  }

  void machine(ig::Block& b, HoleRun& c) const { cycle_.leave(b, c); }
};

const ig::Register<KlartextPocketCycle> klartext_pocket_cycle_syntax;

}  // namespace
}  // namespace heidenhain
