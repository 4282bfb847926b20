/// The definition of a plane by a PLANE statement: its kind, the words of that kind, and the directions that they give.
#pragma once

#include <numbers>
#include <span>

#include <isogloss/cnc/tool_kinematics.hpp>
#include <isogloss/cnc/units.hpp>

#include "language/klartext_text.hpp"

namespace heidenhain {

using namespace ig::cnc;

struct PlaneDefinition {
  enum Kind : std::size_t { spatial, euler, vector, points, axial, relative, reset, kind_count };

  Kind kind = kind_count;
  std::array<std::optional<double>, 9> words{};

  static Kind kind_of(std::string_view name) {
    static constexpr std::array<std::string_view, kind_count> names{"SPATIAL", "EULER",   "VECTOR", "POINTS",
                                                                    "AXIAL",   "RELATIV", "RESET"};
    std::size_t kind = 0;
    while (kind < kind_count && !equals_ignoring_case(name, names[kind])) ++kind;
    return static_cast<Kind>(kind);
  }
  std::string_view shown() const {
    static constexpr std::array<std::string_view, kind_count> all{
        "PLANE SPATIAL", "PLANE EULER", "PLANE VECTOR", "PLANE POINTS", "PLANE AXIAL", "PLANE RELATIV", "PLANE RESET"};
    return all[kind];
  }

  /// The words of the kind, in the order of `words`.
  std::span<const std::string_view> names() const {
    static constexpr std::array<std::string_view, 3> of_spatial{"SPA", "SPB", "SPC"};
    static constexpr std::array<std::string_view, 3> of_euler{"EULPR", "EULNUT", "EULROT"};
    static constexpr std::array<std::string_view, 6> of_vector{"BX", "BY", "BZ", "NX", "NY", "NZ"};
    static constexpr std::array<std::string_view, 9> of_points{"P1X", "P1Y", "P1Z", "P2X", "P2Y",
                                                               "P2Z", "P3X", "P3Y", "P3Z"};
    static constexpr std::array<std::string_view, 3> of_axes{"A", "B", "C"};
    switch (kind) {
      case euler: return of_euler;
      case vector: return of_vector;
      case points: return of_points;
      case axial: return of_axes;
      case reset: return {};
      default: return of_spatial;
    }
  }
  /// True where one of the words is enough.
  bool takes_some() const { return kind == relative || kind == axial; }

  double word(std::size_t i) const { return words[i].value_or(0); }
  ig::Vec3 words_from(std::size_t i) const { return {word(i), word(i + 1), word(i + 2)}; }

  static Mat4 spatial_plane(const ig::Vec3& angles) { return roll_pitch_yaw(angles, {0, 1, 2}, TurnedAxes::fixed); }
  /// The spatial angles of a plane.
  static ig::Vec3 spatial_angles(const Mat4& m) {
    const double b = std::atan2(-m[2], std::hypot(m[0], m[1]));  // an arcsine would lose digits near 90 degrees
    if (std::fabs(m[0]) < 1e-12 && std::fabs(m[1]) < 1e-12)
      return {std::atan2(-m[9], m[5]) / radians_per_degree, b / radians_per_degree, 0};
    return {std::atan2(m[6], m[10]) / radians_per_degree, b / radians_per_degree,
            std::atan2(m[1], m[0]) / radians_per_degree};
  }

  /// A matrix whose rows are the axes of the plane; nothing where the words define none. RELATIV rotates the plane
  /// `present`; under AXIAL the rotary axes are at `axes`.
  std::optional<Mat4> frame(const Mat4& present, const Angles& axes, const ToolKinematics& machine) const {
    switch (kind) {
      case euler: return euler_zxz(words_from(0));
      case vector: return from_z_and_x(words_from(3), words_from(0));
      case points: return from_x_and_side(words_from(3) - words_from(0), words_from(6) - words_from(0));
      case axial: return frame_of_axes(axes, machine);
      case relative: return product(spatial_plane(words_from(0)), present);
      default: return spatial_plane(words_from(0));
    }
  }

 private:
  /// The plane that belongs to angles of the axes: the head turns its directions from those of the machine, the table
  /// turns them with the workpiece. Nothing where the tool is not square to the plane, because two axes of a head are
  /// not as their names suggest.
  static std::optional<Mat4> frame_of_axes(const Angles& axes, const ToolKinematics& machine) {
    const auto pivot = machine.pivot(axes);
    const auto tool = machine.tool_axis(axes);
    const auto head = pivot ? turn_of_head(axes, *pivot, machine) : std::nullopt;
    if (!tool || !head) return std::nullopt;
    Mat4 m = identity_frame;
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 3; ++column) {
        m[4 * row + column] = 0;
        for (std::size_t k = 0; k < 3; ++k) m[4 * row + column] += (*head)[4 * row + k] * (*pivot)[4 * column + k];
      }
    constexpr double same = 1e-6;
    if (!(dot(*tool, {m[8], m[9], m[10]}) > 1 - same)) return std::nullopt;
    return m;
  }

  /// How the head has turned the tool, in machine coordinates. The machine's tool axis includes the rotation of the
  /// table, which is undone here.
  static std::optional<Mat4> turn_of_head(const Angles& axes, const Mat4& pivot, const ToolKinematics& machine) {
    std::size_t heads = 0, head = 0;
    for (std::size_t i = 0; i < machine.count(); ++i)
      if (!machine.is_table(i)) {
        ++heads;
        head = machine.axis(i);
      }
    if (heads != 1) {
      Mat4 m = identity_frame;
      for (std::size_t i = machine.count(); i-- > 0;)
        if (!machine.is_table(i)) m = product(m, turn_about(machine.axis(i), axes[machine.axis(i)]));
      return m;
    }
    const auto seen = [&](double angle) {
      Angles turned = axes;
      turned[head] = angle;
      const auto tool = machine.tool_axis(turned);
      ig::Vec3 out;
      for (std::size_t i = 0; tool && i < 3; ++i) out[i] = dot(*tool, {pivot[i], pivot[4 + i], pivot[8 + i]});
      return out;
    };
    // The tool moves on a circle about the head's axis.
    const ig::Vec3 start = seen(0), middle = 0.5 * (start + seen(180));
    const auto n = unit(vector_product(start - middle, seen(90) - middle));
    if (!n) return turn_about(head, axes[head]);  // the tool lies along the axis
    const ig::Vec3 upright = ig::Vec3{0, 0, 1} - middle, here = seen(axes[head]) - middle;
    const double angle = std::atan2(dot(*n, vector_product(upright, here)), dot(upright, here));
    const double c = std::cos(angle), s = std::sin(angle);
    Mat4 m = identity_frame;
    for (std::size_t row = 0; row < 3; ++row) {
      ig::Vec3 e{};
      e[row] = 1;
      const ig::Vec3 turned = c * e + s * vector_product(*n, e) + (1 - c) * dot(*n, e) * *n;
      for (std::size_t column = 0; column < 3; ++column) m[4 * row + column] = turned[column];
    }
    return m;
  }
};

}  // namespace heidenhain
