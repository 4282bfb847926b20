// The host knows all fields of the dialect, so it checks rows that name some. A row may set what a syntax that asks its
// table has declared: fields that match the patterns of an option. So no row reaches a field past the contract.
#include "run/field_rows.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "dialect/options.hpp"
#include "link/link_steps.hpp"

namespace isogloss {

namespace {

std::string_view trim(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t' || text.front() == '\n')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\n')) text.remove_suffix(1);
  return text;
}

bool asks(const LinkedSyntax& s, const ig_dependency& table) {
  for (const char* const* id = table.provides; id != nullptr && *id != nullptr; ++id)
    for (std::uint32_t i = 0; i < s.syntax->service_count; ++i)
      if (std::string_view(*id) == s.syntax->services[i].id) return true;
  return false;
}

/// The fields that rows of the table may set, by the options of the syntaxes that ask it.
std::vector<ig_field> settable(const LinkedDialect& linked, const ig_dependency& table) {
  std::vector<ig_field> out;
  for (const LinkedSyntax& s : linked.chain) {
    if (!asks(s, table)) continue;
    for (std::uint32_t i = 0; i < s.expansions.size(); ++i) {
      const ig_field_decl& decl = s.syntax->fields[i];
      const bool is_value = decl.type >= IG_NUMBER && decl.type <= IG_SYMBOL;
      if ((decl.access & IG_WRITE) == 0 || *decl.path != '@' || !is_value) continue;
      for (const ig_field f : s.expansions[i])
        if (linked.layout.fields[f].life != IG_LIFE_WORD) out.push_back(f);
    }
  }
  return out;
}

bool is_read(const LinkedDialect& linked, ig_field f) {
  for (const FieldInfo& info : standard_fields())
    if (info.path == linked.layout.fields[f].path) return true;  // the output shows it
  return std::any_of(linked.chain.begin(), linked.chain.end(),
                     [&](const LinkedSyntax& s) { return (s.may_read[f >> 6] >> (f & 63) & 1) != 0; });
}

/// A value may be a number and its unit, or stand for one that the program gives: {P} and {P:2}.
bool fits(ig_type type, std::string_view value) {
  constexpr double largest = 9007199254740992.0;  // beyond it a double skips integers
  const bool is_given = value.starts_with('{') && value.ends_with('}');
  const bool is_number = type == IG_NUMBER || type == IG_INTEGER;
  if (is_given) {
    const std::size_t colon = value.find(':');
    if (!is_number || colon == std::string_view::npos) return is_number;
    value = trim(value.substr(colon + 1, value.size() - colon - 2));
  }
  if (type == IG_BOOLEAN) return value == "true" || value == "false";
  if (!is_number) return true;
  const std::optional<double> number = parse_number(value);
  return number && (type == IG_NUMBER || (*number == std::trunc(*number) && std::abs(*number) <= largest));
}

class FieldRow {
 public:
  FieldRow(const LinkedDialect& linked, const LinkedDependency& table, std::string_view row, const Location& where)
      : linked_(linked), table_(table), row_(row), where_(where), settable_(settable(linked, *table.dependency)) {}

  void check(const std::string& path, std::string_view value) {
    const std::optional<ig_field> f = linked_.layout.find(path);
    if (!f || linked_.layout.fields[*f].hidden) {
      std::vector<std::string> names;
      for (const ig_field one : settable_) names.push_back(linked_.layout.fields[one].path);
      return report("IG-0145", path, {}, {}, did_you_mean(nearest_name(path, names)));
    }
    const FieldInfo& info = linked_.layout.fields[*f];
    if (std::find(settable_.begin(), settable_.end(), *f) == settable_.end()) {
      std::string all;
      for (const ig_field one : settable_) all += (all.empty() ? "" : ", ") + linked_.layout.fields[one].path;
      return report("IG-0147", path, {}, {}, all.empty() ? "no syntax here sets fields" : "rows may set " + all);
    }
    const std::size_t close = value.starts_with('{') ? value.find('}') : value.find(' ');
    const std::size_t end = std::min(value.starts_with('{') ? close + 1 : close, value.size());
    const std::string_view number = value.substr(0, close == std::string_view::npos ? value.size() : end);
    const std::string unit(trim(value.substr(number.size())));
    if (info.type != IG_SYMBOL && !fits(info.type, number))
      return report("IG-0146", path, std::string(value), type_name(info.type));
    if (info.type == IG_SYMBOL && (value.starts_with('{') || value != number))
      return report("IG-0146", path, std::string(value), type_name(info.type));
    if (!unit.empty() && unit != info.unit)
      return report("IG-0148", path, unit, info.unit.empty() ? "none" : info.unit);
    if (!is_read(linked_, *f)) report("IG-0149", path);
  }
  std::vector<Diagnostic> take_faults() { return std::move(faults_); }

 private:
  void report(std::string_view code, const std::string& path, const std::string& value = {},
              const std::string& expected = {}, const std::string& hint = {}) {
    faults_.push_back(host_diagnostic(code, where_, {table_.element.alias, row_, path, value, expected}, hint));
  }

  const LinkedDialect& linked_;
  const LinkedDependency& table_;
  const std::string row_;
  const Location& where_;
  const std::vector<ig_field> settable_;
  std::vector<Diagnostic> faults_;
};

}  // namespace

std::vector<Diagnostic> check_field_rows(const LinkedDialect& linked, const LinkedDependency& dependency,
                                         std::string_view row, std::string_view text, const Location& where) {
  // A syntax alone (cases, apply) has no other one beside it that could set the fields.
  if (linked.chain.size() < 2) return {};
  FieldRow check(linked, dependency, row, where);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    const std::string_view one = text.substr(0, end);
    const std::size_t equals = std::min(one.find('='), one.size());
    const std::string_view path = trim(one.substr(0, equals));
    const std::string_view value = equals < one.size() ? trim(one.substr(equals + 1)) : std::string_view();
    if (!path.empty() && !value.empty()) check.check(std::string(path), value);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return check.take_faults();
}

}  // namespace isogloss
