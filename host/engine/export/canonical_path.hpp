/// Paths that no block describes, as points on them: arcs in a tilted plane, and moves that lead the tip of the tool.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "export/motion_reader.hpp"
#include "isogloss.h"

namespace isogloss {

/// X Y Z A B C.
using PathPoint = std::array<double, 6>;

inline double distance_xyz(const PathPoint& a, const PathPoint& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// A circle or helix about the unit vector `normal`; the radius may change evenly from start to end.
class ArcPath {
 public:
  ArcPath(const PathPoint& start, const PathPoint& end, const double* center, const double* normal, double sweep_deg)
      : start_(start), end_(end), sweep_(sweep_deg * std::numbers::pi / 180) {
    std::copy_n(normal, 3, normal_);
    const double from = height(start, center), to = height(end, center);
    rise_ = to - from;
    double out[2] = {0, 0};
    for (int i = 0; i < 3; ++i) {
      center_[i] = center[i] + from * normal[i];
      radial_[i] = start[i] - center_[i];
      const double at_end = end[i] - center_[i] - rise_ * normal[i];
      out[0] += radial_[i] * radial_[i];
      out[1] += at_end * at_end;
    }
    radius_ = std::sqrt(out[0]);
    end_radius_ = std::sqrt(out[1]);
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      side_[i] = normal[j] * radial_[k] - normal[k] * radial_[j];
    }
  }

  double radius() const { return radius_; }
  double end_radius() const { return end_radius_; }
  double sweep() const { return sweep_; }

  /// At `place`, 0 to 1, of the way.
  PathPoint at(double place) const {
    PathPoint out;
    const double angle = sweep_ * place;
    const double scale = radius_ > 0 ? 1 + place * (end_radius_ / radius_ - 1) : 1;
    for (int i = 0; i < 3; ++i)
      out[i] =
          center_[i] + scale * (radial_[i] * std::cos(angle) + side_[i] * std::sin(angle)) + rise_ * place * normal_[i];
    for (int i = 3; i < 6; ++i) out[i] = start_[i] + place * (end_[i] - start_[i]);
    return out;
  }

 private:
  double height(const PathPoint& p, const double* center) const {
    double out = 0;
    for (int i = 0; i < 3; ++i) out += (p[i] - center[i]) * normal_[i];
    return out;
  }
  PathPoint start_, end_;
  double center_[3], normal_[3], radial_[3], side_[3];
  double radius_ = 0, end_radius_ = 0, rise_ = 0, sweep_;
};

/// The tip goes straight in the workpiece and the rotary axes turn evenly: where the machine's axes are on the way.
class LedPath {
 public:
  LedPath(const ig_machine_kinematics_1& kinematics, const PathPoint& start, const PathPoint& end, double length)
      : kinematics_(kinematics), start_(start), end_(end), length_(length) {
    is_known_ = tip_of(start, tip_) && tip_of(end, way_);
    for (int i = 0; i < 3; ++i) way_[i] -= tip_[i];
  }
  bool is_known() const { return is_known_; }
  double length_of_tip() const { return std::hypot(way_[0], way_[1], way_[2]); }

  PathPoint at(double place) const {
    PathPoint out;
    for (int i = 3; i < 6; ++i) out[i] = start_[i] + place * (end_[i] - start_[i]);
    double pivot[16], axis[3];
    if (!ask(out, pivot, axis)) return end_;
    double point[3];
    for (int i = 0; i < 3; ++i) point[i] = tip_[i] + place * way_[i] + length_ * axis[i];
    for (int j = 0; j < 3; ++j) {
      out[j] = pivot[12 + j];
      for (int i = 0; i < 3; ++i) out[j] += point[i] * pivot[4 * i + j];
    }
    return out;
  }

 private:
  bool ask(const PathPoint& p, double (&pivot)[16], double (&axis)[3]) const {
    const double angles[3] = {p[3], p[4], p[5]};
    return kinematics_.pivot(kinematics_.self, angles, pivot) != 0 &&
           kinematics_.tool_axis(kinematics_.self, angles, axis) != 0;
  }
  /// The inverse of the pivot's rotation is its transpose.
  bool tip_of(const PathPoint& p, double (&tip)[3]) const {
    double pivot[16], axis[3];
    if (!ask(p, pivot, axis)) return false;
    for (int i = 0; i < 3; ++i) {
      tip[i] = -length_ * axis[i];
      for (int j = 0; j < 3; ++j) tip[i] += (p[j] - pivot[12 + j]) * pivot[4 * i + j];
    }
    return std::isfinite(tip[0] + tip[1] + tip[2]);
  }

  const ig_machine_kinematics_1& kinematics_;
  PathPoint start_, end_;
  double length_;
  double tip_[3] = {}, way_[3] = {};
  bool is_known_ = false;
};

/// Places, the last one 1, between which lines stay within the tolerance of the path: halved until the middle and both
/// quarters lie on the line.
inline std::vector<double> divide(const std::function<PathPoint(double)>& at, double tolerance, int first_pieces) {
  constexpr int deepest = 14;
  std::vector<double> out;
  const auto is_near = [&](double begin, double end) {
    const PathPoint a = at(begin), b = at(end);
    for (const double share : {0.25, 0.5, 0.75}) {
      const PathPoint on_path = at(begin + share * (end - begin));
      PathPoint on_line;
      for (int i = 0; i < 6; ++i) on_line[i] = a[i] + share * (b[i] - a[i]);
      if (distance_xyz(on_path, on_line) > tolerance) return false;
    }
    return true;
  };
  const std::function<void(double, double, int)> add = [&](double begin, double end, int depth) {
    if (depth < deepest && !is_near(begin, end)) {
      const double middle = (begin + end) / 2;
      add(begin, middle, depth + 1);
      add(middle, end, depth + 1);
    } else {
      out.push_back(end);
    }
  };
  for (int i = 0; i < first_pieces; ++i)
    add(static_cast<double>(i) / first_pieces, i + 1 == first_pieces ? 1 : (i + 1.0) / first_pieces, 0);
  return out;
}

}  // namespace isogloss
