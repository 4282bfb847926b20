// TOOL.T: a tool a row. iTNC 530 and TNC 640 user's manuals, "Entering tool data in tables".
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/cnc/units.hpp>

#include "tables/table_reader.hpp"
#include "tables/table_text.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

constexpr std::int64_t highest_tool = 32'767, highest_index = 99;
constexpr std::size_t longest_tool_name = 32;
constexpr double first_type_of_sinumerik = 100;

struct ToolColumn {
  const char* ours;
  const char* name;
  bool is_length = true;
  bool is_written_always = true;
  double least = -1e9, most = 1e9;
  bool is_none_at_zero = false;
};
constexpr ToolColumn tool_columns[] = {{"H", "L"},
                                       {"D", "R"},
                                       {"HWear", "DL"},
                                       {"DWear", "DR"},
                                       {"CornerRadius", "R2", true, false, 0},
                                       {"CornerRadiusWear", "DR2", true, false},
                                       {"TipAngle", "T-ANGLE", false, false, 0, 180, true},
                                       {"Teeth", "CUT", false, false, 0, 1000, true},
                                       {"MaximumSpeed", "NMAX", false, false, 0, 1e9, true},
                                       {"Type", "TYP", false, false, 0, 9999},
                                       {"CuttingLength", "LCUTS", true, false, 0, 1e9, true},
                                       {"PlungeAngle", "ANGLE", false, false, 0, 90, true},
                                       {"Life", "TIME1", false, false, 0, 1e9, true},
                                       {"LifeAtCall", "TIME2", false, false, 0, 1e9, true},
                                       {"UsedLife", "CUR_TIME", false, false, 0, 1e9, true}};

const ToolColumn* column_of(std::string_view name) {
  for (const ToolColumn& column : tool_columns)
    if (column.name == name || (name == "CUR.TIME" && column.ours == std::string_view("UsedLife"))) return &column;
  return nullptr;
}

struct HeidenhainToolTable {
  static constexpr auto spec = ig::importer("HeidenhainToolTable", "The tool table of a TNC, TOOL.T.")
                                   .files("TOOL.T *.t")
                                   .fills("ToolOffsetTable");

  ig::Choice<TableUnit> unit{"unit", "as-written|mm|inch", "as-written",
                             "The unit of a table whose first line names none; of a table that is written."};

  static unsigned recognise(std::string_view text, std::string_view) {
    return read_table_head(text, true).kind == TableKind::tools ? 95 : 0;
  }

  void read(ig::Import& file) const {
    TableReader table(file, TableKind::tools, unit, [](std::string_view name) { return column_of(name) != nullptr; });
    table.rows([&](const std::vector<TableCell>& cells) {
      const std::optional<std::string> number = table.row_number(cells, highest_tool, highest_index);
      if (!number) return;
      if (*number == "0" || number->starts_with("0."))
        return file.unused("tool 0", "it stands for no tool", cells[0].begin, cells[0].end());
      file.row("ToolOffsetTable", *number, cells[0].begin);
      for (const TableCell& cell : std::span(cells).subspan(1)) read_cell(file, table, cell, *number);
    });
  }

  void write(ig::Export& out) const {
    std::vector<Tool> tools;
    for (std::uint32_t i = 0; i < out.rows("ToolOffsetTable"); ++i)
      if (const Tool tool(out, i); tool.is_of_control)
        tools.push_back(tool);
      else
        out.unused("tool " + std::string(out.key("ToolOffsetTable", i)), "the control has tools 1 to 32767");
    std::stable_sort(tools.begin(), tools.end(), [](const Tool& a, const Tool& b) {
      return std::pair(a.number, a.index) < std::pair(b.number, b.index);
    });
    out.write(unit == TableUnit::inch ? "BEGIN TOOL.T INCH\n" : "BEGIN TOOL.T MM\n");
    std::string names = padded("T", width_of_row_number) + padded("NAME", longest_tool_name + 1);
    std::vector<ToolColumn> used;
    for (const ToolColumn& column : tool_columns)
      if (column.is_written_always || is_used(out, tools, column)) used.push_back(column);
    for (const ToolColumn& column : used) names += padded(column.name, width_of_value);
    out.write(names + "\n" + padded("0", width_of_row_number + longest_tool_name + 1));
    for (std::size_t i = 0; i < used.size(); ++i) out.write(padded("+0", width_of_value));
    for (const Tool& tool : tools) write_tool(out, tool, used);
    out.write("\n[END]\n");
  }

