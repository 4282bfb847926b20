// What a program defines, gives back to its caller, and leaves behind when the run begins again.
#include "language/variable_store.hpp"

namespace siemens {

void VariableStore::enter_other(std::uint64_t frame) {
  while (scopes_.size() > 1 && scopes_.back().frame > frame) {
    const Scope ended = std::move(scopes_.back());
    scopes_.pop_back();
    for (const auto& [inner, outer] : ended.references)
      if (const auto it = ended.variables.find(inner); it != ended.variables.end()) {
        if (!it->second.is_array) set(outer, it->second.value);
        for (const std::string& element : it->second.elements)
          if (const auto own = ended.variables.find(inner + element); own != ended.variables.end())
            set(outer + element, own->second.value);
      }
  }
  if (scopes_.back().frame != frame) scopes_.push_back({frame, {}, {}, {}});
}

void VariableStore::give_for_run(const std::string& name, double value) {
  if (given_for_run_.size() < most_names) given_for_run_[name] = value;
}

std::optional<double> VariableStore::given(const std::string& name) const {
  if (const auto it = given_for_run_.find(name); it != given_for_run_.end()) return it->second;
  const auto it = given_.find(name);
  return it == given_.end() ? std::nullopt : std::optional(it->second);
}

bool VariableStore::define(const std::string& name, Value value, bool is_array) {
  auto& variables = scopes_.back().variables;
  if (is_array)
    for (const auto& [element, own] : elements(name)) variables.erase(name + element);
  if (variables.size() >= most_names) return false;
  const auto [it, is_new] = variables.insert_or_assign(name, Variable{std::move(value), is_array});
  const std::size_t bracket = name.find('[');
  if (!is_new || bracket == std::string::npos) return true;
  if (const auto array = variables.find(name.substr(0, bracket)); array != variables.end())
    array->second.elements.push_back(name.substr(bracket));
  return true;
}

void VariableStore::fill(const std::string& array, Value value) {
  auto& variables = scopes_.back().variables;
  for (const auto& [element, own] : elements(array)) variables.erase(array + element);
  Variable& all = variables.at(array);
  all.elements.clear();
  all.value = std::move(value);
}

std::vector<std::pair<std::string, Value>> VariableStore::elements(const std::string& array) {
  std::vector<std::pair<std::string, Value>> out;
  if (const Variable* const v = find(array))
    for (const std::string& element : v->elements)
      if (const Variable* const own = find(array + element)) out.emplace_back(element, own->value);
  return out;
}

void VariableStore::restart() {
  scopes_.assign(1, {});
  passed_.clear();
  said_.clear();
  macros_.clear();
  given_for_run_.clear();
  patterns.clear();
  call_path.clear();
  master_spindle.reset();
  curve_begins = 0;
}

void VariableStore::set(const std::string& name, const Value& value) {
  if (name.size() > 1 && name[0] == 'R' && name.find_first_not_of("0123456789", 1) == std::string::npos) {
    if (name.size() < 8)
      if (RParameter* const p = r(static_cast<std::size_t>(std::stoul(name.substr(1))))) *p = {value.number, true};
    return;
  }
  if (Variable* const v = find(name)) {
    if (const auto fitting = value.as(v->value.type)) v->value = *fitting;
    return;
  }
  const Variable* const array = find(name.substr(0, name.find('[')));
  if (array == nullptr || !array->is_array) return;
  if (auto fitting = value.as(array->value.type)) define(name, std::move(*fitting));
}

}  // namespace siemens
