// PRESET.PR: a preset a row. iTNC 530 and TNC 640 user's manuals, "Datum management with the preset table".
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <map>

#include <isogloss/cnc/units.hpp>

#include "tables/table_reader.hpp"
#include "tables/table_text.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

constexpr const char *origins = "IsoCoordinateTable", *rotations = "HeidenhainBasicRotations";
constexpr std::string_view prefix = "DATUM_PRESET_";
constexpr std::int64_t highest_preset = 99'999;
constexpr const char* turns_of_preset[] = {"SPA", "SPB", "SPC", "ROT"};
constexpr const char* no_place = "no table has a place for it";

bool is_turn(std::string_view name) {
  return std::find(std::begin(turns_of_preset), std::end(turns_of_preset), name) != std::end(turns_of_preset);
}
bool is_shift(std::string_view name) { return name.ends_with("_OFFS"); }
bool holds_number(std::string_view name) {
  constexpr std::string_view axes = "XYZABC";
  return is_turn(name) || is_shift(name) || (name.size() == 1 && axes.find(name[0]) != std::string_view::npos);
}

struct WrittenColumn {
  const char *name, *ours;
  bool is_rotation = false, is_length = false;
};
constexpr WrittenColumn written_columns[] = {{"X", "X", false, true}, {"Y", "Y", false, true}, {"Z", "Z", false, true},
                                             {"SPA", "SPA", true},    {"SPB", "SPB", true},    {"SPC", "SPC", true},
                                             {"A_OFFS", "A"},         {"B_OFFS", "B"},         {"C_OFFS", "C"}};

