// A datum table, *.D: a shift a row, which cycle 7 #n adds to the preset. iTNC 530 and TNC 640 cycle programming
// manuals, "Datum shift with datum tables".
#include <cstdint>

#include <isogloss/cnc/units.hpp>

#include "tables/named_tables.hpp"
#include "tables/table_reader.hpp"
#include "tables/table_text.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

constexpr const char* datums = "HeidenhainDatums";
constexpr std::string_view datum_axes = "XYZABC";
constexpr std::int64_t highest_datum_row = 99'999;

bool is_datum_axis(std::string_view name) {
  return name.size() == 1 && datum_axes.find(name[0]) != std::string_view::npos;
}

struct HeidenhainDatumTable {
  static constexpr auto spec =
      ig::importer("HeidenhainDatumTable", "A datum table of a TNC, *.D.").files("*.d").fills(datums);

  ig::Choice<TableUnit> unit{"unit", "as-written|mm|inch", "as-written",
                             "The unit of a table whose first line names none; of a table that is written."};
  ig::TextOption table{"table", "", "The table that is written; none: the first one."};

  static unsigned recognise(std::string_view text, std::string_view) {
    return read_table_head(text, true).kind == TableKind::datums ? 90 : 0;
  }

  void read(ig::Import& file) const {
    TableReader reader(file, TableKind::datums, unit, is_datum_axis);
    const std::string name(file.file_name());
    reader.rows([&](const std::vector<TableCell>& cells) {
      const std::optional<std::string> number = reader.row_number(cells, highest_datum_row, 0);
      if (!number) return;
      file.row(datums, name + "#" + *number, cells[0].begin);
      for (const TableCell& cell : std::span(cells).subspan(1)) read_cell(file, reader, cell, *number);
    });
  }

  void write(ig::Export& out) const {
    const WrittenTable written = written_table(out, datums, table.text());
    const double per_length = unit == TableUnit::inch ? mm_per_inch : 1;
    out.write("BEGIN " + (written.name.empty() ? std::string("ZERO.D") : written.name) +
              (unit == TableUnit::inch ? " INCH\n" : " MM\n"));
    out.write(padded("D", width_of_row_number));
    for (const char axis : datum_axes) out.write(padded({&axis, 1}, width_of_value));
    for (const auto& [number, row] : written.rows) {
      out.write("\n" + padded(std::to_string(number), width_of_row_number));
      for (const char axis : datum_axes)
        out.write(written_cell(out, datums, row, {&axis, 1}, axis >= 'X' ? per_length : 1));
    }
    out.write("\n[END]\n");
  }

 private:
  static void read_cell(ig::Import& file, const TableReader& reader, const TableCell& cell, const std::string& row) {
    const std::string& name = reader.column(cell).name;
    if (!is_datum_axis(name)) return reader.unused(cell, "no table has a place for it");
    if (!cell.is_given()) return;
    if (const std::optional<double> value = reader.number(cell, row))
      file.cell(name, name[0] >= 'X' ? reader.in_mm(*value) : *value, cell.begin);
  }
};

const ig::Register<HeidenhainDatumTable> heidenhain_datum_table;

}  // namespace
}  // namespace heidenhain
