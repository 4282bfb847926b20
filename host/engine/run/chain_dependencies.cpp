// The dependencies of a chain: their tables, the values that the dialect and the run give them, and which one answers.
#include <algorithm>
#include <span>
#include <stdexcept>

#include "contract/host_table.hpp"
#include "dialect/options.hpp"
#include "dialect/row_checks.hpp"
#include "isogloss/engine/chain.hpp"
#include "run/calling.hpp"
#include "run/field_rows.hpp"

namespace isogloss {

namespace {

/// Does an element of a file that was given to the run mean this dependency of the dialect?
bool is_given(const DependencyElement& element, const DependencyElement& of_dialect) {
  return of_dialect.alias == element.alias || of_dialect.id == element.id;
}

/// True for tables whose rows have one main value, even if they also have values by axis.
bool has_one_value(const ig_dependency& d) {
  return d.column_count == 1 || std::string_view(d.columns[0].name) == "Value";
}

std::string columns_of(const ig_dependency& d) {
  std::string text = "the columns of " + std::string(d.id) + " are ";
  for (std::uint32_t i = 0; i < d.column_count; ++i) text += (i == 0 ? "" : ", ") + std::string(d.columns[i].name);
  return text;
}

void set_row(DependencyTable& table, const TableRow& row) {
  const std::string_view key = key_of(table.dependency(), row);
  table.add(key);
  for (const Attribute& a : row.attributes)
    if (const auto column = table.column(a.name)) table.set(key, static_cast<std::uint32_t>(*column), a.value);
}

/// The place where the user, or the dialect, gave the dependency its values.
const Location& place_of(const DependencyElement& of_dialect, const std::vector<DependencyElement>& of_user) {
  const Location* place = &of_dialect.where;
  for (const DependencyElement& given : of_user)
    if (is_given(given, of_dialect)) place = &given.where;
  return *place;
}

/// The option that a misspelt name may mean; empty: none. Rows of tables may have any name, and no row begins as
/// options do.
std::string near_option(const ig_dependency& d, const std::string& name) {
  constexpr std::size_t telling = 3;
  const bool is_like_one = name.size() >= telling && name[0] >= 'a' && name[0] <= 'z';
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i < d.option_count; ++i) names.emplace_back(d.options[i].name);
  return is_like_one && name.find('.') == std::string::npos ? nearest_name(name, names) : std::string();
}

std::string option_names(const ig_dependency& d) {
  std::string out = d.option_count == 0 ? "it has no option" : "its options are ";
  for (std::uint32_t i = 0; i < d.option_count; ++i) out += std::string(i == 0 ? "" : ", ") + d.options[i].name;
  return out;
}

/// NULL where the dependency does not provide it, or does not exist yet.
const void* service_of(const ig_dependency& d, void* self, std::string_view id) {
  if (self == nullptr || d.provides == nullptr) return nullptr;
  for (const char* const* provided = d.provides; *provided != nullptr; ++provided)
    if (id == *provided)
      if (const void* const s = d.service(self, *provided)) return s;
  return nullptr;
}

}  // namespace

