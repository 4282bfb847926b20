/// G17/G18/G19: the plane of arcs and canned cycles. The first axis of the plane is named first: ZX, not XZ.
#include <isogloss/cnc/modal_group.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct PlaneSelect {
  static constexpr auto spec = ig::syntax("PlaneSelectSyntax", "G17/G18/G19 plane of arcs and canned cycles.")
                                   .before("CannedCycleResolveSyntax", "CircularMotionSyntax");

  ig::Codes planes_{"G17", "G18", "G19"};
  ig::Out<ig::Symbol> term_{"PlaneSelect.Term"};
  ig::Out<ig::Symbol> plane_{"PlaneSelect.Plane"};
  ig::Name xy_{"XY"}, zx_{"ZX"}, yz_{"YZ"};

  ig::Status build(ig::Block& b) {
    const auto plane = take_modal(b, planes_);
    if (!plane) return ig::Status::unchanged;
    b.set(term_, planes_.name(*plane));
    b.set(plane_, *plane == 0 ? xy_ : *plane == 1 ? zx_ : yz_);
    return ig::Status::changed;
  }
};

const ig::Register<PlaneSelect> plane_select_syntax;

}  // namespace
}  // namespace iso
