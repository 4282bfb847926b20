/// Cycle 11: one factor about the datum, for X, Y and Z or for the two axes of the plane. It is the first entry of the
/// frame, so that whatever a program gives as a length is scaled, radii and the dimensions of cycles as well, and
/// neither the tool nor the feed.
#pragma once

#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/tilt_transform.hpp>
#include <isogloss/sdk.hpp>

namespace heidenhain {

using namespace ig::cnc;

inline constexpr ig::About scaling_factor{ig::Life::modal, "", "Scaling about the datum."};
inline constexpr ig::About unscaled_axis{ig::Life::modal, "", "The axis that the scaling leaves as it is; none: all."};

/// A member of each syntax that needs to know it.
class ScalingInForce {
 public:
  /// Millimetres of the machine for one of the program, in the plane.
  double factor(const ig::Block& b) const { return b.get_or(factor_, 1.0); }
  double along(const ig::Block& b, std::size_t axis) const { return b.is(unscaled_, axes_[axis]) ? 1 : factor(b); }
  bool is_on(const ig::Block& b) const { return b.has(factor_); }
  /// False where an arc in this plane is no circle in the machine.
  bool keeps_circles(const ig::Block& b, const PlaneAxes& plane) const {
    return along(b, plane.first) == along(b, plane.second);
  }

 private:
  ig::In<double> factor_{"ScalingFrame.Factor", ig::read, scaling_factor};
  ig::In<ig::Symbol> unscaled_{"ScalingFrame.UnscaledAxis", ig::read, unscaled_axis};
  std::array<ig::Name, 3> axes_{ig::Name{"X"}, ig::Name{"Y"}, ig::Name{"Z"}};
};

/// A member of the syntax that executes the cycle.
class Scaling {
 public:
  static constexpr double least = 1e-6, most = 99.999999;

  /// 1 ends it. `unscaled` is an axis that it leaves as it is.
  void set(ig::Block& b, double factor, std::optional<std::size_t> unscaled) const {
    end(b);
    if (factor == 1) return;
    Mat4 m = identity_frame;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (axis != unscaled) m[5 * axis] = factor;
    b.set_transform(frame_, m);
    b.set(factor_, factor);
    if (unscaled) b.set(unscaled_, axes_[*unscaled]);
  }
  void end(ig::Block& b) const {
    if (!b.has(factor_)) return;
    b.set_transform(frame_, identity_frame);
    b.erase(factor_);
    if (b.has(unscaled_)) b.erase(unscaled_);
  }

 private:
  ig::Transform frame_{"ScalingFrame"};
  ig::Out<double> factor_{"ScalingFrame.Factor", scaling_factor};
  ig::Out<ig::Symbol> unscaled_{"ScalingFrame.UnscaledAxis", unscaled_axis};
  std::array<ig::Name, 3> axes_{ig::Name{"X"}, ig::Name{"Y"}, ig::Name{"Z"}};
};

}  // namespace heidenhain
