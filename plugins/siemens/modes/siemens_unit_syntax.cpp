/// G70, G71, G700 and G710: inch or metric input. G70 applies to positions only, F remains in mm/min; under G700 F is
/// in inch/min. It is the first syntax of the logic and converts the programmed values into mm, so that no later syntax
/// has to know of inches.
#include <isogloss/cnc/modal_group.hpp>
#include <isogloss/cnc/units.hpp>
#include <isogloss/sdk.hpp>

#include <cmath>

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensUnit {
  static constexpr auto spec =
      ig::syntax("SiemensUnitSyntax", "G70/G71/G700/G710 inch or metric input; lengths become mm.")
          .after("ParameterizedFlagSyntax")
          .before("FeedrateSyntax", "SiemensCycleSyntax", "ProgramXyzSyntax");

  ig::Codes modes_{"G70", "G71", "G700", "G710"};
  ig::Fields lengths_{"lengths", "Parsing.**{mm}", ig::read | ig::write, "The words that are lengths."};
  ig::Fields feeds_{"feeds", "Parsing.**{mm/min}", ig::read | ig::write, "The words that are feeds."};
  ig::Out<ig::Symbol> term_{"Unit.Term"};
  ig::InWhile<ig::Symbol> system_{"Unit.System", "Inch", ig::write};
  ig::Codes feed_modes_{{"G93", "G94", "G95"}, ig::read};
  ig::In<ig::Symbol> feed_mode_{"Feedrate.Term"};
  ig::Name inch_{"Inch"}, metric_{"Metric"}, g93_{"G93"}, g700_{"G700"};

  ig::Status build(ig::Block& b) {
    const auto mode = take_modal(b, modes_);
    if (mode) {
      b.set(term_, modes_.name(*mode));
      b.set(system_, *mode % 2 == 0 ? inch_ : metric_);
    }
    if (!b.is(system_, inch_)) return mode ? ig::Status::changed : ig::Status::unchanged;
    bool any = convert(b, lengths_);
    if (b.is(term_, g700_) && !is_inverse_time(b)) any |= convert(b, feeds_);
    return mode || any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  bool is_inverse_time(const ig::Block& b) const {
    const auto mode = b.find(feed_modes_);
    return mode ? feed_modes_.name(*mode) == g93_ : b.is(feed_mode_, g93_);
  }

  static bool convert(ig::Block& b, const ig::Fields& words) {
    bool any = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
      ig_value v;
      if (!b.get(words.id(i), v)) continue;
      any = true;
      if (const double mm = v.number * mm_per_inch; std::isfinite(mm)) {
        b.rewrite(words.id(i), mm);
      } else {
        b.report(ig::diag("SIE-0105"), ig::Where::word(words.id(i)), ig::word_name(words.path(i)));
        b.erase(words.id(i));
      }
    }
    return any;
  }
};

const ig::Register<SiemensUnit> siemens_unit_syntax;

}  // namespace
}  // namespace siemens
