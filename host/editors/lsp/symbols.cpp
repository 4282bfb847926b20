#include <algorithm>
#include <map>
#include <set>

#include "lsp/features.hpp"

namespace isogloss::editors {

namespace {

constexpr std::size_t most_symbols = 20'000;

// SymbolKind of the protocol.
enum : int { kind_module = 2, kind_class = 5, kind_string = 15, kind_key = 20 };

/// An entry of the outline. It reaches to the next one of its level or of a lower one.
struct Entry {
  std::uint32_t line = 0;
  int level = 0, kind = kind_string;
  std::string name, detail{};
};

class Outline {
 public:
  explicit Outline(OpenProgram& program) : program_(program), map_(program.scan_map()) {}

  std::vector<Entry> entries() {
    add_labels();
    if (program_.analysis)
      for (const ToolUse& t : program_.analysis->tools)
        out_.push_back({t.line, 1, kind_class, "Tool " + std::to_string(t.tool), comment_near(t.line)});
    for (const Remark& c : map_.comments) {
      const std::size_t first = c.text.find_first_not_of(" \t-*=");
      if (first != std::string::npos) out_.push_back({c.line, 2, kind_string, c.text.substr(first)});
    }
    std::ranges::stable_sort(
        out_, [](const Entry& a, const Entry& b) { return a.line != b.line ? a.line < b.line : a.level < b.level; });
    if (out_.size() > most_symbols) out_.resize(most_symbols);
    return std::move(out_);
  }

 private:
  /// A block number is an entry only where something goes there.
  void add_labels() {
    std::set<std::uint32_t> reached;
    if (program_.analysis)
      for (const Move& m : program_.analysis->moves)
        if (m.to_file == program_.path && !m.label.empty()) reached.insert(m.to_line);
    for (const NamedPlace& place : map_.labels) {
      const auto [first, last] = map_.between(place.begin, place.begin + 1);
      const bool is_number = first < last && map_.tokens[first].kind == TokenKind::number;
      if (is_number && !place.is_program && !reached.contains(place.line)) continue;
      std::string name = program_.text.text().substr(place.begin, place.end - place.begin);
      if (name.empty()) name = place.name;
      out_.push_back({place.line, place.is_program ? 0 : 2, place.is_program ? kind_module : kind_key, std::move(name),
                      place.is_program ? comment_near(place.line) : ""});
    }
  }

  /// What a comment beside the line says, or one line above.
  std::string comment_near(std::uint32_t line) const {
    std::string out;
    for (const Remark& c : map_.comments)
      if (c.line == line || (c.line + 1 == line && out.empty())) out = c.text;
    return out;
  }

  OpenProgram& program_;
  const ScanMap& map_;
  std::vector<Entry> out_;
};

/// Takes the entries that lie in one of a lower level.
Json nest(const std::vector<Entry>& entries, std::size_t& at, int level, const OpenProgram& program) {
  Json out = Json::array();
  while (at < entries.size() && entries[at].level >= level) {
    const Entry& e = entries[at];
    const Range own = line_range(program.text, e.line);
    const std::size_t first = at++;
    Json children = nest(entries, at, e.level + 1, program);
    std::uint32_t end = e.line;
    if (e.level < 2) {
      end = at < entries.size() ? entries[at].line : static_cast<std::uint32_t>(program.text.run_lines()) + 1;
      end = std::max(end - 1, entries[first].line);
    }
    Json one{{"name", e.name.empty() ? "?" : e.name},
             {"kind", e.kind},
             {"range",
              to_json(Range{own.start, std::max(end, e.line) == e.line ? own.end : line_range(program.text, end).end})},
             {"selectionRange", to_json(own)}};
    if (!e.detail.empty()) one["detail"] = e.detail;
    if (!children.empty()) one["children"] = std::move(children);
    out.push_back(std::move(one));
  }
  return out;
}

class Folds {
 public:
  explicit Folds(OpenProgram& program) : program_(program) {}

  Json find() {
    add_programs();
    add_comments();
    if (program_.analysis) {
      add_loops();
      add_cycles();
    }
    return std::move(out_);
  }

 private:
  void add(std::uint32_t first, std::uint32_t last, const char* kind) {
    if (last <= first || out_.size() >= most_symbols || !known_.emplace(first, last).second) return;
    out_.push_back({{"startLine", program_.text.position_in_run(first, 1).line},
                    {"endLine", program_.text.position_in_run(last, 1).line},
                    {"kind", kind}});
  }
  void add_programs() {
    std::uint32_t begin = 0;
    for (const NamedPlace& place : program_.scan_map().labels) {
      if (!place.is_program) continue;
      if (begin != 0) add(begin, place.line - 1, "region");
      begin = place.line;
    }
    auto end = static_cast<std::uint32_t>(program_.text.run_lines());
    while (end > begin && program_.text.run_line(end).empty()) --end;
    if (begin != 0) add(begin, end, "region");
  }
  void add_comments() {
    const std::vector<Remark>& all = program_.scan_map().comments;
    for (std::size_t i = 0; i < all.size();) {
      std::size_t last = i;
      while (last + 1 < all.size() && all[last + 1].line == all[last].line + 1) ++last;
      add(all[i].line, all[last].line, "comment");
      i = last + 1;
    }
  }
  void add_loops() {
    for (const Move& m : program_.analysis->moves)
      if (m.kind == FlowStep::Kind::jump && m.file == program_.path && m.to_file == m.file && m.to_line < m.line)
        add(m.to_line, m.line, "region");
  }
  /// Lines under one canned cycle; lines that no run has come to end it.
  void add_cycles() {
    const std::vector<LineFacts>& lines = program_.analysis->lines;
    std::uint32_t begin = 0, last = 0;
    std::uint16_t cycle = 0;
    for (std::uint32_t line = 1; line <= lines.size(); ++line) {
      const LineFacts& facts = lines[line - 1];
      if (facts.passes == 0) continue;
      if (facts.cycle != cycle) {
        if (cycle != 0) add(begin, last, "region");
        begin = line;
        cycle = facts.cycle;
      }
      last = line;
    }
    if (cycle != 0) add(begin, last, "region");
  }

  OpenProgram& program_;
  Json out_ = Json::array();
  std::set<std::pair<std::uint32_t, std::uint32_t>> known_;
};

}  // namespace

Json symbols(OpenProgram& program) {
  const std::vector<Entry> entries = Outline(program).entries();
  std::size_t at = 0;
  return nest(entries, at, 0, program);
}

Json folding(OpenProgram& program) { return Folds(program).find(); }

}  // namespace isogloss::editors
