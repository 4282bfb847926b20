/// The words of DEP as written: KlartextMotionSyntax makes positions of them.
#pragma once

#include <isogloss/cnc/contour_approach.hpp>

namespace heidenhain {

using namespace ig::cnc;

class KlartextDeparture {
 public:
  using Shape = ContourApproach::Shape;
  using Way = ContourApproach::Way;

  explicit KlartextDeparture(ig::Access access)
      : shape_("KlartextDeparture.Shape", access, {ig::Life::block, "", "0 LT, 1 LN, 2 CT, 3 LCT."}),
        length_("KlartextDeparture.Length_mm", access, {ig::Life::block, "mm", "LEN"}),
        radius_("KlartextDeparture.Radius_mm", access, {ig::Life::block, "mm", "R"}),
        angle_("KlartextDeparture.Angle_deg", access, {ig::Life::block, "deg", "CCA"}) {}

  ig_field shape() const { return shape_.id(); }
  void set(ig::Block& b, const Way& way) const {
    b.set(shape_, static_cast<std::int64_t>(way.shape));
    b.set(length_, way.length);
    b.set(radius_, way.radius);
    b.set(angle_, way.angle_deg);
  }
  std::optional<Way> get(const ig::Block& b) const {
    const auto shape = b.get(shape_);
    if (!shape) return std::nullopt;
    return Way{static_cast<Shape>(*shape),
               b.get_or(length_, 0.0),
               b.get_or(radius_, 0.0),
               b.get_or(angle_, 0.0),
               false,
               std::nullopt};
  }

 private:
  ig::Field<std::int64_t> shape_;
  ig::Field<double> length_, radius_, angle_;
};

}  // namespace heidenhain
