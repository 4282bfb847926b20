// Lists of the parameters of a Syntec control: a number and a value on each line, with or without a name between them.
// How an export looks differs by version, so only what is plain is read.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

namespace syntec {

using namespace ig::cnc;

namespace {

/// The parameters that SyntecParameterTable uses and that exist once for the whole control.
struct KnownParameter {
  std::int64_t first, last;
  double least, most;
  bool is_whole = false;
};
constexpr double any = 1e9;
constexpr std::array known{KnownParameter{17, 17, 1, 3, true},    KnownParameter{3215, 3215, -any, any},
                           KnownParameter{3241, 3241, -any, any}, KnownParameter{3601, 3610, -any, any},
                           KnownParameter{3701, 3710, -any, any}, KnownParameter{3741, 3741, 0, any},
                           KnownParameter{4002, 4002, 0, any},    KnownParameter{5003, 5003, -any, any}};
/// Those that have one value for each axis: a list of single values cannot tell of which axis one is.
constexpr std::array of_axes{1006, 1020, 1240, 1241, 1242, 1243, 1320, 1321, 1420};

const KnownParameter* known_parameter(std::int64_t number) {
  for (const KnownParameter& k : known)
    if (number >= k.first && number <= k.last) return &k;
  return nullptr;
}
bool is_of_axes(std::int64_t number) { return std::find(of_axes.begin(), of_axes.end(), number) != of_axes.end(); }

struct SyntecParameters {
  static constexpr auto spec = ig::importer("SyntecParameters", "A list of the parameters of a Syntec control.")
                                   .files("*.par *param*.txt *param*.csv")
                                   .fills("SyntecParameterTable");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "SYN-0007", "'{0}' is no parameter with its value, so this line is left out"),
      ig::diagnostic(IG_WARNING, "SYN-0008",
                     "the control has no value {1} of parameter {0}, so the one of the dialect stays"),
  };

  static unsigned recognise(std::string_view text, std::string_view) {
    constexpr std::size_t looked_at = std::size_t{64} << 10;
    unsigned entries = 0, sure = 0, others = 0;
    for (const ig::TextLine& line : ig::TextLines(text)) {
      if (line.begin + line.text.size() >= looked_at) break;  // it may be cut
      if (is_empty(line.text)) continue;
      const std::optional<Entry> entry = read_line(line.text);
      if (!entry) {
        ++others;
        continue;
      }
      ++entries;
      sure += known_parameter(entry->number) != nullptr || is_of_axes(entry->number) ? 1 : 0;
    }
    return entries >= 3 && sure >= 2 && others * 4 <= entries ? 45 : 0;
  }

  void read(ig::Import& file) const {
    for (const ig::TextLine& line : file.lines()) {
      if (is_empty(line.text)) continue;
      const std::size_t begin = line.begin + skip_blanks(line.text, 0), end = line.begin + line.text.size();
      const std::optional<Entry> entry = read_line(line.text);
      if (!entry) {
        file.report(ig::diag("SYN-0007"), begin, end, ig::shown_part(trim(line.text)));
        continue;
      }
      read_entry(file, *entry, begin, end);
    }
  }

 private:
  struct Entry {
    std::int64_t number;
    double value;
  };

  static constexpr std::string_view separators = " \t,;=:";

  static bool is_empty(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t,;");
    return first == std::string_view::npos || line[first] == '#' || line.substr(first).starts_with("//");
  }

  /// "4002 2000", "4002,name,2000", "Pr4002=2000": the first number and the last.
  static std::optional<Entry> read_line(std::string_view line) {
    line = trim(line);
    if (line.size() > 2 && (line.starts_with("Pr") || line.starts_with("PR"))) line.remove_prefix(2);
    const ig::Decimal number = ig::read_decimal(line, 0);
    const std::size_t behind = line.find_first_of(separators);
    if (!number.ok || number.has_point || number.value < 1 || number.value > 99'999 || number.end != behind)
      return std::nullopt;
    const std::size_t last = line.find_last_of(separators);
    const ig::Decimal value = ig::read_decimal(line, last + 1);
    if (!value.ok || value.end != line.size() || !(std::abs(value.value) <= any)) return std::nullopt;
    return Entry{static_cast<std::int64_t>(number.value), value.value + 0.0};
  }

  static void read_entry(ig::Import& file, const Entry& e, std::size_t begin, std::size_t end) {
    if (is_of_axes(e.number))
      return file.unused("parameter of axes", "the list does not tell of which axis a value is", begin, end);
    const KnownParameter* const parameter = known_parameter(e.number);
    if (parameter == nullptr) return file.unused("parameter", "no syntax uses it", begin, end);
    const bool is_odd = parameter->is_whole && e.value != std::floor(e.value);
    if (is_odd || !(e.value >= parameter->least && e.value <= parameter->most))
      return file.report(ig::diag("SYN-0008"), begin, end, static_cast<double>(e.number), e.value);
    file.row("SyntecParameterTable", e.number, begin);
    file.cell("Value", e.value, begin);
  }
};

const ig::Register<SyntecParameters> syntec_parameters;

}  // namespace
}  // namespace syntec
