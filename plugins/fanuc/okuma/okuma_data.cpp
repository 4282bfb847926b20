// Tool data and zero offsets of an Okuma as lists of its system variables: VTOFH[1]=120.5. Okuma OSP programming
// manual, "System variables". A list may be a program; only assignments of numbers are read, and nothing is executed.
#include <cmath>

#include <isogloss/cnc/work_offset_id.hpp>
#include <isogloss/sdk.hpp>

#include "punch_out/punched_block.hpp"

namespace fanuc {

using namespace ig::cnc;

namespace {

enum class OkumaIncrement { mm1, um10, um1 };

/// "VTOFH[12]=98.5" in its parts; the number's end is the line's.
struct Assignment {
  std::string_view name, index;
  ig::Decimal number{};
  bool is_sound = false;
};

struct OkumaData {
  static constexpr const char *tools = "ToolOffsetTable", *work = "IsoCoordinateTable";
  static constexpr auto spec = ig::importer("OkumaData", "Tool data and zero offsets of an Okuma as system variables.")
                                   .files("*.top *.zop *.min")
                                   .fills(work, tools);
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "FAN-0252",
                     "'{0}' is not the assignment of a number to a variable, so this line is left out"),
      ig::diagnostic(IG_WARNING, "FAN-0253", "{0} has an index that is not from 1 to 99999, so this line is left out"),
      ig::diagnostic(IG_WARNING, "FAN-0254", "the value of {0} is larger than a table holds, so it is left out"),
  };

  ig::Choice<OffsetUnit> unit{"unit", "unknown|mm|inch", "unknown",
                              "The unit of the control, which the file does not name; unknown: mm is assumed."};
  ig::Choice<OkumaIncrement> without_point{
      "without-point", "1mm|10um|1um", "1mm",
      "What a value without a decimal point counts, by a parameter of the control."};

  static unsigned recognise(std::string_view text, std::string_view) {
    ig::EntryCount variables;
    unsigned known = 0;
    for (const ig::TextLine& line : ig::TextLines(ig::whole_lines(text))) {
      const std::string_view code = code_of(line.text);
      if (is_frame(code)) continue;
      const Assignment found = read_assignment(code);
      variables.add(found.is_sound && found.name.starts_with('V'));
      known += found.is_sound && column_of(found.name).table != nullptr ? 1 : 0;
    }
    return known > 0 ? variables.confidence(85) : 0;
  }

  void read(ig::Import& file) const {
    PunchedUnit lengths{unit == OffsetUnit::inch, without_point != OkumaIncrement::mm1, counts_per_mm(),
                        unit == OffsetUnit::unknown};
    std::int64_t highest = 0;
    for (const ig::TextLine& line : file.lines()) read_line(file, line, lengths, highest);
    // All importers raise the size alike, so that the tables of two files agree.
    if (highest > most_shipped_offsets) file.option(tools, "size", std::to_string(most_offsets), file.text().size());
  }

 private:
  static constexpr std::int64_t most_shipped_offsets = 400, most_offsets = 99'999;
  static constexpr std::string_view blanks = " \t";

  struct Column {
    const char* table = nullptr;
    std::string_view name{};
    bool is_length = true;
  };

  static Column column_of(std::string_view variable) {
    if (variable == "VTOFH") return {tools, "H"};
    if (variable == "VTOFD") return {tools, "D"};
    constexpr std::string_view axes = "XYZABC";
    if (variable.size() != 5 || !variable.starts_with("VZOF") || axes.find(variable[4]) == std::string_view::npos)
      return {};
    return {work, variable.substr(4), !is_rotary(variable[4])};
  }

  double counts_per_mm() const {
    return without_point == OkumaIncrement::mm1 ? 1 : without_point == OkumaIncrement::um10 ? 100 : 1000;
  }

