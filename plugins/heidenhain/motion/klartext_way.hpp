/// The move of a path block, while KlartextMotionSyntax works it out. Program coordinates in mm.
#pragma once

#include <cmath>

#include <isogloss/cnc/arc.hpp>
#include <isogloss/cnc/plane.hpp>
#include <isogloss/sdk.hpp>

namespace heidenhain {

using namespace ig::cnc;

struct KlartextWay {
  PlaneAxes plane;
  ig::Vec3 from, to;
  std::uint32_t mask;  ///< the axes that the block moves
  ig::Symbol function;

  Point2 start() const { return {from[plane.first], from[plane.second]}; }
  Point2 end() const { return {to[plane.first], to[plane.second]}; }
  void set_end(const Point2& p) {
    to[plane.first] = p.u;
    to[plane.second] = p.v;
    mask |= 1u << plane.first | 1u << plane.second;
  }
};

}  // namespace heidenhain
