/// G04: wait. The X, U or P of G04 is a time and belongs to it, never to a move or to a hole. G04 alone is an exact
/// stop at the end of the block: no time passes.
#include "diagnostics.hpp"

namespace iso {
namespace {

enum class TimeUnit { seconds, milliseconds };

struct Dwell {
  static constexpr auto spec = ig::syntax("DwellSyntax", "G04 dwell.").after("ParameterizedFlagSyntax");

  ig::Call g04_{{"G04"}, "X[s] U[s] P[]"};
  ig::Out<double> time_{"Dwell.Time"};
  ig::Choice<TimeUnit> p_unit_{"p-unit", "s|ms", "s", "What P counts."};

  ig::Status build(ig::Block& b) {
    const auto words = b.take(g04_);
    if (!words) return ig::Status::unchanged;
    const auto x = (*words)['X'], u = (*words)['U'], p = (*words)['P'];
    const double seconds = x ? *x : u ? *u : p ? (p_unit_ == TimeUnit::milliseconds ? *p / 1000 : *p) : 0;
    if (x.has_value() + u.has_value() + p.has_value() > 1)
      b.report(diag("ISO-0216"), ig::Where::word(g04_.code(0)), std::string_view(x ? "X" : "U"));
    if (seconds < 0) {
      b.report(diag("ISO-0215"), ig::Where::word(g04_.code(0)), seconds);
    } else if (x || u || p) {
      b.set(time_, seconds);
    }
    return ig::Status::changed;
  }
};

const ig::Register<Dwell> registered;

}  // namespace
}  // namespace iso
