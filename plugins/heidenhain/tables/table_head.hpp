/// The tables of a TNC have one shape: BEGIN with the name and the unit, the names of the columns, the rows, [END]. A
/// column begins at the first character of its name and ends before the name of the next one; cells may be empty, and
/// names hold blanks, so that no row can be split at its blanks.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace heidenhain {

enum class TableKind { unknown, tools, presets, datums, points, pockets, pallets };

/// Of option `unit`, and of a table's first line.
enum class TableUnit { as_written, mm, inch };

/// Without blanks and control characters at its ends.
std::string_view without_blanks(std::string_view text);
/// The position in the line that `count` characters of UTF-8 follow from another one.
std::size_t after_characters(std::string_view line, std::size_t position, std::size_t count);

struct TableColumn {
  std::string name;       ///< in capitals
  std::size_t begin = 0;  ///< characters of the line before it
};

struct TableHead {
  TableKind kind = TableKind::unknown;
  TableUnit unit = TableUnit::as_written;  ///< as_written where the first line names none
  std::vector<TableColumn> columns;
  std::size_t names_begin = 0, names_end = 0;  ///< the line with the names of the columns; rows follow it
  bool has_tabs = false;                       ///< a tab ends each cell, not the width of its column

  const TableColumn* find(std::string_view name) const;
};

/// Of any text; its kind is unknown where it does not begin as a table. With `needs_begin` the first line must stand.
TableHead read_table_head(std::string_view text, bool needs_begin);

}  // namespace heidenhain
