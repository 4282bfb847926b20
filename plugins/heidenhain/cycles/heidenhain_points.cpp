// The point tables of a machine: files of positions, at which CYCL CALL PAT runs a cycle. iTNC 530 cycle programming
// manual, "Point tables".
#include <array>
#include <set>
#include <string>

#include <isogloss/rows.hpp>
#include <isogloss/sdk.hpp>

#include "cycles/point_tables.hpp"

namespace heidenhain {

namespace {

struct HeidenhainPoints {
  static constexpr auto spec = ig::dependency("HeidenhainPoints", "Point tables: positions for CYCL CALL PAT.")
                                   .rows("Point", "id")
                                   .provides(point_table_service);

  std::array<ig::Column, 3> axes{
      ig::Column{"X", nullptr, "mm", {-1e9, 1e9}, "Position."},
      ig::Column{"Y", nullptr, "mm", {-1e9, 1e9}, "Position."},
      ig::Column{"Z", nullptr, "mm", {-1e9, 1e9}, "Added to the surface of the cycle; none: 0."}};
  ig::Column fade{"Fade", "0", "", {0, 1}, "1: the point is not run."};
  ig::Column clearance{"Clearance", nullptr, "mm", {-1e9, 1e9}, "Height at which the tool comes to the point."};
  ig::Table table;
  ig::RowNames names;
  PointTables tables;
  std::set<std::string> repeated;

  HeidenhainPoints() {
    for (const std::string& name : names)
      if (const auto key = TableKey::read(name); key && !tables.add(*key, row(name))) repeated.insert(name);
  }

  const void* service(std::string_view id) const { return id == point_table_service ? &tables : nullptr; }

  std::string row_fault(std::string_view name) const {
    if (!TableKey::read(name)) return "its id is the name of a table, # and the number of a row, as HOLES.PNT#5";
    return repeated.count(std::string(name)) != 0 ? "another row has the same table and number" : "";
  }

 private:
  TablePoint row(std::string_view name) const {
    TablePoint out;
    out.name = name;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) out.position[axis] = table.value(name, axes[axis]);
    out.clearance = table.value(name, clearance);
    out.is_faded = table.value(name, fade).value_or(0) != 0;
    return out;
  }
};

const ig::Register<HeidenhainPoints> heidenhain_points;

}  // namespace
}  // namespace heidenhain
