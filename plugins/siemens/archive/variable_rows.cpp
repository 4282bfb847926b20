// Values of variables. An array stands in the table as one row for each element, NAME[1,2].
#include "archive/variable_rows.hpp"

#include "frames/frame_value.hpp"
#include "language/declared_type.hpp"
#include "language/expression_operators.hpp"
#include "language/siemens_environment.hpp"

namespace siemens {

namespace {

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

void VariableRows::put(Row row) {
  const auto [it, is_new] = known_.try_emplace(row.key, rows_.size());
  if (is_new) return rows_.push_back(std::move(row));
  if (Row& own = rows_[it->second]; row.is_assigned || !own.is_assigned) own = std::move(row);
}

std::optional<Value> VariableRows::read_value(std::string_view text, bool& is_axis) {
  if (const auto n = number_of(text)) return Value::real(*n);
  if (const auto quoted = quoted_text(text); quoted && quoted->find('"') == std::string_view::npos)
    return Value::string(std::string(*quoted));
  Cursor cursor(text);
  const std::string word = upper(cursor.word());
  if (!word.empty() && word[0] != '$' && cursor.is_at_end()) return is_axis = true, Value::string(word);
  const auto frame = frame_link(word) ? FrameValue::read(text) : std::nullopt;
  return frame ? std::optional(Value::frame(frame->text())) : std::nullopt;
}

void VariableRows::assign(ig::Import& file, const Assignment& a) {
  const std::size_t begin = place_in(file, a.written), end = begin + a.written.size();
  Assignment own = a;
  if (own.name.starts_with('$')) own.name.erase(0, 1);
  if (is_r_name(own.name) && !read_list(a.value)) {
    const std::optional<double> value = number_of(a.value);
    const std::int64_t n = r_number(own);
    if (n < 0 || n >= most_r) return file.report(ig::diag("SIE-0354"), begin, end, shown(own.full_name()));
    if (!value) return file.report(ig::diag("SIE-0342"), begin, end, shown(own.full_name()), shown(a.value));
    highest_r_ = std::max(highest_r_, n);
    return put({"R" + std::to_string(n), Value::real(*value), begin, end, true});
  }
  if (local_.contains(own.name)) return file.unused("variable of one program", no_place, begin, end);
  if (read_list(a.value)) return assign_list(file, own);
  bool is_axis = false;
  if (auto value = read_value(a.value, is_axis))
    return put({own.full_name(), std::move(value), begin, end, true, is_axis});
  file.report(ig::diag("SIE-0342"), begin, end, shown(own.full_name()), shown(a.value));
}

void VariableRows::assign_list(ig::Import& file, const Assignment& a) {
  const std::size_t begin = place_in(file, a.written), end = begin + a.written.size();
  const ValueList list = *read_list(a.value);
  const auto defined = definitions_.find(a.name);
  const Sizes sizes = defined != definitions_.end() ? defined->second.sizes : Sizes();
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
    const std::string_view text = list.values[list.repeats ? 0 : i];
    const std::string key = element(a.name, at);
    bool is_axis = false;
    if (auto value = read_value(text, is_axis))
      put({key, std::move(value), begin, end, true, is_axis});
    else if (!text.empty())
      return file.report(ig::diag("SIE-0342"), begin, end, shown(key), shown(text));
    is_inside = go_on(at, sizes);
  }
}

void VariableRows::give_row(ig::Import& file, const Row& row) const {
  const std::size_t bracket = row.key.find('[');
  const auto base = definitions_.find(row.key.substr(0, bracket));
  const bool is_known = base != definitions_.end();
  const bool is_definition = is_known && bracket == std::string::npos;
  // GRID=4 beside GRID[2]=1, without a definition: GRID is a plain variable.
  if (!is_known && bracket != std::string::npos && known_.contains(row.key.substr(0, bracket)))
    return file.report(ig::diag("SIE-0349"), row.begin, row.end, shown(row.key));
  Variable array;
  if (is_known) array.sizes = base->second.sizes;
  std::optional<Value> value = row.value;
  const std::string_view index = std::string_view(row.key).substr(std::min(bracket, row.key.size()));
  const bool is_whole_array = index.empty() && !array.sizes.empty() && row.is_assigned;
  const bool is_component = index.size() > 3 && frame_component_link(index.substr(index.size() - 3, 2));  // F[X,TR]
  const bool is_outside = is_known && !index.empty() && (array.sizes.empty() || !array.number_of(index));
  if (is_whole_array || is_component || is_outside) {
    file.report(ig::diag("SIE-0349"), row.begin, row.end, shown(row.key));
    if (!is_definition) return;
    value.reset();
  }
  const std::string written = value ? text_of(*value) : std::string();
  if (value && is_known && base->second.type.fit(*value) != Stored::yes) {
    file.report(ig::diag("SIE-0362"), row.begin, row.end, shown(row.key), shown(written), type_text(base->second.type));
    if (!is_definition) return;
    value.reset();
  }
  file.row("SiemensVariables", row.key, row.begin);
  if (value && value->is_text() && (row.is_assigned || !value->text.empty()))
    file.cell("Text", value->text, row.begin);
  else if (value && !value->is_text() && (row.is_assigned || value->number != 0))
    file.cell("Value", value->number, row.begin);
  if (!is_known && value && (row.is_axis || value->type == Type::frame) && bracket == std::string::npos)
    file.cell("Type", row.is_axis ? "AXIS" : "FRAME", row.begin);
  if (!is_definition) return;
  const Definition& d = base->second;
  file.cell("Type", type_text(d.type), row.begin);
  std::string sizes;
  for (const std::uint32_t size : d.sizes) sizes += (sizes.empty() ? "" : ",") + std::to_string(size);
  if (!sizes.empty()) file.cell("Size", sizes, row.begin);
  if (d.lowest) file.cell("Lowest", *d.lowest, row.begin);
  if (d.highest) file.cell("Highest", *d.highest, row.begin);
}

void VariableRows::give(ig::Import& file) const {
  for (const Row& row : rows_) give_row(file, row);
  if (highest_r_ >= delivered_r) file.option("SiemensVariables", "r-parameters", std::to_string(highest_r_ + 1), 0);
  for (const Macro& macro : macros_) {
    file.row("SiemensMacros", macro.name, macro.place);
    file.cell("Text", macro.text, macro.place);
  }
}

}  // namespace siemens
