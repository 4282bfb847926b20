// Values of variables. An array stands in the table as one row for each element, NAME[1,2].
#include "archive/variable_rows.hpp"

namespace siemens {

namespace {

constexpr double most_elements = 10'000;        // of one array
constexpr std::size_t most_repeated = 200'000;  // of a file, by definitions and by REP
constexpr std::int64_t most_r = 32'535;
constexpr std::int64_t delivered_r = 1'000;  // option r-parameters of SiemensVariables

/// The number of R5 or R[5]; -1 where it is none.
std::int64_t r_number(const Assignment& a) {
  if (a.name == "R") return a.index.size() == 1 ? a.number(0) : -1;
  Assignment digits;
  digits.index.push_back(a.name.substr(1));
  return a.index.empty() ? digits.number(0) : -1;
}

/// The next element of an array, the last index first; false behind the last one. Without sizes there is one index.
bool go_on(std::vector<std::int64_t>& at, const VariableRows::Sizes& sizes) {
  if (sizes.empty()) return ++at.back(), true;
  for (std::size_t i = at.size(); i-- > 0;) {
    if (++at[i] < sizes[i]) return true;
    at[i] = 0;
  }
  return false;
}

std::string element(std::string_view name, const std::vector<std::int64_t>& at) {
  std::string out(name);
  for (std::size_t i = 0; i < at.size(); ++i) out += (i == 0 ? "[" : ",") + std::to_string(at[i]);
  return out + ']';
}

}  // namespace

std::optional<ValueList> read_list(std::string_view value) {
  Cursor cursor(value);
  const std::string word = upper(cursor.word());
  if ((!word.empty() && word != "SET" && word != "REP") || !cursor.accept('(')) return std::nullopt;
  const std::string_view inside = cursor.until(")");
  if (!cursor.accept(')') || !cursor.is_at_end()) return std::nullopt;
  ValueList out{split(inside), word == "REP", std::nullopt};
  if (!out.repeats) return out;
  if (out.values.size() > 2) return std::nullopt;
  if (out.values.size() == 2) {
    const std::optional<double> n = number_of(out.values[1]);
    if (!n || !(*n >= 0 && *n < 1e9)) return std::nullopt;
    out.count = static_cast<std::size_t>(*n);
  }
  return out;
}

double VariableRows::element_count(const Sizes& sizes) {
  double out = 1;
  for (const std::uint32_t size : sizes) out *= size;
  return out;
}

bool VariableRows::has_room_for(double elements) {
  if (elements > most_elements || repeated_ >= most_repeated) return false;
  repeated_ += static_cast<std::size_t>(elements);
  return true;
}

void VariableRows::put(std::string key, std::optional<double> value, std::size_t place, bool is_assigned) {
  const auto [it, is_new] = known_.try_emplace(key, rows_.size());
  if (is_new) return rows_.push_back({std::move(key), value, place, is_assigned});
  if (Row& row = rows_[it->second]; is_assigned || !row.is_assigned) row = {std::move(key), value, place, is_assigned};
}

void VariableRows::assign(ig::Import& file, const Assignment& a) {
  const std::size_t begin = place_in(file, a.written), end = begin + a.written.size();
  Assignment own = a;
  if (own.name.starts_with('$')) own.name.erase(0, 1);
  const std::optional<double> value = number_of(a.value);
  if (is_r_name(own.name) && !read_list(a.value)) {
    const std::int64_t n = r_number(own);
    if (n < 0 || n >= most_r) return file.report(ig::diag("SIE-0354"), begin, end, shown(own.full_name()));
    if (!value) return file.report(ig::diag("SIE-0342"), begin, end, shown(own.full_name()), shown(a.value));
    highest_r_ = std::max(highest_r_, n);
    return put("R" + std::to_string(n), *value, begin, true);
  }
  if (local_.contains(own.name)) return file.unused("variable of one program", no_place, begin, end);
  if (value) return put(own.full_name(), *value, begin, true);
  if (quoted_text(a.value)) return file.unused("text of a variable", "SiemensVariables holds numbers only", begin, end);
  if (read_list(a.value)) return assign_list(file, own);
  Cursor cursor(a.value);
  if (!cursor.word().empty() && (cursor.is_at_end() || cursor.peek() == '('))
    return file.unused("axis or frame of a variable", "SiemensVariables holds numbers only", begin, end);
  file.report(ig::diag("SIE-0342"), begin, end, shown(own.full_name()), shown(a.value));
}

void VariableRows::assign_list(ig::Import& file, const Assignment& a) {
  const std::size_t begin = place_in(file, a.written), end = begin + a.written.size();
  const ValueList list = *read_list(a.value);
  const auto defined = sizes_.find(a.name);
  const Sizes sizes = defined != sizes_.end() ? defined->second : Sizes();
  std::vector<std::int64_t> at;
  for (std::size_t i = 0; i < a.index.size(); ++i) at.push_back(a.number(i));
  if (at.empty()) at.assign(std::max<std::size_t>(sizes.size(), 1), 0);
  bool is_inside = sizes.empty() ? at.size() == 1 : at.size() == sizes.size();
  for (std::size_t i = 0; i < at.size() && is_inside; ++i)
    is_inside = at[i] >= 0 && (sizes.empty() || at[i] < sizes[i]);
  if (!is_inside || is_r_name(a.name) || (list.repeats && sizes.empty()))
    return file.report(ig::diag("SIE-0349"), begin, end, shown(a.full_name()));
  const std::size_t count = list.repeats ? list.count.value_or(SIZE_MAX) : list.values.size();
  if (list.repeats && !has_room_for(element_count(sizes)))
    return file.report(ig::diag("SIE-0350"), begin, end, shown(a.name), element_count(sizes));
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_inside) {
      if (!list.repeats) file.report(ig::diag("SIE-0349"), begin, end, shown(a.full_name()));
      return;
    }
    const std::string_view value = list.values[list.repeats ? 0 : i];
    const std::string key = element(a.name, at);
    if (const std::optional<double> n = number_of(value))
      put(key, *n, begin, true);
    else if (quoted_text(value))
      file.unused("text of a variable", "SiemensVariables holds numbers only", begin, end);
    else if (!value.empty())
      return file.report(ig::diag("SIE-0342"), begin, end, shown(key), shown(value));
    is_inside = go_on(at, sizes);
  }
}

void VariableRows::give(ig::Import& file) const {
  for (const Row& row : rows_) {
    file.row("SiemensVariables", row.key, row.place);
    if (row.value) file.cell("Value", *row.value, row.place);
  }
  if (highest_r_ >= delivered_r) file.option("SiemensVariables", "r-parameters", std::to_string(highest_r_ + 1), 0);
}

}  // namespace siemens
