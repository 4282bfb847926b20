// DEF NCK|CHAN [attributes] TYPE [attributes] NAME[sizes]=value, … Manual Job planning, "Definition of global user
// data".
#include <algorithm>
#include <cmath>

#include "archive/variable_rows.hpp"
#include "language/declared_type.hpp"
#include "language/macro_table.hpp"

namespace siemens {

namespace {

template <class... Words>
bool is_one_of(std::string_view word, Words... words) {
  return (equals_ignoring_case(word, words) || ...);
}

bool is_switch(std::string_view w) {
  return is_one_of(w, "SYNR", "SYNW", "SYNRW", "INIPO", "INIRE", "INICF", "PRLOC", "DCM", "DCI", "DCU");
}
bool has_value(std::string_view w) {
  return is_one_of(w, "APR", "APW", "APRP", "APWP", "APRB", "APWB", "APX", "PHU", "LLI", "ULI");
}
std::optional<VariableRows::Sizes> read_sizes(Cursor& cursor) {
  VariableRows::Sizes out;
  if (!cursor.accept('[')) return out;
  for (const std::string_view part : split(cursor.until("]"))) {
    const std::optional<double> n = number_of(part);
    if (!n || *n < 1 || *n > 1e6 || *n != std::floor(*n)) return std::nullopt;
    out.push_back(static_cast<std::uint32_t>(*n));
  }
  return cursor.accept(']') && out.size() <= 3 ? std::optional(out) : std::nullopt;
}

}  // namespace

bool VariableRows::define(ig::Import& file, std::string_view code) {
  Cursor cursor(code);
  const std::string_view keyword = cursor.word();
  const std::size_t begin = place_in(file, code), end = begin + code.size();
  if (cursor.peek() == '=' || cursor.peek() == '[') return false;
  if (is_one_of(keyword, "DEFINE")) return define_macro(file, code, cursor), true;
  if (is_one_of(keyword, "REDEF")) {
    file.unused("REDEF", "no table has a place for attributes of variables", begin, end);
    return true;
  }
  if (!is_one_of(keyword, "DEF")) return false;
  Definition d;
  std::string_view name;
  bool is_global = false;
  const bool is_sound = read_attributes(cursor, code, d, name, is_global);
  if (is_sound && !is_global) {
    file.unused("variable of one program", no_place, begin, end);
    for (const std::string_view one : split(code.substr(static_cast<std::size_t>(name.data() - code.data()))))
      local_.insert(upper(Cursor(one).word()));
  } else if (!is_sound || !read_names(file, cursor, d, name)) {
    file.report(ig::diag("SIE-0352"), begin, end, shown(code));
  }
  return true;
}

void VariableRows::define_macro(ig::Import& file, std::string_view code, Cursor cursor) {
  const std::size_t begin = place_in(file, code), end = begin + code.size();
  const std::string name = upper(cursor.word());
  if (!is_one_of(cursor.word(), "AS")) return file.report(ig::diag("SIE-0352"), begin, end, shown(code));
  const std::string_view text = trim(cursor.rest());
  if (const std::string fault = macro_fault(name, text); !fault.empty())
    return file.report(ig::diag("SIE-0363"), begin, end, shown(name), fault);
  if (!macro_names_.insert(name).second) return file.report(ig::diag("SIE-0351"), begin, end, name);
  macros_.push_back({name, text, begin});
}

bool VariableRows::read_attributes(Cursor& cursor, std::string_view code, Definition& d, std::string_view& name,
                                   bool& is_global) {
  for (bool has_type = false;;) {
    const std::string_view word = cursor.word();
    if (word.empty() || word[0] == '$') return false;
    std::size_t position = static_cast<std::size_t>(word.data() - code.data());
    const bool is_string = is_one_of(word, "STRING");
    const auto type = has_type ? std::nullopt : type_at(code, position);
    if (is_one_of(word, "NCK", "CHAN")) {
      is_global = true;
    } else if (type) {
      d.type = *type;
      has_type = true;
      if (is_string) cursor = Cursor(code.substr(position));
    } else if (is_string && !has_type) {
      return false;  // its length cannot be read
    } else if (has_value(word)) {
      const std::string_view value = cursor.until(" \t");
      const std::optional<double> limit = number_of(value);
      if (value.empty() || (is_one_of(word, "LLI", "ULI") && !limit)) return false;
      if (is_one_of(word, "LLI")) d.lowest = limit;
      if (is_one_of(word, "ULI")) d.highest = limit;
    } else if (!is_switch(word)) {
      name = word;
      const bool takes_limits = d.type.type == Type::real || d.type.type == Type::integer;
      if (!has_type || ((d.lowest || d.highest) && !takes_limits)) return false;
      if (d.lowest) d.type.lowest = std::max(d.type.lowest, *d.lowest);
      if (d.highest) d.type.highest = std::min(d.type.highest, *d.highest);
      return d.type.lowest <= d.type.highest;
    }
  }
}

bool VariableRows::read_names(ig::Import& file, Cursor& cursor, const Definition& d, std::string_view name) {
  for (;;) {
    const std::optional<Sizes> sizes = read_sizes(cursor);
    if (name.empty() || name[0] == '$' || !sizes) return false;
    const std::string_view initial = cursor.accept('=') ? cursor.until(",") : std::string_view();
    if (!cursor.is_at_end() && cursor.peek() != ',') return false;
    Definition own = d;
    own.sizes = *sizes;
    define_one(file, std::move(own), name, initial);
    if (!cursor.accept(',')) return true;
    name = cursor.word();
  }
}

std::optional<Value> VariableRows::initial_value(ig::Import& file, const Definition& d, const std::string& key,
                                                 std::string_view name, std::string_view text) const {
  const std::size_t begin = place_in(file, name), end = begin + name.size();
  bool is_axis = false;
  auto value = read_value(text, is_axis);
  const bool takes_text = d.type.type == Type::text || d.type.type == Type::frame;
  const bool is_bare_word = is_axis && d.type.detail != Declared::Detail::axis;
  if (!takes_text && (!value || is_bare_word)) {
    file.report(ig::diag("SIE-0342"), begin, end, shown(key), shown(text));
    return std::nullopt;
  }
  if (value && !is_bare_word && d.type.fit(*value) == Stored::yes) return value;
  file.report(ig::diag("SIE-0362"), begin, end, shown(key), shown(text), type_text(d.type));
  return d.type.initial();
}

void VariableRows::define_one(ig::Import& file, Definition d, std::string_view name, std::string_view initial) {
  const std::size_t begin = place_in(file, name), end = begin + name.size();
  const std::string base = upper(name);
  const bool is_array = !d.sizes.empty();
  Variable array;
  array.sizes = d.sizes;
  const auto [defined, is_new] = definitions_.emplace(base, std::move(d));
  if (!is_new) return file.report(ig::diag("SIE-0351"), begin, end, base);
  const Definition& own = defined->second;
  Value all = own.type.initial();
  const std::optional<ValueList> list = read_list(initial);
  if (!is_array) {
    if (list && !list->repeats && list->values.size() == 1) initial = list->values[0];
    if (const auto value = initial.empty() ? all : initial_value(file, own, base, name, initial))
      put({base, *value, begin, end, false});
    else
      definitions_.erase(defined);
    return;
  }
  std::vector<std::string_view> given = list ? list->values : std::vector{initial};
  const double count = element_count(own.sizes);
  if (list && list->repeats) {
    const auto repeated = static_cast<double>(list->count.value_or(SIZE_MAX));
    const auto value = initial_value(file, own, base, name, given[0]);
    if (value && repeated >= count) all = *value;
    given.assign(value && repeated < std::min(count, most_elements + 1) ? static_cast<std::size_t>(repeated) : 0,
                 given[0]);
    if (value && repeated < count && !has_room_for(repeated))
      return file.report(ig::diag("SIE-0350"), begin, end, base, repeated), put({base, all, begin, end, false});
  }
  put({base, all, begin, end, false});
  if (static_cast<double>(given.size()) > count) file.report(ig::diag("SIE-0349"), begin, end, base);
  for (std::size_t i = 0; i < given.size() && static_cast<double>(i) < count; ++i) {
    if (given[i].empty()) continue;
    const std::string key = base + array.indices_of(i);
    if (const auto value = initial_value(file, own, key, name, given[i]))
      if (value->number != all.number || value->text != all.text) put({key, *value, begin, end, false});
  }
}

}  // namespace siemens
