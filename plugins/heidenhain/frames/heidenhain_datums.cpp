// The datum tables of a machine: files of datum shifts, of which a program selects one with SEL TABLE and a row of it
// with cycle 7. iTNC 530 and TNC 640 cycle programming manuals, "Datum shift with datum tables".
#include <array>
#include <set>
#include <string>

#include <isogloss/rows.hpp>
#include <isogloss/sdk.hpp>

#include "frames/datum_tables.hpp"

namespace heidenhain {

namespace {

constexpr std::size_t datum_axis_count = 6;

enum class EmptyCell { keep, zero };

struct HeidenhainDatums {
  static constexpr auto spec = ig::dependency("HeidenhainDatums", "Datum tables: shifts that cycle 7 selects by row.")
                                   .rows("Datum", "id")
                                   .provides(datum_table_service);

  ig::TextOption standard{"standard", "", "The table that is in force before SEL TABLE; none: the only one."};
  ig::Choice<EmptyCell> empty_cell{
      "empty-cell", "keep|zero", "keep",
      "What a row without a value does to the axis: its shift stays in force, or it becomes 0."};
  std::array<ig::Column, datum_axis_count> axes{ig::Column{"X", nullptr, "mm", {-1e9, 1e9}, "Shift of X."},
                                                ig::Column{"Y", nullptr, "mm", {}, "Shift of Y."},
                                                ig::Column{"Z", nullptr, "mm", {-1e9, 1e9}, "Shift of Z."},
                                                ig::Column{"A", nullptr, "deg", {-1e9, 1e9}, "Shift of A."},
                                                ig::Column{"B", nullptr, "deg", {-1e9, 1e9}, "Shift of B."},
                                                ig::Column{"C", nullptr, "deg", {}, "Shift of C."}};
  ig::Table table;
  ig::RowNames names;
  DatumTables tables;
  std::set<std::string> repeated;

  HeidenhainDatums() {
    tables.mark(standard.text());
    for (const std::string& name : names)
      if (const auto key = TableKey::read(name); key && !tables.add(*key, row(name))) repeated.insert(name);
  }

  const void* service(std::string_view id) const { return id == datum_table_service ? &tables : nullptr; }

  std::string row_fault(std::string_view name) const {
    if (!TableKey::read(name)) return "its id is the name of a table, # and the number of a row, as ZERO.D#5";
    if (repeated.count(std::string(name)) != 0) return "another row has the same table and number";
    return "";
  }

 private:
  DatumRow row(std::string_view name) const {
    DatumRow out;
    out.name = name;
    for (std::size_t axis = 0; axis < datum_axis_count; ++axis)
      if (const auto value = table.value(name, axes[axis]); value || empty_cell == EmptyCell::zero) {
        out.mask |= 1u << axis;
        out.value[axis] = value.value_or(0);
      }
    return out;
  }
};

const ig::Register<HeidenhainDatums> heidenhain_datums;

}  // namespace

}  // namespace heidenhain
