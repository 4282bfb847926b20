#include "explain/rest_clause.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "explain/frame_text.hpp"
#include "explain/ladder_text.hpp"
#include "isogloss/engine/printable.hpp"

namespace isogloss::cli {

namespace {

constexpr std::size_t most_listed = 3;

bool is_shown(const std::string& path) {
  for (const char* const hidden :
       {"Parsing.", "Source.", "Vars.", "ProgramToMcTransform", "UnparsedText", "Comment.", "ProgramXyz."})
    if (path.starts_with(hidden)) return false;
  return true;
}

std::string value_of(const ExplainedVariable& v) { return v.value.empty() ? "no value" : short_value(v.value); }

/// "X10 Y5 belong to TRANS": each text once, with those of the same function.
class OwnedWords {
 public:
  void add(const std::string& text, const std::string& owner) {
    const auto found =
        std::find_if(owners_.begin(), owners_.end(), [&](const Owned& one) { return one.owner == owner; });
    Owned& one = found == owners_.end() ? owners_.emplace_back(Owned{owner, {}}) : *found;
    if (owner != text && std::find(one.texts.begin(), one.texts.end(), text) == one.texts.end())
      one.texts.push_back(text);
  }
  std::vector<std::string> sentences() const {
    std::vector<std::string> out;
    for (const Owned& one : owners_) {
      std::string texts;
      for (const std::string& text : one.texts) texts += (texts.empty() ? "" : " ") + text;
      if (!texts.empty()) out.push_back(texts + (one.texts.size() == 1 ? " belongs to " : " belong to ") + one.owner);
    }
    return out;
  }

 private:
  struct Owned {
    std::string owner;
    std::vector<std::string> texts;
  };
  std::vector<Owned> owners_;
};

/// What the syntaxes of the block have given values, and the sections that they have cleared.
void find_changes(const Facts& facts, std::vector<std::string>& sets, std::vector<std::string>& ended) {
  for (const ExplainedStep& step : facts.block().steps)
    for (const ExplainedChange& c : step.changes) {
      if (!is_shown(c.path)) continue;
      if (!c.after.empty()) {
        sets.push_back(c.path + " = " + printable(short_value(c.after)));
        continue;
      }
      const std::string section = c.path.substr(0, c.path.find('.'));
      if (std::find(ended.begin(), ended.end(), section) == ended.end()) ended.push_back(section);
    }
}

/// "G21 is in force already: G20/G21 select inch or metric": a code that a syntax has used, and nothing has changed.
std::string code_clause(const Facts& facts, const ExplainedWord& word) {
  const bool is_in_force = std::any_of(facts.block().values.begin(), facts.block().values.end(), [&](const auto& v) {
    return is_shown(v.path) && v.value == '"' + word.name + '"';
  });
  // Klartext has words of its own for what is a code elsewhere.
  const std::string text = mentions(word.text, word.name) ? word.text : cut(facts.block().text, 40);
  return fmt::format("{} {} ({})", text, is_in_force ? "is in force already" : "changes no value",
                     facts.summary_of(word.users.back()));
}

/// "it changes no value (Reads BLK FORM …)": who has read the longest piece of text that holds no words.
std::string no_change(const Facts& facts) {
  if (facts.now("Comment.Text") != nullptr) return "it holds a comment";
  const ExplainedWord* longest = nullptr;
  for (const ExplainedWord& w : facts.block().words)
    if (w.name.empty() && !w.reader.empty() && (longest == nullptr || w.text.size() > longest->text.size()))
      longest = &w;
  return "it changes no value" + (longest == nullptr ? "" : " (" + facts.summary_of(longest->reader) + ")");
}

}  // namespace

std::string list_of(const std::vector<std::string>& parts) {
  std::string out;
  for (std::size_t i = 0; i < std::min(parts.size(), most_listed); ++i) out += (i == 0 ? "" : ", ") + parts[i];
  return parts.size() > most_listed ? out + fmt::format(" and {} more", parts.size() - most_listed) : out;
}

std::string written_text(const Facts& facts) {
  std::vector<std::string> out;
  for (const ExplainedVariable& v : facts.block().written) out.push_back(v.name + " = " + value_of(v));
  return list_of(out);
}

std::string rest_clause(const Facts& facts) {
  const ExplainedBlock& b = facts.block();
  if (facts.now("BlockSkip.Body") != nullptr)
    return "moves nothing: the block is skipped, because --block-skip switches its layer on";
  std::vector<std::string> sets, ended, codes, lost;
  OwnedWords owned;
  for (const ExplainedVariable& v : b.written) sets.push_back(v.name + " = " + value_of(v));
  find_changes(facts, sets, ended);
  for (const ExplainedWord& w : b.words) {
    if (w.name.empty()) continue;
    if (w.users.empty())
      lost.push_back(w.text);
    else if (!w.value.empty())
      owned.add(w.text, facts.function_of(w.users.back()));
    else
      codes.push_back(code_clause(facts, w));
  }
  std::vector<std::string> reasons;
  if (!lost.empty()) reasons.push_back("no function of this dialect uses " + list_of(lost));
  if (const std::vector<std::string> words = owned.sentences(); !words.empty()) reasons.push_back(list_of(words));
  if (!sets.empty()) reasons.push_back("it sets " + list_of(sets));
  if (!ended.empty()) reasons.push_back("it clears values of " + list_of(ended));
  if (reasons.empty() && !codes.empty()) reasons.push_back(list_of(codes));
  if (reasons.empty()) reasons.push_back(no_change(facts));
  std::string out = "moves nothing: ";
  for (std::size_t i = 0; i < reasons.size(); ++i) out += (i == 0 ? "" : "; ") + reasons[i];
  return out;
}

}  // namespace isogloss::cli
