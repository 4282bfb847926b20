/// The plane in force: which axes span it, and which one the tool works along.
#pragma once

#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// Axes as 0 X, 1 Y, 2 Z, such that first × second = tool. A turn from first to second is counter-clockwise, seen from
/// the positive end of the tool axis.
struct PlaneAxes {
  std::size_t first = 0, second = 1, tool = 2;

  /// The point over (or in) `hole` whose tool axis stands at `level`.
  constexpr Vec3 at_level(Vec3 hole, double level) const {
    hole[tool] = level;
    return hole;
  }
  friend constexpr bool operator==(const PlaneAxes&, const PlaneAxes&) = default;
};

inline constexpr PlaneAxes xy_plane{0, 1, 2};
inline constexpr PlaneAxes zx_plane{2, 0, 1};  // ZX, not XZ: this decides the sense of arcs
inline constexpr PlaneAxes yz_plane{1, 2, 0};

/// A member of each syntax that works in the plane. G17 where nothing was said.
class PlaneInForce {
 public:
  PlaneAxes operator()(const Block& b) const {
    const Symbol term = b.get_or(term_, Symbol{});
    return term == g18_ ? zx_plane : term == g19_ ? yz_plane : xy_plane;
  }

 private:
  In<Symbol> term_{"PlaneSelect.Term"};
  Name g18_{"G18"}, g19_{"G19"};
};

}  // namespace ig::cnc
