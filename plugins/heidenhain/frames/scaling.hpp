/// Cycle 11: one factor for X, Y and Z about the datum. It is the first entry of the frame, so that whatever a program
/// gives as a length is scaled, radii and the dimensions of cycles as well, and neither the tool nor the feed.
#pragma once

#include <isogloss/cnc/tilt_transform.hpp>
#include <isogloss/sdk.hpp>

namespace heidenhain {

using namespace ig::cnc;

/// A member of each syntax that needs to know it.
class ScalingInForce {
 public:
  /// Millimetres of the machine for one of the program.
  double factor(const ig::Block& b) const { return b.get_or(factor_, 1.0); }
  bool is_on(const ig::Block& b) const { return b.has(factor_); }

 private:
  ig::In<double> factor_{
      "ScalingFrame.Factor", ig::read, {ig::Life::modal, "", "Scaling of X, Y and Z about the datum."}};
};

/// A member of the syntax that executes the cycle.
class Scaling {
 public:
  static constexpr double least = 1e-6, most = 99.999999;

  /// 1 ends it.
  void set(ig::Block& b, double factor) const {
    if (factor == 1) return end(b);
    Mat4 m = identity_frame;
    for (std::size_t axis = 0; axis < 3; ++axis) m[5 * axis] = factor;
    b.set_transform(frame_, m);
    b.set(factor_, factor);
  }
  void end(ig::Block& b) const {
    if (!b.has(factor_)) return;
    b.set_transform(frame_, identity_frame);
    b.erase(factor_);
  }

 private:
  ig::Transform frame_{"ScalingFrame"};
  ig::Out<double> factor_{"ScalingFrame.Factor", {ig::Life::modal, "", "Scaling of X, Y and Z about the datum."}};
};

}  // namespace heidenhain