  /// Without comments, a sequence number and the blanks around; the whole line where more stands behind a comment.
  static std::string_view code_of(std::string_view line) {
    line = behind_comments(line);
    if (line.starts_with('N')) {
      const std::size_t end = std::min(line.find_first_not_of("0123456789", 1), line.size());
      if (end > 1) line = behind_comments(line.substr(end));
    }
    const std::size_t comment = std::min(line.find('('), line.size());
    return behind_comments(line.substr(comment)).empty() ? trimmed(line.substr(0, comment)) : line;
  }
  static std::string_view behind_comments(std::string_view text) {
    text = trimmed(text);
    while (text.starts_with('(')) text = trimmed(text.substr(std::min(text.find(')'), text.size() - 1) + 1));
    return text;
  }
  static std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
  }
  /// Heads ($TOOL.TOP%), names of programs (O1000, OTOOL) and their ends.
  static bool is_frame(std::string_view code) {
    if (code.empty() || code.starts_with('$') || code.starts_with('%')) return true;
    constexpr std::string_view of_name = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    const bool is_name = code.find_first_not_of(of_name, 1) == std::string_view::npos;
    return (code[0] == 'O' && is_name) || code == "M2" || code == "M02" || code == "M30" || code == "RTS";
  }

  static Assignment read_assignment(std::string_view code) {
    const std::size_t equals = code.find('=');
    if (equals == std::string_view::npos) return {};
    Assignment out;
    out.name = trimmed(code.substr(0, equals));
    const std::size_t bracket = out.name.find('[');
    if (bracket != std::string_view::npos) {
      if (!out.name.ends_with(']')) return {};
      out.index = trimmed(out.name.substr(bracket + 1, out.name.size() - bracket - 2));
      out.name = trimmed(out.name.substr(0, bracket));
    }
    const std::string_view value = trimmed(code.substr(equals + 1));
    out.number = ig::read_decimal(value, 0);
    const bool is_name = !out.name.empty() && out.name.find_first_of(" []=+-*/") == std::string_view::npos;
    out.is_sound = is_name && out.number.ok && out.number.end == value.size();
    return out;
  }

  static void read_line(ig::Import& file, const ig::TextLine& line, PunchedUnit& lengths, std::int64_t& highest) {
    const std::string_view code = code_of(line.text);
    if (is_frame(code)) return;
    const std::size_t begin = line.begin + static_cast<std::size_t>(code.data() - line.text.data());
    const std::size_t end = begin + code.size();
    const Assignment found = read_assignment(code);
    if (!found.is_sound) return file.report(ig::diag("FAN-0252"), begin, end, shown_part(code));
    const Column column = column_of(found.name);
    if (column.table == nullptr)
      return file.unused("variable " + shown_variable(found.name), "no table has a place for it", begin, end);
    const ig::Decimal index = ig::read_decimal(found.index, 0);
    const auto row = index.ok && index.end == found.index.size() ? whole_number(index.value) : std::nullopt;
    if (!row || *row < 1 || *row > most_offsets)
      return file.report(ig::diag("FAN-0253"), begin, end, shown_part(code.substr(0, code.find('='))));
    const double value =
        column.is_length ? in_mm(file, found.number, lengths, begin, end) : lengths.degrees(found.number);
    if (!(std::abs(value) <= 1e9))  // that of the tables
      return file.report(ig::diag("FAN-0254"), begin, end, shown_part(code.substr(0, code.find('='))));
    if (column.table == tools) {
      highest = std::max(highest, *row);
      file.row(tools, *row, begin);
    } else {
      file.row(work, WorkOffsetId::additional(static_cast<double>(*row)).text(), begin);
    }
    file.cell(column.name, value, begin);
  }

  static double in_mm(ig::Import& file, const ig::Decimal& number, PunchedUnit& lengths, std::size_t begin,
                      std::size_t end) {
    PunchedWord word;
    word.number = number;
    word.begin = begin;
    word.end = end;
    return lengths.mm(file, word);
  }

  /// VC12 and VC13 are named once, as VC.
  static std::string shown_variable(std::string_view name) {
    const std::size_t digits = name.find_first_of("0123456789");
    return std::string(shown_part(name.substr(0, digits)));
  }
};

const ig::Register<OkumaData> okuma_data;

}  // namespace
}  // namespace fanuc