 private:
  struct Tool {
    std::uint32_t row;
    std::int64_t number = 0, index = 0;
    bool is_of_control = false;

    Tool(const ig::Export& out, std::uint32_t i) : row(i) {
      const std::string_view key = out.key("ToolOffsetTable", i);
      const char* const end = key.data() + key.size();
      auto read = std::from_chars(key.data(), end, number);
      if (read.ec == std::errc{} && read.ptr != end && *read.ptr == '.')
        read = std::from_chars(read.ptr + 1, end, index);
      is_of_control = read.ec == std::errc{} && read.ptr == end && number >= 1 && number <= highest_tool;
    }
  };

  static void read_cell(ig::Import& file, const TableReader& table, const TableCell& cell, const std::string& tool) {
    const std::string& name = table.column(cell).name;
    if (name == "NAME") {
      if (cell.is_given()) file.cell("Name", cell.text, cell.begin);
      return;
    }
    const ToolColumn* const column = column_of(name);
    if (name == "TL") return table.unused(cell, "a tool that the control has locked is called as any other");
    if (name == "RT") return table.unused(cell, "no tool wears out here, so that no sister tool replaces it");
    if (column == nullptr) return table.unused(cell, "no table has a place for it");
    if (!cell.is_given()) return;
    if (name == "TYP" && is_letter(cell.text.front())) return table.unused(cell, "only numbers of types are read");
    const std::optional<double> value = table.number(cell, tool);
    if (!value || (*value == 0 && column->is_none_at_zero)) return;
    if (!(*value >= column->least && *value <= column->most)) return table.unused(cell, "no tool has such a value");
    file.cell(column->ours, column->is_length ? table.in_mm(*value) : *value, cell.begin);
  }

  static bool is_used(ig::Export& out, const std::vector<Tool>& tools, const ToolColumn& column) {
    return std::any_of(tools.begin(), tools.end(),
                       [&](const Tool& tool) { return !out.cell("ToolOffsetTable", tool.row, column.ours).empty(); });
  }

  void write_tool(ig::Export& out, const Tool& tool, const std::vector<ToolColumn>& used) const {
    const std::string key(out.key("ToolOffsetTable", tool.row));
    out.write("\n" + padded(key, width_of_row_number) + padded(name_of(out, tool.row), longest_tool_name + 1));
    for (const ToolColumn& column : used) {
      if (column.name == std::string_view("TYP") && !has_type_of_control(out, tool)) {
        out.write(padded("", width_of_value));
        continue;
      }
      const double per_unit = column.is_length && unit == TableUnit::inch ? mm_per_inch : 1;
      out.write(written_cell(out, "ToolOffsetTable", tool.row, column.ours, per_unit));
    }
  }

  static bool has_type_of_control(ig::Export& out, const Tool& tool) {
    const std::optional<double> type = number_of_cell(out.cell("ToolOffsetTable", tool.row, "Type"));
    if (!type || (*type < first_type_of_sinumerik && *type == std::floor(*type))) return true;
    out.unused("types of another control", "the control has whole numbers up to 99");
    return false;
  }

  static std::string_view name_of(ig::Export& out, std::uint32_t row) {
    const std::string_view name = out.cell("ToolOffsetTable", row, "Name");
    const std::size_t end = after_characters(name, 0, longest_tool_name);
    if (end < name.size()) out.unused("the end of a name", "the control's names have 32 characters at most");
    return name.substr(0, end);
  }
};

const ig::Register<HeidenhainToolTable> heidenhain_tool_table;

}  // namespace
}  // namespace heidenhain
