#include "dialect/row_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "dialect/options.hpp"

namespace isogloss {

namespace {

class RowCheck {
 public:
  RowCheck(const ig_dependency& dependency, const std::string& owner) : dependency_(dependency), owner_(owner) {
    for (std::uint32_t i = 0; i < dependency.column_count; ++i) columns_.emplace_back(dependency.columns[i].name);
  }

  void check(const TableRow& row) {
    if (dependency_.row_element == nullptr || row.element != dependency_.row_element) {
      const std::string wanted = dependency_.row_element == nullptr ? "(none)" : dependency_.row_element;
      const bool is_near = dependency_.row_element != nullptr && !nearest_name(row.element, {wanted}).empty();
      report("IG-0217", row.where, {owner_, row.element, wanted}, is_near ? "did you mean " + wanted + "?" : "");
      return;
    }
    for (const Attribute& a : row.attributes)
      if (a.name != dependency_.row_key) check_cell(a);
    const std::string_view key = key_of(dependency_, row);
    if (key.empty())
      report("IG-0218", row.where, {owner_, dependency_.row_key});
    else if (const auto [first, added] =
                 first_.emplace(std::pair(std::string_view(row.where.file), key), row.where.line);
             !added)
      report("IG-0433", row.where, {owner_, std::string(key), std::to_string(first->second)});
  }

  std::vector<Diagnostic> take_faults() { return std::move(faults_); }

 private:
  void report(std::string_view code, const Location& where, std::initializer_list<std::string> arguments,
              std::string hint = {}) {
    faults_.push_back(host_diagnostic(code, where, arguments, std::move(hint)));
  }

  void check_cell(const Attribute& a) {
    const auto found = std::find(columns_.begin(), columns_.end(), a.name);
    if (found == columns_.end()) {
      constexpr std::size_t telling = 3;  // for a shorter name any other one is near
      const std::string near = a.name.size() < telling ? std::string() : nearest_name(a.name, columns_);
      std::string all;
      for (const std::string& column : columns_) all += (all.empty() ? "its columns are " : ", ") + column;
      report("IG-0219", a.where, {owner_, a.name}, near.empty() ? all : "did you mean " + near + "?");
      return;
    }
    const ig_column_decl& column = dependency_.columns[found - columns_.begin()];
    if (column.is_text != 0) return;
    const std::optional<double> v = parse_number(a.value);
    if (!v || *v < column.minimum || *v > column.maximum)
      report("IG-0220", a.where, {a.name, a.value, v ? " within its range" : ""}, range_of(column));
  }

  static std::string range_of(const ig_column_decl& column) {
    const bool has_minimum = std::isfinite(column.minimum), has_maximum = std::isfinite(column.maximum);
    std::string out = "it is a number";
    if (has_minimum) out += fmt::format("{} {}", has_maximum ? " from" : ", at least", column.minimum);
    if (has_maximum) out += fmt::format("{} {}", has_minimum ? " to" : ", at most", column.maximum);
    const std::string_view unit = column.unit == nullptr ? "" : column.unit;
    return unit.empty() ? out : fmt::format("{}, in {}", out, unit);
  }

  const ig_dependency& dependency_;
  const std::string& owner_;
  std::vector<std::string> columns_;
  // A row beside src replaces that of the file.
  std::map<std::pair<std::string_view, std::string_view>, std::uint32_t> first_;
  std::vector<Diagnostic> faults_;
};

}  // namespace

std::string_view key_of(const ig_dependency& dependency, const TableRow& row) {
  if (dependency.row_key != nullptr)
    for (const Attribute& a : row.attributes)
      if (a.name == dependency.row_key) return a.value;
  return {};
}

std::vector<Diagnostic> check_rows(const ig_dependency& dependency, const std::string& owner,
                                   const std::vector<TableRow>& rows) {
  RowCheck check(dependency, owner);
  for (const TableRow& row : rows) check.check(row);
  return check.take_faults();
}

}  // namespace isogloss
