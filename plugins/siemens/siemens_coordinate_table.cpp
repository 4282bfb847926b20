// The settable work offsets of a SINUMERIK: G54 to G57, G505 to G599, and the base frame, which is in force under all
// of them and alone under G500.
#include <charconv>

#include <isogloss/sdk.hpp>

namespace siemens {
namespace {

struct SiemensCoordinateTable {
  static constexpr auto spec =
      ig::dependency("SiemensCoordinateTable", "Work offsets: G54 to G57, G505 to G599, and the base frame BASE.")
          .rows("Offset", "id")
          .provides("isogloss.work-offset/1");

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
  static bool exists(std::string_view id) {
    if (id == "BASE" || id == "G500" || id == "G54" || id == "G55" || id == "G56" || id == "G57") return true;
    int number = 0;
    if (id.size() != 4 || id[0] != 'G') return false;
    const auto [end, error] = std::from_chars(id.data() + 1, id.data() + 4, number);
    return error == std::errc{} && end == id.data() + 4 && number >= 505 && number <= 599;
  }
  static std::int32_t get(void* self, ig_text id, double offset[3]) {
    const auto& t = *static_cast<const SiemensCoordinateTable*>(self);
    const std::string_view row = ig::to_view(id);
    if (!exists(row)) return 0;
    offset[0] = t.table.value(row, t.x).value_or(0);
    offset[1] = t.table.value(row, t.y).value_or(0);
    offset[2] = t.table.value(row, t.z).value_or(0);
    return 1;
  }
  static std::int32_t set(void* self, ig_text id, const double offset[3]) {
    const auto& t = *static_cast<const SiemensCoordinateTable*>(self);
    const std::string_view row = ig::to_view(id);
    return exists(row) && t.table.set_value(row, t.x, offset[0]) && t.table.set_value(row, t.y, offset[1]) &&
                   t.table.set_value(row, t.z, offset[2])
               ? 1
               : 0;
  }
  static std::int32_t get_rotary(void* self, ig_text id, double offset[3]) {
    const auto& t = *static_cast<const SiemensCoordinateTable*>(self);
    if (!exists(ig::to_view(id))) return 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      offset[axis] = t.table.value(ig::to_view(id), t.rotary[axis]).value_or(0);
    return 1;
  }
  static std::int32_t set_rotary(void* self, ig_text id, const double offset[3]) {
    const auto& t = *static_cast<const SiemensCoordinateTable*>(self);
    double present[3];
    if (get_rotary(self, id, present) == 0) return 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (offset[axis] != present[axis] && !t.table.set_value(ig::to_view(id), t.rotary[axis], offset[axis])) return 0;
    return 1;
  }

  ig_work_offset_1 offsets{sizeof(ig_work_offset_1), 0, this, &get, &set, &get_rotary, &set_rotary};
};

const ig::Register<SiemensCoordinateTable> registered;

}  // namespace
}  // namespace siemens