void Chain::create_dependencies() {
  const auto create_row = [](DependencyTable& table, std::string_view shipped) {
    const std::size_t bar = shipped.find('|');
    const std::string_view key = shipped.substr(0, bar);
    table.add_row(key);
    table.add(key);
    while (shipped.find('|') != std::string_view::npos) {
      shipped.remove_prefix(shipped.find('|') + 1);
      const std::string_view cell = shipped.substr(0, shipped.find('|'));
      const std::size_t equals = cell.find('=');
      const std::optional<std::size_t> column = table.column(cell.substr(0, equals));
      if (column && equals != std::string_view::npos)
        table.set(key, static_cast<std::uint32_t>(*column), cell.substr(equals + 1));
    }
  };
  for (const LinkedDependency& d : linked_.dependencies) {
    auto table = std::make_unique<DependencyTable>(*d.dependency);
    for (std::uint32_t i = 0; i < d.dependency->default_row_count; ++i)
      create_row(*table, d.dependency->default_rows[i]);
    for (const TableRow& row : d.element.rows) set_row(*table, row);
    tables_.push_back(std::move(table));
    dependency_options_.push_back(d.options);
  }
  for (const DependencyElement& element : settings_.dependencies) overlay(element);
  for (const auto& [path, value] : settings_.assignments) assign(path, value);
  dependencies_.resize(linked_.dependencies.size());
  for (std::size_t i = 0; i < dependencies_.size(); ++i) {
    const LinkedDependency& d = linked_.dependencies[i];
    ig_link link{this, &dependency_options_[i], nullptr, tables_[i].get(), {}, false};
    const Calling calling(*d.plugin, d.element.alias.c_str(), "create");
    ig_status status = IG_FAILED;
    try {
      status = d.dependency->create(&link_functions(), &link, nullptr, &dependencies_[i]);
    } catch (...) {
      dependencies_[i] = nullptr;
      sink_.add(
          exception_diagnostic(*d.plugin, d.element.alias, "create", place_of(d.element, settings_.dependencies)));
      throw std::runtime_error(d.element.alias + " could not be created");
    }
    if (status == IG_FAILED) {
      dependencies_[i] = nullptr;
      sink_.add(
          host_diagnostic("IG-0308", place_of(d.element, settings_.dependencies), {d.element.alias, link.reason()}));
      throw std::runtime_error(d.element.alias + " could not be created");
    }
    refuse_rows(i);
  }
  check_answers();
  report_idle_rows();
}

/// Refuses rows that have no meaning; each is reported.
void Chain::refuse_rows(std::size_t dependency) {
  const LinkedDependency& d = linked_.dependencies[dependency];
  if (d.dependency->row_fault == nullptr) return;
  const Calling calling(*d.plugin, d.element.alias.c_str(), "row_fault");
  bool is_sound = true;
  // Each cell where it stands: a row may have cells in several files.
  const auto check_fields = [&](const std::string& name, const TableRow* row) {
    for (std::uint32_t i = 0; i < d.dependency->column_count; ++i) {
      const ig_column_decl& column = d.dependency->columns[i];
      if (column.is_text == 0 || column.unit == nullptr || std::string_view(column.unit) != "fields") continue;
      const auto is_cell = [&](const Attribute& a) { return a.name == column.name; };
      if (row != nullptr && std::none_of(row->attributes.begin(), row->attributes.end(), is_cell)) continue;
      const Attribute cell = row != nullptr
                                 ? *std::find_if(row->attributes.begin(), row->attributes.end(), is_cell)
                                 : Attribute{column.name, std::string(tables_[dependency]->text(name, i)), {"--set"}};
      for (Diagnostic& fault : check_field_rows(linked_, d, name, cell.value, cell.where)) {
        is_sound = is_sound && fault.severity != Severity::error;
        sink_.add(std::move(fault));
      }
    }
  };
  const auto check = [&](const std::string& row, const Location& where, const TableRow* given) {
    ig_text fault{};
    try {
      fault = d.dependency->row_fault(dependencies_[dependency], {row.data(), row.size()});
    } catch (...) {
      is_sound = false;
      sink_.add(exception_diagnostic(*d.plugin, d.element.alias, "row_fault", where));
      return;
    }
    if (fault.size == 0) return check_fields(row, given);
    is_sound = false;
    sink_.add(host_diagnostic("IG-0432", where, {d.element.alias, row, std::string(fault.data, fault.size)}));
  };
  const auto check_all = [&](const DependencyElement& element) {
    for (const TableRow& row : element.rows) check(std::string(key_of(*d.dependency, row)), row.where, &row);
  };
  check_all(d.element);
  for (const DependencyElement& given : settings_.dependencies)
    if (is_given(given, d.element)) check_all(given);
  for (const AssignedRow& row : assigned_rows_)
    if (row.dependency == dependency) check(row.name, {"--set"}, nullptr);
  if (!is_sound) throw std::runtime_error(d.element.alias + " has no such row");
}

