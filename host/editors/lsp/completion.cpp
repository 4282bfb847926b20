#include <algorithm>
#include <set>

#include "lsp/features.hpp"

namespace isogloss::editors {

namespace {

// CompletionItemKind of the protocol.
enum : int { item_field = 5, item_variable = 6, item_keyword = 14, item_reference = 18 };

bool is_part_of_word(char c) {
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '#' || c == '.';
}

class Completion {
 public:
  Completion(OpenProgram& program, const Position& at, const Surroundings& around)
      : program_(program), layout_(program.setup->linked->layout), end_(program.text.offset_of(at)), begin_(end_) {
    line_ = program.text.run_line_of(end_);
    const std::size_t line_begin = program.text.run_line_begin(line_);
    while (begin_ > line_begin && is_part_of_word(program.text.text()[begin_ - 1])) --begin_;
    codes_ = around.toolbox.codes(*program.setup->linked);
  }

  Json items() {
    const std::set<std::string> here = codes_here();
    add_words_of(here);
    add_codes();
    add_variables();
    add_labels();
    return {{"isIncomplete", false}, {"items", std::move(out_)}};
  }

 private:
  /// The codes of the line, and the cycle in force: both have words of their own.
  std::set<std::string> codes_here() {
    std::set<std::string> out;
    const ScanMap& map = program_.scan_map();
    const auto [first, last] = map.between(program_.text.run_line_begin(line_), end_);
    for (std::size_t i = first; i < last; ++i)
      if (map.tokens[i].kind == TokenKind::code)
        out.insert(std::string(Layout::code_name(layout_.fields[map.tokens[i].field].path)));
    if (program_.analysis)
      for (std::uint32_t line = line_; line-- > 1;)
        if (const LineFacts* const facts = program_.analysis->at(line); facts != nullptr && facts->passes > 0) {
          out.insert(program_.analysis->names[facts->cycle]);
          break;
        }
    return out;
  }

  std::string doc_of(const std::string& syntax) const {
    for (const LinkedSyntax& s : program_.setup->linked->chain)
      if (s.element.alias == syntax)
        return (s.syntax->summary != nullptr ? std::string(s.syntax->summary) : std::string()) + " (" + syntax + ")";
    return syntax;
  }

  void add_words_of(const std::set<std::string>& codes) {
    for (const CodeInfo& info : codes_) {
      if (!info.is_code || !codes.contains(info.code)) continue;
      for (const std::string& word : info.words) {
        const auto field = layout_.find("Parsing." + info.code + "." + word);
        std::string doc = field ? layout_.fields[*field].doc : std::string();
        if (field && !layout_.fields[*field].unit.empty()) doc += " [" + layout_.fields[*field].unit + "]";
        add(word, item_field, "word of " + info.code, doc.empty() ? doc_of(info.syntax) : doc, '0');
      }
    }
  }

  void add_codes() {
    for (std::size_t i = 0; i < codes_.size();) {
      const CodeInfo& info = codes_[i];
      std::string docs, words;
      for (; i < codes_.size() && codes_[i].code == info.code; ++i) {
        const std::string doc = doc_of(codes_[i].syntax);
        if (docs.find(doc) == std::string::npos) docs += "- " + doc + "\n";
      }
      for (const std::string& word : info.words) words += (words.empty() ? "\nWords: " : " ") + word;
      const std::string detail = info.is_code ? "code" : info.unit.empty() ? "word" : "word, " + info.unit;
      add(info.code, info.is_code ? item_keyword : item_field, detail, docs + words, '1');
    }
  }

  void add_variables() {
    if (!program_.analysis) return;
    for (const VariableUse& use : program_.analysis->variables)
      add(use.name, item_variable, use.value.empty() ? "variable" : "variable, " + use.value, "", '2');
  }

  void add_labels() {
    for (const NamedPlace& place : program_.scan_map().labels)
      add(place.name, item_reference, place.is_program ? "program" : "label, line " + std::to_string(place.line), "",
          '3');
  }

  void add(const std::string& label, int kind, const std::string& detail, const std::string& doc, char order) {
    constexpr std::size_t most = 3000;
    if (label.empty() || out_.size() >= most || !known_.insert(label).second) return;
    Json one{{"label", label},
             {"kind", kind},
             {"detail", detail},
             {"sortText", order + label},
             {"textEdit", {{"range", to_json(program_.text.range_of(begin_, end_))}, {"newText", label}}}};
    if (!doc.empty()) one["documentation"] = {{"kind", "markdown"}, {"value", doc}};
    out_.push_back(std::move(one));
  }

  OpenProgram& program_;
  const Layout& layout_;
  std::size_t end_, begin_;
  std::uint32_t line_ = 0;
  std::vector<CodeInfo> codes_;
  std::set<std::string> known_;
  Json out_ = Json::array();
};

}  // namespace

Json completion(OpenProgram& program, const Position& at, const Surroundings& around) {
  if (program.setup == nullptr) return Json::array();
  return Completion(program, at, around).items();
}

}  // namespace isogloss::editors
