#include "dialect/options.hpp"
#include "isogloss/engine/chain.hpp"

#include <fmt/format.h>

#include <cmath>

namespace isogloss {

std::optional<std::size_t> DependencyTable::column(std::string_view name) const {
  for (std::uint32_t i = 0; i < dependency_->column_count; ++i)
    if (name == dependency_->columns[i].name) return i;
  return std::nullopt;
}

std::vector<DependencyTable::Cell>& DependencyTable::row(std::string_view name) {
  if (const auto known = index_.find(name); known != index_.end()) return cells_[known->second];
  index_.emplace(std::string(name), names_.size());
  names_.emplace_back(name);
  std::vector<Cell> cells(dependency_->column_count);
  for (std::uint32_t i = 0; i < dependency_->column_count; ++i) {
    const char* const fallback = dependency_->columns[i].fallback;
    if (fallback == nullptr) continue;
    cells[i].text = fallback;
    cells[i].number = parse_number(fallback).value_or(0);
    cells[i].has_value = true;
  }
  return cells_.emplace_back(std::move(cells));
}

std::optional<double> DependencyTable::value(std::string_view name, std::uint32_t column) const {
  const auto found = index_.find(name);
  const Cell* const cell =
      found == index_.end() || column >= dependency_->column_count ? nullptr : &cells_[found->second][column];
  const bool has_value = cell != nullptr && cell->has_value;
  if (listener_) listener_(name, has_value);
  return has_value ? std::optional<double>(cell->number) : std::nullopt;
}

std::string_view DependencyTable::text(std::string_view name, std::uint32_t column) const {
  const auto found = index_.find(name);
  const std::string_view text = found == index_.end() || column >= dependency_->column_count
                                    ? std::string_view{}
                                    : std::string_view(cells_[found->second][column].text);
  if (listener_) listener_(name, !text.empty());
  return text;
}

bool DependencyTable::set(std::string_view name, std::uint32_t column, std::string_view text) {
  if (column >= dependency_->column_count) return false;
  const ig_column_decl& declared = dependency_->columns[column];
  double number = 0;
  if (declared.is_text == 0) {
    const std::optional<double> v = parse_number(text);
    if (!v || *v < declared.minimum || *v > declared.maximum) return false;
    number = *v;
  }
  row(name)[column] = {std::string(text), number, true};
  return true;
}

bool DependencyTable::set(std::string_view name, std::uint32_t column, double value) {
  if (column >= dependency_->column_count) return false;
  const ig_column_decl& declared = dependency_->columns[column];
  if (!std::isfinite(value) || value < declared.minimum || value > declared.maximum) return false;
  row(name)[column] = {fmt::format("{}", value), value, true};
  return true;
}

}  // namespace isogloss