/// Reports a dependency that was given values although another one answers in its place, and no syntax asks it for
/// anything else.
void Chain::check_answers() {
  // Texts, such as further names of an axis, and rows beyond the shipped ones are what no other table has.
  const auto is_shipped = [](const ig_dependency& d, std::string_view row) {
    const std::span<const char* const> shipped(d.default_rows, d.default_row_count);
    return std::any_of(shipped.begin(), shipped.end(),
                       [&](std::string_view one) { return one.substr(0, one.find('|')) == row; });
  };
  const auto has_number = [](const ig_dependency& d, const TableRow& row) {
    return std::any_of(row.attributes.begin(), row.attributes.end(), [&](const Attribute& a) {
      return std::any_of(d.columns, d.columns + d.column_count,
                         [&](const ig_column_decl& c) { return c.is_text == 0 && a.name == c.name; });
    });
  };
  const auto changes_shipped_row = [&](std::size_t i) {
    const LinkedDependency& d = linked_.dependencies[i];
    return std::any_of(d.element.rows.begin(), d.element.rows.end(),
                       [&](const TableRow& row) {
                         return is_shipped(*d.dependency, key_of(*d.dependency, row)) && has_number(*d.dependency, row);
                       }) ||
           std::any_of(assigned_rows_.begin(), assigned_rows_.end(), [&](const AssignedRow& row) {
             return row.dependency == i && d.dependency->columns[row.column].is_text == 0 &&
                    is_shipped(*d.dependency, row.name);
           });
  };
  const auto is_asked = [&](std::string_view id) {
    for (const LinkedSyntax& s : linked_.chain)
      for (std::uint32_t k = 0; k < s.syntax->service_count; ++k)
        if (id == s.syntax->services[k].id) return true;
    return false;
  };
  for (std::size_t i = 0; i < dependencies_.size(); ++i) {
    const LinkedDependency& d = linked_.dependencies[i];
    if (d.dependency->provides == nullptr || d.dependency->provides[0] == nullptr) continue;
    const bool is_assigned =
        std::any_of(settings_.assignments.begin(), settings_.assignments.end(),
                    [&](const auto& a) { return a.first.substr(0, a.first.find('.')) == d.element.alias; });
    if (d.element.rows.empty() && !is_assigned) continue;
    std::string other;
    bool answers = false, is_passed_over = false;  // in its first service, which is what the dependency is for
    for (const char* const* id = d.dependency->provides; *id != nullptr; ++id) {
      if (*id == std::string_view(IG_ROW_MEANING_SERVICE)) continue;  // the host asks each dependency for it
      const std::optional<std::size_t> who = answering(*id);
      const bool is_own = !who || *who == i;
      answers |= is_own && is_asked(*id);
      if (is_own) continue;
      other = linked_.dependencies[*who].element.alias;
      is_passed_over |=
          id == d.dependency->provides && is_asked(*id) && service_of(*d.dependency, dependencies_[i], *id) != nullptr;
    }
    if (!other.empty() && (!answers || (is_passed_over && changes_shipped_row(i))))
      sink_.add(
          host_diagnostic("IG-0434", is_assigned ? Location{"--set"} : d.element.where, {d.element.alias, other}));
  }
}

