#include "tables/table_head.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include <isogloss/sdk.hpp>

namespace heidenhain {

namespace {

constexpr std::size_t longest_name = 64;

bool is_space_or_control(char c) { return static_cast<unsigned char>(c) <= ' '; }
bool is_in_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

std::string capitals(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return out;
}

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < line.size();) {
    if (is_space_or_control(line[i])) {
      ++i;
      continue;
    }
    const std::size_t begin = i;
    while (i < line.size() && !is_space_or_control(line[i])) ++i;
    out.push_back(capitals(line.substr(begin, i - begin)));
  }
  return out;
}

/// "BEGIN TOOL.T MM", of old controls "BEGIN TOOL    .T       MM"; perhaps a version follows.
struct BeginLine {
  bool stands = false;
  TableUnit unit = TableUnit::as_written;
  std::string suffix;

  explicit BeginLine(std::string_view line) {
    const std::vector<std::string> words = words_of(without_blanks(line));
    stands = words.size() >= 2 && words[0] == "BEGIN" && words[1] != "PGM";
    if (!stands) return;
    for (std::size_t i = 2; i < words.size() && unit == TableUnit::as_written; ++i)
      unit = words[i] == "MM" ? TableUnit::mm : words[i] == "INCH" ? TableUnit::inch : TableUnit::as_written;
    const std::string& name = words.size() > 2 && words[2].starts_with('.') ? words[2] : words[1];
    if (const std::size_t point = name.rfind('.'); point != std::string::npos) suffix = name.substr(point);
  }
};

/// Skips the description of the columns that some tables have before their names.
class Preamble {
 public:
  bool holds(std::string_view line) {
    if (line.starts_with(';')) return true;
    if (!inside_) {
      inside_ = line.starts_with("#STRUCTBEGIN") || line.starts_with("TableDescription");
      return inside_;
    }
    if (line.starts_with('#') || line.starts_with(')')) inside_ = false;
    return true;
  }

 private:
  bool inside_ = false;
};

/// False where the tabs do not stand one between each two names.
bool read_names(std::string_view line, TableHead& head) {
  head.has_tabs = line.find('\t') != std::string_view::npos;
  bool is_between = true;
  for (std::size_t i = 0, characters = 0; i < line.size(); ++characters) {
    const std::size_t end = after_characters(line, i, 1);
    const bool was_between = std::exchange(is_between, is_space_or_control(line[i]));
    if (was_between && !is_between) head.columns.push_back({"", characters});
    if (!is_between && head.columns.back().name.size() < longest_name)
      head.columns.back().name += capitals(line.substr(i, end - i));
    i = end;
  }
  std::unordered_set<std::string> known;
  for (TableColumn& column : head.columns)
    if (!known.insert(column.name).second) column.name += " (again)";
  const std::string_view inner = without_blanks(line);
  const auto tabs = static_cast<std::size_t>(std::count(inner.begin(), inner.end(), '\t'));
  return !head.has_tabs || tabs + 1 == head.columns.size();
}

TableKind kind_of(const TableHead& head, std::string_view suffix) {
  const auto has = [&](std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(), [&](const char* name) { return head.find(name) != nullptr; });
  };
  if (head.columns.empty()) return TableKind::unknown;
  const std::string& first = head.columns[0].name;
  if (first == "T") return has({"L"}) && has({"R"}) ? TableKind::tools : TableKind::unknown;
  if (first == "P") return has({"T", "TNAME"}) ? TableKind::pockets : TableKind::unknown;
  if (first != "NO" && first != "NR" && first != "D") return TableKind::unknown;
  if (has({"PAL/PGM", "PAL", "PALPRES"})) return TableKind::pallets;
  if (has({"FADE", "CLEARANCE"}) || suffix == ".PNT") return TableKind::points;
  if (!has({"X", "Y", "Z"})) return TableKind::unknown;
  const bool is_preset = has({"ROT", "SPA", "SPB", "SPC", "X_OFFS", "A_OFFS", "B_OFFS", "C_OFFS", "ACTNO"});
  return is_preset || suffix == ".PR" ? TableKind::presets : TableKind::datums;
}

}  // namespace

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && is_space_or_control(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space_or_control(text.back())) text.remove_suffix(1);
  return text;
}

std::size_t after_characters(std::string_view line, std::size_t position, std::size_t count) {
  for (; count > 0 && position < line.size(); --count) {
    ++position;
    while (position < line.size() && is_in_character(line[position])) ++position;
  }
  return position;
}

const TableColumn* TableHead::find(std::string_view name) const {
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const TableColumn& c) { return c.name == name; });
  return found == columns.end() ? nullptr : &*found;
}

TableHead read_table_head(std::string_view text, bool needs_begin) {
  TableHead head;
  BeginLine begin("");
  Preamble preamble;
  const ig::TextLines lines(text);
  bool is_first = true;
  for (const ig::TextLine& line : lines) {
    const std::string_view content = without_blanks(line.text);
    if (content.empty()) continue;
    if (std::exchange(is_first, false)) {
      begin = BeginLine(content);
      if (begin.stands) continue;
      if (needs_begin) return {};
    }
    if (preamble.holds(line.text)) continue;
    head.unit = begin.unit;
    head.names_begin = line.begin;
    head.names_end = line.begin + line.text.size();
    const bool is_sound = read_names(line.text, head);
    head.kind = kind_of(head, begin.suffix);
    // The name of the first column may be indented; its cells are not always.
    if (!head.columns.empty()) head.columns[0].begin = 0;
    if (!is_sound) head.columns.clear();
    return head;
  }
  return {};
}

}  // namespace heidenhain
