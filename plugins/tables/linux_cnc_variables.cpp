// The parameter file of LinuxCNC (linuxcnc.var): the number and the value of a variable in each line. LinuxCNC manual,
// "Numbered parameters".
#include <cmath>

#include <isogloss/cnc/whole_number.hpp>
#include <isogloss/sdk.hpp>

#include "file_unit.hpp"

namespace tables {

namespace {

struct LinuxCncVariables {
  static constexpr auto spec = ig::importer("LinuxCncVariables", "Work offsets and variables of LinuxCNC.")
                                   .files("*.var")
                                   .fills("IsoCoordinateTable", "MacroVariables");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "TAB-0103", "'{0}' is no number of a variable with its value, so it is left out"),
      ig::diagnostic(IG_WARNING, "TAB-0111", "variable {0} is too large for a work offset, so this value is left out"),
  };

  ig::Choice<FileUnit> unit{"unit", "unknown|mm|inch", "unknown",
                            "The unit of the machine, LINEAR_UNITS in its INI file; unknown: mm is assumed."};

  static unsigned recognise(std::string_view text, std::string_view) {
    ig::EntryCount entries;
    unsigned offsets = 0;
    for (const ig::TextLine& line : ig::TextLines(ig::whole_lines(text))) {
      if (line.text.find_first_not_of(" \t") == std::string_view::npos) continue;
      const std::optional<Entry> entry = read_line(line);
      entries.add(entry.has_value());
      offsets += entry && entry->number >= g28 && entry->number < first_offset + 9 * offset_step ? 1 : 0;
    }
    return entries.confidence(offsets > 4 ? 90 : offsets > 0 ? 50 : 0);
  }

  void read(ig::Import& file) const {
    FileLengths lengths(file, unit);
    for (const ig::TextLine& line : file.lines()) {
      const std::size_t first = line.text.find_first_not_of(" \t");
      if (first == std::string_view::npos) continue;
      if (const std::optional<Entry> entry = read_line(line))
        read_entry(file, lengths, *entry);
      else
        file.report(ig::diag("TAB-0103"), line.begin + first, line.begin + line.text.size(), line.text.substr(first));
    }
  }

 private:
  static constexpr std::int64_t last_local = 33, last_own = 5000, g28 = 5161, g92 = 5210, offset_in_force = 5220,
                                first_offset = 5221, offset_step = 20, rotation = 9;
  static constexpr double largest = 1e9;  // that of the table

  struct Entry {
    std::int64_t number;
    double value;
    std::size_t begin, end;
  };

  static std::optional<Entry> read_line(const ig::TextLine& line) {
    constexpr std::string_view gaps = " \t";
    const std::size_t first = line.text.find_first_not_of(gaps);
    const ig::Decimal number = ig::read_decimal(line.text, first);
    const auto whole = ig::cnc::whole_number(number.value);
    const std::size_t second = line.text.find_first_not_of(gaps, number.end);
    if (!number.ok || number.has_point || !whole || second == std::string_view::npos || second == number.end)
      return std::nullopt;
    const ig::Decimal value = ig::read_decimal(line.text, second);
    if (!value.ok || line.text.find_first_not_of(gaps, value.end) != std::string_view::npos) return std::nullopt;
    return Entry{*whole, value.value, line.begin + first, line.begin + value.end};
  }

  static void read_entry(ig::Import& file, FileLengths& lengths, const Entry& e) {
    const auto unused = [&](std::string_view what, std::string_view why = "no table has a place for it") {
      if (e.value != 0) file.unused(what, why, e.begin, e.end);  // a shift of 0 has no effect anyway
    };
    if (e.number <= last_local) return unused("variables below #34", "they are local to a call");
    if (e.number <= last_own) {
      file.row("MacroVariables", e.number, e.begin);
      return file.cell("Value", e.value, e.begin);
    }
    if (e.number >= first_offset && e.number < first_offset + 9 * offset_step)
      return read_offset(file, lengths, e, unused);
    if (e.number == offset_in_force) return unused("the work offset in force", "a program begins with its own");
    if (e.number >= g92 && e.number < offset_in_force) return unused("shift of G92");
    if (e.number >= g28 && e.number < g92) return unused("position of G28 or G30");
    unused("state of the control");
  }

  /// Nine offsets G54 to G59.3, each with X Y Z A B C U V W and a rotation about Z.
  template <class Unused>
  static void read_offset(ig::Import& file, FileLengths& lengths, const Entry& e, Unused&& unused) {
    static constexpr std::array<const char*, 9> ids{"G54", "G55",   "G56",   "G57",  "G58",
                                                    "G59", "G59.1", "G59.2", "G59.3"};
    static constexpr std::array<const char*, 6> columns{"X", "Y", "Z", "A", "B", "C"};
    const auto id = static_cast<std::size_t>((e.number - first_offset) / offset_step);
    const auto place = static_cast<std::size_t>((e.number - first_offset) % offset_step);
    if (place == rotation) return unused("rotation of a work offset");
    if (place > rotation) return unused("state of the control");
    if (place >= columns.size()) return unused("work offset of U, V or W");
    const bool is_length = place < 3;
    const double value = is_length ? lengths.mm(e.value, e.begin, e.end) : e.value;
    if (std::abs(value) > largest)
      return file.report(ig::diag("TAB-0111"), e.begin, e.end, static_cast<double>(e.number));
    file.row("IsoCoordinateTable", ids[id], e.begin);
    file.cell(columns[place], value, e.begin);
  }
};

const ig::Register<LinuxCncVariables> linux_cnc_variables;

}  // namespace
}  // namespace tables
