// What create() may ask: options, patterns, services, settings, the dependency's own table.
#include <fmt/format.h>

#include <algorithm>

#include "contract/c_text.hpp"
#include "contract/host_table.hpp"

namespace isogloss {

namespace {

/// The checked host tells a fault of create(); each of them answers as if there were no such thing.
void violation(ig_link* link, const std::string& what) {
  if (link->syntax != nullptr && &link->chain->host() == &host_table(Mode::checked))
    link->chain->sink().add(
        host_diagnostic("IG-0402", link->syntax->element.where, {link->syntax->element.alias, what}));
}

const OptionValue& option(ig_link* link, std::uint32_t i) {
  static const OptionValue none;
  if (i >= link->options->size()) violation(link, fmt::format("it asks for option {} of {}", i, link->options->size()));
  return i < link->options->size() ? (*link->options)[i] : none;
}

ig_symbol symbol(ig_link* link, ig_text name) { return link->chain->symbols().intern(to_view(name)); }

void check_type(ig_link* link, std::uint32_t i, bool is_number, const char* name) {
  if (link->syntax == nullptr || i >= link->syntax->syntax->option_count) return;
  const ig_option_decl& o = link->syntax->syntax->options[i];
  const bool has_integer = o.type == IG_OPTION_INTEGER || o.type == IG_OPTION_BOOLEAN || o.type == IG_OPTION_CHOICE;
  const bool is_right = is_number ? o.type == IG_OPTION_NUMBER || o.type == IG_OPTION_INTEGER : has_integer;
  if (!is_right)
    violation(link, fmt::format("it calls {} for the option '{}', which is of another type", name, o.name));
}

double option_number(ig_link* link, std::uint32_t i) {
  check_type(link, i, true, "option_number()");
  return option(link, i).number;
}
std::int64_t option_integer(ig_link* link, std::uint32_t i) {
  check_type(link, i, false, "option_integer()");
  return option(link, i).integer;
}
ig_text option_text(ig_link* link, std::uint32_t i) { return to_text(option(link, i).text); }

std::uint32_t expand(ig_link* link, std::uint32_t declaration, const ig_field** ids) {
  if (link->syntax == nullptr || declaration >= link->syntax->expansions.size() ||
      (link->syntax->syntax->fields[declaration].access & IG_PATTERN) == 0) {
    violation(link, fmt::format("it expands the declaration {}, which is no pattern", declaration));
    return 0;
  }
  const std::vector<ig_field>& fields = link->syntax->expansions[declaration];
  *ids = fields.data();
  return static_cast<std::uint32_t>(fields.size());
}

ig_text field_path(ig_link* link, ig_field f) {
  const Layout& layout = link->chain->linked().layout;
  return f < layout.fields.size() ? to_text(layout.fields[f].path) : ig_text{nullptr, 0};
}

ig_text field_unit(ig_link* link, ig_field f) {
  const Layout& layout = link->chain->linked().layout;
  return f < layout.fields.size() ? to_text(layout.fields[f].unit) : ig_text{nullptr, 0};
}

const void* service(ig_link* link, const char* id) {
  if (link->syntax != nullptr) {
    const ig_syntax& s = *link->syntax->syntax;
    const bool is_declared =
        std::any_of(s.services, s.services + s.service_count,
                    [&](const ig_service_decl& declared) { return std::string_view(declared.id) == id; });
    if (!is_declared) violation(link, fmt::format("it asks for the service {}, which it does not declare", id));
  }
  return link->chain->service(id);
}
ig_text setting(ig_link* link, const char* name) { return to_text(link->chain->setting(name)); }
ig_table* table(ig_link* link) { return reinterpret_cast<ig_table*>(link->table); }

const DependencyTable& rows(const ig_table* t) { return *reinterpret_cast<const DependencyTable*>(t); }

std::int32_t value(const ig_table* t, ig_text row, std::uint32_t column, double* out) {
  const std::optional<double> v = rows(t).value(to_view(row), column);
  if (!v) return 0;
  *out = *v;
  return 1;
}

std::int32_t set_value(ig_table* t, ig_text row, std::uint32_t column, double v) {
  return reinterpret_cast<DependencyTable*>(t)->set(to_view(row), column, v) ? 1 : 0;
}

std::int32_t set_text_value(ig_table* t, ig_text row, std::uint32_t column, ig_text value) {
  DependencyTable& table = *reinterpret_cast<DependencyTable*>(t);
  const ig_dependency& d = table.dependency();
  const bool is_text = column < d.column_count && d.columns[column].is_text != 0;
  return is_text && table.set(to_view(row), column, to_view(value)) ? 1 : 0;
}

ig_text text_value(const ig_table* t, ig_text row, std::uint32_t column) {
  return to_text(rows(t).text(to_view(row), column));
}
std::uint32_t row_count(const ig_table* t) { return static_cast<std::uint32_t>(rows(t).rows().size()); }
ig_text row_name(const ig_table* t, std::uint32_t row) {
  return row < rows(t).rows().size() ? to_text(rows(t).rows()[row]) : ig_text{nullptr, 0};
}

void idle(ig_link* link) { link->is_idle = true; }

void fail(ig_link* link, ig_text reason) { link->failure.assign(reason.data, reason.size); }

}  // namespace

const ig_link_api& link_api() {
  static constexpr ig_link_api api{.struct_size = sizeof(ig_link_api),
                                   .host_minor = IG_ABI_MINOR,
                                   .symbol = symbol,
                                   .option_number = option_number,
                                   .option_integer = option_integer,
                                   .option_text = option_text,
                                   .expand = expand,
                                   .field_path = field_path,
                                   .field_unit = field_unit,
                                   .service = service,
                                   .setting = setting,
                                   .table = table,
                                   .value = value,
                                   .set_value = set_value,
                                   .text_value = text_value,
                                   .row_count = row_count,
                                   .row_name = row_name,
                                   .fail = fail,
                                   .idle = idle,
                                   .set_text_value = set_text_value};
  return api;
}

}  // namespace isogloss
