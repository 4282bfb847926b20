// The datum tables of a machine: files of datum shifts, of which a program selects one with SEL TABLE and a row of it
// with cycle 7. iTNC 530 and TNC 640 cycle programming manuals, "Datum shift with datum tables".
#include <algorithm>
#include <charconv>
#include <set>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/rows.hpp>
#include <isogloss/sdk.hpp>

#include "frames/datum_tables.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

constexpr std::size_t datum_axis_count = 6;

std::string_view without_folder(std::string_view path) {
  const std::size_t slash = path.find_last_of("\\/:");
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

std::string capitals_of(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), [](char c) { return to_upper(c); });
  return out;
}

std::string_view without_ending(std::string_view name) { return name.substr(0, name.rfind('.')); }

enum class EmptyCell { keep, zero };

struct HeidenhainDatums {
  static constexpr auto spec = ig::dependency("HeidenhainDatums", "Datum tables: shifts that cycle 7 selects by row.")
                                   .rows("Datum", "id")
                                   .provides(datum_table_service);

  ig::TextOption standard{"standard", "", "The table that is in force before SEL TABLE; none: the only one."};
  ig::Choice<EmptyCell> empty_cell{
      "empty-cell", "keep|zero", "keep",
      "What a row without a value does to the axis: its shift stays in force, or it becomes 0."};
  std::array<ig::Column, datum_axis_count> axes{
      ig::Column{"X", nullptr, "mm", {}, "Shift of X."},  ig::Column{"Y", nullptr, "mm", {}, "Shift of Y."},
      ig::Column{"Z", nullptr, "mm", {}, "Shift of Z."},  ig::Column{"A", nullptr, "deg", {}, "Shift of A."},
      ig::Column{"B", nullptr, "deg", {}, "Shift of B."}, ig::Column{"C", nullptr, "deg", {}, "Shift of C."}};
  ig::Table table;
  ig::RowNames names;
  DatumTables tables;
  std::set<std::string> repeated;

  HeidenhainDatums() {
    tables.mark(standard.text());
    for (const std::string& name : names)
      if (const auto key = DatumKey::read(name); key && !tables.add(*key, row(name))) repeated.insert(name);
  }

  const void* service(std::string_view id) const { return id == datum_table_service ? &tables : nullptr; }

  std::string row_fault(std::string_view name) const {
    if (!DatumKey::read(name)) return "its id is the name of a table, # and the number of a row, as ZERO.D#5";
    if (repeated.count(std::string(name)) != 0) return "another row has the same table and number";
    return "";
  }

 private:
  DatumRow row(std::string_view name) const {
    DatumRow out;
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

std::optional<DatumKey> DatumKey::read(std::string_view key) {
  const std::size_t mark = key.rfind('#');
  if (mark == std::string_view::npos || mark == 0 || without_folder(key.substr(0, mark)).size() != mark)
    return std::nullopt;
  DatumKey out{key.substr(0, mark), 0};
  const char* const end = key.data() + key.size();
  const auto [read, error] = std::from_chars(key.data() + mark + 1, end, out.row);
  const bool is_number = error == std::errc{} && read == end && out.row >= 0;
  return is_number && std::to_string(out.row) == key.substr(mark + 1) ? std::optional(out) : std::nullopt;
}

const DatumTable* DatumTables::find(std::string_view path) const {
  const std::string name = capitals_of(without_folder(path));
  if (const auto found = tables_.find(name); found != tables_.end()) return &found->second;
  const auto found = without_ending_.find(name);
  return found != without_ending_.end() ? found->second : nullptr;
}

const DatumTable* DatumTables::standard() const {
  if (!marked_.empty()) return find(marked_);
  return tables_.size() == 1 ? &tables_.begin()->second : nullptr;
}

bool DatumTables::add(const DatumKey& key, const DatumRow& row) {
  const std::string name = capitals_of(key.table);
  DatumTable& table = tables_[name];
  if (table.name.empty()) {
    table.name = key.table;
    without_ending_.emplace(without_ending(name), &table);
  }
  return table.rows.emplace(key.row, row).second;
}

}  // namespace heidenhain
