// The table of options on a page has the columns "option", "default" and "range", in any order and beside others.
#include "validate/option_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace isogloss::cli {

namespace {

std::string_view trimmed(std::string_view s) {
  while (!s.empty() && (s.front() == ' ' || s.front() == '`')) s.remove_prefix(1);
  while (!s.empty() && (s.back() == ' ' || s.back() == '`' || s.back() == '\r')) s.remove_suffix(1);
  return s;
}

/// The cells of a row of a table, without the bar before the first one. A bar in code is written as \|.
std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> out;
  std::size_t begin = 1;
  for (std::size_t i = 1; i < line.size(); ++i)
    if (line[i] == '|' && line[i - 1] != '\\') {
      out.push_back(trimmed(line.substr(begin, i - begin)));
      begin = i + 1;
    }
  return out;
}

struct Row {
  std::string_view name, fallback, range;
};

std::vector<Row> rows_of(std::string_view page) {
  std::vector<Row> out;
  std::vector<std::string_view> head;
  const auto cell = [&](const std::vector<std::string_view>& cells, std::string_view title) {
    const auto at = std::find(head.begin(), head.end(), title);
    const auto index = static_cast<std::size_t>(at - head.begin());
    return at == head.end() || index >= cells.size() ? std::string_view() : cells[index];
  };
  while (!page.empty()) {
    const std::string_view line = page.substr(0, page.find('\n'));
    page.remove_prefix(std::min(line.size() + 1, page.size()));
    if (!line.starts_with('|')) {
      head.clear();
      continue;
    }
    const std::vector<std::string_view> cells = cells_of(line);
    if (cells.empty()) continue;
    if (head.empty()) head = cells;
    if (head.front() != "option" || cells == head || cells.front().starts_with('-') || cells.front().starts_with(':'))
      continue;
    out.push_back({cells.front(), cell(cells, "default"), cell(cells, "range")});
  }
  return out;
}

/// The number at the head of `s`, which is shortened by it: -1.5, 10^15.
std::optional<double> take_number(std::string_view& s) {
  s = trimmed(s);
  double out = 0;
  const auto read = [&s](double& to) {
    const auto [end, error] = std::from_chars(s.data(), s.data() + s.size(), to, std::chars_format::general);
    if (error != std::errc()) return false;
    s.remove_prefix(static_cast<std::size_t>(end - s.data()));
    return true;
  };
  if (!read(out)) return std::nullopt;
  double power = 1;
  if (s.starts_with('^') && (s.remove_prefix(1), read(power))) out = std::pow(out, power);
  return out;
}

/// "0 to 100 mm"; nothing where the cell is no such range.
std::optional<std::pair<double, double>> range_of(std::string_view cell) {
  const std::optional<double> least = take_number(cell);
  cell = trimmed(cell);
  std::string_view word;
  for (const std::string_view between : {"to ", "…", "...", "–", ".."})
    if (word.empty() && cell.starts_with(between)) word = between;
  if (!least || word.empty()) return std::nullopt;
  cell.remove_prefix(word.size());
  const std::optional<double> most = take_number(cell);
  return most ? std::optional(std::pair(*least, *most)) : std::nullopt;
}

std::vector<std::string_view> choices_of(const ig_option_decl& o) {
  std::vector<std::string_view> out;
  for (std::string_view rest = o.type == IG_OPTION_CHOICE ? o.choices : ""; !rest.empty();) {
    out.push_back(rest.substr(0, rest.find('|')));
    rest.remove_prefix(std::min(out.back().size() + 1, rest.size()));
  }
  return out;
}

bool is_number(const ig_option_decl& o) { return o.type == IG_OPTION_NUMBER || o.type == IG_OPTION_INTEGER; }

std::string default_fault(const ig_option_decl& o, std::string_view cell) {
  if (o.fallback == nullptr || cell.empty()) return {};
  const std::string_view declared = o.fallback;
  const auto differs = [&](std::string_view shown) {
    return fmt::format("the page says that the default of option '{}' is {}, the declaration has {}", o.name, shown,
                       declared);
  };
  std::string_view rest = cell, own = declared;
  if (is_number(o)) {
    const std::optional<double> shown = take_number(rest), real = take_number(own);
    return shown && real && *shown != *real ? differs(cell) : "";
  }
  std::vector<std::string_view> values = choices_of(o);
  if (o.type == IG_OPTION_BOOLEAN) values = {"true", "false"};
  const std::string_view word = trimmed(cell.substr(0, cell.find_first_of(" ,;:")));
  const bool is_value = std::find(values.begin(), values.end(), word) != values.end();
  return is_value && word != declared ? differs(word) : "";
}

std::string range_fault(const ig_option_decl& o, std::string_view cell) {
  const auto range = is_number(o) ? range_of(cell) : std::nullopt;
  if (!range || (range->first == o.minimum && range->second == o.maximum)) return {};
  return fmt::format("the page says that option '{}' goes from {} to {}, the declaration has {} to {}", o.name,
                     range->first, range->second, o.minimum, o.maximum);
}

}  // namespace

std::vector<std::string> page_faults(std::string_view page, std::span<const ig_option_decl> options) {
  std::vector<std::string> out;
  const std::vector<Row> rows = rows_of(page);
  for (const ig_option_decl& o : options) {
    if (page.find(o.name) == std::string_view::npos) {
      out.push_back(fmt::format("the page does not name option '{}'", o.name));
      continue;
    }
    for (const std::string_view choice : choices_of(o))
      if (page.find(choice) == std::string_view::npos)
        out.push_back(fmt::format("the page does not name the choice '{}' of option '{}'", choice, o.name));
    for (const Row& row : rows)
      if (row.name == o.name)
        for (std::string& fault : std::vector{default_fault(o, row.fallback), range_fault(o, row.range)})
          if (!fault.empty()) out.push_back(std::move(fault));
  }
  for (const Row& row : rows)
    if (std::none_of(options.begin(), options.end(), [&](const ig_option_decl& o) { return row.name == o.name; }) &&
        row.name.find_first_of(" ,`") == std::string_view::npos)
      out.push_back(fmt::format("the page describes the option '{}', which is not declared", row.name));
  return out;
}

}  // namespace isogloss::cli
