/// One view of a path: from the workpiece to the paper.
#pragma once

#include <array>
#include <string_view>

#include "tool_path.hpp"

namespace isogloss::cli::plotting {

struct Spot {
  double x = 0, y = 0;
};

struct Frame {
  double x = 0, y = 0, width = 0, height = 0;  ///< px
};

class Projection {
 public:
  /// `right` and `up`: the directions of the paper in the workpiece.
  Projection(std::string_view name, const Point& right, const Point& up) : name_(name), right_(right), up_(up) {}
  /// Chooses scale and place so that the extent fills the frame.
  void fit(const Extent& extent, const Frame& frame);
  std::string_view name() const { return name_; }
  const Frame& frame() const { return frame_; }
  double scale() const { return scale_; }  ///< px for each mm
  Spot at(const Point& p) const {
    const Spot v = vector(p);
    return {v.x + origin_.x, v.y + origin_.y};
  }
  /// A direction, without the place.
  Spot vector(const Point& p) const {
    return {scale_ * (p[0] * right_[0] + p[1] * right_[1] + p[2] * right_[2]),
            -scale_ * (p[0] * up_[0] + p[1] * up_[1] + p[2] * up_[2])};
  }

 private:
  std::string_view name_;
  Point right_, up_;
  Frame frame_;
  double scale_ = 1;
  Spot origin_;
};

/// An ellipse on the paper: what a circle becomes.
struct Ellipse {
  double major = 0, minor = 0, tilt_deg = 0;
  bool is_clockwise = false;  ///< on the paper, where the angle of the circle grows
};
Ellipse project(const Projection& projection, const PathArc& arc);

}  // namespace isogloss::cli::plotting
