// The variables of custom macro that a control puts out (MACRO.TXT). A current control writes each value as the bits of
// a double inside a comment, `G10L85P500(4014000000000000)`, and the names with SETVN; older files and those of Haas
// list `#500=12.5` or `N500=12.5`.
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <set>

#include <isogloss/sdk.hpp>

#include "punch_out/haas_registers.hpp"
#include "punch_out/punched_block.hpp"

namespace fanuc {

using namespace ig::cnc;

namespace {

enum class Registers { unread, haas };

struct FanucMacroVariables {
  static constexpr const char* variables = "MacroVariables";
  static constexpr auto spec =
      ig::importer("FanucMacroVariables", "Macro variables that a Fanuc or Haas control puts out.")
          .files("MACRO.TXT *.var")
          .fills(variables, "ToolOffsetTable", "IsoCoordinateTable");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "FAN-0234", "'{0}' is no variable with a value, so this line is left out"),
      ig::diagnostic(IG_WARNING, "FAN-0235", "the value '{0}' of #{1} is no number, so the variable gets no value"),
  };

  ig::Choice<Registers> registers{"registers", "unread|haas", "unread",
                                  "Variables of offsets: not read, or read as those of a Haas (#2001, #5221 …)."};
  ig::Choice<OffsetUnit> unit{"unit", "unknown|mm|inch", "unknown",
                              "The unit of offsets (Haas setting 9); unknown: mm is assumed."};
  ig::Choice<ToolRadius> tool_radius{"tool-radius", "radius|diameter", "radius",
                                     "What cutter offsets are on this Haas: setting 40."};

  static unsigned recognise(std::string_view text, std::string_view) {
    ig::EntryCount values;
    unsigned sure = 0;
    for (const ig::TextLine& line : ig::TextLines(ig::whole_lines(text))) {
      const Entry entry = read_line(line);
      // N10 alone is a vacant variable, or a sequence number.
      const bool is_open =
          entry.is_listed && entry.value.empty() && line.text.find_first_of("#=") == std::string_view::npos;
      if (entry.kind != Kind::other && (entry.kind != Kind::variable || is_open)) continue;
      const bool is_value = !entry.is_listed || is_vacant(entry.value) || number_in(entry.value);
      values.add(entry.kind == Kind::variable && is_value);
      if (sure == 0 && values.own == 1) sure = entry.is_listed ? (line.text.find('#') < 4 ? 70 : 50) : 90;
    }
    return values.confidence(sure);
  }

  void read(ig::Import& file) const {
    Values values{file, {unit == OffsetUnit::inch, false, 1, unit == OffsetUnit::unknown}, {}};
    for (const ig::TextLine& line : file.lines()) {
      const Entry entry = read_line(line);
      const std::size_t end = line.begin + line.text.size();
      switch (entry.kind) {
        case Kind::frame: break;
        case Kind::other: file.report(ig::diag("FAN-0234"), entry.begin, end, shown_part(entry.value)); break;
        case Kind::offset:
          file.unused("G10 that writes no variable", "the importer FanucOffsets reads it", entry.begin, end);
          break;
        case Kind::name:
          if (!entry.value.empty()) file.unused("name of a variable", "no table has a place for it", entry.begin, end);
          break;
        case Kind::variable: read_value(values, entry, end);
      }
    }
  }

  void write(ig::Export& out) const {
    out.write("%\n");
    for (std::uint32_t row = 0; row < out.rows(variables); ++row) {
      const std::string_view cell = out.cell(variables, row, "Value"), null = out.cell(variables, row, "Null");
      const ig::Decimal value = ig::read_decimal(cell, 0);
      if (!value.ok || value.end != cell.size() || (!null.empty() && null != "0")) {
        out.unused("empty variables", "how a control writes them is not documented");
        continue;
      }
      std::array<char, 17> bits{};
      std::snprintf(bits.data(), bits.size(), "%016llX",
                    static_cast<unsigned long long>(std::bit_cast<std::uint64_t>(value.value)));
      out.write("G10L85P" + std::string(out.key(variables, row)) + "(" + bits.data() + ")\n");
    }
    for (const char* const table : {"ToolOffsetTable", "IsoCoordinateTable"})
      if (out.rows(table) > 0) out.unused(std::string("rows of ") + table, "the format FanucOffsets has them");
    out.write("M02\n%\n");
  }

 private:
  static constexpr double largest_offset = 1e9 / mm_per_inch;  // that of the table
  enum class Kind { frame, variable, name, offset, other };
  struct Entry {
    Kind kind = Kind::frame;
    std::size_t begin = 0;
    std::int64_t number = -1;
    std::string_view value;  // of `other`: the line
    bool is_listed = false;  // as a decimal number, not as the bits of a double
  };

  struct Values {
    ig::Import& file;
    PunchedUnit unit;
    std::set<std::int64_t> vacant;
  };

