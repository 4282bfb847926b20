/// G61 to G64 and G09: how the control passes from one block to the next. The end points are the same under all of
/// them; the mode in force is recorded for syntaxes that compute times and corners. Fanuc manual, "Feed functions".
#include <isogloss/cnc/modal_group.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct PathMode {
  static constexpr auto spec =
      ig::syntax("PathModeSyntax", "G09, G61 to G64: exact stop and cutting mode, as a record.")
          .after("UnitModeSyntax");

  ig::Codes modes_{"G61", "G61.1", "G62", "G63", "G64"};
  ig::Codes once_{"G09"};
  ig::Call tolerance_words_{{"G64"}, "P[mm] Q[mm]"};
  ig::Out<ig::Symbol> term_{"PathMode.Term"};
  ig::Out<ig::Symbol> mode_{"PathMode.Mode"};
  ig::Out<double> tolerance_{"PathMode.Tolerance_mm"};
  ig::Out<double> naive_tolerance_{"PathMode.NaiveTolerance_mm"};
  ig::Out<bool> exact_stop_{"PathMode.IsExactStop"};
  std::array<ig::Name, 5> names_{ig::Name{"ExactStop"}, ig::Name{"ExactStop"}, ig::Name{"CornerOverride"},
                                 ig::Name{"Tapping"}, ig::Name{"Cutting"}};

  ig::Status build(ig::Block& b) {
    const bool once = b.take(once_).has_value();
    if (once) b.set(exact_stop_, true);
    const auto mode = take_modal(b, modes_);
    if (mode) {
      b.set(term_, modes_.name(*mode));
      b.set(mode_, names_[*mode]);
      b.erase(tolerance_);
      b.erase(naive_tolerance_);
    }
    if (const auto words = b.take(tolerance_words_)) {
      if (const auto p = (*words)['P']) b.set(tolerance_, *p);
      if (const auto q = (*words)['Q']) b.set(naive_tolerance_, *q);
    }
    return once || mode ? ig::Status::changed : ig::Status::unchanged;
  }
};

const ig::Register<PathMode> path_mode_syntax;

}  // namespace
}  // namespace iso
