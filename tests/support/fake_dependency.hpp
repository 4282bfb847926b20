/// A dependency of a plugin outside a host: its descriptor, an in-memory table, and its services.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "isogloss.h"

namespace isogloss_test {

class FakeDependency {
 public:
  /// What stands in a column: a number, or a text.
  struct Cell {
    Cell(double value) : number(value) {}     // NOLINT(google-explicit-constructor): a table of values reads better
    Cell(const char* value) : text(value) {}  // NOLINT(google-explicit-constructor)
    double number = 0;
    std::string text;
  };
  using Rows = std::map<std::string, std::map<std::string, Cell>>;

  /// Options by name; those not given have their default. Shipped rows come first, `rows` change them.
  FakeDependency(const ig_plugin& plugin, std::string_view id, const Rows& rows = {},
                 std::map<std::string, std::string> options = {})
      : descriptor_(find(plugin, id)), options_(std::move(options)) {
    for (std::uint32_t i = 0; i < descriptor_.default_row_count; ++i) ship(descriptor_.default_rows[i]);
    for (const auto& [row, cells] : rows) {
      add(row);
      for (const auto& [column, value] : cells) table_.at(row).insert_or_assign(index_of(column), value);
    }
    api_.struct_size = sizeof api_;
    api_.option_number = [](ig_link* link, std::uint32_t i) { return std::stod(self(link).option(i)); };
    api_.option_integer = [](ig_link* link, std::uint32_t i) { return self(link).integer(i); };
    api_.option_text = [](ig_link* link, std::uint32_t i) {
      const FakeDependency& me = self(link);
      const auto given = me.options_.find(me.descriptor_.options[i].name);
      if (given != me.options_.end()) return ig_text{given->second.data(), given->second.size()};
      const std::string_view fallback = me.descriptor_.options[i].fallback;
      return ig_text{fallback.data(), fallback.size()};
    };
    api_.table = [](ig_link* link) { return reinterpret_cast<ig_table*>(link); };
    api_.value = [](const ig_table* table, ig_text row, std::uint32_t column, double* out) {
      return self(table).value({row.data, row.size}, column, out);
    };
    api_.set_value = [](ig_table* table, ig_text row, std::uint32_t column, double v) {
      auto& me = const_cast<FakeDependency&>(self(table));
      me.add({row.data, row.size});
      me.table_.at(std::string(row.data, row.size)).insert_or_assign(column, v);
      return std::int32_t{1};
    };
    api_.text_value = [](const ig_table* table, ig_text row, std::uint32_t column) {
      const Cell* const cell = self(table).cell({row.data, row.size}, column);
      return cell == nullptr ? ig_text{nullptr, 0} : ig_text{cell->text.data(), cell->text.size()};
    };
    api_.row_count = [](const ig_table* table) { return static_cast<std::uint32_t>(self(table).table_.size()); };
    api_.row_name = [](const ig_table* table, std::uint32_t row) {
      const std::string& name = std::next(self(table).table_.begin(), row)->first;
      return ig_text{name.data(), name.size()};
    };
    api_.fail = [](ig_link* link, ig_text reason) {
      const_cast<FakeDependency&>(self(link)).failure_.assign(reason.data, reason.size);
    };
    if (descriptor_.create(&api_, reinterpret_cast<ig_link*>(this), nullptr, &instance_) != IG_CHANGED)
      throw std::runtime_error(failure_.empty() ? "create() failed" : failure_);
  }
  ~FakeDependency() { descriptor_.destroy(instance_); }
  FakeDependency(const FakeDependency&) = delete;
  FakeDependency& operator=(const FakeDependency&) = delete;

  template <class Service>
  const Service* service(const char* id) const {
    return static_cast<const Service*>(descriptor_.service(instance_, id));
  }
  /// Why a row means nothing; empty when it means something.
  std::string row_fault(std::string_view row) const {
    const ig_text fault = descriptor_.row_fault(instance_, {row.data(), row.size()});
    return {fault.data, fault.size};
  }

