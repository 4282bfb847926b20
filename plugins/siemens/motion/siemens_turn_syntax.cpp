/// TURN=n: a helix makes n full turns in addition to those that its end point needs.
#include <isogloss/sdk.hpp>

#include <cmath>

namespace siemens {
namespace {

struct SiemensTurn {
  static constexpr auto spec =
      ig::syntax("SiemensTurnSyntax", "TURN=: additional full turns of a helix.").after("CircularMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0226",
                     "TURN={0} is not executed: it needs an arc and a whole number from 0 to 999"),
  };

  ig::Word turn_{"Parsing.TURN", ig::wake, "", "Further full turns."};
  ig::Out<std::int64_t> circles_{"MotionEvent.AdditionalCircleNum"};
  ig::In<ig::Symbol> form_{"MotionEvent.Form"};
  ig::Name arc_{"McArc"};

  ig::Status build(ig::Block& b) {
    const auto n = b.take(turn_);
    if (!n) return ig::Status::unchanged;
    if (!b.is(form_, arc_) || *n < 0 || *n > 999 || *n != std::floor(*n))
      b.report(ig::diag("SIE-0226"), ig::Where::word(turn_.id()), *n);
    else
      b.set(circles_, static_cast<std::int64_t>(*n));
    return ig::Status::changed;
  }
};

const ig::Register<SiemensTurn> siemens_turn_syntax;

}  // namespace
}  // namespace siemens
