#include "state/frame_parts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isogloss::cli {

namespace {

using Row = std::array<double, 3>;

double inner_product(const Row& a, const Row& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

double determinant(const std::array<Row, 3>& r) {
  return r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1]) - r[0][1] * (r[1][0] * r[2][2] - r[1][2] * r[2][0]) +
         r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
}

}  // namespace

std::optional<FrameParts> FrameParts::of(const std::array<double, 16>& matrix) {
  constexpr double degrees = 180 / std::numbers::pi, square = 1e-9;
  FrameParts out;
  std::array<Row, 3> r{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) r[i][k] = matrix[4 * i + k];
    out.shift[i] = matrix[12 + i];
    out.scale[i] = std::sqrt(inner_product(r[i], r[i]));
    if (!(out.scale[i] > 0)) return std::nullopt;
    for (double& value : r[i]) value /= out.scale[i];
  }
  for (std::size_t i = 0; i < 3; ++i)
    if (std::abs(inner_product(r[i], r[(i + 1) % 3])) > square) return std::nullopt;
  if (determinant(r) < 0) {
    std::size_t least = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if (r[i][i] < r[least][least]) least = i;
    out.is_mirrored[least] = true;
    for (double& value : r[least]) value = -value;
  }
  const double sine = std::clamp(-r[0][2], -1.0, 1.0);
  out.turn_deg[1] = std::asin(sine) * degrees;
  if (std::abs(sine) < 1 - 1e-15) {
    out.turn_deg[0] = std::atan2(r[1][2], r[2][2]) * degrees;
    out.turn_deg[2] = std::atan2(r[0][1], r[0][0]) * degrees;
  } else {  // X and Z turn about the same line
    out.turn_deg[2] = std::atan2(-r[1][0], r[1][1]) * degrees;
  }
  return out;
}

}  // namespace isogloss::cli
