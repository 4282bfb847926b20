// CP with IPA beyond 360 degrees: how many additional whole circles the arc makes.
#include <isogloss/sdk.hpp>

namespace heidenhain {
namespace {

struct KlartextHelix {
  static constexpr auto spec = ig::syntax("KlartextHelixSyntax", "CP IPA beyond 360 degrees: additional full circles.")
                                   .after("KlartextMotionSyntax", "CircularMotionSyntax");

  ig::In<std::int64_t> circles_{"KlartextPath.Circles", ig::wake};
  ig::In<ig::Symbol> form_{"MotionEvent.Form"};
  ig::Out<std::int64_t> additional_{"MotionEvent.AdditionalCircleNum"};
  ig::Name arc_{"McArc"};

  ig::Status build(ig::Block& b) {
    if (!b.is(form_, arc_)) return ig::Status::unchanged;
    b.set(additional_, b.get_or(circles_, std::int64_t{0}));
    return ig::Status::changed;
  }
};

const ig::Register<KlartextHelix> klartext_helix_syntax;

}  // namespace
}  // namespace heidenhain
