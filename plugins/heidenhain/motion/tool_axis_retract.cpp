#include "motion/tool_axis_retract.hpp"

namespace heidenhain {

using namespace ig::cnc;

bool ToolAxisRetract::follow(ig::Block& b, KlartextWay& way, const ig::Vec3& here_in_program) const {
  const auto distance = b.take(distance_);
  const auto refuse = [&](std::string_view why) {
    b.report(ig::diag("HEI-0139"), ig::Where::block(), std::string_view("M140"), why);
    return false;
  };
  if (way.mask != 0) return refuse("the retract after the other move of the block is missing");
  ig::Vec3 out = way.from;
  if (distance) {
    out[way.plane.tool] += *distance;
  } else {
    ig::Vec3 beyond = way.from;
    beyond[way.plane.tool] += 1;
    const auto here = b.to_machine(here_in_program), there = b.to_machine(beyond);
    const auto rest = here && there ? travel_.way(*here, *there - *here) : std::nullopt;
    if (!rest) return refuse("the retract is missing: where the travel of the tool axis ends is not known");
    out[way.plane.tool] += *rest;
  }
  way.to = out;
  way.mask = 1u << way.plane.tool;
  return true;
}

}  // namespace heidenhain
