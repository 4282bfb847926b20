// Lists of the parameters of a Syntec control: a number and a value on each line, with or without a name between them.
// How an export looks differs by version, so only what is plain is read.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

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
/// Those that have one value for each axis: the list names the axis beside the number, or has a value for each.
constexpr std::array of_axes{1006, 1020, 1240, 1241, 1242, 1243, 1320, 1321, 1420};
constexpr std::int64_t rate_of_axes = 1420;
constexpr std::string_view axis_columns = "XYZABC";

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
      ig::diagnostic(IG_WARNING, "SYN-0010",
                     "parameter {0} has more values than the option axes has letters, so the line is left out"),
  };

  ig::TextOption axes{"axes", "XYZ", "Letters of the axes 1, 2, 3 and so on, in lines with a value for each axis."};

  static unsigned recognise(std::string_view text, std::string_view) {
    unsigned entries = 0, sure = 0, others = 0;
    for (const ig::TextLine& line : ig::TextLines(ig::whole_lines(text))) {
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
      if (is_of_axes(entry->number))
        read_axes(file, *entry, line.text, begin, end);
      else
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

  struct AxisValue {
    char axis;
    std::string_view text;
  };

  static std::vector<std::string_view> fields_behind_number(std::string_view line) {
    std::vector<std::string_view> out;
    line = trim(line);
    for (std::size_t at = std::min(line.find_first_of(separators), line.size());
         (at = line.find_first_not_of(separators, at)) != std::string_view::npos;) {
      const std::size_t end = std::min(line.find_first_of(separators, at), line.size());
      out.push_back(line.substr(at, end - at));
      at = end;
    }
    return out;
  }
  static bool is_number(std::string_view field) {
    const ig::Decimal value = ig::read_decimal(field, 0);
    return value.ok && value.end == field.size();
  }

  /// "1240 0 0 350".
  std::vector<AxisValue> values_in_order(const std::vector<std::string_view>& fields) const {
    std::vector<AxisValue> out;
    for (std::size_t i = 0; i < std::min(fields.size(), axes.text().size()); ++i)
      out.push_back({to_upper(axes.text()[i]), fields[i]});
    return out;
  }
  /// "1240,name,X,-250.5": the line ends in axes with their values, so that no number of a name is one of them.
  static std::vector<AxisValue> values_by_axis(const std::vector<std::string_view>& fields) {
    std::vector<AxisValue> out;
    for (std::size_t i = fields.size(); i >= 2; i -= 2) {
      const std::string_view axis = fields[i - 2];
      if (axis.size() != 1 || !is_letter(axis[0]) || !is_number(fields[i - 1])) break;
      out.push_back({to_upper(axis[0]), fields[i - 1]});
    }
    std::reverse(out.begin(), out.end());
    return out;
  }

  void read_axes(ig::Import& file, const Entry& e, std::string_view line, std::size_t begin, std::size_t end) const {
    const std::vector<std::string_view> fields = fields_behind_number(line);
    const bool are_all_values = fields.size() > 1 && std::all_of(fields.begin(), fields.end(), is_number);
    const std::vector<AxisValue> values = are_all_values ? values_in_order(fields) : values_by_axis(fields);
    if (are_all_values && fields.size() > values.size())
      return file.report(ig::diag("SYN-0010"), begin, end, static_cast<double>(e.number));
    if (values.empty())
      return file.unused("parameter of axes", "the line does not tell of which axis the value is", begin, end);
    for (const AxisValue& v : values) {
      const double value = ig::read_decimal(v.text, 0).value + 0.0;
      if (axis_columns.find(v.axis) == std::string_view::npos) {
        file.unused(std::string("value of axis ") + v.axis, "no table has a place for it", begin, end);
      } else if (!(std::abs(value) <= any) || (e.number == rate_of_axes && value < 0)) {
        file.report(ig::diag("SYN-0008"), begin, end, static_cast<double>(e.number), ig::shown_part(v.text));
      } else {
        file.row("SyntecParameterTable", e.number, begin);
        file.cell({&v.axis, 1}, value, begin);
      }
    }
  }

  static void read_entry(ig::Import& file, const Entry& e, std::size_t begin, std::size_t end) {
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
