#include "tables/table_reader.hpp"

#include <algorithm>
#include <cmath>

#include <isogloss/cnc/file_length.hpp>
#include <isogloss/cnc/scan.hpp>
#include <isogloss/cnc/units.hpp>

namespace heidenhain {

using namespace ig::cnc;

namespace {

constexpr std::size_t longest_number = 64, longest_shown = 40;
// Far beyond any machine, and within what the columns of all tables take.
constexpr double largest_number = 1e8;

bool begins_number(char c) { return is_digit(c) || c == '.' || c == ',' || c == '+' || c == '-'; }
bool continues_number(char c) { return is_digit(c) || c == '.' || c == ','; }

/// A value as a diagnostic shows it.
std::string_view shown(std::string_view text) { return text.substr(0, after_characters(text, 0, longest_shown)); }

}  // namespace

TableReader::TableReader(ig::Import& file, TableKind kind, TableUnit unit, IsName holds_number)
    : file_(file), head_(read_table_head(file.text(), false)), end_(file.lines().end()) {
  const bool is_wrong = head_.kind != kind;
  if (is_wrong || head_.columns.empty()) {
    file.report(is_wrong ? ig::diag("HEI-0301") : ig::diag("HEI-0302"), head_.names_begin, head_.names_end);
    head_ = {};
    has_end_ = true;
    return;
  }
  for (const TableColumn& column : head_.columns) holds_number_.push_back(holds_number(column.name));
  holds_number_[0] = true;
  if (head_.unit == TableUnit::as_written) head_.unit = unit;
  if (head_.unit == TableUnit::as_written) file.report(ig::diag("HEI-0303"), 0, head_.names_begin);
  mm_ = head_.unit == TableUnit::inch ? mm_per_inch : 1;
}

ig::TextLines::Iterator TableReader::first_row() const {
  if (head_.columns.empty()) return end_;
  ig::TextLines::Iterator line(file_.text(), head_.names_begin);
  return ++line;
}

bool TableReader::ends(const ig::TextLine& line) {
  if (!without_blanks(line.text).starts_with("[END]")) return false;
  has_end_ = true;
  after_end_ = line.begin + line.text.size();
  return true;
}

void TableReader::finish() {
  const std::string_view all = file_.text();
  if (!has_end_) return file_.report(ig::diag("HEI-0304"), all.size(), all.size());
  if (after_end_ == 0) return;
  const std::string_view rest = without_blanks(all.substr(after_end_));
  if (rest.empty()) return;
  const auto begin = static_cast<std::size_t>(rest.data() - all.data());
  file_.unused("text after [END]", "the table ends there", begin, begin + rest.size());
}

/// False where the line has no cells.
bool TableReader::split(const ig::TextLine& line) {
  cells_.clear();
  const std::string_view content = without_blanks(line.text);
  if (content.empty() || content.front() == ';') return false;
  if (head_.has_tabs || content.find('\t') != std::string_view::npos) return split_at_tabs(line);
  std::size_t begin = 0;
  for (std::size_t i = 0; i < head_.columns.size() && begin < line.text.size(); ++i) {
    const bool is_last = i + 1 == head_.columns.size();
    const std::size_t end =
        is_last ? line.text.size()
                : after_characters(line.text, begin, head_.columns[i + 1].begin - head_.columns[i].begin);
    add_cell(line, i, begin, end);
    if (!cells_.empty() && cells_.back().column == i)
      cells_.back().is_shifted = is_shifted(line.text, begin, end, cells_.back().text);
    begin = end;
  }
  return !cells_.empty();
}

/// A row with tabs has a cell for each column, or the alignment is lost. At the end cells may be missing where the
/// names of the columns have tabs, too.
bool TableReader::split_at_tabs(const ig::TextLine& line) {
  const auto fields = static_cast<std::size_t>(std::count(line.text.begin(), line.text.end(), '\t')) + 1;
  const std::size_t columns = head_.columns.size();
  const bool fits =
      fields == columns || (head_.has_tabs && fields < columns) || (fields == columns + 1 && line.text.back() == '\t');
  if (!fits) {
    file_.report(ig::diag("HEI-0305"), line.begin, line.begin + line.text.size());
    return false;
  }
  std::size_t begin = 0;
  for (std::size_t i = 0; i < columns && begin <= line.text.size(); ++i) {
    const std::size_t end = std::min(line.text.find('\t', begin), line.text.size());
    add_cell(line, i, begin, end);
    begin = end + 1;
  }
  return !cells_.empty();
}

void TableReader::add_cell(const ig::TextLine& line, std::size_t column, std::size_t begin, std::size_t end) {
  const std::string_view all = line.text, text = without_blanks(all.substr(begin, end - begin));
  if (text.empty()) return;
  const auto at = static_cast<std::size_t>(text.data() - all.data());
  cells_.push_back({column, text, line.begin + at, false});
}

/// True for a number that runs over an edge of its column, for two of them, and for a digit that the column has only
/// because it stands one character before the next one. Between tabs nothing is shifted.
bool TableReader::is_shifted(std::string_view line, std::size_t begin, std::size_t end, std::string_view text) {
  const auto crosses = [&](std::size_t edge) {
    return edge > 0 && edge < line.size() && begins_number(line[edge - 1]) && continues_number(line[edge]);
  };
  const bool is_last = text.size() == 1 && end - begin > 2 && end < line.size() && text.data() + 1 == line.data() + end;
  return crosses(begin) || crosses(end) || is_last || text.find(' ') != std::string_view::npos;
}

bool TableReader::reports_shift() const {
  const auto shifted = std::find_if(cells_.begin(), cells_.end(),
                                    [&](const TableCell& c) { return c.is_shifted && holds_number_[c.column]; });
  if (shifted == cells_.end()) return false;
  file_.report(ig::diag("HEI-0309"), shifted->begin, shifted->end(), column(*shifted).name, shown(cells_.front().text));
  return true;
}

std::optional<std::string> TableReader::row_number(const std::vector<TableCell>& cells, std::int64_t maximum,
                                                   std::int64_t maximum_index) {
  const TableCell& cell = cells.front();
  const std::string& name = head_.columns[0].name;
  if (cell.column != 0) {
    file_.report(ig::diag("HEI-0306"), cell.begin, cell.end(), name);
    return std::nullopt;
  }
  const std::size_t point = std::min(cell.text.find_first_of(".,"), cell.text.size());
  const auto whole = [](std::string_view digits) -> std::int64_t {
    const bool is_number = !digits.empty() && digits.size() < 9 && std::all_of(digits.begin(), digits.end(), is_digit);
    return is_number ? static_cast<std::int64_t>(ig::read_decimal(digits, 0).value) : -1;
  };
  const std::int64_t number = whole(cell.text.substr(0, point));
  const std::string_view index_text = point < cell.text.size() ? cell.text.substr(point + 1) : "0";
  // 5.10 is index 10 and 5.1 is index 1; what 5.01 would be is not known.
  const bool is_index = index_text.size() == 1 || !index_text.starts_with('0');
  const std::int64_t index = is_index ? whole(index_text) : -1;
  if (number < 0 || number > maximum || index < 0 || index > maximum_index) {
    file_.report(ig::diag("HEI-0307"), cell.begin, cell.end(), shown(cell.text), name, maximum);
    return std::nullopt;
  }
  std::string key = std::to_string(number);
  if (index > 0) key += "." + std::to_string(index);
  if (known_rows_.insert(key).second) return key;
  file_.report(ig::diag("HEI-0308"), cell.begin, cell.end(), key);
  return std::nullopt;
}

std::optional<double> TableReader::number(const TableCell& cell, std::string_view row) const {
  const std::string& name = column(cell).name;
  std::string digits(cell.text.substr(0, longest_number));
  // The decimal sign is a setting of the control; no table has another comma in a number.
  if (const std::size_t comma = digits.find(','); comma != std::string::npos) digits[comma] = '.';
  const ig::Decimal read = ig::read_decimal(digits, 0);
  if (read.ok && read.end == cell.text.size() && std::abs(read.value) <= largest_number) return read.value;
  file_.report(ig::diag("HEI-0310"), cell.begin, cell.end(), shown(cell.text), name, row);
  return std::nullopt;
}

double TableReader::in_mm(double length) const { return length_in_mm(length, mm_); }

void TableReader::unused(const TableCell& cell, std::string_view why) const {
  const auto is_filling = [](char c) { return c == '0' || c == '+' || c == '-' || c == '.' || c == ',' || c == '%'; };
  if (std::all_of(cell.text.begin(), cell.text.end(), is_filling)) return;
  file_.unused("column " + column(cell).name, why, cell.begin, cell.end());
}

}  // namespace heidenhain
