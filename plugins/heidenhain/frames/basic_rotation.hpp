/// The basic rotation of a preset: spatial angles SPA, SPB and SPC, in degrees. The rows of HeidenhainBasicRotations,
/// through a service of this plugin.
#pragma once

#include <cstdint>
#include <optional>

#include <isogloss/cnc/tilt_transform.hpp>
#include <isogloss/sdk.hpp>

namespace heidenhain {

using namespace ig::cnc;

inline constexpr const char* basic_rotation_service = "heidenhain.basic-rotation/1";

/// The service: the angles of a preset; zeros for a preset without a row.
struct BasicRotationTable {
  std::uint32_t struct_size;
  std::uint32_t reserved;
  void* self;
  void (*get)(void* self, std::int64_t preset, double degrees[3]);
};

/// The prefix of a preset's row in the table of work offsets.
inline constexpr std::string_view preset_prefix = "DATUM_PRESET_";

/// A member of each syntax that puts a preset in force.
class BasicRotations {
 public:
  ig::Vec3 angles(std::int64_t preset) const {
    double degrees[3] = {0, 0, 0};
    if (table_) table_->get(table_->self, preset, degrees);
    return {degrees[0], degrees[1], degrees[2]};
  }
  /// Of the row of the table of work offsets.
  ig::Vec3 angles_of(std::string_view row) const;

  /// About the fixed axes X (SPA), Y (SPB) and Z (SPC), in this order, as under PLANE SPATIAL.
  static Mat4 matrix(const ig::Vec3& angles) { return roll_pitch_yaw(angles, {0, 1, 2}, TurnedAxes::fixed); }

 private:
  ig::Service<BasicRotationTable> table_{basic_rotation_service, ig::Need::optional, "Basic rotations of presets."};
};

}  // namespace heidenhain
