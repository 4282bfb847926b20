/// How far X, Y and Z of the machine can go in one direction before the first of them reaches the end of its travel.
#pragma once

#include <cmath>
#include <optional>

#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// A member of each syntax that retracts to the end of the travel. Machine coordinates, mm.
class TravelEnd {
 public:
  /// The way from `here` in multiples of `direction`, 0 where an axis is already beyond its end; nothing where the
  /// end of an axis that would move is not known.
  std::optional<double> way(const Vec3& here, const Vec3& direction) const {
    constexpr double least = 1e-9;
    std::optional<double> out;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double share = direction[axis];
      if (std::fabs(share) <= least) continue;
      double minimum = 0, maximum = 0;
      if (!axes_ || axes_->travel(axes_->self, "XYZ"[axis], &minimum, &maximum) == 0) return std::nullopt;
      const double way = ((share > 0 ? maximum : minimum) - here[axis]) / share;
      if (!std::isfinite(way)) return std::nullopt;
      out = std::fmin(out.value_or(way), way);
    }
    return out ? std::optional(std::fmax(0, *out)) : std::nullopt;
  }

 private:
  Service<ig_machine_axis_1> axes_{"isogloss.machine-axis/1", Need::optional, "The travel of X, Y and Z."};
};

}  // namespace ig::cnc
