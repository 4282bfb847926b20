/// Scaling (G51) and programmable mirror image (G51.1) in force, and what they make of program positions (Fanuc manual,
/// "Scaling", "Programmable mirror image"). ScalingSyntax and ProgrammableMirrorSyntax rewrite the words of a block; a
/// syntax that needs other points asks here. Lengths in mm.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>

#include "isogloss/cnc/plane.hpp"
#include "isogloss/cnc/program_xyz.hpp"
#include "isogloss/cnc/units.hpp"

namespace ig::cnc {

/// The map of one axis: a position x becomes factor · x + offset, a distance is multiplied by factor.
struct AxisMap {
  double factor = 1, offset = 0;
  constexpr double position(double x) const { return factor * x + offset; }
  constexpr double programmed(double position) const { return (position - offset) / factor; }
  /// This map first, then a scaling about `center`.
  constexpr AxisMap scaled(double by, double center) const { return {by * factor, by * offset + (1 - by) * center}; }
  constexpr AxisMap mirrored(double at) const { return {-factor, 2 * at - offset}; }
};

/// The holes of a repeat that G16 with G91 rotates about the pole, hole by hole.
struct PolarRepeats {
  double turn_deg;
  Vec3 pole;
  AxisMap first_axis, second_axis;

  /// The hole of repeat i, counted from 0; `start` is hole 0.
  Vec3 hole(const Vec3& start, int i, const PlaneAxes& plane) const {
    const double angle = std::remainder(i * turn_deg, 360) * radians_per_degree;
    const double c = std::cos(angle), s = std::sin(angle);
    const double u = first_axis.programmed(start[plane.first]) - pole[plane.first];
    const double v = second_axis.programmed(start[plane.second]) - pole[plane.second];
    Vec3 out = start;
    out[plane.first] = rounded(first_axis.position(pole[plane.first] + c * u - s * v));
    out[plane.second] = rounded(second_axis.position(pole[plane.second] + s * u + c * v));
    return out;
  }
};

/// A member of each syntax that needs more than the words of its block.
class ScaleAndMirror {
 public:
  AxisMap axis(const Block& b, std::size_t i) const {
    const PartialVec3 center = b.get(center_), factor = b.get(factor_), mirror = b.get(mirror_);
    AxisMap map;
    if (factor.has(i) && factor.value[i] != 0) map = map.scaled(factor.value[i], center.value[i]);
    return mirror.has(i) ? map.mirrored(mirror.value[i]) : map;
  }
  /// The point that a program without scaling and mirror image would name.
  Vec3 programmed(const Block& b, const Vec3& point) const {
    Vec3 out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = axis(b, i).programmed(point[i]);
    return out;
  }
  /// True when exactly one axis of the plane is mirrored: arcs and rotations then turn in the opposite sense.
  bool swaps_sense(const Block& b, const PlaneAxes& plane) const {
    if (!b.has_any(scaling_, image_)) return false;
    const PartialVec3 factor = b.get(factor_), mirror = b.get(mirror_);
    bool swaps = false;
    for (const std::size_t i : {plane.first, plane.second})
      swaps ^= (factor.has(i) && factor.value[i] < 0) != mirror.has(i);
    return swaps;
  }

 private:
  In<Symbol> scaling_{"Scaling.Term"}, image_{"MirrorImage.Term"};
  Xyz center_{"Scaling.Center", read};
  Xyz factor_{"Scaling.Factor", read};
  Xyz mirror_{"MirrorImage", read};
};

/// A member of each syntax that repeats holes; nothing where the holes of a repeat are not rotated.
class PolarRepeatsInForce {
 public:
  std::optional<PolarRepeats> operator()(const Block& b, const PlaneAxes& plane) const {
    if (const auto turn = b.get(pattern_turn_))
      return PolarRepeats{*turn, b.get(pattern_center_).or_else({}), AxisMap{}, AxisMap{}};
    const auto turn = b.get(turn_);
    if (!turn) return std::nullopt;
    return PolarRepeats{*turn, b.get(pole_).or_else({}), scale_and_mirror_.axis(b, plane.first),
                        scale_and_mirror_.axis(b, plane.second)};
  }

 private:
  In<double> turn_{"PolarCoordinate.Turn_deg"};
  Xyz pole_{"PolarCoordinate.Pole", read};
  In<double> pattern_turn_{"HolePattern.Turn_deg"};
  Xyz pattern_center_{"HolePattern.Center", read};
  ScaleAndMirror scale_and_mirror_;
};

}  // namespace ig::cnc
