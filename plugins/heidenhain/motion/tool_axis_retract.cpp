#include "motion/tool_axis_retract.hpp"

#include <isogloss/cnc/tilt_transform.hpp>

namespace heidenhain {

using namespace ig::cnc;

bool ToolAxisRetract::follow(ig::Block& b, KlartextWay& way, const ig::Vec3& here_in_program) const {
  const auto distance = b.take(distance_);
  const auto refuse = [&](std::string_view why) {
    b.report(ig::diag("HEI-0139"), ig::Where::block(), std::string_view("M140"), why);
    return false;
  };
  if (way.mask != 0) return refuse("the retract after the other move of the block is missing");
  if (tip_control_.is_on(b) && ig::cnc::length(way.from - here_in_program) > 1e-6)
    return refuse("the retract is missing, because a mirror image would turn its direction");
  const auto step = unit_way(b, way, here_in_program);
  auto size = distance;
  if (!size && step) {
    const auto here = b.to_machine(here_in_program), there = b.to_machine(here_in_program + *step);
    size = here && there ? travel_.way(*here, *there - *here) : std::nullopt;
  }
  if (!size || !step) return refuse("the retract is missing: where the travel of the tool axis ends is not known");
  way.to = way.from + *size * *step;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if ((*step)[axis] != 0) way.mask |= 1u << axis;
  return true;
}

std::optional<ig::Vec3> ToolAxisRetract::unit_way(ig::Block& b, const KlartextWay& way,
                                                  const ig::Vec3& here_in_program) const {
  ig::Vec3 along;
  along[way.plane.tool] = 1 / scaling_.along(b, way.plane.tool);
  if (!tip_control_.is_on(b) || !kinematics_) return along;
  const auto direction = tool_direction(kinematics_, rotary_.get(b).or_else({}));
  const auto here = b.to_machine(here_in_program);
  const auto there = direction && here ? b.to_program(*here + *direction) : std::nullopt;
  if (!there) return std::nullopt;
  along = *there - here_in_program;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (std::fabs(along[axis]) < 1e-9) along[axis] = 0;
  return along;
}

}  // namespace heidenhain
