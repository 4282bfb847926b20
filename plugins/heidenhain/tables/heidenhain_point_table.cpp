// A point table, *.PNT: a position a row, for CYCL CALL PAT. iTNC 530 cycle programming manual, "Point tables".
#include <cstdint>
#include <span>

#include <isogloss/cnc/units.hpp>

#include "tables/named_tables.hpp"
#include "tables/table_reader.hpp"
#include "tables/table_text.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

constexpr const char* points = "HeidenhainPoints";
constexpr std::int64_t highest_point = 99'999;

bool is_length_of_point(std::string_view name) {
  return name == "X" || name == "Y" || name == "Z" || name == "CLEARANCE";
}

struct HeidenhainPointTable {
  static constexpr auto spec =
      ig::importer("HeidenhainPointTable", "A point table of a TNC, *.PNT.").files("*.pnt").fills(points);

  ig::Choice<TableUnit> unit{"unit", "as-written|mm|inch", "as-written",
                             "The unit of a table whose first line names none; of a table that is written."};
  ig::TextOption table{"table", "", "The table that is written; none: the first one."};

  static unsigned recognise(std::string_view text, std::string_view) {
    return read_table_head(text, true).kind == TableKind::points ? 90 : 0;
  }

  void read(ig::Import& file) const {
    TableReader reader(file, TableKind::points, unit, is_length_of_point);
    const std::string name(file.file_name());
    reader.rows([&](const std::vector<TableCell>& cells) {
      const std::optional<std::string> number = reader.row_number(cells, highest_point, 0);
      if (!number) return;
      file.row(points, name + "#" + *number, cells[0].begin);
      for (const TableCell& cell : std::span(cells).subspan(1)) read_cell(file, reader, cell, *number);
    });
  }

  void write(ig::Export& out) const {
    const WrittenTable written = written_table(out, points, table.text());
    const double per_length = unit == TableUnit::inch ? mm_per_inch : 1;
    out.write("BEGIN " + (written.name.empty() ? std::string("POINTS.PNT") : written.name) +
              (unit == TableUnit::inch ? " INCH\n" : " MM\n"));
    out.write(padded("NR", width_of_row_number));
    for (const char* const name : {"X", "Y", "Z"}) out.write(padded(name, width_of_value));
    out.write(padded("FADE", width_of_fade) + "CLEARANCE");
    for (const auto& [number, row] : written.rows) {
      out.write("\n" + padded(std::to_string(number), width_of_row_number));
      for (const char* const name : {"X", "Y", "Z"}) out.write(written_cell(out, points, row, name, per_length));
      const std::string_view fade = out.cell(points, row, "Fade");
      const std::optional<double> is_left_out = number_of_cell(fade);
      if (!is_left_out && !fade.empty()) out.unused("column Fade", "it holds no number");
      out.write(padded(is_left_out.value_or(0) != 0 ? "Y" : "N", width_of_fade));
      out.write(written_cell(out, points, row, "Clearance", per_length));
    }
    out.write("\n[END]\n");
  }

 private:
  static constexpr std::size_t width_of_fade = 5;

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