 private:
  static const FakeDependency& self(const void* p) { return *static_cast<const FakeDependency*>(p); }
  static const FakeDependency& self(ig_link* p) { return self(static_cast<const void*>(p)); }

  static const ig_dependency& find(const ig_plugin& plugin, std::string_view id) {
    for (std::uint32_t i = 0; i < plugin.dependency_count; ++i)
      if (id == plugin.dependencies[i]->id) return *plugin.dependencies[i];
    throw std::runtime_error("no such dependency");
  }

  std::string option(std::uint32_t i) const {
    const auto given = options_.find(descriptor_.options[i].name);
    return given != options_.end() ? given->second : descriptor_.options[i].fallback;
  }
  std::int64_t integer(std::uint32_t i) const {
    if (descriptor_.options[i].type == IG_OPTION_BOOLEAN) return option(i) == "true" ? 1 : 0;
    if (descriptor_.options[i].type != IG_OPTION_CHOICE) return std::stoll(option(i));
    const std::string choices = descriptor_.options[i].choices;
    const std::size_t at = ('|' + choices + '|').find('|' + option(i) + '|');
    std::int64_t index = 0;
    for (std::size_t k = 0; k < at; ++k) index += choices[k] == '|';
    return at == 0 ? 0 : index;
  }

  std::uint32_t index_of(std::string_view column) const {
    for (std::uint32_t i = 0; i < descriptor_.column_count; ++i)
      if (column == descriptor_.columns[i].name) return i;
    throw std::runtime_error("no such column");
  }
  void add(std::string_view row) {
    const auto [cells, is_new] = table_.try_emplace(std::string(row));
    if (!is_new) return;
    for (std::uint32_t i = 0; i < descriptor_.column_count; ++i)
      if (const char* fallback = descriptor_.columns[i].fallback; fallback != nullptr)
        cells->second.insert_or_assign(i, std::stod(fallback));
  }
  /// "key|column=value|…"
  void ship(std::string_view row) {
    const std::string key(row.substr(0, row.find('|')));
    add(key);
    while (row.find('|') != std::string_view::npos) {
      row.remove_prefix(row.find('|') + 1);
      const std::string_view cell = row.substr(0, row.find('|'));
      const std::size_t equals = cell.find('=');
      table_.at(key).insert_or_assign(index_of(cell.substr(0, equals)),
                                      std::stod(std::string(cell.substr(equals + 1))));
    }
  }
  const Cell* cell(std::string_view row, std::uint32_t column) const {
    const auto cells = table_.find(std::string(row));
    if (cells == table_.end()) return nullptr;
    const auto found = cells->second.find(column);
    return found == cells->second.end() ? nullptr : &found->second;
  }
  std::int32_t value(std::string_view row, std::uint32_t column, double* out) const {
    const Cell* const found = cell(row, column);
    if (found == nullptr) return 0;
    *out = found->number;
    return 1;
  }

  const ig_dependency& descriptor_;
  std::map<std::string, std::string> options_;
  std::map<std::string, std::map<std::uint32_t, Cell>> table_;
  ig_link_api api_{};
  void* instance_ = nullptr;
  std::string failure_;
};

/// The services of a control's parameters.
inline constexpr const char* number_format = "isogloss.number-format/1";
inline constexpr const char* canned_cycle = "isogloss.canned-cycle/1";
inline constexpr const char* motion_settings = "isogloss.motion/1";
inline constexpr const char* coordinate_system = "isogloss.coordinate-system/1";

/// What a parameter table answers to a name; -1000 where it does not know it.
inline double number(const FakeDependency& table, const char* service, std::string_view name) {
  constexpr double unknown = -1000;
  const auto* s = table.service<ig_config_1>(service);
  double out = unknown;
  return s->number(s->self, {name.data(), name.size()}, &out) != 0 ? out : unknown;
}

}  // namespace isogloss_test