/// What a dialect or machine holds is for `lint`; what is given for one run is looked at here.
void Chain::report_idle_rows() {
  const auto idle_name = [&](std::size_t i, const std::string& row, const char* column) {
    const ig_dependency& d = *linked_.dependencies[i].dependency;
    if (service_of(d, dependencies_[i], IG_ROW_MEANING_SERVICE) == nullptr || meaning_of(i, row, column))
      return std::string();
    const bool has_other = std::any_of(d.columns, d.columns + d.column_count,
                                       [&](const ig_column_decl& c) { return meaning_of(i, row, c.name).has_value(); });
    return has_other ? row + "." + column : row;
  };
  for (const AssignedRow& row : assigned_rows_) {
    const LinkedDependency& d = linked_.dependencies[row.dependency];
    const std::string name = idle_name(row.dependency, row.name, d.dependency->columns[row.column].name);
    if (!name.empty()) sink_.add(host_diagnostic("IG-0613", {"--set"}, {d.element.alias, name}));
  }
  const auto look_at = [&](std::size_t i, const DependencyElement& given) {
    const LinkedDependency& d = linked_.dependencies[i];
    if (service_of(*d.dependency, dependencies_[i], IG_ROW_MEANING_SERVICE) == nullptr) return;
    std::vector<std::string> names;
    Location first;
    for (const TableRow& row : given.rows)
      for (const Attribute& cell : row.attributes) {
        const bool is_key = cell.name == d.dependency->row_key;
        const std::string name = is_key ? "" : idle_name(i, std::string(key_of(*d.dependency, row)), cell.name.c_str());
        if (name.empty() || (!names.empty() && names.back() == name)) continue;
        if (names.empty()) first = cell.where;
        names.push_back(name);
      }
    if (!names.empty()) sink_.add(host_diagnostic("IG-0613", first, {d.element.alias, listed(names, 8)}));
  };
  for (std::size_t i = 0; i < dependencies_.size(); ++i)
    for (const DependencyElement& given : settings_.dependencies)
      if (is_given(given, linked_.dependencies[i].element)) look_at(i, given);
}

void Chain::overlay(const DependencyElement& element) {
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    const LinkedDependency& d = linked_.dependencies[i];
    if (!is_given(element, d.element)) continue;
    for (const Attribute& option : element.options) assign(d.element.alias + "." + option.name, option.value);
    std::vector<Diagnostic> faults = check_rows(*d.dependency, d.element.alias, element.rows);
    for (Diagnostic& fault : faults) sink_.add(std::move(fault));
    if (!faults.empty()) throw std::runtime_error("no such rows of " + d.element.alias);
    for (const TableRow& row : element.rows) set_row(*tables_[i], row);
    return;
  }
  std::vector<std::string> names;
  for (const LinkedDependency& d : linked_.dependencies) names.push_back(d.element.alias);
  const std::string near = nearest_name(element.id, names);
  sink_.add(host_diagnostic("IG-0410", element.where, {element.id}, near.empty() ? "" : "did you mean " + near + "?"));
  throw std::runtime_error("no dependency " + element.id);
}

void Chain::assign(const std::string& path, const std::string& value) {
  const std::size_t dot = path.find('.');
  const std::string name = path.substr(0, dot);
  const std::string rest = dot == std::string::npos ? std::string() : path.substr(dot + 1);
  std::vector<std::string> names;
  std::string hint;
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    const LinkedDependency& d = linked_.dependencies[i];
    names.push_back(d.element.alias);
    if (d.element.alias != name) continue;
    for (std::uint32_t o = 0; o < d.dependency->option_count; ++o) {
      if (rest != d.dependency->options[o].name) continue;
      const std::optional<OptionValue> parsed = parse_option(d.dependency->options[o], value);
      if (!parsed) {
        sink_.add(host_diagnostic("IG-0411", {"--set"}, {path, value},
                                  "it must be " + describe_option(d.dependency->options[o])));
        throw std::runtime_error("no value for " + path);
      }
      dependency_options_[i][o] = *parsed;
      return;
    }
    if (const std::string near = near_option(*d.dependency, rest); !near.empty()) {
      hint = "did you mean " + name + "." + near + "?";
      break;
    }
    if (rest.empty() || d.dependency->column_count == 0) {
      hint = option_names(*d.dependency);
      break;
    }
    // "ROW.COLUMN", or "ROW" alone where it has one value; rows may hold points.
    const std::size_t last = rest.rfind('.');
    std::optional<std::size_t> column;
    if (last != std::string::npos) column = tables_[i]->column(rest.substr(last + 1));
    const std::string row = column ? rest.substr(0, last) : rest;
    if (!column && !has_one_value(*d.dependency)) {
      std::vector<std::string> columns;
      for (std::uint32_t c = 0; c < d.dependency->column_count; ++c)
        columns.emplace_back(d.dependency->columns[c].name);
      const std::string given = last == std::string::npos ? std::string() : rest.substr(last + 1);
      constexpr std::size_t telling = 3;  // for a shorter name any other one is near
      const std::string near = given.size() < telling ? std::string() : nearest_name(given, columns);
      hint = near.empty() ? columns_of(*d.dependency) : "did you mean " + near + "?";
      break;
    }
    assigned_rows_.push_back({i, row, static_cast<std::uint32_t>(column.value_or(0))});
    if (!tables_[i]->set(row, static_cast<std::uint32_t>(column.value_or(0)), std::string_view(value))) {
      sink_.add(host_diagnostic("IG-0411", {"--set"}, {path, value}));
      throw std::runtime_error("no value for " + path);
    }
    return;
  }
  const std::string near = nearest_name(name, names);
  if (hint.empty() && !near.empty() && near != name)
    hint = "did you mean " + near + (rest.empty() ? "" : "." + rest) + "?";
  if (hint.empty() && linked_.position(name))
    hint = name + " is a syntax: its options stand in the dialect, <Configure syntax=\"" + name + "\" …/>";
  sink_.add(host_diagnostic("IG-0410", {"--set"}, {path}, hint));
  throw std::runtime_error("no dependency or column " + path);
}

