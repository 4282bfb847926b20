#include "isogloss/engine/layout.hpp"

namespace isogloss {

SymbolTable::SymbolTable() { names_.emplace_back(); }

SymbolTable::SymbolTable(const SymbolTable& other) {
  names_.emplace_back();
  for (std::size_t i = 1; i < other.names_.size(); ++i) intern(other.names_[i]);
}

ig_symbol SymbolTable::intern(std::string_view name) {
  if (const auto found = ids_.find(name); found != ids_.end()) return found->second;
  const auto id = static_cast<ig_symbol>(names_.size());
  const auto [where, added] = ids_.emplace(std::string(name), id);
  names_.push_back(where->first);
  return id;
}

void Layout::index() {
  ids_.clear();
  ids_.reserve(fields.size());
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (fields[i].previous_of == IG_NO_FIELD) ids_.emplace(fields[i].path, static_cast<ig_field>(i));
}

std::optional<ig_field> Layout::find(std::string_view path) const {
  const auto found = ids_.find(path);
  return found == ids_.end() ? std::nullopt : std::optional<ig_field>(found->second);
}

ig_field Layout::record(std::string_view list, std::string_view path) const {
  for (std::size_t l = 0; l < lists.size(); ++l) {
    if (lists[l].path != list) continue;
    for (std::size_t i = 0; i < lists[l].fields.size(); ++i)
      if (lists[l].fields[i].path == path) return record_field(l, i);
  }
  return IG_NO_FIELD;
}

std::string_view Layout::code_name(std::string_view path) {
  constexpr std::string_view flags = "Parsing.Flags.", words = "Parsing.";
  if (path.starts_with(flags)) return path.substr(flags.size());
  return path.starts_with(words) ? path.substr(words.size()) : path;
}

}  // namespace isogloss
