// The work offsets: where the origin of each work coordinate system lies in machine coordinates. Sets that the control
// has but no row names lie at machine zero, as they do before anyone has measured a part.
#include <array>
#include <charconv>

#include <isogloss/sdk.hpp>

namespace iso {
namespace {

constexpr const char* shipped[] = {"EXT|X=0|Y=0|Z=0", "G54|X=0|Y=0|Z=0", "G55|X=0|Y=0|Z=0", "G56|X=0|Y=0|Z=0",
                                   "G57|X=0|Y=0|Z=0", "G58|X=0|Y=0|Z=0", "G59|X=0|Y=0|Z=0"};

struct IsoCoordinateTable {
  static constexpr auto spec =
      ig::dependency("IsoCoordinateTable", "Work offsets: G54 to G59.9, G54.1 P1 to P300, and the external offset EXT.")
          .rows("Offset", "id")
          .provides("isogloss.work-offset/1")
          .ships(shipped);

  ig::Column x{"X", "0", "mm", {}, "Origin in machine coordinates."};
  ig::Column y{"Y", "0", "mm", {}, "Origin in machine coordinates."};
  ig::Column z{"Z", "0", "mm", {}, "Origin in machine coordinates."};
  std::array<ig::Column, 3> rotary{
      ig::Column{"A", nullptr, "deg", {-1e9, 1e9}, "Angle of the machine at which the program counts 0."},
      ig::Column{"B", nullptr, "deg", {-1e9, 1e9}, "Angle of the machine at which the program counts 0."},
      ig::Column{"C", nullptr, "deg", {-1e9, 1e9}, "Angle of the machine at which the program counts 0."}};
  ig::Table table;

  const void* service(std::string_view id) const { return id == "isogloss.work-offset/1" ? &offsets : nullptr; }

 private:
  static bool is_within(std::string_view number, std::int64_t maximum) {
    std::int64_t n = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), n);
    return error == std::errc{} && end == number.data() + number.size() && n >= 1 && n <= maximum;
  }
  static bool exists(std::string_view id) {
    if (id == "EXT") return true;
    if (id.starts_with("G54.1P")) return is_within(id.substr(6), 300);
    if (id.starts_with("G59.")) return is_within(id.substr(4), 9);
    return id.size() == 3 && id.starts_with("G5") && id[2] >= '4' && id[2] <= '9';
  }

  static std::int32_t get(void* self, ig_text id, double offset[3]) {
    const auto& t = *static_cast<const IsoCoordinateTable*>(self);
    const std::string_view row = ig::to_view(id);
    const auto x_value = t.table.value(row, t.x), y_value = t.table.value(row, t.y), z_value = t.table.value(row, t.z);
    if (!x_value && !y_value && !z_value && !exists(row)) return 0;
    offset[0] = x_value.value_or(0);
    offset[1] = y_value.value_or(0);
    offset[2] = z_value.value_or(0);
    return 1;
  }
  static std::int32_t set(void* self, ig_text id, const double offset[3]) {
    const auto& t = *static_cast<const IsoCoordinateTable*>(self);
    const std::string_view row = ig::to_view(id);
    double present[3];
    if (get(self, id, present) == 0) return 0;
    return t.table.set_value(row, t.x, offset[0]) && t.table.set_value(row, t.y, offset[1]) &&
                   t.table.set_value(row, t.z, offset[2])
               ? 1
               : 0;
  }

  static std::int32_t get_rotary(void* self, ig_text id, double offset[3]) {
    const auto& t = *static_cast<const IsoCoordinateTable*>(self);
    double present[3];
    if (get(self, id, present) == 0) return 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      offset[axis] = t.table.value(ig::to_view(id), t.rotary[axis]).value_or(0);
    return 1;
  }
  /// Axes whose origin stays are not written: a table that is saved names the axes that have one.
  static std::int32_t set_rotary(void* self, ig_text id, const double offset[3]) {
    const auto& t = *static_cast<const IsoCoordinateTable*>(self);
    double present[3];
    if (get_rotary(self, id, present) == 0) return 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (offset[axis] != present[axis] && !t.table.set_value(ig::to_view(id), t.rotary[axis], offset[axis])) return 0;
    return 1;
  }

  ig_work_offset_1 offsets{sizeof(ig_work_offset_1), 0, this, &get, &set, &get_rotary, &set_rotary};
};

const ig::Register<IsoCoordinateTable> registered;

}  // namespace
}  // namespace iso
