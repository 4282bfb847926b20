// A table of tools as comma-separated values, as spreadsheets and CAM systems write it: the first line names the
// columns.
#include <array>
#include <cmath>
#include <vector>

#include <isogloss/cnc/file_length.hpp>
#include <isogloss/cnc/units.hpp>
#include <isogloss/sdk.hpp>

#include "csv_text.hpp"
#include "file_unit.hpp"
#include "tool_rows.hpp"

namespace tables {

namespace {

struct CsvTools {
  static constexpr auto spec =
      ig::importer("CsvTools", "A table of tools as comma-separated values.").files("*.csv").fills("ToolOffsetTable");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "TAB-0106", "'{0}' is no number that column {1} can hold, so it is left out"),
      ig::diagnostic(IG_ERROR, "TAB-0107",
                     "the first line names no column for the number of the tool, so the file is not read"),
      ig::diagnostic(IG_WARNING, "TAB-0108",
                     "this row has more fields than the first line has columns, so it is left out: check its commas"),
  };

  ig::Choice<FileUnit> unit{
      "unit", "unknown|mm|inch", "unknown",
      "The unit of columns whose head names none, as 'Length (mm)' does; unknown: mm is assumed."};

  static unsigned recognise(std::string_view text, std::string_view name) {
    for (const ig::TextLine& line : ig::TextLines(text)) {
      if (is_blank_csv(line.text)) continue;
      bool has_number = false, has_size = false;
      const char separator = csv_separator(line.text);
      for (const CsvField& field : csv_fields(line, separator)) {
        const CsvTarget target = csv_head(field.text).target;
        has_number = has_number || target == CsvTarget::number;
        has_size = has_size || (target >= CsvTarget::length && target <= CsvTarget::diameter_wear);
      }
      const bool is_named = name.ends_with(".csv") || name.ends_with(".CSV");
      return separator == '\0' || !has_number || !has_size ? 0 : is_named ? 60 : 40;
    }
    return 0;
  }

  void read(ig::Import& file) const {
    std::vector<CsvHead> heads;
    ToolRows rows(file);
    FileLengths lengths(file, unit);
    char separator = '\0';
    for (const ig::TextLine& line : file.lines()) {
      if (is_blank_csv(line.text)) continue;
      if (!heads.empty()) {
        read_row(file, rows, lengths, heads, line, separator);
        continue;
      }
      separator = csv_separator(line.text);
      heads = read_heads(file, line, separator);
      const auto is_number = [](const CsvHead& head) { return head.target == CsvTarget::number; };
      if (std::none_of(heads.begin(), heads.end(), is_number))
        return file.report(ig::diag("TAB-0107"), line.begin, line.begin + line.text.size());
    }
    rows.finish();
  }

  void write(ig::Export& out) const {
    struct Column {
      const char *name, *title;
      bool is_length;
    };
    static constexpr std::array columns{Column{"H", "length", true},
                                        Column{"HWear", "length wear", true},
                                        Column{"D", "radius", true},
                                        Column{"DWear", "radius wear", true},
                                        Column{"CornerRadius", "corner radius", true},
                                        Column{"TipAngle", "tip angle", false},
                                        Column{"Teeth", "teeth", false},
                                        Column{"MaximumSpeed", "maximum speed", false}};
    const std::string_view suffix = unit == FileUnit::inch ? " (inch)" : " (mm)";
    out.write("number");
    for (const Column& c : columns) {
      out.write(std::string(",") + c.title);
      if (c.is_length) out.write(suffix);
    }
    out.write(",name\n");
    for (std::uint32_t row = 0; row < out.rows("ToolOffsetTable"); ++row) {
      std::string line(out.key("ToolOffsetTable", row));
      for (const Column& c : columns) {
        const std::string_view cell = out.cell("ToolOffsetTable", row, c.name);
        line += "," + (c.is_length ? value_of(cell) : std::string(cell));
      }
      line += "," + quoted(out.cell("ToolOffsetTable", row, "Name"));
      out.write(line + "\n");
    }
  }

