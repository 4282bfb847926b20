// The work offsets: the origin of each work coordinate system in machine coordinates. Offsets that the control has but
// no row names are at machine zero, as they are before a part is measured.
#include <charconv>
#include <cmath>

#include <isogloss/cnc/work_offset_service.hpp>

#include "motion/further_axis_order.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

constexpr const char* shipped_offsets[] = {"EXT|X=0|Y=0|Z=0", "G54|X=0|Y=0|Z=0", "G55|X=0|Y=0|Z=0", "G56|X=0|Y=0|Z=0",
                                           "G57|X=0|Y=0|Z=0", "G58|X=0|Y=0|Z=0", "G59|X=0|Y=0|Z=0"};

struct IsoCoordinateTable {
  static constexpr auto spec =
      ig::dependency("IsoCoordinateTable", "Work offsets: G54 to G59.9, G54.1 P1 to P300, and the external offset EXT.")
          .rows("Offset", "id")
          .provides("isogloss.work-offset/1", further_offset_service)
          .ships(shipped_offsets);

  ig::IntegerOption additional_sets{
      "additional-sets", "300", {0, 99999}, "The highest P of G54.1 on this control; a row may name a higher one."};
  WorkOffsetColumns columns;
  std::array<ig::Column, 3> further{further_column("U"), further_column("V"), further_column("W")};
  ig::Table table;

  const void* service(std::string_view id) const {
    if (id == further_offset_service) return &further_offsets;
    return id == "isogloss.work-offset/1" ? &offsets : nullptr;
  }

  /// A row may name a larger P than the control has. No program reaches a row with any other name.
  std::string row_fault(std::string_view row) const {
    constexpr std::string_view set = "G54.1P", preset = "DATUM_PRESET_";
    const bool is_set = row.starts_with(set) && is_within(row.substr(set.size()), most_sets);
    const bool is_preset =
        row == "DATUM_PRESET_0" || (row.starts_with(preset) && is_within(row.substr(preset.size()), most_sets));
    if (exists(row) || is_set || is_preset) return {};
    return "its rows are EXT, G54 to G59, G59.1 to G59.9, G54.1P1, G54.1P2 and so on, and DATUM_PRESET_0, _1 and so on";
  }

  /// True for an offset that the control has, and for one that a row names.
  bool has(std::string_view id) const {
    for (const ig::Column& column : columns.linear)
      if (table.value(id, column)) return true;
    return exists(id);
  }

 private:
  static constexpr std::int64_t most_sets = 99'999;

  static bool is_within(std::string_view number, std::int64_t maximum) {
    std::int64_t n = 0;
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), n);
    return error == std::errc{} && end == number.data() + number.size() && n >= 1 && n <= maximum;
  }
  bool exists(std::string_view id) const {
    if (id == "EXT") return true;
    if (id.starts_with("G54.1P")) return is_within(id.substr(6), additional_sets);
    if (id.starts_with("G59.")) return is_within(id.substr(4), 9);
    return id.size() == 3 && id.starts_with("G5") && id[2] >= '4' && id[2] <= '9';
  }

  static ig::Column further_column(const char* axis) {
    return {axis, nullptr, "mm, deg", {}, "Origin of this axis, where the machine has it."};
  }
  const ig::Column* column_of(std::string_view axis) const {
    const std::size_t index = axis.size() == 1 ? std::string_view("UVW").find(axis[0]) : std::string_view::npos;
    return index == std::string_view::npos ? nullptr : &further[index];
  }
  static std::int32_t get_further(void* self, ig_text id, ig_text axis, double* origin) {
    const auto& own = *static_cast<const IsoCoordinateTable*>(self);
    const ig::Column* const column = own.column_of(ig::to_view(axis));
    if (column == nullptr || !own.has(ig::to_view(id))) return 0;
    *origin = own.table.value(ig::to_view(id), *column).value_or(0);
    return 1;
  }
  /// Writes only an origin that changes, so that a saved table names only axes that have one.
  static std::int32_t set_further(void* self, ig_text id, ig_text axis, double origin) {
    const auto& own = *static_cast<const IsoCoordinateTable*>(self);
    double present = 0;
    if (get_further(self, id, axis, &present) == 0 || !std::isfinite(origin)) return 0;
    return origin == present || own.table.set_value(ig::to_view(id), *own.column_of(ig::to_view(axis)), origin) ? 1 : 0;
  }

  FurtherOffsetTable further_offsets{sizeof(FurtherOffsetTable), 0, this, &get_further, &set_further};
  ig_work_offset_1 offsets = WorkOffsetService<IsoCoordinateTable>::of(this);
};

const ig::Register<IsoCoordinateTable> iso_coordinate_table;

}  // namespace
}  // namespace iso
