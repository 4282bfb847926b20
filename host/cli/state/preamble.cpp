#include "state/preamble.hpp"

#include <algorithm>
#include <cctype>
#include <functional>
#include <set>

#include "json_text.hpp"

namespace isogloss::cli {

namespace {

constexpr std::string_view part = "restart ", value_row = " variable", definition_row = " definition";

bool is_of_variables(std::string_view row) { return row.ends_with(value_row) || row.ends_with(definition_row); }

bool is_letter_or_figure(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// In capitals or not.
bool has_word(std::string_view text, std::string_view word) {
  const auto is_same = [](char a, char b) {
    return std::toupper(static_cast<unsigned char>(a)) == std::toupper(static_cast<unsigned char>(b));
  };
  for (auto at = text.begin();; ++at) {
    at = std::search(at, text.end(), word.begin(), word.end(), is_same);
    if (at == text.end()) return false;
    const auto end = at + static_cast<std::ptrdiff_t>(word.size());
    if ((at == text.begin() || !is_letter_or_figure(at[-1])) && (end == text.end() || !is_letter_or_figure(*end)))
      return true;
  }
}

/// Writes the rows of variables: " variable" once for each that the rest reads, " definition" the blocks that have
/// assigned these first.
class VariableRows {
 public:
  VariableRows(const ProgramPoint& point, const ProgramLines& lines, std::string others)
      : point_(point), lines_(lines), others_(std::move(others)) {}

  std::string values(const ProgramText::Row& row) const {
    std::string out;
    for (const VariableAt& v : point_.variables) {
      if (v.first == v.last && defined_.contains(v.first.line) && v.is_local) continue;
      const Json value = Json::parse(v.value, nullptr, false);
      std::string block;
      const auto value_of = [&](std::string_view name, std::string_view format, std::string& line) {
        if (name == "VARIABLE") return line += v.name, true;
        if (name == "VALUE" && value.is_number()) {
          const std::string number = block_number(value.get<double>(), true, format == "n" || format == "+");
          return line += (format == "+" && !number.starts_with('-') ? "+" : "") + number, true;
        }
        return name == "TEXT" && value.is_string() && (line += value.get<std::string>(), true);
      };
      if (is_wanted(row, v) && row.block.fill(value_of, block)) out += block + "\n";
    }
    return out;
  }

  std::string definitions(const ProgramText::Row& row) {
    std::set<std::uint32_t>& places = defined_;
    const std::string& file = point_.block.where.file;
    for (const VariableAt& v : point_.variables)
      if (is_wanted(row, v) && v.first.file == file) places.insert(v.first.line);
    std::string out;
    for (const std::uint32_t line : places) {
      std::string block;
      const auto value_of = [&](std::string_view name, std::string_view, std::string& text) {
        return name == "DEFINITION" && (text += lines_.block({file, line}), true);
      };
      if (row.block.fill(value_of, block)) out += block + "\n";
    }
    return out;
  }

 private:
  bool is_wanted(const ProgramText::Row& row, const VariableAt& v) const {
    return (v.is_read || has_word(others_, v.name)) &&
           holds(row.when, {{"VARIABLE", v.name}, {"SCOPE", v.is_local ? "local" : "global"}});
  }

  const ProgramPoint& point_;
  const ProgramLines& lines_;
  std::set<std::uint32_t> defined_;  ///< lines of the definitions that are written
  std::string others_;  ///< the blocks of the other rows: those of the program that they repeat may read variables
};

}  // namespace

bool has_preamble(const ProgramText& text) {
  for (const ProgramText::Row& row : text.rows)
    if (row.name.starts_with(part)) return true;
  return false;
}

std::string make_preamble(const ProgramText& text, const ProgramPoint& point, const ProgramLines& lines,
                          const Layout& layout) {
  const RestartValues values(point, lines, layout);
  std::vector<std::string> blocks(text.rows.size());
  std::string others, out;
  for (std::size_t i = 0; i < text.rows.size(); ++i) {
    const ProgramText::Row& row = text.rows[i];
    if (!row.name.starts_with(part) || is_of_variables(row.name) || !holds(row.when, values.state())) continue;
    if (row.block.fill(std::cref(values), blocks[i])) blocks[i] += '\n';
    others += blocks[i];
  }
  VariableRows variables(point, lines, std::move(others));
  for (std::size_t i = 0; i < text.rows.size(); ++i) {
    const ProgramText::Row& row = text.rows[i];
    if (row.name.starts_with(part) && is_of_variables(row.name))
      blocks[i] = row.name.ends_with(value_row) ? variables.values(row) : variables.definitions(row);
    out += blocks[i];
  }
  return out;
}

}  // namespace isogloss::cli
