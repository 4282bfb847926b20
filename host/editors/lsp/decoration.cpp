// What an editor shows beside and over the text: inlay hints and semantic colours.
#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "lsp/features.hpp"

namespace isogloss::editors {

namespace {

constexpr const char* token_types[] = {"keyword", "parameter", "comment", "function", "number", "macro"};

std::string axis_number(double value) {
  std::string out = fmt::format("{:.3f}", value);
  while (out.ends_with('0')) out.pop_back();
  if (out.ends_with('.')) out.pop_back();
  return out == "-0" ? "0" : out;
}

std::string machine_hint(const LineFacts& facts) {
  std::string out;
  for (std::size_t i = 0; i < facts.machine.size(); ++i)
    if ((facts.known >> i & 1u) != 0) out += fmt::format(" {}{}", "XYZABC"[i], axis_number(facts.machine[i]));
  return out.empty() ? out : "machine" + out;
}

/// Does the line program this code?
bool programs(const OpenProgram& program, const ScanMap& map, std::uint32_t line, const std::string& code) {
  const Layout& layout = program.setup->linked->layout;
  const std::size_t begin = program.text.run_line_begin(line);
  const auto [first, last] = map.between(begin, begin + program.text.run_line(line).size());
  for (std::size_t i = first; i < last; ++i)
    if (map.tokens[i].kind == TokenKind::code && Layout::code_name(layout.fields[map.tokens[i].field].path) == code)
      return true;
  return false;
}

Json hint_at(const TextDocument& text, std::size_t offset, const std::string& label, bool before) {
  return {{"position", to_json(text.position_of(offset))},
          {"label", label},
          {before ? "paddingRight" : "paddingLeft", true}};
}

/// Writes tokens as differences from the one before; a token that several lines hold becomes one a line.
class TokenWriter {
 public:
  explicit TokenWriter(const TextDocument& text) : text_(text) {}

  void add(std::size_t begin, std::size_t end, TokenKind kind) {
    const std::string_view up_to_end = std::string_view(text_.text()).substr(0, end);
    while (begin < end) {
      const std::size_t stop = std::min(up_to_end.find_first_of("\r\n", begin), end);
      if (stop > begin) add_in_line(begin, stop, kind);
      begin = std::max(stop + 1, begin + 1);
    }
  }
  Json take() { return {{"data", std::move(data_)}}; }

 private:
  void add_in_line(std::size_t begin, std::size_t end, TokenKind kind) {
    const Position from = text_.position_of(begin), to = text_.position_of(end);
    if (to.line != from.line || to.character <= from.character) return;
    if (from.line < last_.line || (from.line == last_.line && from.character < last_.character)) return;
    data_.push_back(from.line - last_.line);
    data_.push_back(from.line == last_.line ? from.character - last_.character : from.character);
    data_.push_back(to.character - from.character);
    data_.push_back(static_cast<std::uint32_t>(kind));
    data_.push_back(0);
    last_ = from;
  }

  const TextDocument& text_;
  Position last_;
  std::vector<std::uint32_t> data_;
};

}  // namespace

Json inlay_hints(OpenProgram& program, const Range& range, const Surroundings& around) {
  Json out = Json::array();
  if (program.setup == nullptr || !program.analysis) return out;
  const Settings& settings = around.settings;
  constexpr std::uint32_t most_lines = 2000;
  const std::uint32_t first = program.text.run_line_of(program.text.offset_of(range.start));
  const std::uint32_t last = std::min(program.text.run_line_of(program.text.offset_of(range.end)), first + most_lines);
  for (std::uint32_t line = first; line <= last; ++line) {
    const LineFacts* const facts = program.analysis->at(line);
    if (facts == nullptr || facts->passes == 0 || !facts->moves) continue;
    const std::size_t begin = program.text.run_line_begin(line);
    const std::string_view text = program.text.run_line(line);
    const std::size_t end = text.find_last_not_of(" \t\r") + 1, start = std::min(text.find_first_not_of(" \t"), end);
    std::string modal;
    const std::string& code = program.analysis->names[facts->cycle != 0 ? facts->cycle : facts->motion];
    if (!code.empty() && !programs(program, program.scan_map(), line, code)) modal = code;
    if (facts->feed_mm_min > 0 && !facts->is_rapid)
      modal += fmt::format("{}{} mm/min", modal.empty() ? "" : " ", axis_number(facts->feed_mm_min));
    if (settings.shows_modal && !modal.empty()) out.push_back(hint_at(program.text, begin + start, modal, true));
    if (const std::string machine = machine_hint(*facts); settings.shows_machine && !machine.empty())
      out.push_back(hint_at(program.text, begin + end, machine, false));
  }
  return out;
}

Json semantic_legend() { return {{"tokenTypes", token_types}, {"tokenModifiers", Json::array()}}; }

Json semantic_tokens(OpenProgram& program, const Range* range) {
  const ScanMap& map = program.scan_map();
  std::size_t first = 0, last = map.tokens.size();
  if (range != nullptr)
    std::tie(first, last) = map.between(program.text.offset_of(range->start), program.text.offset_of(range->end));
  TokenWriter writer(program.text);
  for (std::size_t i = first; i < last; ++i) writer.add(map.tokens[i].begin, map.tokens[i].end, map.tokens[i].kind);
  return writer.take();
}

}  // namespace isogloss::editors
