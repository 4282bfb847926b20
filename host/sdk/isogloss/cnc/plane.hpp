/// The plane in force (G17, G18, G19): the two axes that span it, and the third one, along which the tool works.
#pragma once

#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// Axes as 0 X, 1 Y, 2 Z, ordered so that first × second = tool: a turn from the first axis to the second is
/// counter-clockwise when seen from the positive end of the tool axis.
struct PlaneAxes {
  std::size_t first = 0, second = 1, tool = 2;

  /// The point above or in `hole` whose tool axis is at `level`, in mm.
  constexpr Vec3 at_level(Vec3 hole, double level) const {
    hole[tool] = level;
    return hole;
  }
  friend constexpr bool operator==(const PlaneAxes&, const PlaneAxes&) = default;
};

inline constexpr PlaneAxes xy_plane{0, 1, 2};
inline constexpr PlaneAxes zx_plane{2, 0, 1};  // ZX, not XZ: this order gives arcs their sense
inline constexpr PlaneAxes yz_plane{1, 2, 0};

/// A member of each syntax that works in the plane; G17 where no block has selected one.
class PlaneInForce {
 public:
  PlaneAxes operator()(const Block& b) const {
    const Symbol term = b.get_or(term_, Symbol{});
    return term == g18_ ? zx_plane : term == g19_ ? yz_plane : xy_plane;
  }
  /// The third of them alone.
  std::size_t tool_axis(const Block& b) const {
    const Symbol term = b.get_or(term_, Symbol{});
    return term == g18_ ? zx_plane.tool : term == g19_ ? yz_plane.tool : xy_plane.tool;
  }

 private:
  In<Symbol> term_{"PlaneSelect.Term"};
  Name g18_{"G18"}, g19_{"G19"};
};

}  // namespace ig::cnc
