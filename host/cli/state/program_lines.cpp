#include "state/program_lines.hpp"

#include <algorithm>
#include <tuple>

#include "session.hpp"

namespace isogloss::cli {

namespace {

bool is_before(const ProgramLine& a, const ProgramLine& b) {
  return std::tie(a.file, a.line) < std::tie(b.file, b.line);
}

/// The words up to the first point, without a number before them; empty: there is no point.
std::string head_of_part(const std::string& block) {
  const std::size_t begin = std::min(block.find_first_not_of("0123456789 \t"), block.size());
  const std::size_t point = block.find_first_of(".\n", begin);
  return point == std::string::npos || block[point] != '.' ? std::string() : block.substr(begin, point - begin);
}

}  // namespace

ProgramLines::ProgramLines(std::string main_file, const std::string& main_text) : further_(is_before) {
  texts_.emplace(std::move(main_file), main_text);
}

void ProgramLines::note(const BlockSource& source) {
  if (!source.is_joined) return;
  std::uint32_t further = 0;
  for (std::string rest = from_line(std::string(source.text), 2); !rest.empty(); rest = from_line(rest, 2)) ++further;
  if (further != 0) further_[{std::string(source.file), source.line}] = further;
}

const std::string* ProgramLines::text_of(const std::string& file) const {
  if (const auto known = texts_.find(file); known != texts_.end()) return &known->second;
  std::string error;
  std::optional<std::string> text = read_text(file, error);
  return text ? &texts_.emplace(file, std::move(*text)).first->second : nullptr;
}

std::string ProgramLines::block(const ProgramLine& at) const {
  const std::string* const text = text_of(at.file);
  if (text == nullptr || at.line == 0) return {};
  const auto further = further_.find(at);
  const std::uint32_t lines = 1 + (further == further_.end() ? 0 : further->second);
  std::string rest = from_line(*text, at.line), out;
  for (std::uint32_t i = 0; i < lines; ++i) {
    const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    out += (i == 0 ? "" : "\n") + rest.substr(0, end);
    rest = from_line(rest, 2);
  }
  return out;
}

std::string ProgramLines::parts(const ProgramLine& at) const {
  std::string out = block(at);
  const std::string head = head_of_part(out);
  if (head.empty()) return out;
  for (ProgramLine next{at.file, at.line + 1};; ++next.line) {
    const std::string further = block(next);
    if (head_of_part(further) != head) return out;
    out += "\n" + further;
  }
}

std::string from_line(const std::string& text, std::uint32_t line) {
  std::size_t at = 0;
  for (std::uint32_t number = 1; number < line && at < text.size(); ++number) {
    at = std::min(text.find_first_of("\r\n", at), text.size());
    if (at < text.size()) at += text.compare(at, 2, "\r\n") == 0 ? 2 : 1;
  }
  return text.substr(at);
}

}  // namespace isogloss::cli
