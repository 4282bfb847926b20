// The basic rotations of presets: SPA, SPB and SPC of the preset table, or ROT of older controls. They have a table of
// their own, because no other control's work offsets have such angles.
#include "frames/basic_rotation.hpp"

#include <charconv>

namespace heidenhain {

using namespace ig::cnc;

namespace {

std::optional<std::int64_t> preset_number(std::string_view text) {
  std::int64_t n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  const bool is_number = error == std::errc{} && end == text.data() + text.size() && n >= 0;
  return is_number && std::to_string(n) == text ? std::optional(n) : std::nullopt;
}

struct HeidenhainBasicRotations {
  static constexpr auto spec = ig::dependency("HeidenhainBasicRotations", "Basic rotations of presets: SPA, SPB, SPC.")
                                   .rows("Preset", "number")
                                   .provides(basic_rotation_service);

  std::array<ig::Column, 3> spatial{ig::Column{"SPA", nullptr, "deg", {-1e9, 1e9}, "Rotation about X."},
                                    ig::Column{"SPB", nullptr, "deg", {-1e9, 1e9}, "Rotation about Y."},
                                    ig::Column{"SPC", nullptr, "deg", {-1e9, 1e9}, "Rotation about Z; ROT."}};
  ig::Table table;

  const void* service(std::string_view id) const { return id == basic_rotation_service ? &service_ : nullptr; }

  static std::string row_fault(std::string_view row) {
    return preset_number(row) ? "" : "its rows are the numbers of presets, from 0";
  }

 private:
  static void get(void* self, std::int64_t preset, double degrees[3]) {
    const auto& own = *static_cast<const HeidenhainBasicRotations*>(self);
    const std::string row = std::to_string(preset);
    for (std::size_t axis = 0; axis < 3; ++axis) degrees[axis] = own.table.value(row, own.spatial[axis]).value_or(0);
  }

  BasicRotationTable service_{sizeof(BasicRotationTable), 0, this, &get};
};

const ig::Register<HeidenhainBasicRotations> heidenhain_basic_rotations;

}  // namespace

ig::Vec3 BasicRotations::angles_of(std::string_view row) const {
  const auto number = row.starts_with(preset_prefix) ? preset_number(row.substr(preset_prefix.size())) : std::nullopt;
  return number ? angles(*number) : ig::Vec3{};
}

}  // namespace heidenhain