struct HeidenhainPresetTable {
  static constexpr auto spec = ig::importer("HeidenhainPresetTable", "The preset table of a TNC, PRESET.PR.")
                                   .files("PRESET.PR *.pr")
                                   .fills(origins, rotations);
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "HEI-0321",
                     "preset {0} has {1} {2}, a shift that is not executed: positions under it will be wrong"),
      ig::diagnostic(IG_WARNING, "HEI-0322",
                     "preset {0} has no {1}: a control keeps the previous datum there, and here it becomes 0"),
  };

  ig::Choice<TableUnit> unit{"unit", "as-written|mm|inch", "as-written",
                             "The unit of a table whose first line names none; of a table that is written."};

  static unsigned recognise(std::string_view text, std::string_view) {
    return read_table_head(text, true).kind == TableKind::presets ? 95 : 0;
  }

  void read(ig::Import& file) const {
    TableReader table(file, TableKind::presets, unit, holds_number);
    table.rows([&](const std::vector<TableCell>& cells) {
      const std::optional<std::string> number = table.row_number(cells, highest_preset, 0);
      if (!number) return;
      // Most rows of a table were never set.
      if (std::any_of(cells.begin(), cells.end(),
                      [&](const TableCell& c) { return c.is_given() && origin_of(table, c) != 0; }))
        begin_row(file, table, cells, *number);
      Found found;
      for (const TableCell& cell : std::span(cells).subspan(1)) read_cell(file, table, cell, *number, found);
      give_rotation(file, found, *number, cells[0].begin);
    });
  }

  void write(ig::Export& out) const {
    std::map<std::int64_t, Rows> presets;
    for (std::uint32_t i = 0; i < out.rows(origins); ++i) {
      const std::string_view key = out.key(origins, i);
      const std::optional<std::int64_t> number =
          key.starts_with(prefix) ? preset_number(key.substr(prefix.size())) : std::nullopt;
      if (number)
        presets[*number].origin = i;
      else
        out.unused("work offset that is no preset", "a preset table holds DATUM_PRESET_0 to DATUM_PRESET_99999");
    }
    for (std::uint32_t i = 0; i < out.rows(rotations); ++i)
      if (const std::optional<std::int64_t> number = preset_number(out.key(rotations, i)))
        presets[*number].rotation = i;
      else
        out.unused("basic rotation of no preset", "a preset table holds presets 0 to 99999");
    out.write(unit == TableUnit::inch ? "BEGIN PRESET.PR INCH\n" : "BEGIN PRESET.PR MM\n");
    std::string names = padded("NO", width_of_row_number);
    for (const WrittenColumn& column : written_columns) names += padded(column.name, width_of_value);
    out.write(names);
    for (const auto& [number, rows] : presets) write_preset(out, number, rows);
    out.write("\n[END]\n");
  }

 private:
  /// The rows of a preset in the two tables.
  struct Rows {
    std::optional<std::uint32_t> origin, rotation;
  };

  static std::optional<std::int64_t> preset_number(std::string_view text) {
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_number = error == std::errc{} && std::to_string(number) == text;
    return is_number && number >= 0 && number <= highest_preset ? std::optional(number) : std::nullopt;
  }

  void write_preset(ig::Export& out, std::int64_t number, const Rows& rows) const {
    out.write("\n" + padded(std::to_string(number), width_of_row_number));
    for (const WrittenColumn& column : written_columns) {
      const std::optional<std::uint32_t> row = column.is_rotation ? rows.rotation : rows.origin;
      const double per_unit = column.is_length && unit == TableUnit::inch ? mm_per_inch : 1;
      out.write(row ? written_cell(out, column.is_rotation ? rotations : origins, *row, column.ours, per_unit)
                    : padded("", width_of_value));
    }
  }

  struct Found {
    std::string axes, turns;         ///< those that have a value
    std::array<double, 3> angles{};  ///< SPA, SPB, SPC; ROT of older controls is SPC
  };

  /// The axis whose origin the cell holds, 'X' to 'Z' and 'A' to 'C'; 0 for other cells. Older controls have A, newer
  /// ones A_OFFS.
  static char origin_of(const TableReader& table, const TableCell& cell) {
    const std::string& name = table.column(cell).name;
    const bool is_rotary = name[0] >= 'A' && name[0] <= 'C';
    const bool is_linear = name[0] >= 'X' && name[0] <= 'Z';
    if (name.size() == 1 && is_linear) return name[0];
    return is_rotary && (name.size() == 1 || name.substr(1) == "_OFFS") ? name[0] : 0;
  }

  static void begin_row(ig::Import& file, const TableReader& table, const std::vector<TableCell>& cells,
                        const std::string& number) {
    std::string missing;
    for (const char axis : {'X', 'Y', 'Z'}) {
      const bool has_axis = std::any_of(
          cells.begin(), cells.end(), [&](const TableCell& c) { return c.is_given() && origin_of(table, c) == axis; });
      if (!has_axis) (missing += missing.empty() ? "" : ", ") += axis;
    }
    if (!missing.empty())
      file.report(ig::diag("HEI-0322"), cells[0].begin, cells[0].end(), number, std::string_view(missing));
    file.row(origins, std::string(prefix) + number, cells[0].begin);
  }

  static void read_cell(ig::Import& file, const TableReader& table, const TableCell& cell, const std::string& preset,
                        Found& found) {
    const std::string& name = table.column(cell).name;
    if (!cell.is_given()) return;
    if (const char axis = origin_of(table, cell); axis != 0) {
      if (found.axes.find(axis) != std::string::npos)
        return table.unused(cell, "a column before it gives the value of its axis");
      found.axes += axis;
      if (const std::optional<double> value = table.number(cell, preset))
        file.cell(std::string_view(&axis, 1), axis >= 'X' ? table.in_mm(*value) : *value, cell.begin);
      return;
    }
    if (is_turn(name)) return read_rotation(table, cell, preset, name, found);
    if (!is_shift(name)) return table.unused(cell, no_place);
    const std::optional<double> value = table.number(cell, preset);
    if (!value || *value == 0) return;
    file.report(ig::diag("HEI-0321"), cell.begin, cell.end(), preset, name, cell.text);
    table.unused(cell, no_place);
  }

  static void read_rotation(const TableReader& table, const TableCell& cell, const std::string& preset,
                            std::string_view name, Found& found) {
    const char axis = name == "ROT" ? 'C' : name[2];
    if (found.turns.find(axis) != std::string::npos)
      return table.unused(cell, "a column before it gives the same rotation");
    found.turns += axis;
    found.angles[static_cast<std::size_t>(axis - 'A')] = table.number(cell, preset).value_or(0);
  }

  static void give_rotation(ig::Import& file, const Found& found, const std::string& preset, std::size_t begin) {
    if (found.angles == std::array<double, 3>{}) return;
    file.row(rotations, preset, begin);
    for (std::size_t i = 0; i < 3; ++i)
      if (found.angles[i] != 0) file.cell(turns_of_preset[i], found.angles[i], begin);
  }
};

const ig::Register<HeidenhainPresetTable> heidenhain_preset_table;

}  // namespace
}  // namespace heidenhain
