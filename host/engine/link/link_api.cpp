// What create() may ask: options, patterns, services, settings, the dependency's own table.
#include "contract/c_text.hpp"
#include "contract/host_table.hpp"

namespace isogloss {

namespace {

const OptionValue& option(const ig_link* link, std::uint32_t i) {
  static const OptionValue none;
  return i < link->options->size() ? (*link->options)[i] : none;
}

ig_symbol symbol(ig_link* link, ig_text name) { return link->chain->symbols().intern(to_view(name)); }
double option_number(ig_link* link, std::uint32_t i) { return option(link, i).number; }
std::int64_t option_integer(ig_link* link, std::uint32_t i) { return option(link, i).integer; }
ig_text option_text(ig_link* link, std::uint32_t i) { return to_text(option(link, i).text); }

std::uint32_t expand(ig_link* link, std::uint32_t declaration, const ig_field** ids) {
  if (link->syntax == nullptr || declaration >= link->syntax->expansions.size()) return 0;
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

const void* service(ig_link* link, const char* id) { return link->chain->service(id); }
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
