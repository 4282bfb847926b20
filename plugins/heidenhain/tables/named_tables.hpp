/// Tables that a program selects by the name of their file: datum tables and point tables. A dependency owns the rows
/// of all of them, each with a key, ZERO.D#5, and provides them to the syntaxes of this plugin.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include <isogloss/sdk.hpp>

namespace heidenhain {

/// The name of a table and the number of a row in it.
struct TableKey {
  std::string_view table;
  std::int64_t row = 0;

  /// Of "ZERO.D#5"; nothing where it is no such key.
  static std::optional<TableKey> read(std::string_view key);
};

/// The name without its folder, in capitals.
std::string table_name(std::string_view path);
/// The name without .D and its kin.
std::string_view without_ending(std::string_view name);

/// The rows of one table, by their number, that a file holds.
struct WrittenTable {
  std::string name;
  std::map<std::int64_t, std::uint32_t> rows;  ///< place among the rows of the dependency
};

/// The table of a dependency that has this name, in any case of letters; the first one where `asked` is empty. Names
/// the others as parts that the file has no place for.
WrittenTable written_table(ig::Export& out, const char* dependency, std::string_view asked);

template <class Row>
class NamedTables {
 public:
  struct Table {
    std::string name;  ///< of the file, without its folder
    std::map<std::int64_t, Row> rows;
  };

  /// The table that a program names, with or without a folder and an ending, in any case of letters.
  const Table* find(std::string_view path) const {
    const std::string name = table_name(path);
    if (const auto found = tables_.find(name); found != tables_.end()) return &found->second;
    const auto found = without_ending_.find(name);
    return found != without_ending_.end() ? found->second : nullptr;
  }
  /// The table that is in force without a selection: the one that the machine marks, or the only one.
  const Table* standard() const {
    if (!marked_.empty()) return find(marked_);
    return tables_.size() == 1 ? &tables_.begin()->second : nullptr;
  }
  std::size_t size() const { return tables_.size(); }

  /// False where the row has been added before.
  bool add(const TableKey& key, const Row& row) {
    const std::string name = table_name(key.table);
    Table& table = tables_[name];
    if (table.name.empty()) {
      table.name = key.table;
      without_ending_.emplace(without_ending(name), &table);
    }
    return table.rows.emplace(key.row, row).second;
  }
  void mark(std::string_view name) { marked_ = name; }

 private:
  std::map<std::string, Table, std::less<>> tables_;  // by the name in capitals
  std::map<std::string, const Table*, std::less<>> without_ending_;
  std::string marked_;
};

}  // namespace heidenhain
