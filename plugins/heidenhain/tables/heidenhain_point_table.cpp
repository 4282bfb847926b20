// A point table, *.PNT: a position a row, for CYCL CALL PAT. iTNC 530 cycle programming manual, "Point tables".
#include <cstdint>
#include <span>

#include "tables/table_reader.hpp"

namespace heidenhain {

namespace {

constexpr std::int64_t highest_point = 99'999;

bool is_length_of_point(std::string_view name) {
  return name == "X" || name == "Y" || name == "Z" || name == "CLEARANCE";
}

struct HeidenhainPointTable {
  static constexpr auto spec =
      ig::importer("HeidenhainPointTable", "A point table of a TNC, *.PNT.").files("*.pnt").fills("HeidenhainPoints");

  ig::Choice<TableUnit> unit{"unit", "as-written|mm|inch", "as-written",
                             "The unit of a table whose first line names none."};

  static unsigned recognise(std::string_view text, std::string_view) {
    return read_table_head(text, true).kind == TableKind::points ? 90 : 0;
  }

  void read(ig::Import& file) const {
    TableReader table(file, TableKind::points, unit, is_length_of_point);
    const std::string name(file.file_name());
    table.rows([&](const std::vector<TableCell>& cells) {
      const std::optional<std::string> number = table.row_number(cells, highest_point, 0);
      if (!number) return;
      file.row("HeidenhainPoints", name + "#" + *number, cells[0].begin);
      for (const TableCell& cell : std::span(cells).subspan(1)) read_cell(file, table, cell, *number);
    });
  }

 private:
  static void read_cell(ig::Import& file, const TableReader& table, const TableCell& cell, const std::string& row) {
    const std::string& name = table.column(cell).name;
    if (name == "FADE") return read_fade(file, table, cell, row);
    if (!is_length_of_point(name)) return table.unused(cell, "no table has a place for it");
    if (!cell.is_given()) return;
    if (const std::optional<double> value = table.number(cell, row))
      file.cell(name == "CLEARANCE" ? "Clearance" : name, table.in_mm(*value), cell.begin);
  }

  /// Y, in German J, or 1; N, 0 and nothing run the point. Another text is reported.
  static void read_fade(ig::Import& file, const TableReader& table, const TableCell& cell, const std::string& row) {
    const std::string_view text = cell.text;
    if (!cell.is_given() || text == "N" || text == "n") return;
    const bool is_yes = text == "Y" || text == "y" || text == "J" || text == "j";
    const std::optional<double> value = is_yes ? std::optional(1.0) : table.number(cell, row);
    if (value && *value != 0) file.cell("Fade", 1.0, cell.begin);
  }
};

const ig::Register<HeidenhainPointTable> heidenhain_point_table;

}  // namespace
}  // namespace heidenhain
