#include "rotary_machine.hpp"

namespace kinematics {

namespace {

/// rad; finer than any machine or program can set
constexpr double reach = 1e-6;
/// rad; a direction nearer to an axis than this is that of the axis
constexpr double singular = 1e-12;
/// Two solutions must differ by this fraction of the radius.
constexpr double apart = 1e-7;

Matrix matrix(const Vector& n, const Turn& by) {
  const double k = 1 - by.cos;
  const Vector s = by.sin * n, kn = k * n;
  Matrix m;
  m << by.cos + kn.x() * n.x(), kn.x() * n.y() - s.z(), kn.x() * n.z() + s.y(),  //
      kn.x() * n.y() + s.z(), by.cos + kn.y() * n.y(), kn.y() * n.z() - s.x(),   //
      kn.x() * n.z() - s.y(), kn.y() * n.z() + s.x(), by.cos + kn.z() * n.z();
  return m;
}

}  // namespace

void RotaryMachine::prepare() {
  const bool from_the_work = count_ == 2 && axes_[1].place == Place::table;
  outer_ = from_the_work ? 1 : 0;
  inner_ = count_ == 2 ? 1 - outer_ : outer_;
  const Vector& n1 = axes_[outer_].direction;
  const Vector& n2 = axes_[inner_].direction;
  height_ = tool_.dot(n2);
  lever_ = tool_ - height_ * n2;
  side_ = n2.cross(tool_);
  cos_between_ = n1.dot(n2);
  const Vector normal = n1.cross(n2);
  sin_between_ = normal.norm();
  if (count_ != 2) return;
  u_ = (n2 - cos_between_ * n1) / sin_between_;
  w_ = normal / sin_between_;
}

// Tables carry a point from the workpiece to the base; the displacement of the gauge point by heads is subtracted. The
// tool axis goes the other way, through the heads and then the tables.
void RotaryMachine::set_pose(const Angles& angles) const {
  Vector gauge = Vector::Zero(), tool = tool_;
  bool has_table = false;
  pose_.translation.setZero();
  for (std::size_t i = count_; i-- > 0;) {
    const RotaryAxis& axis = axes_[i];
    const Turn& turn = turn_of(i, angles);
    if (axis.place == Place::head) {
      gauge = axis.point + turned(gauge - axis.point, axis.direction, turn);
      tool = turned(tool, axis.direction, turn);
      continue;
    }
    const Matrix r = matrix(axis.direction, {turn.cos, -turn.sin});
    if (has_table)
      pose_.rotation = r * pose_.rotation;
    else
      pose_.rotation = r;
    pose_.translation = axis.point + Vector(r * (pose_.translation - axis.point));
    has_table = true;
  }
  if (!has_table) pose_.rotation.setIdentity();
  pose_.translation -= gauge;
  pose_.tool_axis = pose_.rotation.transpose() * tool;
  has_pose_ = true;
}

Vector RotaryMachine::axis_speeds(const Angles& angles, const Angles& turning, const Vector& tip, double length,
                                  const Vector& tip_speed) const {
  Moving tool{turned(tool_, axes_[inner_].direction, turn_of(inner_, angles)), Vector::Zero()};
  tool.speed = speed_of(inner_, turning) * axes_[inner_].direction.cross(tool.at);
  if (count_ == 2) tool = carried(tool, outer_, angles, turning);
  Moving point{tip + length * tool.at, tip_speed + length * tool.speed};
  Moving gauge{Vector::Zero(), Vector::Zero()};
  for (std::size_t i = count_; i-- > 0;) {
    const RotaryAxis& axis = axes_[i];
    Moving& moving = axis.place == Place::head ? gauge : point;
    moving.at -= axis.point;
    moving = axis.place == Place::head ? carried(moving, i, angles, turning) : carried_back(moving, i, angles, turning);
    moving.at += axis.point;
  }
  return point.speed - gauge.speed;
}

std::uint32_t RotaryMachine::solve(const Vector& direction, const Angles& present, std::array<Solution, 2>& out) const {
  out[0] = out[1] = {present, 0};
  const bool inner_is_tool = lever_.norm() < singular;
  return count_ == 2 && !inner_is_tool ? solve_two(direction, out) : solve_one(direction, out[0]);
}

// R1(q1) v = direction, where v = R2(q2) tool lies on two circles: about the inner axis through the tool, and about the
// outer axis through the direction. u and w span the plane of the second circle; u points towards the inner axis.
std::uint32_t RotaryMachine::solve_two(const Vector& direction, std::array<Solution, 2>& out) const {
  const Vector& n1 = axes_[outer_].direction;
  const double level = direction.dot(n1);
  const double radius = n1.cross(direction).norm();
  const double towards = (height_ - level * cos_between_) / sin_between_;
  if (std::fabs(towards) > radius + reach) return 0;
  if (radius < singular) {
    keep(outer_, out[0]);
    set(inner_, inner_angle(std::copysign(1.0, level) * n1), out[0]);
    return 1;
  }
  const double tu = direction.dot(u_), tw = direction.dot(w_);
  const double square = (radius - towards) * (radius + towards);
  const double aside = square > 0 ? std::sqrt(square) : 0;
  if (aside <= apart * radius) {
    const double k = std::copysign(radius, towards);
    set(outer_, std::atan2(k * tw, k * tu), out[0]);
    set(inner_, inner_angle(level * n1 + k * u_), out[0]);
    return 1;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const double g = i == 0 ? aside : -aside;
    set(outer_, std::atan2(towards * tw - g * tu, towards * tu + g * tw), out[i]);
    set(inner_, inner_angle(level * n1 + towards * u_ + g * w_), out[i]);
  }
  return 2;
}

std::uint32_t RotaryMachine::solve_one(const Vector& direction, Solution& out) const {
  if (count_ == 2) keep(inner_, out);
  const Vector& n = axes_[outer_].direction;
  const Vector tool = count_ == 2 ? Vector(height_ * axes_[inner_].direction) : tool_;
  const double height = tool.dot(n);
  const Vector lever = tool - height * n;
  const double radius = lever.norm();
  const Vector reached = direction - direction.dot(n) * n;
  if (std::fabs(direction.dot(n) - height) > reach || std::fabs(reached.norm() - radius) > reach) return 0;
  if (radius < singular)
    keep(outer_, out);
  else
    set(outer_, std::atan2(n.cross(tool).dot(direction), lever.dot(direction)), out);
  return 1;
}

}  // namespace kinematics
