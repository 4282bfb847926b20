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
  for (const char* const hidden : {"Parsing.", "Source.", "Vars.", "ProgramToMcTransform", "UnparsedText", "Comment.",
                                   "ProgramXyz.", "RadiusCompensation.Vector.", "MachineCoordinate."})
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

/// A value that a syntax of the block has given.
struct Change {
  std::string syntax, path, value;
  bool is_told = false;
};

/// What the block has given values, and the sections that it has cleared.
std::vector<Change> changes_of(const Facts& facts, std::vector<std::string>& ended) {
  std::vector<Change> out;
  for (const ExplainedStep& step : facts.block().steps)
    for (const ExplainedChange& c : step.changes) {
      if (!is_shown(c.path)) continue;
      if (!c.after.empty()) {
        out.push_back({step.syntax, c.path, printable(short_value(c.after))});
        continue;
      }
      const std::string section = c.path.substr(0, c.path.find('.'));
      if (std::find(ended.begin(), ended.end(), section) == ended.end()) ended.push_back(section);
    }
  return out;
}

/// What the codes of the block do, code by code.
struct CodeClauses {
  std::vector<std::string> set;                ///< "G91 sets PositioningMode.Mode = …"
  std::vector<std::string> begun;              ///< codes that give nothing but their own name
  std::vector<const ExplainedWord*> in_force;  ///< codes that change nothing, since they are in force
  std::vector<std::string> without;            ///< "M1 changes no value (M00 stop, M01 optional stop)"

  /// What the codes have set, and which codes are in force from here on.
  void tell(std::vector<std::string>& out) const {
    out.insert(out.end(), set.begin(), set.end());
    if (!begun.empty())
      out.push_back(series_of(begun) + (begun.size() == 1 ? " is" : " are") + " in force from here on");
  }

  void add(const Facts& facts, const ExplainedWord& word, std::vector<Change>& changes) {
    if (!mentions(word.text, word.name)) return;  // Klartext has words of its own for what is a code elsewhere
    std::vector<std::string> values;
    bool has_acted = false;
    for (Change& c : changes) {
      if (c.is_told || c.syntax != word.users.back()) continue;
      c.is_told = has_acted = true;
      if (c.value != '"' + word.name + '"') values.push_back(c.path + " = " + c.value);
    }
    const bool is_in_force = std::any_of(facts.block().values.begin(), facts.block().values.end(), [&](const auto& v) {
      return is_shown(v.path) && v.value == '"' + word.name + '"';
    });
    if (!values.empty())
      set.push_back(fmt::format("{} sets {}", word.text, list_of(values)));
    else if (has_acted)
      begun.push_back(word.text);
    else if (is_in_force)
      in_force.push_back(&word);
    else
      without.push_back(fmt::format("{} changes no value ({})", word.text, facts.summary_of(word.users.back())));
  }
};

/// Sections that a sentence tells in words of its own.
bool is_told_in_words(const std::string& path) {
  for (const char* const told :
       {"ToolChange.", "SpindleSpeed.", "SpindleControl.", "Dwell.", "ProgramStop.", "ProgramEnd.", "SubProgram"})
    if (path.starts_with(told)) return true;
  return false;
}

/// "G17, G21 and G90 are in force already"; a single one with what it is.
std::string in_force_clause(const Facts& facts, const std::vector<const ExplainedWord*>& words, bool is_alone) {
  std::vector<std::string> texts;
  for (const ExplainedWord* const word : words) texts.push_back(word->text);
  const std::string out = series_of(texts) + (words.size() == 1 ? " is" : " are") + " in force already";
  return words.size() == 1 && is_alone ? fmt::format("{} ({})", out, facts.summary_of(words[0]->users.back())) : out;
}

/// "it changes no value (Reads BLK FORM …)": who has read the longest piece of text that holds no words.
std::string no_change(const Facts& facts) {
  const ExplainedValue *const comment = facts.now("Comment.Text"), *const number = facts.now("Source.N");
  const auto is_beside = [](const ExplainedWord& w, const ExplainedValue* v) {
    return v != nullptr && w.reader == v->writer;
  };
  const ExplainedWord* longest = nullptr;
  for (const ExplainedWord& w : facts.block().words)
    if (w.name.empty() && !w.reader.empty() && !is_beside(w, comment) && !is_beside(w, number) &&
        (longest == nullptr || w.text.size() > longest->text.size()))
      longest = &w;
  if (longest == nullptr && comment != nullptr) return "it holds a comment";
  return "it changes no value" + (longest == nullptr ? "" : " (" + facts.summary_of(longest->reader) + ")");
}

}  // namespace

std::string list_of(const std::vector<std::string>& parts) { return listed(parts, most_listed); }

std::string series_of(const std::vector<std::string>& parts) {
  std::string out;
  for (std::size_t i = 0; i < parts.size(); ++i)
    out += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return out;
}

std::string written_text(const Facts& facts) {
  std::vector<std::string> out;
  for (const ExplainedVariable& v : facts.block().written) out.push_back(v.name + " = " + value_of(v));
  return list_of(out);
}

std::vector<std::string> mode_clauses(const Facts& facts) {
  std::vector<std::string> ended, out;
  std::vector<Change> changes = changes_of(facts, ended);
  std::erase_if(changes, [](const Change& c) { return is_told_in_words(c.path); });
  CodeClauses codes;
  for (const ExplainedWord& w : facts.block().words)
    if (!w.name.empty() && w.value.empty() && !w.users.empty()) codes.add(facts, w, changes);
  codes.tell(out);
  return out;
}

std::string rest_clause(const Facts& facts) {
  const ExplainedBlock& b = facts.block();
  if (facts.now("BlockSkip.Body") != nullptr)
    return "moves nothing: the block is skipped, because --block-skip switches its layer on";
  std::vector<std::string> sets, ended, lost;
  OwnedWords owned;
  CodeClauses codes;
  std::vector<Change> changes = changes_of(facts, ended);
  for (const ExplainedWord& w : b.words) {
    if (w.name.empty()) continue;
    if (w.users.empty())
      lost.push_back(w.text);
    else if (!w.value.empty())
      owned.add(w.text, facts.function_of(w.users.back()));
    else
      codes.add(facts, w, changes);
  }
  for (const ExplainedVariable& v : b.written) sets.push_back(v.name + " = " + value_of(v));
  for (const Change& c : changes)
    if (!c.is_told) sets.push_back(c.path + " = " + c.value);

  std::vector<std::string> reasons;
  if (!lost.empty()) reasons.push_back("no function of this dialect uses " + list_of(lost));
  if (const std::vector<std::string> words = owned.sentences(); !words.empty()) reasons.push_back(list_of(words));
  codes.tell(reasons);
  if (!sets.empty()) reasons.push_back("it sets " + list_of(sets));
  if (!ended.empty()) reasons.push_back("it clears values of " + list_of(ended));
  if (!codes.in_force.empty()) reasons.push_back(in_force_clause(facts, codes.in_force, reasons.empty()));
  if (const std::string report = facts.report(); !report.empty())
    reasons.push_back(report);
  else if (reasons.empty() && !codes.without.empty())
    reasons.push_back(list_of(codes.without));
  if (reasons.empty()) reasons.push_back(no_change(facts));
  std::string out = "moves nothing: ";
  for (std::size_t i = 0; i < reasons.size(); ++i) out += (i == 0 ? "" : "; ") + reasons[i];
  return out;
}

}  // namespace isogloss::cli
