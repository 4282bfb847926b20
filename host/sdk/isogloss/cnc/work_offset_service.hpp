/// The columns of a table of work offsets, and the service isogloss.work-offset/1 from such a table. Lengths in mm,
/// angles in degrees.
#pragma once

#include <array>

#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// A member of each table of work offsets, declared before the table itself.
struct WorkOffsetColumns {
  std::array<Column, 3> linear{Column{"X", "0", "mm", {}, "Origin in machine coordinates."},
                               Column{"Y", "0", "mm", {}, "Origin in machine coordinates."},
                               Column{"Z", "0", "mm", {}, "Origin in machine coordinates."}};
  std::array<Column, 3> rotary{
      Column{"A", nullptr, "deg", {-1e9, 1e9}, "Angle of the machine at which the program counts 0."},
      Column{"B", nullptr, "deg", {-1e9, 1e9}, "Angle of the machine at which the program counts 0."},
      Column{"C", nullptr, "deg", {-1e9, 1e9}, "Angle of the machine at which the program counts 0."}};
};

/// `Table` has the members `columns` and `table`, and `bool has(std::string_view id) const`, which tells whether the
/// control has such an offset. An offset that the control has but no row names is at machine zero.
template <class Table>
struct WorkOffsetService {
  static ig_work_offset_1 of(Table* table) {
    return {sizeof(ig_work_offset_1), 0, table, &get, &set, &get_rotary, &set_rotary};
  }

 private:
  static const Table& self_of(void* self) { return *static_cast<const Table*>(self); }

  static std::int32_t read(const Table& t, ig_text id, const std::array<Column, 3>& columns, double* offset) {
    const std::string_view row = to_view(id);
    if (!t.has(row)) return 0;
    for (std::size_t axis = 0; axis < 3; ++axis) offset[axis] = t.table.value(row, columns[axis]).value_or(0);
    return 1;
  }
  static std::int32_t get(void* self, ig_text id, double offset[3]) {
    return read(self_of(self), id, self_of(self).columns.linear, offset);
  }
  static std::int32_t set(void* self, ig_text id, const double offset[3]) {
    const Table& t = self_of(self);
    const std::string_view row = to_view(id);
    if (!t.has(row)) return 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!t.table.set_value(row, t.columns.linear[axis], offset[axis])) return 0;
    return 1;
  }
  static std::int32_t get_rotary(void* self, ig_text id, double offset[3]) {
    return read(self_of(self), id, self_of(self).columns.rotary, offset);
  }
  /// Writes only axes whose origin changes, so that a saved table names only axes that have an origin.
  static std::int32_t set_rotary(void* self, ig_text id, const double offset[3]) {
    const Table& t = self_of(self);
    double present[3];
    if (get_rotary(self, id, present) == 0) return 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (offset[axis] != present[axis] && !t.table.set_value(to_view(id), t.columns.rotary[axis], offset[axis]))
        return 0;
    return 1;
  }
};

}  // namespace ig::cnc
