#include "dap/program_variables.hpp"

#include <algorithm>

namespace isogloss::dap {

namespace {

bool is_decimal(char c) { return c >= '0' && c <= '9'; }

/// #9 before #10: runs of digits are compared as numbers, all else without its case.
int order(std::string_view a, std::string_view b) {
  std::size_t i = 0, k = 0;
  while (i < a.size() && k < b.size()) {
    if (is_decimal(a[i]) && is_decimal(b[k])) {
      const std::size_t first = i, second = k;
      while (i < a.size() && is_decimal(a[i])) ++i;
      while (k < b.size() && is_decimal(b[k])) ++k;
      const std::string_view x = a.substr(first, i - first), y = b.substr(second, k - second);
      if (x.size() != y.size()) return x.size() < y.size() ? -1 : 1;
      if (const int less = x.compare(y); less != 0) return less;
      continue;
    }
    const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : static_cast<unsigned char>(c); };
    if (const int less = small(a[i]) - small(b[k]); less != 0) return less;
    ++i, ++k;
  }
  return static_cast<int>(a.size() - i) - static_cast<int>(b.size() - k);
}

}  // namespace

bool ProgramVariables::Less::operator()(const std::pair<std::string, std::uint64_t>& a,
                                        const std::pair<std::string, std::uint64_t>& b) const {
  const int less = order(a.first, b.first);
  return less != 0 ? less < 0 : a.second < b.second;
}
bool ProgramVariables::Less::operator()(const std::pair<std::string, std::uint64_t>& a, std::string_view b) const {
  return order(a.first, b) < 0;
}
bool ProgramVariables::Less::operator()(std::string_view a, const std::pair<std::string, std::uint64_t>& b) const {
  return order(a, b.first) < 0;
}

void ProgramVariables::note(const VariableUse& use, std::uint64_t call) {
  const std::pair<std::string, std::uint64_t> key(use.name, use.scope);
  auto found = all_.find(key);
  if (found == all_.end()) {
    if (all_.size() >= most) return;
    found = all_.emplace(key, Variable{use.name, use.scope, call, 0, {}}).first;
  }
  found->second.call = call;
  found->second.used = ++uses_;
  found->second.value = use.value;
}

const ProgramVariables::Variable* ProgramVariables::find(std::string_view name) const {
  const Variable* best = nullptr;
  const auto [first, last] = all_.equal_range(name);
  for (auto i = first; i != last; ++i) {
    const Variable& v = i->second;
    const bool is_nearer = best == nullptr || (v.call == call_) > (best->call == call_) ||
                           ((v.call == call_) == (best->call == call_) && v.used > best->used);
    if (is_nearer) best = &v;
  }
  return best;
}

Value ProgramVariables::value_of(std::string_view name) const {
  const Variable* const found = find(name);
  return found == nullptr ? Value{} : found->value;
}

std::vector<const ProgramVariables::Variable*> ProgramVariables::of_program() const {
  std::vector<const Variable*> out;
  for (const auto& [key, variable] : all_)
    if (variable.scope == 0) out.push_back(&variable);
  return out;
}

std::vector<const ProgramVariables::Variable*> ProgramVariables::of_call(std::uint64_t call) const {
  std::vector<const Variable*> out;
  for (const auto& [key, variable] : all_)
    if (variable.scope != 0 && variable.call == call) out.push_back(&variable);
  return out;
}

Value value_of_argument(const ig_argument* value) {
  if (value == nullptr) return {};
  if (value->is_text == 0) return Value::of(value->number);
  return Value::of(std::string(value->text.data, value->text.size));
}

}  // namespace isogloss::dap
