/// What the rotary axes do to the tool: its direction, and the frame that turns with them (Fanuc 30i manuals, "Tool
/// center point control"). Lengths in mm, angles in degrees.
#pragma once

#include <algorithm>

#include "isogloss/cnc/rotary_axis.hpp"
#include "isogloss/cnc/tilt_transform.hpp"

namespace ig::cnc {

inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The machine's rotary axes, as the service isogloss.machine-kinematics/1 describes them. False where no axis is
/// known: then tool_axis(), pivot() and solve() must not be called.
class ToolKinematics {
 public:
  explicit operator bool() const { return count_ != 0; }
  std::size_t count() const { return count_; }
  /// The axis number i, from 0, as 0 for A, 1 for B, 2 for C; the axis nearer the machine's base comes first.
  std::size_t axis(std::size_t i) const { return axes_[i]; }
  bool has(std::size_t axis) const { return (mask_ >> axis & 1u) != 0; }
  /// A bit for each of A, B and C.
  std::uint32_t mask() const { return mask_; }
  /// True when one axis carries the tool (head) and the other one the workpiece (table).
  bool is_mixed() const { return count_ == 2 && is_table_[0] != is_table_[1]; }
  bool is_table(std::size_t i) const { return is_table_[i]; }

  /// The unit vector from the tip to the holder, in coordinates of the workpiece; nothing for angles that are not
  /// finite.
  std::optional<Vec3> tool_axis(const Angles& angles) const {
    double t[3];
    if (service_->tool_axis(service_->self, angles.data(), t) == 0) return std::nullopt;
    return Vec3{t[0], t[1], t[2]};
  }
  std::optional<Mat4> pivot(const Angles& angles) const {
    Mat4 m;
    if (service_->pivot(service_->self, angles.data(), m.data()) == 0) return std::nullopt;
    return m;
  }
  std::size_t solve(const Vec3& direction, const Angles& present, std::array<ig_rotary_solution, 2>& out) const {
    const double d[3] = {direction.x, direction.y, direction.z};
    return service_->solve(service_->self, d, present.data(), out.data());
  }

 private:
  std::size_t ask() {
    if (!service_) return 0;
    char names[2] = {};
    const std::size_t n = std::min<std::size_t>(2, service_->axes(service_->self, names));
    for (std::size_t i = 0; i < n; ++i) {
      axes_[i] = rotary_names.find(names[i]);
      if (axes_[i] > 2) return 0;
    }
    for (std::size_t i = 0; i < n; ++i) mask_ |= 1u << axes_[i];
    for (std::size_t i = 0; i < n; ++i) {
      Angles quarter{};
      quarter[axes_[i]] = 90;
      Mat4 turned = identity_frame, zero = identity_frame;
      service_->pivot(service_->self, quarter.data(), turned.data());
      service_->pivot(service_->self, Angles{}.data(), zero.data());
      for (const std::size_t e : {0u, 1u, 2u, 4u, 5u, 6u, 8u, 9u, 10u})
        is_table_[i] = is_table_[i] || std::fabs(turned[e] - zero[e]) > 1e-6;
    }
    return n;
  }

  Service<ig_machine_kinematics_1> service_{"isogloss.machine-kinematics/1", Need::optional,
                                            "The kinematics of the rotary axes."};
  std::array<std::size_t, 2> axes_{};
  std::uint32_t mask_ = 0;
  std::array<bool, 2> is_table_{};
  std::size_t count_ = ask();
};

/// The relation between X Y Z of the machine and the tip of a tool of this length in the workpiece, in coordinates with
/// all rotary axes at zero. Each function gives nothing for angles that are not finite.
struct ToolTip {
  const ToolKinematics& machine;
  double length;

  std::optional<Vec3> in_workpiece(const Vec3& xyz, const Angles& angles) const {
    const auto pivot = machine.pivot(angles);
    const auto axis = machine.tool_axis(angles);
    if (!pivot || !axis) return std::nullopt;
    const Mat4& m = *pivot;
    const Vec3 way = xyz - Vec3{m[12], m[13], m[14]};
    Vec3 out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = dot(way, {m[4 * i], m[4 * i + 1], m[4 * i + 2]});
    return out - length * *axis;
  }
  std::optional<Vec3> machine_point(const Vec3& tip, const Angles& angles) const {
    const auto pivot = machine.pivot(angles);
    const auto axis = machine.tool_axis(angles);
    if (!pivot || !axis) return std::nullopt;
    return mapped(*pivot, tip + length * *axis);
  }
};

/// The code of tool length compensation in force, and whether that is tool centre point control (G43.4, G43.5).
class ToolCenterMode {
 public:
  bool is_on(const Block& b) const {
    const Symbol term = b.get_or(term_, Symbol{});
    return term == g43_4_ || term == g43_5_;
  }
  Symbol term(const Block& b) const { return b.get_or(term_, Symbol{}); }

 private:
  In<Symbol> term_{"ToolHeightCompensation.Term"};
  Name g43_4_{"G43.4"}, g43_5_{"G43.5"};
};

}  // namespace ig::cnc
