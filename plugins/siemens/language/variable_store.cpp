// What a program defines, gives back to its caller, and leaves behind when the run begins again.
#include "language/variable_store.hpp"

#include <algorithm>

namespace siemens {

void VariableStore::enter_other(std::uint64_t frame) {
  while (scopes_.size() > 1 && scopes_.back().frame > frame) {
    const Scope ended = std::move(scopes_.back());
    scopes_.pop_back();
    for (const auto& [inner, outer] : ended.references)
      if (const auto it = ended.variables.find(inner); it != ended.variables.end()) {
        if (!it->second.is_array) give_back(outer, it->second.value);
        for (const std::string& element : it->second.elements)
          if (const auto own = ended.variables.find(inner + element); own != ended.variables.end())
            give_back(outer + element, own->second.value);
      }
  }
  if (scopes_.back().frame != frame) scopes_.push_back({frame, {}, {}, {}});
}

std::vector<VariableStore::GivenBack> VariableStore::given_back() {
  std::vector<GivenBack> out;
  if (scopes_.size() < 2) return out;
  Scope &ended = scopes_.back(), &caller = scopes_[scopes_.size() - 2];
  for (const auto& [inner, outer] : ended.references) {
    const auto it = ended.variables.find(inner);
    if (it == ended.variables.end()) continue;
    const bool is_own = caller.variables.contains(outer);
    if (!it->second.is_array) out.push_back({outer, it->second.value, is_own, caller.frame});
    for (const std::string& element : it->second.elements)
      if (const auto own = ended.variables.find(inner + element); own != ended.variables.end())
        out.push_back({outer + element, own->second.value, is_own, caller.frame});
  }
  return out;
}

void VariableStore::give_for_run(const std::string& name, double value) {
  if (given_for_run_.size() >= most_names) return;
  given_for_run_[name] = value;
  rows.overwrite(name);
}

std::optional<double> VariableStore::given(const std::string& name) const {
  if (const auto it = given_for_run_.find(name); it != given_for_run_.end()) return it->second;
  const auto it = given_.find(name);
  return it == given_.end() ? std::nullopt : std::optional(it->second);
}

bool VariableStore::define(const std::string& name, const Declared& type, bool is_array) {
  Variables& variables = scopes_.back().variables;
  if (const Variable* const before = find_own(name); before != nullptr && is_array)
    for (const std::string& element : before->elements) variables.erase(name + element);
  if (variables.size() >= most_names) return false;
  Variable& defined = variables.insert_or_assign(name, Variable{type.initial(), is_array}).first->second;
  defined.declared = type;
  return true;
}

VariableStore::Variables* VariableStore::holder_of(const std::string& name, const std::string& base) {
  for (Variables* const variables : {&scopes_.back().variables, &user_data_}) {
    if (find_in(*variables, name) != nullptr) return variables;
    if (const Variable* const array = find_in(*variables, base); array != nullptr && array->is_array) return variables;
  }
  return nullptr;
}

Stored VariableStore::assign(const std::string& name, Value value) {
  const std::size_t bracket = name.find('[');
  const std::string base = name.substr(0, bracket);
  Variables* const variables = holder_of(name, base);
  if (variables == nullptr) return Stored::unknown;
  Variable* to = find_in(*variables, name);
  Variable* const array = bracket == std::string::npos ? nullptr : find_in(*variables, base);
  if (to == nullptr && !array->sizes.empty() && !array->number_of(std::string_view(name).substr(bracket)))
    return Stored::outside_array;
  if (const Stored fitting = (to != nullptr ? to : array)->declared.fit(value); fitting != Stored::yes) return fitting;
  if (to == nullptr) {
    if (variables->size() >= most_names) return Stored::too_many;
    array->elements.push_back(name.substr(bracket));
    to = &(*variables)[name];
    to->declared = array->declared;
  }
  to->value = std::move(value);
  if (variables == &user_data_ && saver_ != nullptr) saver_->save(name, to->value);
  return Stored::yes;
}

bool VariableStore::may_hold(const std::string& array, std::size_t first, std::size_t count) {
  const Variables& variables = *holder_of(array, array);
  const Variable& all = variables.at(array);
  const auto known = std::count_if(all.elements.begin(), all.elements.end(), [&](const std::string& element) {
    const std::optional<std::size_t> number = all.number_of(element);
    return number && *number >= first && *number - first < count;
  });
  return variables.size() + count - static_cast<std::size_t>(known) <= most_names;
}

void VariableStore::fill(const std::string& array, const Value& value) {
  Variables& variables = *holder_of(array, array);
  const bool is_saved = &variables == &user_data_ && saver_ != nullptr;
  Variable& all = variables.at(array);
  for (const std::string& element : all.elements) {
    variables.erase(array + element);
    if (is_saved) saver_->save(array + element, value);
  }
  all.elements.clear();
  all.value = value;
  if (is_saved) saver_->save(array, value);
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
  user_data_ = user_data_at_start_;
  passed_.clear();
  unread_.clear();
  said_.clear();
  macros_.clear();
  given_for_run_.clear();
  patterns.clear();
  call_path.clear();
  master_spindle.reset();
  curve_begins = 0;
}

void VariableStore::give_back(const std::string& name, const Value& value) {
  if (name.size() > 1 && name[0] == 'R' && name.find_first_not_of("0123456789", 1) == std::string::npos) {
    if (name.size() < 8)
      if (const std::size_t number = std::stoul(name.substr(1)); r(number) != nullptr) assign_r(number, value.number);
    return;
  }
  if (const Stored outcome = assign(name, value); outcome != Stored::yes)
    not_given_back.push_back({name, value, outcome});
}

}  // namespace siemens
