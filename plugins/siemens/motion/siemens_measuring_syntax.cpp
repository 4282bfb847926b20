/// MEAS= and MEAW=: a move that measures. There is no probe here: the move goes to its end, and the option says whether
/// the probe has touched there.
#include <cmath>

#include <isogloss/cnc/program_xyz.hpp>

#include "motion/measured_point.hpp"

namespace siemens {

namespace {

struct SiemensMeasuring {
  static constexpr auto spec =
      ig::syntax("SiemensMeasuringSyntax", "MEAS= and MEAW=: moves that measure.").after("McXyzSyntax", "McAbcSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_NOTE, "SIE-0372", "{0}={1}: no probe is simulated, so the move goes to its end, and {2}"),
      ig::diagnostic(IG_ERROR, "SIE-0373",
                     "{0}={1} measures nothing, because the number is not that of a probe: write 1, -1, 2 or -2"),
  };

  ig::BooleanOption touches_{"touches", "true", "The probe counts as touching at the end of the move."};
  std::array<ig::Word, 2> words_{
      ig::Word{"Parsing.MEAS", ig::wake, "", "Measuring with deletion of the distance to go."},
      ig::Word{"Parsing.MEAW", ig::wake, "", "Measuring without it."}};
  std::array<ig::In<double>, 3> program_{ig::In<double>{"ProgramXyz.X"}, ig::In<double>{"ProgramXyz.Y"},
                                         ig::In<double>{"ProgramXyz.Z"}};
  std::array<ig::In<double>, 6> machine_{ig::In<double>{"MachineCoordinate.X"}, ig::In<double>{"MachineCoordinate.Y"},
                                         ig::In<double>{"MachineCoordinate.Z"}, ig::In<double>{"MachineCoordinate.A"},
                                         ig::In<double>{"MachineCoordinate.B"}, ig::In<double>{"MachineCoordinate.C"}};
  MeasuredPoint point_{ig::write};
  ig::Signal said_{"SiemensMeasuring.~Said", ig::read | ig::write, ig::Life::modal};

  ig::Status build(ig::Block& b) {
    bool any = false;
    for (const ig::Word& word : words_) {
      const std::string_view name = &word == &words_[0] ? "MEAS" : "MEAW";
      const auto edge = b.take(word);
      if (!edge) continue;
      any = true;
      if (const double number = std::fabs(*edge); number == 1 || number == 2)
        measure(b, word, name, *edge);
      else
        b.report(ig::diag("SIE-0373"), ig::Where::word(word.id()), name, *edge);
    }
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  void measure(ig::Block& b, const ig::Word& word, std::string_view name, double edge) const {
    if (!b.is_raised(said_))
      b.report(ig::diag("SIE-0372"), ig::Where::word(word.id()), name, edge,
               touches_ ? std::string_view("the probe counts as touching there")
                        : std::string_view("the probe counts as not touching"));
    b.raise(said_);
    b.set(point_.probe(), touches_ ? static_cast<std::int64_t>(std::fabs(edge)) : std::int64_t{0});
    if (!touches_) return;
    for (std::size_t axis = 0; axis < program_.size(); ++axis)
      if (const auto at = b.get(program_[axis])) b.set(point_.program(axis), *at);
    for (std::size_t axis = 0; axis < machine_.size(); ++axis)
      if (const auto at = b.get(machine_[axis])) b.set(point_.machine(axis), *at);
  }
};

const ig::Register<SiemensMeasuring> siemens_measuring_syntax;

}  // namespace
}  // namespace siemens
