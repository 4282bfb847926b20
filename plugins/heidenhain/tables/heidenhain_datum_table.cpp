// A datum table, *.D: a shift a row, which cycle 7 #n adds to the preset. iTNC 530 and TNC 640 cycle programming
// manuals, "Datum shift with datum tables".
#include <cstdint>
#include <map>

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
    std::string name(table.text());
    std::map<std::int64_t, std::uint32_t> rows;
    for (std::uint32_t i = 0; i < out.rows(datums); ++i) {
      const auto key = TableKey::read(out.key(datums, i));
      if (!key) continue;
      if (name.empty()) name = key->table;
      if (key->table == name)
        rows.emplace(key->row, i);
      else
        out.unused("table " + std::string(key->table), "a file holds one table: name it by the option table");
    }
    out.write("BEGIN " + (name.empty() ? std::string("ZERO.D") : name) + (is_inch() ? " INCH\n" : " MM\n"));
    out.write(padded("D", width_of_row_number));
    for (const char axis : datum_axes) out.write(padded(std::string_view(&axis, 1), width_of_value));
    for (const auto& [number, row] : rows) {
      out.write("\n" + padded(std::to_string(number), width_of_row_number));
      for (std::size_t axis = 0; axis < datum_axes.size(); ++axis) write_cell(out, row, axis);
    }
    out.write("\n[END]\n");
  }

 private:
  bool is_inch() const { return unit == TableUnit::inch; }

  static void read_cell(ig::Import& file, const TableReader& reader, const TableCell& cell, const std::string& row) {
    const std::string& name = reader.column(cell).name;
    if (!is_datum_axis(name)) return reader.unused(cell, "no table has a place for it");
    if (!cell.is_given()) return;
    if (const std::optional<double> value = reader.number(cell, row))
      file.cell(name, name[0] >= 'X' ? reader.in_mm(*value) : *value, cell.begin);
  }

  void write_cell(ig::Export& out, std::uint32_t row, std::size_t axis) const {
    const std::string_view name = datum_axes.substr(axis, 1), text = out.cell(datums, row, name);
    const std::optional<double> value = number_of_cell(text);
    if (!value && !text.empty()) out.unused("column " + std::string(name), "it holds no number");
    const double scale = is_inch() && axis < 3 ? mm_per_inch : 1;
    out.write(padded(value ? number_text(*value / scale) : "", width_of_value));
  }
};

const ig::Register<HeidenhainDatumTable> heidenhain_datum_table;

}  // namespace
}  // namespace heidenhain