const void* Chain::service(std::string_view id) const {
  if (id == IG_FLOW_SERVICE) return &flow_service_;
  if (id == IG_PROVENANCE_SERVICE) return &provenance_;
  const std::optional<std::size_t> who = answering(id);
  return who ? service_of(*linked_.dependencies[*who].dependency, dependencies_[*who], id) : nullptr;
}

/// Dependencies from the run's files come first, those of the last file before all; then the dialect's, in its order.
std::optional<std::size_t> Chain::answering(std::string_view id) const {
  const auto answers = [&](std::size_t i) {
    return service_of(*linked_.dependencies[i].dependency, dependencies_[i], id) != nullptr;
  };
  for (std::size_t given = settings_.dependencies.size(); given-- > 0;)
    for (std::size_t i = 0; i < dependencies_.size(); ++i)
      if (is_given(settings_.dependencies[given], linked_.dependencies[i].element) && answers(i)) return i;
  for (std::size_t i = 0; i < dependencies_.size(); ++i)
    if (answers(i)) return i;
  return std::nullopt;
}

void Chain::listen_to_rows() {
  provenance_.is_listening = 1;
  for (std::size_t i = 0; i < tables_.size(); ++i)
    tables_[i]->listen([this, i](std::string_view row, bool has_value) { note_row(i, row, has_value); });
}

void Chain::note_row(std::size_t dependency, std::string_view row, bool has_value) {
  if (creating_ != 0 && has_value) rows_at_start.push_back({creating_, dependency, std::string(row)});
  if (creating_ != 0) return;
  if (row_asked) row_asked(dependency, row);
  const Document* const at_work = breadcrumb().document;
  if (!has_value || at_work == nullptr || answered_rows.size() >= most_answered_rows) return;
  AnsweredRow answered{at_work->current, dependency, std::string(row)};
  if (answered_rows.empty() || !(answered_rows.back() == answered)) answered_rows.push_back(std::move(answered));
}

std::optional<ig_row_meaning> Chain::meaning_of(std::size_t dependency, const std::string& row,
                                                const char* column) const {
  const LinkedDependency& d = linked_.dependencies[dependency];
  const auto* const service = static_cast<const ig_row_meaning_1*>(
      service_of(*d.dependency, dependencies_[dependency], IG_ROW_MEANING_SERVICE));
  if (service == nullptr) return std::nullopt;
  ig_row_meaning out{};
  out.struct_size = sizeof out;
  const Calling calling(*d.plugin, d.element.alias.c_str(), "meaning");
  const ig_text name{row.data(), row.size()}, of_column{column, std::string_view(column).size()};
  return service->meaning(service->self, name, of_column, &out) != 0 ? std::optional(out) : std::nullopt;
}

DependencyTable* Chain::table(std::string_view dependency) {
  for (std::size_t i = 0; i < tables_.size(); ++i)
    if (linked_.dependencies[i].element.alias == dependency) return tables_[i].get();
  return nullptr;
}

}  // namespace isogloss
