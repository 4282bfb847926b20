// Changes of the text: quick fixes, and formatting that changes no motion.
#include <algorithm>
#include <optional>
#include <set>

#include "lsp/features.hpp"
#include "lsp/same_motions.hpp"

namespace isogloss::editors {

namespace {

/// The name that a hint proposes: "did you mean X?".
std::optional<std::string> proposed(std::string_view hint) {
  constexpr std::string_view question = "did you mean ";
  const std::size_t at = hint.find(question);
  if (at == std::string_view::npos) return std::nullopt;
  const std::size_t begin = at + question.size(), end = hint.find('?', begin);
  if (end == std::string_view::npos || end == begin) return std::nullopt;
  std::string_view name = hint.substr(begin, end - begin);
  while (name.size() > 2 && (name.front() == '\'' || name.front() == '<')) name.remove_prefix(1);
  while (name.size() > 1 && (name.back() == '\'' || name.back() == '>')) name.remove_suffix(1);
  return std::string(name);
}

bool overlaps(const Json& a, const Range& b) {
  const auto before = [](const Json& p, const Position& q) {
    const std::uint32_t line = p.at("line"), character = p.at("character");
    return line < q.line || (line == q.line && character < q.character);
  };
  return !before(a.at("end"), b.start) && (before(a.at("start"), b.end) || to_json(b.end) == a.at("start"));
}

class Formatter {
 public:
  Formatter(OpenProgram& program, const Settings& settings)
      : program_(program), map_(program.scan_map()), settings_(settings) {
    if (program.analysis)
      for (const Move& m : program.analysis->moves)
        if (m.to_file == program.path) kept_.insert(m.to_line);
  }

  /// The line as it should be, without its end.
  std::string line(std::uint32_t number) {
    const std::string_view text = program_.text.run_line(number);
    const std::size_t base = program_.text.run_line_begin(number);
    const auto [first, last] = map_.between(base, base + text.size());
    std::string out;
    std::size_t at = 0;  // of text: what comes before is written
    const Token* before = nullptr;
    for (std::size_t i = first; i < last; ++i) {
      const Token& token = map_.tokens[i];
      if (token.begin < base + at || token.end > base + text.size()) continue;
      const std::string_view gap = text.substr(at, token.begin - base - at);
      out += before == nullptr ? std::string(gap) : gap_between(*before, gap, token);
      out += shown(token, number);
      at = token.end - base;
      before = &token;
    }
    out += text.substr(at);
    if (settings_.formats_words) out.erase(out.find_last_not_of(" \t") + 1);
    return out;
  }

 private:
  static bool is_word(const Token& t) {
    return t.kind == TokenKind::code || t.kind == TokenKind::word || t.kind == TokenKind::number;
  }
  std::string gap_between(const Token& a, std::string_view gap, const Token& b) const {
    const bool is_blank = gap.find_first_not_of(" \t") == std::string_view::npos;
    if (!settings_.formats_words || !is_blank) return std::string(gap);
    return !gap.empty() || (is_word(a) && is_word(b)) ? " " : "";
  }
  /// A block number anew, except where something goes there.
  std::string shown(const Token& token, std::uint32_t line) {
    std::string text = program_.text.text().substr(token.begin, token.end - token.begin);
    if (token.kind != TokenKind::number || !settings_.formats_numbers) return text;
    const std::size_t digits = text.find_first_of("0123456789");
    const std::size_t end = digits == std::string::npos ? digits : text.find_first_not_of("0123456789", digits);
    next_ += settings_.number_step;
    if (digits == std::string::npos || kept_.contains(line)) return text;
    return text.replace(digits, end == std::string::npos ? end : end - digits, std::to_string(next_));
  }

  OpenProgram& program_;
  const ScanMap& map_;
  const Settings& settings_;
  std::set<std::uint32_t> kept_;
  std::uint64_t next_ = 0;
};

}  // namespace

Json code_actions(const OpenProgram& program, const Range& range, const Json& context, const Surroundings&) {
  Json out = Json::array();
  const auto listed = context.find("diagnostics");
  if (listed == context.end() || !listed->is_array()) return out;
  for (const Json& d : *listed) {
    const auto data = d.find("data");
    if (data == d.end() || !data->is_object() || !d.contains("range") || !overlaps(d["range"], range)) continue;
    const auto name = proposed(data->value("hint", std::string()));
    if (!name) continue;
    Json edit{{"range", d["range"]}, {"newText", *name}};
    out.push_back({{"title", "Replace with " + *name},
                   {"kind", "quickfix"},
                   {"isPreferred", true},
                   {"diagnostics", Json::array({d})},
                   {"edit", {{"changes", {{program.uri, Json::array({std::move(edit)})}}}}}});
  }
  return out;
}

Json formatting(OpenProgram& program, const Range* range, const Surroundings& around) {
  Json edits = Json::array();
  if (program.setup == nullptr) return edits;
  Formatter formatter(program, around.settings);
  std::uint32_t first = 1, last = static_cast<std::uint32_t>(program.text.run_lines());
  if (range != nullptr) {
    first = program.text.run_line_of(program.text.offset_of(range->start));
    last = program.text.run_line_of(program.text.offset_of(range->end));
  }
  std::string text;
  std::size_t copied = 0;
  for (std::uint32_t line = 1; line <= last; ++line) {
    const std::string wanted = formatter.line(line);
    const std::string_view now = program.text.run_line(line);
    if (line < first || wanted == now) continue;
    const std::size_t begin = program.text.run_line_begin(line);
    edits.push_back({{"range", to_json(program.text.range_of(begin, begin + now.size()))}, {"newText", wanted}});
    text.append(program.text.text(), copied, begin - copied).append(wanted);
    copied = begin + now.size();
  }
  if (edits.empty()) return edits;
  text.append(program.text.text(), copied);
  if (const std::string why = why_not_same(*program.setup, program.path, program.text.text(), text, around);
      !why.empty())
    throw Refusal("Formatted so, " + why + ": nothing is changed.");
  return edits;
}

}  // namespace isogloss::editors
