#include "state/variables_at.hpp"

#include <algorithm>

#include "json_text.hpp"

namespace isogloss::cli {

namespace {

std::string json_of_value(const ig_argument* value) {
  if (value == nullptr) return {};
  const Json json = value->is_text != 0 ? Json(std::string(value->text.data, value->text.size)) : Json(value->number);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool is_figure(char c) { return c >= '0' && c <= '9'; }

/// "#2" comes before "#10", and "Q" before "QS".
bool comes_before(const VariableAt& a, const VariableAt& b) {
  const std::string &x = a.name, &y = b.name;
  std::size_t i = 0, k = 0;
  while (i < x.size() && k < y.size()) {
    if (!is_figure(x[i]) || !is_figure(y[k])) {
      if (x[i] != y[k]) return x[i] < y[k];
      ++i, ++k;
      continue;
    }
    const std::size_t end_x = std::min(x.find_first_not_of("0123456789", i), x.size());
    const std::size_t end_y = std::min(y.find_first_not_of("0123456789", k), y.size());
    if (end_x - i != end_y - k) return end_x - i < end_y - k;
    if (const int order = x.compare(i, end_x - i, y, k, end_y - k); order != 0) return order < 0;
    i = end_x, k = end_y;
  }
  return x.size() - i < y.size() - k;
}

}  // namespace

void VariablesAt::use(const BlockSource& where, bool is_write, std::string_view name, std::uint64_t scope,
                      bool is_called, const ig_argument* value) {
  if (scope != 0 && is_called) return;
  auto found = known_.find(name);
  if (is_behind_) {
    if (found == known_.end() || found->second.is_decided) return;
    found->second.is_decided = true;
    found->second.at.is_read = !is_write;
    --open_;
    return;
  }
  if (!is_write) return;
  const ProgramLine line{std::string(where.file), where.line};
  if (found == known_.end()) {
    if (known_.size() >= most_variables) return;
    found = known_.emplace(std::string(name), Known{{std::string(name), {}, line, {}, scope != 0, false}, false}).first;
  }
  found->second.at.value = json_of_value(value);
  found->second.at.last = line;
}

std::vector<VariableAt> VariablesAt::all() const {
  std::vector<VariableAt> out;
  for (const auto& [name, known] : known_) {
    out.push_back(known.at);
    // An element of an array is defined where the array is.
    const auto array = known_.find(std::string_view(name).substr(0, name.find('[')));
    if (array != known_.end()) out.back().first = array->second.at.first;
  }
  std::sort(out.begin(), out.end(), comes_before);
  return out;
}

}  // namespace isogloss::cli
