/// What a settable frame has besides its coarse offset: fine offset, rotation, scale and mirror. The table of work
/// offsets gives them through a service of its own. Lengths in mm, angles in degrees.
#pragma once

#include <cstdint>
#include <string_view>

#include <isogloss/cnc/tilt_transform.hpp>
#include <isogloss/sdk.hpp>

namespace siemens {

using namespace ig::cnc;

inline constexpr const char* settable_shape_service = "siemens.settable-shape/1";

/// The order of the values of each axis.
enum class ShapePart : std::uint32_t { fine, rotation, scale, mirror };
inline constexpr std::size_t shape_parts = 4;
inline constexpr ig::Range settable_scales{1e-6, 1e6};

/// The service: `part` is a ShapePart, `axis` 0 to 2. Each returns 1, or 0 when the table has no such frame, or cannot
/// keep the value.
struct SettableShapes {
  std::uint32_t struct_size;
  std::uint32_t reserved;
  void* self;
  std::int32_t (*get)(void* self, ig_text id, std::uint32_t part, std::uint32_t axis, double* value);
  std::int32_t (*set)(void* self, ig_text id, std::uint32_t part, std::uint32_t axis, double value);
};

/// The value of a part that the table does not name.
constexpr double default_of(ShapePart part) { return part == ShapePart::scale ? 1 : 0; }

class SettableShape {
 public:
  ig::Vec3& operator[](ShapePart part) { return parts_[static_cast<std::size_t>(part)]; }
  const ig::Vec3& operator[](ShapePart part) const { return parts_[static_cast<std::size_t>(part)]; }

  /// Rotation, scale and mirror. With row vectors the mirror is applied first, then the scale, then the rotation about
  /// X, Y and Z, as under ROT.
  Mat4 matrix() const {
    Mat4 m = roll_pitch_yaw((*this)[ShapePart::rotation], {0, 1, 2}, TurnedAxes::fixed);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double factor = (*this)[ShapePart::scale][axis] * ((*this)[ShapePart::mirror][axis] != 0 ? -1 : 1);
      if (factor == 1) continue;
      for (std::size_t column = 0; column < 3; ++column) m[4 * axis + column] = m[4 * axis + column] * factor + 0.0;
    }
    return m;
  }

 private:
  std::array<ig::Vec3, shape_parts> parts_{ig::Vec3{}, ig::Vec3{}, ig::Vec3{1, 1, 1}, ig::Vec3{}};
};

/// A member of each syntax that reads or writes them.
class ShapeTable {
 public:
  SettableShape get(std::string_view id) const {
    SettableShape out;
    for (std::uint32_t part = 0; service_ && part < shape_parts; ++part)
      for (std::uint32_t axis = 0; axis < 3; ++axis)
        service_->get(service_->self, ig::to_text(id), part, axis, &out[static_cast<ShapePart>(part)][axis]);
    return out;
  }
  /// False where the table cannot keep the value.
  bool set(std::string_view id, ShapePart part, std::size_t axis, double value) const {
    return service_ && service_->set(service_->self, ig::to_text(id), static_cast<std::uint32_t>(part),
                                     static_cast<std::uint32_t>(axis), value) != 0;
  }

 private:
  ig::Service<SettableShapes> service_{settable_shape_service, ig::Need::optional,
                                       "Fine offset, rotation, scale and mirror."};
};

}  // namespace siemens
