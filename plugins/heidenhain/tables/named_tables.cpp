#include "tables/named_tables.hpp"

#include <charconv>

#include <isogloss/cnc/scan.hpp>

namespace heidenhain {

using namespace ig::cnc;

std::string table_name(std::string_view path) {
  const std::size_t folder = path.find_last_of("\\/:");
  return in_capitals(folder == std::string_view::npos ? path : path.substr(folder + 1));
}

std::string_view without_ending(std::string_view name) { return name.substr(0, name.rfind('.')); }

std::optional<TableKey> TableKey::read(std::string_view key) {
  const std::size_t mark = key.rfind('#');
  const std::size_t folder = key.find_last_of("\\/:");
  if (mark == std::string_view::npos || mark == 0 || folder != std::string_view::npos) return std::nullopt;
  TableKey out{key.substr(0, mark), 0};
  const char* const end = key.data() + key.size();
  const auto [read, error] = std::from_chars(key.data() + mark + 1, end, out.row);
  const bool is_number = error == std::errc{} && read == end && out.row >= 0;
  return is_number && std::to_string(out.row) == key.substr(mark + 1) ? std::optional(out) : std::nullopt;
}

WrittenTable written_table(ig::Export& out, const char* dependency, std::string_view asked) {
  WrittenTable table{std::string(asked), {}};
  for (std::uint32_t i = 0; i < out.rows(dependency); ++i) {
    const auto key = TableKey::read(out.key(dependency, i));
    if (!key) {
      out.unused("row " + std::string(out.key(dependency, i)), "its id has no name of a table and number of a row");
      continue;
    }
    if (table.name.empty()) table.name = key->table;
    if (table_name(key->table) != table_name(table.name)) {
      out.unused("table " + std::string(key->table), "a file holds one table: name it by the option table");
      continue;
    }
    if (!table.rows.emplace(key->row, i).second)
      out.unused("row " + std::string(out.key(dependency, i)), "another row has this name, in other letters");
  }
  return table;
}

}  // namespace heidenhain
