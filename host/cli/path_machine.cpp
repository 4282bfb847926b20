#include "path_machine.hpp"

#include <cmath>

#include "isogloss/engine/chain.hpp"

namespace isogloss::cli {

namespace {

using Matrix = std::array<double, 16>;  // row vectors

Matrix product(const Matrix& first, const Matrix& then) {
  Matrix out{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k) out[4 * i + j] += first[4 * i + k] * then[4 * k + j];
  return out;
}

/// Of a rotation and a translation.
Matrix inverse(const Matrix& m) {
  Matrix out{};
  out[15] = 1;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      out[4 * i + j] = m[4 * j + i];
      out[12 + i] -= m[12 + j] * m[4 * i + j];
    }
  return out;
}

/// The line about which a quarter turn goes; false where the matrix turns nothing.
bool read_quarter_turn(const Matrix& m, TurningTable& out) {
  out.direction = {(m[6] - m[9]) / 2, (m[8] - m[2]) / 2, (m[1] - m[4]) / 2};
  const Point& d = out.direction;
  constexpr double nearly_a_quarter = 0.999;
  if (std::hypot(d[0], d[1], d[2]) < nearly_a_quarter) return false;
  // The point that rests: p = (t + d × t) / 2.
  const Point t{m[12], m[13], m[14]};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    out.point[i] = (t[i] + d[j] * t[k] - d[k] * t[j]) / 2;
  }
  return true;
}

}  // namespace

PathMachine::PathMachine(const Chain* chain) {
  if (chain == nullptr) return;
  service_ = static_cast<const ig_machine_kinematics_1*>(chain->service("isogloss.machine-kinematics/1"));
  char names[2];
  if (service_ != nullptr && service_->axes(service_->self, names) == 0) service_ = nullptr;
}

std::array<double, 16> PathMachine::pivot(const Point& angles) const {
  Matrix out{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  if (service_ != nullptr) service_->pivot(service_->self, angles.data(), out.data());
  return out;
}

Point PathMachine::tool_axis(const Point& angles) const {
  Point out{0, 0, 1};
  if (service_ != nullptr) service_->tool_axis(service_->self, angles.data(), out.data());
  return out;
}

Point PathMachine::tip(const Point& machine, const Point& angles, double length) const {
  if (service_ == nullptr) return {machine[0], machine[1], machine[2] - length};
  const Matrix m = pivot(angles);
  const Point axis = tool_axis(angles);
  Point out;
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = -length * axis[i];
    for (std::size_t j = 0; j < 3; ++j) out[i] += (machine[j] - m[12 + j]) * m[4 * i + j];
  }
  return out;
}

PathKinematics PathMachine::describe() const {
  PathKinematics out;
  if (service_ == nullptr) return out;
  char names[2];
  out.is_known = true;
  out.axes.assign(names, service_->axes(service_->self, names));
  out.zero = pivot({});
  const Matrix back = inverse(out.zero);
  for (std::size_t i = 0; i < out.axes.size(); ++i) {
    TurningTable table;
    table.axis = static_cast<std::size_t>(out.axes[i] - 'A');
    Point quarter{};
    quarter[table.axis] = 90;
    const Matrix turned = pivot(quarter);
    const bool is_outer = out.tables.empty();
    if (read_quarter_turn(is_outer ? product(back, turned) : product(turned, back), table)) out.tables.push_back(table);
  }
  return out;
}

}  // namespace isogloss::cli