  static std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(PunchedBlock::padding);
    return first == std::string_view::npos
               ? std::string_view()
               : text.substr(first, text.find_last_not_of(PunchedBlock::padding) + 1 - first);
  }

  static Entry read_line(const ig::TextLine& line) {
    const std::string_view text = trimmed(line.text);
    Entry entry{.value = text};
    if (text.empty()) return entry;
    entry.begin = line.begin + static_cast<std::size_t>(text.data() - line.text.data());
    if (text.starts_with("SETVN")) return read_name(entry, text.substr(5));
    if (text[0] == '#' || text[0] == 'N') return read_listed(entry, text.substr(1));
    PunchedBlock block;
    block.read(line);
    entry.kind = Kind::other;
    if (!block.is_sound()) return entry;
    if (!block.has('G', 10)) {
      if (block.is_frame()) entry.kind = Kind::frame;
      return entry;
    }
    if (!block.has('L', 85)) {
      entry.kind = Kind::offset;
      return entry;
    }
    const PunchedWord *const p = block.find('P'), *const r = block.find('R');
    if (p == nullptr || !p->whole()) return entry;
    return {Kind::variable, entry.begin, *p->whole(), r != nullptr ? r->digits : trimmed(block.comment()),
            r != nullptr};
  }

  /// "500[DEPTH]"
  static Entry read_name(Entry entry, std::string_view text) {
    const std::size_t open = text.find('['), close = text.find(']');
    entry.kind = close == std::string_view::npos || close < open ? Kind::other : Kind::name;
    if (entry.kind == Kind::name) entry.value = trimmed(text.substr(open + 1, close - open - 1));
    return entry;
  }

  /// "500=12.5", "500 12.5" or "500" for one that is vacant.
  static Entry read_listed(Entry entry, std::string_view text) {
    std::int64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    entry.kind = Kind::other;
    if (error != std::errc{} || number < 0 ||
        (stop != end && std::string_view(" \t=(").find(*stop) == std::string_view::npos))
      return entry;
    std::string_view value = trimmed(text.substr(static_cast<std::size_t>(stop - text.data())));
    if (value.starts_with('=')) value.remove_prefix(1);
    return {Kind::variable, entry.begin, number, trimmed(value.substr(0, value.find('('))), true};
  }

  static bool is_vacant(std::string_view value) { return value.empty() || value == "#0"; }
  static std::optional<double> number_in(std::string_view value) {
    const ig::Decimal n = ig::read_decimal(value, 0);
    return n.ok && n.end == value.size() ? std::optional(n.value) : std::nullopt;
  }
  /// A value that is not finite stands for a variable without one.
  static std::optional<double> double_of(std::string_view hex) {
    std::uint64_t bits = 0;
    const auto [stop, error] = std::from_chars(hex.data(), hex.data() + hex.size(), bits, 16);
    const bool is_whole = error == std::errc{} && hex.size() == 16 && stop == hex.data() + hex.size();
    return is_whole ? std::optional(std::bit_cast<double>(bits)) : std::nullopt;
  }

  void read_value(Values& values, const Entry& entry, std::size_t end) const {
    ig::Import& file = values.file;
    // Haas lists #100 to #999 as #10100 to #10999 too; to a Fanuc, these are tool offsets, which it does not list.
    const bool is_alias = entry.number >= 10'100 && entry.number <= 10'999;
    const std::int64_t number = is_alias ? entry.number - 10'000 : entry.number;
    if (number < 100) return file.unused("local variables", "each call of a program has its own", entry.begin, end);
    if (const auto offset = haas_register(number)) return read_offset(values, entry, end, *offset);
    if (number > 999 && (number < 98'000 || number > 999'999))
      return file.unused("system variables", "the control sets them itself", entry.begin, end);
    const bool is_empty = is_vacant(entry.value);
    const std::optional<double> value = entry.is_listed ? number_in(entry.value) : double_of(entry.value);
    if (!is_empty && !value)
      return file.report(ig::diag("FAN-0235"), entry.begin, end, shown_part(entry.value), std::to_string(number));
    file.row(variables, number, entry.begin);
    if (is_empty || !std::isfinite(*value)) {
      values.vacant.insert(number);
      return file.cell("Null", 1., entry.begin);
    }
    file.cell("Value", *value, entry.begin);
    if (values.vacant.erase(number) != 0) file.cell("Null", 0., entry.begin);
  }

  void read_offset(Values& values, const Entry& entry, std::size_t end, const HaasRegister& offset) const {
    ig::Import& file = values.file;
    if (registers == Registers::unread)
      return file.unused("variables of offsets", "option registers tells what they are", entry.begin, end);
    const std::optional<double> value = entry.is_listed ? number_in(entry.value) : double_of(entry.value);
    if (!value || !(std::abs(*value) <= largest_offset))
      return file.report(ig::diag("FAN-0235"), entry.begin, end, shown_part(entry.value), std::to_string(entry.number));
    file.row(offset.table, offset.row, entry.begin);
    const double mm = offset.is_length ? values.unit.mm(file, *value, entry.begin, end) : *value;
    file.cell(offset.column, offset.is_radius && tool_radius == ToolRadius::diameter ? mm / 2 : mm, entry.begin);
  }
};

const ig::Register<FanucMacroVariables> fanuc_macro_variables;

}  // namespace
}  // namespace fanuc
