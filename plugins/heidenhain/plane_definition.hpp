/// How a PLANE statement defines the plane: its kind, the words of that kind, and the directions that they give.
#pragma once

#include <numbers>
#include <span>

#include "klartext_text.hpp"
#include "tool_kinematics.hpp"

namespace heidenhain {

struct PlaneDefinition {
  enum Kind : std::size_t { spatial, euler, vector, points, axial, relative, reset, kind_count };

  Kind kind = kind_count;
  std::array<std::optional<double>, 9> words{};

  static Kind kind_of(std::string_view name) {
    static constexpr std::array<std::string_view, kind_count> names{"SPATIAL", "EULER",   "VECTOR", "POINTS",
                                                                    "AXIAL",   "RELATIV", "RESET"};
    std::size_t kind = 0;
    while (kind < kind_count && !iso::equals_ignoring_case(name, names[kind])) ++kind;
    return static_cast<Kind>(kind);
  }
  std::string_view shown() const {
    static constexpr std::array<std::string_view, kind_count> all{
        "PLANE SPATIAL", "PLANE EULER", "PLANE VECTOR", "PLANE POINTS", "PLANE AXIAL", "PLANE RELATIV", "PLANE RESET"};
    return all[kind];
  }

  /// Those of the kind, in the order of `words`.
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
  /// One word of these is enough.
  bool takes_some() const { return kind == relative || kind == axial; }

  double word(std::size_t i) const { return words[i].value_or(0); }
  ig::Vec3 words_from(std::size_t i) const { return {word(i), word(i + 1), word(i + 2)}; }

  static iso::Mat4 spatial_plane(const ig::Vec3& angles) {
    return iso::roll_pitch_yaw(angles, {0, 1, 2}, iso::TurnedAxes::fixed);
  }
  /// The spatial angles of a plane.
  static ig::Vec3 spatial_angles(const iso::Mat4& m) {
    constexpr double degree = std::numbers::pi / 180;
    const double b = std::asin(std::fmax(-1, std::fmin(1, -m[2])));
    if (std::fabs(m[0]) < 1e-12 && std::fabs(m[1]) < 1e-12) return {std::atan2(-m[9], m[5]) / degree, b / degree, 0};
    return {std::atan2(m[6], m[10]) / degree, b / degree, std::atan2(m[1], m[0]) / degree};
  }

  /// Its rows are the axes of the plane; nothing where the words give none. RELATIV turns the plane `present`; the axes
  /// of AXIAL stand at `axes`.
  std::optional<iso::Mat4> frame(const iso::Mat4& present, const iso::Angles& axes,
                                 const iso::ToolKinematics& machine) const {
    switch (kind) {
      case euler: return iso::euler_zxz(words_from(0));
      case vector: return iso::from_z_and_x(words_from(3), words_from(0));
      case points: return iso::from_x_and_side(words_from(3) - words_from(0), words_from(6) - words_from(0));
      case axial: return frame_of_axes(axes, machine);
      case relative: return iso::product(spatial_plane(words_from(0)), present);
      default: return spatial_plane(words_from(0));
    }
  }

 private:
  /// The plane that the axes, counted from the tool to the workpiece, turn: those of the head from the spindle on, then
  /// those of the table from the machine's base on. Nothing where the tool does not stand upright on it, since an axis
  /// is none about X, Y or Z.
  static std::optional<iso::Mat4> frame_of_axes(const iso::Angles& axes, const iso::ToolKinematics& machine) {
    iso::Mat4 m = iso::identity_frame;
    for (std::size_t i = machine.count(); i-- > 0;)
      if (!machine.is_table(i)) m = iso::product(m, iso::turn_about(machine.axis(i), axes[machine.axis(i)]));
    for (std::size_t i = 0; i < machine.count(); ++i)
      if (machine.is_table(i)) m = iso::product(m, iso::turn_about(machine.axis(i), axes[machine.axis(i)]));
    const auto tool = machine.tool_axis(axes);
    constexpr double same = 1e-6;
    if (!tool || !(iso::dot(*tool, {m[8], m[9], m[10]}) > 1 - same)) return std::nullopt;
    return m;
  }
};

}  // namespace heidenhain
