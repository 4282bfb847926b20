#include "explain/explain_target.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <fstream>

namespace isogloss::cli {

namespace {

/// Up to nine digits; 0 is no line.
std::uint32_t line_number(std::string_view text) {
  std::uint32_t out = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc{} && end == text.data() + text.size() && text.size() < 10 ? out : 0;
}

/// The content of a line, for a file that can be read again. Lines end as in the run: LF, CR or both.
struct LineInFile {
  std::uint32_t lines = 0;  ///< up to this line; fewer than asked for: the file has no more
  bool is_empty = true;
};

LineInFile look_up(const std::string& path, std::uint32_t number) {
  std::error_code code;
  std::ifstream file;
  if (std::filesystem::is_regular_file(path, code)) file.open(path, std::ios::binary);
  LineInFile out;
  bool is_begun = false;
  char before = '\0', buffer[65536];
  while (file.read(buffer, sizeof buffer), file.gcount() > 0)
    for (const char c : std::string_view(buffer, static_cast<std::size_t>(file.gcount()))) {
      const bool is_half_end = before == '\r' && c == '\n';
      before = c;
      if (is_half_end) continue;
      if (!is_begun && out.lines == number) return out;
      if (!is_begun) ++out.lines;
      is_begun = c != '\n' && c != '\r';
      if (out.lines == number && is_begun && c != ' ' && c != '\t') out.is_empty = false;
    }
  return out;
}

}  // namespace

std::optional<NamedLines> read_lines(const std::string& text, Lines lines, Workspace& workspace) {
  const std::size_t colon = text.rfind(':');
  const std::string_view numbers =
      colon == std::string::npos ? std::string_view() : std::string_view(text).substr(colon + 1);
  const std::size_t hyphen = numbers.find('-');
  NamedLines out{text.substr(0, colon), line_number(numbers.substr(0, hyphen)), 0};
  out.last = hyphen == std::string_view::npos ? out.first : line_number(numbers.substr(hyphen + 1));
  if (out.first != 0 && out.last != 0) {
    if (out.first <= out.last) return out;
    workspace.report("IG-0181", {}, {std::to_string(out.first), std::to_string(out.last)},
                     fmt::format("{}:{}-{}", out.program, out.last, out.first));
    return std::nullopt;
  }
  if (lines == Lines::optional) return NamedLines{text, 0, 0};
  workspace.report("IG-0513", {},
                   {"explain needs PROGRAM:LINE, PROGRAM:10-20 or the code of a diagnostic, not '" + text + "'"});
  return std::nullopt;
}

void report_short_file(const NamedLines& lines, const std::string& file, Workspace& workspace) {
  const std::uint32_t has = look_up(file, lines.last).lines;
  if (has >= lines.first && has < lines.last)
    workspace.report("IG-0521", {file, has, 0}, {std::to_string(lines.last), std::to_string(has)});
}

std::string why_no_block(const ExplainReach& reach, const ExplainTarget& target, const std::string& path) {
  if (reach.passes > 0 && reach.passes < target.pass)
    return reach.passes == 1 ? "the run comes to this line once"
                             : fmt::format("the run comes to this line {} times", reach.passes);
  if (const LineInFile line = look_up(target.file.empty() ? path : std::string(), target.line); line.lines > 0) {
    if (line.lines < target.line) return fmt::format("the file has {} lines", line.lines);
    if (line.is_empty && target.last() == target.line) return "the line is empty";
  }
  if (reach.first == 0) return "no block of this file is executed";
  if (target.last() < reach.first) return fmt::format("the run begins at line {}", reach.first);
  if (reach.jumped_to != 0)
    return fmt::format("the run goes from line {} to line {}", reach.jumped_from, reach.jumped_to);
  return fmt::format("the run ends at {}:{}: {}", reach.last.file, reach.last.line, reach.last_text);
}

}  // namespace isogloss::cli
