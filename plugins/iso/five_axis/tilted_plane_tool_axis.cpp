/// G68.3: Z of the plane is the direction of the tool, its origin X Y Z or the tip of the tool.
#include "five_axis/tilted_plane.hpp"

#include <cmath>

namespace iso {

using namespace ig::cnc;

void TiltedPlane::by_tool_axis(ig::Block& b) const {
  const ig::PartialVec3 named = take_words(b, by_tool, "XYZ");
  const auto turn = take_word(b, by_tool, 'R');
  if (named.mask != 0 && !named.complete()) {
    alarm(b, ig::diag("ISO-0428"), at(by_tool));
    return;
  }
  const double angles[3] = {b.get_or(rotary_[0], 0.0), b.get_or(rotary_[1], 0.0), b.get_or(rotary_[2], 0.0)};
  const ig::Vec3 tool = tool_axis(b, angles);
  const auto up = static_cast<std::size_t>(vertical_ - 1);
  ig::Vec3 vertical, beside;
  vertical[up] = beside[(up + 1) % 3] = 1;
  const ig::Vec3 x = vector_product(vertical, tool);
  constexpr double parallel = 1e-9;
  const auto plane = from_z_and_x(tool, std::sqrt(scalar_product(x, x)) > parallel ? x : beside);
  if (!plane) return;  // a tool axis has a direction
  const ig::Vec3 at_point = named.complete() ? named.value : tip(b, tool, angles);
  if (!put_in_force(b, by_tool, at_origin(product(turn_about(2, turn.value_or(0)), *plane), at_point))) return;
  write(b, by_tool, at_point, 0);
  if (turn) b.set(turn_, *turn);
  b.set(is_aligned_, true);
  b.set(orientation_, tool);
}

ig::Vec3 TiltedPlane::tool_axis(ig::Block& b, const double (&angles)[3]) const {
  double t[3];
  if (kinematics_ && kinematics_->tool_axis(kinematics_->self, angles, t) != 0) return {t[0], t[1], t[2]};
  const ig::PartialVec3 orientation = b.get(orientation_);
  if (orientation.complete() && unit(orientation.value)) return orientation.value;
  b.report(ig::diag("ISO-0433"), at(by_tool));
  return {0, 0, 1};
}

ig::Vec3 TiltedPlane::tip(ig::Block& b, const ig::Vec3& tool, const double (&angles)[3]) const {
  const ig::PartialVec3 machine = b.get(machine_);
  Mat4 pivot;
  if (!machine.complete()) return rounded(mapped(frame_.get(b), last_(b)));
  if (!kinematics_ || kinematics_->pivot(kinematics_->self, angles, pivot.data()) == 0) pivot = identity_frame;
  ig::Vec3 point = mapped(inverse(pivot), machine.value) - b.get_or(length_, 0.0) * tool;
  for (const Offset& offset : offsets_) point = point - offset.get(b);
  return rounded(point);
}

}  // namespace iso
