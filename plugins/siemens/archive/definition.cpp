// DEF NCK|CHAN [attributes] TYPE [attributes] NAME[sizes]=value, … Manual Job planning, "Definition of global user
// data".
#include <cmath>

#include "archive/variable_rows.hpp"

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
bool is_type(std::string_view w) { return is_one_of(w, "BOOL", "CHAR", "INT", "REAL", "STRING", "AXIS", "FRAME"); }

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

std::string element(std::string name, const VariableRows::Sizes& sizes, std::size_t number) {
  if (sizes.empty()) return name;
  std::string indices;
  for (std::size_t i = sizes.size(); i-- > 0; number /= sizes[i])
    indices = (i == 0 ? '[' : ',') + std::to_string(number % sizes[i]) + indices;
  return name + indices + ']';
}

}  // namespace

double VariableRows::Definition::initial() const {
  const double low = lowest.value_or(0), high = highest.value_or(0);
  return low > 0 ? low : high < 0 ? high : 0;
}

bool VariableRows::define(ig::Import& file, std::string_view code) {
  Cursor cursor(code);
  const std::string_view keyword = cursor.word();
  const std::size_t begin = place_in(file, code), end = begin + code.size();
  if (cursor.peek() == '=' || cursor.peek() == '[') return false;
  if (is_one_of(keyword, "DEFINE")) {
    file.unused("macro", "no table holds DEFINE: put the line into the programs that use the name", begin, end);
    return true;
  }
  if (is_one_of(keyword, "REDEF")) {
    file.unused("REDEF", "no table has a place for attributes of variables", begin, end);
    return true;
  }
  if (!is_one_of(keyword, "DEF")) return false;
  Definition d;
  std::string_view name;
  bool is_global = false;
  const bool is_sound = read_attributes(cursor, d, name, is_global);
  if (is_sound && !is_global) {
    file.unused("variable of one program", no_place, begin, end);
    for (const std::string_view one : split(code.substr(static_cast<std::size_t>(name.data() - code.data()))))
      local_.insert(upper(Cursor(one).word()));
  } else if (is_sound && is_one_of(d.type, "STRING", "AXIS", "FRAME")) {
    file.unused("definition of a STRING, AXIS or FRAME", "SiemensVariables holds numbers only", begin, end);
  } else if (!is_sound || !read_names(file, cursor, d, name)) {
    file.report(ig::diag("SIE-0352"), begin, end, shown(code));
  }
  return true;
}

bool VariableRows::read_attributes(Cursor& cursor, Definition& d, std::string_view& name, bool& is_global) {
  for (;;) {
    const std::string_view word = cursor.word();
    if (word.empty() || word[0] == '$') return false;
    if (is_one_of(word, "NCK", "CHAN")) {
      is_global = true;
    } else if (is_type(word) && d.type.empty()) {
      d.type = word;
      if (is_one_of(word, "STRING") && cursor.accept('[')) {
        cursor.until("]");
        if (!cursor.accept(']')) return false;
      }
    } else if (has_value(word)) {
      const std::string_view value = cursor.until(" \t");
      if (value.empty()) return false;
      if (is_one_of(word, "LLI")) d.lowest = number_of(value);
      if (is_one_of(word, "ULI")) d.highest = number_of(value);
    } else if (!is_switch(word)) {
      name = word;
      return !d.type.empty();
    }
  }
}

bool VariableRows::read_names(ig::Import& file, Cursor& cursor, const Definition& d, std::string_view name) {
  for (;;) {
    const std::optional<Sizes> sizes = read_sizes(cursor);
    if (name.empty() || name[0] == '$' || !sizes) return false;
    const std::string_view initial = cursor.accept('=') ? cursor.until(",") : std::string_view();
    if (!cursor.is_at_end() && cursor.peek() != ',') return false;
    define_one(file, d, name, *sizes, initial);
    if (!cursor.accept(',')) return true;
    name = cursor.word();
  }
}

void VariableRows::define_one(ig::Import& file, const Definition& d, std::string_view name, const Sizes& sizes,
                              std::string_view initial) {
  const std::size_t begin = place_in(file, name), end = begin + name.size();
  const std::string base = upper(name);
  if (!sizes_.emplace(base, sizes).second) return file.report(ig::diag("SIE-0351"), begin, end, base);
  if (!has_room_for(element_count(sizes)))
    return file.report(ig::diag("SIE-0350"), begin, end, base, element_count(sizes));
  const auto count = static_cast<std::size_t>(element_count(sizes));
  std::vector<std::optional<double>> values(count, d.initial());
  const auto set = [&](std::size_t i, std::string_view text) {
    values[i] = number_of(text);
    if (!values[i]) file.report(ig::diag("SIE-0342"), begin, end, element(base, sizes, i), shown(text));
    if (values[i] && is_one_of(d.type, "INT")) values[i] = std::round(*values[i]);
    if (values[i] && is_one_of(d.type, "BOOL")) values[i] = *values[i] != 0;
  };
  const std::optional<ValueList> list = read_list(initial);
  const std::vector<std::string_view> given = list ? list->values : std::vector{initial};
  if (list && list->repeats) {
    set(0, given[0]);
    const std::size_t repeated = std::min(count, list->count.value_or(count));
    for (std::size_t i = 1; i < repeated; ++i) values[i] = values[0];
    if (repeated == 0) values[0] = d.initial();
  } else {
    for (std::size_t i = 0; i < std::min(count, given.size()); ++i)
      if (!given[i].empty()) set(i, given[i]);
    if (given.size() > count) file.report(ig::diag("SIE-0349"), begin, end, base);
  }
  for (std::size_t i = 0; i < count; ++i)
    if (values[i]) put(element(base, sizes, i), *values[i] != 0 ? values[i] : std::nullopt, begin, false);
}

}  // namespace siemens
