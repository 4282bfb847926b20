#include "explain/sentence.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "explain/frame_text.hpp"
#include "explain/go_clause.hpp"
#include "explain/move_clause.hpp"
#include "isogloss/engine/printable.hpp"

namespace isogloss::cli {

namespace {

constexpr std::size_t most_listed = 3;

std::string list_of(const std::vector<std::string>& parts) {
  std::string out;
  for (std::size_t i = 0; i < std::min(parts.size(), most_listed); ++i) out += (i == 0 ? "" : ", ") + parts[i];
  return parts.size() > most_listed ? out + fmt::format(" and {} more", parts.size() - most_listed) : out;
}

/// "#102 = 10, #103 = 5".
std::string written_text(const Facts& facts) {
  std::vector<std::string> out;
  for (const ExplainedVariable& v : facts.block().written)
    out.push_back(v.name + " = " + (v.value.empty() ? "no value" : v.value));
  return list_of(out);
}

/// "sets the spindle to CW at 2000 rpm"; the speed has a line where another one has programmed it.
std::string spindle_part(const Facts& facts) {
  const bool turns = facts.has_changed("SpindleSpeed.Direction"),
             has_new_speed = facts.has_changed("SpindleSpeed.SpindleSpeed_rpm");
  const std::string direction = facts.text("SpindleSpeed.Direction");
  if (!turns && (!has_new_speed || direction.empty() || direction == "STOP")) return {};
  std::string out = "sets the spindle to " + direction;
  const std::optional<double> speed = facts.number("SpindleSpeed.SpindleSpeed_rpm");
  if (direction == "STOP" || !speed) return out;
  out += fmt::format(" at {} rpm", short_number(*speed));
  const ExplainedValue& set = *facts.now("SpindleSpeed.SpindleSpeed_rpm");
  return facts.is_here(set.set) ? out : out + " (" + facts.place(set.set) + ")";
}

/// What the block does besides moving.
std::vector<std::string> other_parts(const Facts& facts) {
  std::vector<std::string> out;
  if (facts.text("ToolChange.IsChange") == "true")
    out.push_back("changes to tool " + facts.text("ToolChange.SpindleToolId"));
  if (const auto time = facts.number("Dwell.Time")) out.push_back(fmt::format("dwells {} s", short_number(*time)));
  if (std::string spindle = spindle_part(facts); !spindle.empty()) out.push_back(std::move(spindle));
  if (facts.now("ProgramStop.Term") != nullptr)
    out.push_back("stops the program (" + facts.text("ProgramStop.Term") + ")");
  if (facts.now("ProgramEnd.Term") != nullptr)
    out.push_back("ends the program (" + facts.text("ProgramEnd.Term") + ")");
  std::string go = go_clause(facts);
  if (const std::string written = written_text(facts); !go.empty() && !written.empty())
    out.push_back("sets " + written);
  if (!go.empty()) out.push_back(std::move(go));
  return out;
}

bool is_shown(const std::string& path) {
  for (const char* const hidden : {"Parsing.", "Source.", "Vars.", "ProgramToMcTransform", "UnparsedText", "Comment."})
    if (path.starts_with(hidden)) return false;
  return true;
}

/// Why the machine does not move: what became of the words, and what the block has set instead.
std::string rest_part(const Facts& facts) {
  const ExplainedBlock& b = facts.block();
  if (facts.now("BlockSkip.Body") != nullptr)
    return "moves nothing: the block is skipped, because --block-skip switches its layer on";
  std::vector<std::string> sets, ended, words, lost;
  for (const ExplainedVariable& v : b.written)
    sets.push_back(v.name + " = " + (v.value.empty() ? "no value" : v.value));
  for (const ExplainedStep& step : b.steps)
    for (const ExplainedChange& c : step.changes)
      if (is_shown(c.path) && !c.after.empty())
        sets.push_back(c.path + " = " + printable(c.after));
      else if (const std::string section = c.path.substr(0, c.path.find('.'));
               is_shown(c.path) && std::find(ended.begin(), ended.end(), section) == ended.end())
        ended.push_back(section);
  for (const ExplainedWord& w : b.words) {
    if (w.name.empty()) continue;
    if (w.users.empty())
      lost.push_back(w.text);
    else if (!w.value.empty())
      words.push_back(w.text + " goes to " + w.users.back());
  }
  std::vector<std::string> reasons;
  if (!lost.empty()) reasons.push_back("no syntax uses " + list_of(lost));
  if (!words.empty()) reasons.push_back(list_of(words));
  if (!sets.empty()) reasons.push_back("it sets " + list_of(sets));
  if (!ended.empty()) reasons.push_back("it clears values of " + list_of(ended));
  if (reasons.empty())
    reasons.push_back(facts.now("Comment.Text") != nullptr ? "it holds a comment" : "it changes no value");
  std::string out = "moves nothing: ";
  for (std::size_t i = 0; i < reasons.size(); ++i) out += (i == 0 ? "" : "; ") + reasons[i];
  return out;
}

}  // namespace

std::string sentence_of(const Facts& facts, const std::vector<Stroke>& strokes) {
  std::vector<std::string> parts = other_parts(facts);
  const bool moves = !strokes.empty() || facts.now("MotionEvent.Form") != nullptr;
  if (!strokes.empty())
    parts.insert(parts.begin(), stroke_clause(facts, strokes));
  else if (moves)
    parts.insert(parts.begin(), move_clause(facts));
  else if (parts.empty())
    parts.push_back(rest_part(facts));
  std::string out = fmt::format("Line {} ", facts.block().where.line);
  for (std::size_t i = 0; i < parts.size(); ++i) out += (i == 0 ? "" : "; it ") + parts[i];
  if (const std::string machine = moves ? machine_clause(facts) : std::string(); !machine.empty())
    out += "; " + machine;
  return printable(out) + ".";
}

}  // namespace isogloss::cli