 private:
  static std::vector<CsvHead> read_heads(ig::Import& file, const ig::TextLine& line, char separator) {
    std::vector<CsvHead> out;
    std::vector<std::string_view> known;
    for (const CsvField& field : csv_fields(line, separator)) {
      CsvHead head = csv_head(field.text);
      const std::string_view column = csv_column(head.target);
      const bool is_repeated = !column.empty() && std::find(known.begin(), known.end(), column) != known.end();
      if (!is_repeated && !column.empty()) known.push_back(column);
      if (is_repeated) head.target = CsvTarget::none;
      if (head.target == CsvTarget::none && !field.text.empty())
        file.unused("column " + field.text, is_repeated ? "an earlier column is read" : "no table has a place for it",
                    field.begin, field.end);
      out.push_back(std::move(head));
    }
    return out;
  }

  static void read_row(ig::Import& file, ToolRows& rows, FileLengths& lengths, const std::vector<CsvHead>& heads,
                       const ig::TextLine& line, char separator) {
    const std::vector<CsvField> fields = csv_fields(line, separator);
    const std::size_t count = std::min(heads.size(), fields.size()), end = line.begin + line.text.size();
    for (std::size_t i = count; i < fields.size(); ++i)
      if (!fields[i].text.empty()) return file.report(ig::diag("TAB-0108"), line.begin, end);
    std::string key, number;
    for (std::size_t i = 0; i < count; ++i)
      if (heads[i].target == CsvTarget::number) key = ToolRows::key_of(number = fields[i].text);
    if (key.empty()) return file.report(ig::diag("TAB-0104"), line.begin, end, number);
    rows.begin(key, line.begin, end);
    for (std::size_t i = 0; i < count; ++i) read_cell(file, lengths, heads[i], fields[i]);
  }

  static void read_cell(ig::Import& file, FileLengths& lengths, const CsvHead& head, const CsvField& field) {
    if (field.text.empty() || head.target == CsvTarget::none || head.target == CsvTarget::number) return;
    if (head.target == CsvTarget::name) return file.cell("Name", field.text, field.begin);
    std::string digits = field.text;
    if (digits.find('.') == std::string::npos) std::replace(digits.begin(), digits.end(), ',', '.');
    const ig::Decimal n = ig::read_decimal(digits, 0);
    constexpr double largest = 1e15;  // a damaged file has longer numbers; their products may not be finite
    if (!n.ok || n.end != digits.size() || std::abs(n.value) > largest)
      return file.report(ig::diag("TAB-0106"), field.begin, field.end, field.text, head.title);
    if (!(n.value >= csv_least(head.target) && n.value <= csv_most(head.target)))
      return file.report(ig::diag("TAB-0106"), field.begin, field.end, field.text, head.title);
    const bool is_length = head.target < CsvTarget::tip_angle;
    if (!is_length) return file.cell(csv_column(head.target), n.value, field.begin);
    const bool is_diameter = head.target == CsvTarget::diameter || head.target == CsvTarget::diameter_wear;
    const double mm = head.is_inch ? ig::cnc::length_in_mm(n.value, *head.is_inch ? ig::cnc::mm_per_inch : 1)
                                   : lengths.mm(n.value, field.begin, field.end);
    file.cell(csv_column(head.target), mm / (is_diameter ? 2 : 1), field.begin);
  }

  // ---- writing

  std::string value_of(std::string_view cell) const {
    const ig::Decimal n = ig::read_decimal(cell, 0);
    if (!n.ok || n.end != cell.size()) return {};
    if (unit != FileUnit::inch) return std::string(cell);
    return ig::cnc::fixed_text(ig::cnc::length_in_unit(n.value, ig::cnc::mm_per_inch));
  }
  static std::string quoted(std::string_view name) {
    if (name.find_first_of(",;\"\t") == std::string_view::npos) return std::string(name);
    std::string out = "\"";
    for (const char c : name) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + '"';
  }
};

const ig::Register<CsvTools> csv_tools;

}  // namespace
}  // namespace tables
