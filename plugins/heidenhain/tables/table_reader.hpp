/// Rows of a TNC's table as cells, and what is wrong with them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include <isogloss/sdk.hpp>

#include "tables/table_head.hpp"

namespace heidenhain {

/// What stands in a column of a row, without the blanks around it.
struct TableCell {
  std::size_t column = 0;
  std::string_view text;
  std::size_t begin = 0;    ///< in the file
  bool is_shifted = false;  ///< as a number it does not stand in its column alone

  std::size_t end() const { return begin + text.size(); }
  /// "-" stands for no value.
  bool is_given() const { return !text.empty() && text != "-"; }
};

/// Reads the rows of one table, and reports what is wrong with them.
class TableReader {
 public:
  using IsName = bool (*)(std::string_view column);

  /// Reports the head where it names no unit. Without a table of this kind there are no rows, which is reported, too.
  TableReader(ig::Import& file, TableKind kind, TableUnit unit, IsName holds_number);

  const TableColumn& column(const TableCell& cell) const { return head_.columns[cell.column]; }
  const TableHead& head() const { return head_; }
  /// A length of the table in mm.
  double in_mm(double length) const;

  /// Calls read(cells) for each row that has a cell; the cells stand in the order of the columns. Leaves out, and
  /// reports, a row in which a number does not stand in its column: others may stand in a wrong one unnoticed.
  template <class Read>
  void rows(Read&& read) {
    for (auto line = first_row(); line != end_ && !ends(*line); ++line)
      if (split(*line) && !reports_shift()) read(std::as_const(cells_));
    finish();
  }

  /// The whole number in the first column; nothing, and reported, where there is none or it came before.
  std::optional<std::string> row_number(const std::vector<TableCell>& cells, std::int64_t maximum,
                                        std::int64_t maximum_index);
  /// Reported where it is not a number.
  std::optional<double> number(const TableCell& cell, std::string_view row) const;
  /// Names a cell that is not read, unless it holds zero, as cells do that nobody filled in.
  void unused(const TableCell& cell, std::string_view why) const;

 private:
  ig::TextLines::Iterator first_row() const;
  bool ends(const ig::TextLine& line);
  void finish();
  bool split(const ig::TextLine& line);
  bool reports_shift() const;
  static bool is_shifted(std::string_view line, std::size_t begin, std::size_t end, std::string_view text);
  bool split_at_tabs(const ig::TextLine& line);
  void add_cell(const ig::TextLine& line, std::size_t column, std::size_t begin, std::size_t end);

  ig::Import& file_;
  TableHead head_;
  std::vector<bool> holds_number_;  // by column; the first one does
  double mm_ = 1;
  ig::TextLines::Iterator end_;
  std::vector<TableCell> cells_;
  std::unordered_set<std::string> known_rows_;
  bool has_end_ = false;
  std::size_t after_end_ = 0;
};

}  // namespace heidenhain
