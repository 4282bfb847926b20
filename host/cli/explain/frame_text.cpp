#include "explain/frame_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace isogloss::cli {

namespace {

using Point = std::array<double, 3>;
constexpr double rounding = 1e-9, smallest_shown = 5e-7;

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point row(const std::array<double, 16>& m, std::size_t i) { return {m[4 * i], m[4 * i + 1], m[4 * i + 2]}; }

/// The rows are the images of the axes: orthogonal and of length 1 where the transform only turns.
bool only_turns(const std::array<double, 16>& m) {
  const Point x = row(m, 0), y = row(m, 1), z = row(m, 2);
  for (const Point& p : {x, y, z})
    if (std::abs(dot(p, p) - 1) > rounding) return false;
  return std::abs(dot(x, y)) < rounding && std::abs(dot(y, z)) < rounding && std::abs(dot(x, z)) < rounding &&
         dot(cross(x, y), z) > 0;
}

/// Unit vector of the axis, and the angle about it, 0 to 180 degrees.
std::pair<Point, double> axis_and_angle(const std::array<double, 16>& m) {
  const Point twice_sine{m[6] - m[9], m[8] - m[2], m[1] - m[4]};
  const double sine = std::sqrt(dot(twice_sine, twice_sine)) / 2, cosine = (m[0] + m[5] + m[10] - 1) / 2;
  Point axis = twice_sine;
  if (sine < 1e-7) {  // half a turn: the axis is what stays as it is
    for (std::size_t i = 0; i < 3; ++i) axis[i] = std::sqrt(std::max(0.0, (m[5 * i] + 1) / 2));
    if (axis[0] > rounding && m[1] + m[4] < 0) axis[1] = -axis[1];
    if (axis[0] > rounding && m[2] + m[8] < 0) axis[2] = -axis[2];
    if (axis[0] <= rounding && m[6] + m[9] < 0) axis[2] = -axis[2];
  }
  const double length = std::sqrt(dot(axis, axis));
  for (double& value : axis) value /= length;
  return {axis, std::atan2(sine, cosine) * 180 / std::acos(-1.0)};
}

/// Where the axis of a turn goes through, if the turn does not shift along it: c = t/2 + (axis x t) / (2 tan(angle/2)).
std::string centre_of(const Point& axis, double angle, const Point& shift, double unit_mm) {
  const double half = std::tan(angle * std::acos(-1.0) / 360);
  if (std::abs(dot(axis, shift)) > 1e-7 || std::abs(half) < 1e-6) return {};
  const Point across = cross(axis, shift);
  Point centre;
  for (std::size_t i = 0; i < 3; ++i) centre[i] = shift[i] / 2 + across[i] / (2 * half);
  return axis_words(centre, unit_mm);
}

std::string turn_text(const std::array<double, 16>& m, double unit_mm) {
  auto [axis, angle] = axis_and_angle(m);
  const Point shift{m[12], m[13], m[14]};
  const std::string added = axis_words(shift, unit_mm),
                    centre = added.empty() ? "" : centre_of(axis, angle, shift, unit_mm);
  std::string name;
  for (std::size_t i = 0; i < 3; ++i)
    if (std::abs(std::abs(axis[i]) - 1) < 1e-7) {
      name = std::string(1, "XYZ"[i]);
      angle = axis[i] < 0 ? -angle : angle;
    }
  if (name.empty()) name = fmt::format("({:.4f} {:.4f} {:.4f})", axis[0] + 0.0, axis[1] + 0.0, axis[2] + 0.0);
  const std::string out = fmt::format("turns {}° about {}", short_number(angle), name);
  if (name.size() == 1 && !centre.empty()) return out + " through " + centre;
  return added.empty() ? out : out + " and adds " + added;
}

std::string stretch_text(const std::array<double, 16>& m) {
  std::string mirrored, scaled;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      if (i != k && std::abs(m[4 * i + k]) > rounding) return "changes the directions of the axes";
    const double factor = m[5 * i];
    const std::string axis(1, "XYZ"[i]);
    if (factor < 0) mirrored += (mirrored.empty() ? "" : " ") + axis;
    if (std::abs(std::abs(factor) - 1) > rounding)
      scaled += (scaled.empty() ? "" : ", ") + axis + " by " + short_number(std::abs(factor));
  }
  if (mirrored.empty()) return "scales " + scaled;
  return "mirrors " + mirrored + (scaled.empty() ? "" : " and scales " + scaled);
}

}  // namespace

std::string short_number(double value) {
  if (!std::isfinite(value) || std::abs(value) >= 1e15) return fmt::format("{}", value);
  std::string out = fmt::format("{:.6f}", value);
  out.erase(out.find_last_not_of('0') + 1);
  if (out.back() == '.') out.pop_back();
  return out == "-0" ? "0" : out;
}

std::string short_value(const std::string& json) {
  const auto value = nlohmann::json::parse(json, nullptr, false);
  return value.is_number_float() ? short_number(value.get<double>()) : json;
}

std::string axis_words(const std::array<double, 3>& values, double unit_mm) {
  std::string out;
  for (std::size_t i = 0; i < 3; ++i)
    if (std::abs(values[i]) >= smallest_shown)
      out += (out.empty() ? "" : " ") + std::string(1, "XYZ"[i]) + short_number(values[i] / unit_mm);
  return out;
}

FrameEffect effect_of(const std::array<double, 16>& m, double unit_mm) {
  FrameEffect out;
  out.shift = {m[12], m[13], m[14]};
  const std::string shift = axis_words(out.shift, unit_mm);
  constexpr std::array<double, 16> identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  for (std::size_t i = 0; i < 12; ++i) out.is_shift = out.is_shift && std::abs(m[i] - identity[i]) < 1e-12;
  if (out.is_shift)
    out.text = shift.empty() ? std::string(changes_nothing) : "adds " + shift;
  else
    out.text = only_turns(m) ? turn_text(m, unit_mm) : stretch_text(m) + (shift.empty() ? "" : " and adds " + shift);
  return out;
}

std::string effect_of_json(const std::string& matrix, double unit_mm) {
  const auto json = nlohmann::json::parse(matrix, nullptr, false);
  if (!json.is_array() || json.size() != 16) return {};
  std::array<double, 16> m{};
  for (std::size_t i = 0; i < 16; ++i) {
    if (!json[i].is_number()) return {};
    m[i] = json[i].get<double>();
  }
  return effect_of(m, unit_mm).text;
}

}  // namespace isogloss::cli
