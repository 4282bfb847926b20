#include "explain/sentence.hpp"

#include <fmt/format.h>

#include <cmath>

#include "explain/frame_text.hpp"
#include "isogloss/engine/printable.hpp"

namespace isogloss::cli {

namespace {

/// "because G00 has been active since line 36"; empty where no value tells it.
std::string because_of(const Facts& facts, const std::string& path) {
  const ExplainedValue* const value = facts.now(path);
  if (value == nullptr) return {};
  const std::string code = facts.text(path);
  if (const ExplainedWord* const word = facts.word(code))
    return fmt::format("because the line programs {}", word->text);
  if (value->since.line == 0) return fmt::format("because {} is the initial state of the control", code);
  if (mentions(facts.line_text(value->since), code))
    return fmt::format("because {} has been active since {}", code, facts.place(value->since));
  for (const ExplainedWord& word : facts.block().words)
    if (!word.reader.empty() && word.name.empty() && facts.is_here(value->set))
      return fmt::format("because {} reads it so", word.reader);
  return fmt::format("because {} has set {} in {}", value->writer, code, facts.place(value->since));
}

std::string feed_clause(const Facts& facts) {
  const std::optional<double> feed = facts.number("MotionEvent.Feedrate_mmds");
  if (!feed) return "without a feed rate";
  std::string out = fmt::format("at {} mm/min", short_number(*feed * 60));
  const ExplainedValue* const programmed = facts.now("Feedrate.FeedrateValue");
  if (programmed == nullptr) return out;
  const std::optional<double> value = facts.number("Feedrate.FeedrateValue");
  std::string from;
  if (value && std::abs(*value - *feed * 60) > 1e-6)
    from = fmt::format("from {} {}", short_number(*value), facts.text("Feedrate.Unit"));
  if (!facts.is_here(programmed->set)) from += (from.empty() ? "" : ", ") + facts.place(programmed->set);
  return from.empty() ? out : out + " (" + from + ")";
}

std::string arc_clause(const Facts& facts) {
  const std::string sense = facts.text("MotionEvent.IsCcw") == "true" ? "counter-clockwise" : "clockwise";
  std::array<double, 3> centre{}, end{};
  double radius = 0;
  const std::string plane = facts.text("PlaneSelect.Plane");
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string axis(1, "XYZ"[i]);
    centre[i] = facts.number("MotionEvent.ArcCenter." + axis).value_or(0);
    end[i] = facts.number("ProgramXyz." + axis).value_or(0);
    if (plane.find(axis) != std::string::npos) radius += (end[i] - centre[i]) * (end[i] - centre[i]);
  }
  std::string out = fmt::format("on an arc {} about", sense);
  for (std::size_t i = 0; i < 3; ++i)
    if (plane.find("XYZ"[i]) != std::string::npos) out += fmt::format(" {}{}", "XYZ"[i], short_number(centre[i]));
  out += fmt::format(", radius {} in plane {}", short_number(std::sqrt(radius)), plane);
  if (const ExplainedValue* const set = facts.now("PlaneSelect.Term"); set != nullptr && !facts.is_here(set->since))
    out += fmt::format(" ({}, {})", facts.text("PlaneSelect.Term"), facts.place(set->since));
  return out;
}

std::string radius_clause(const Facts& facts) {
  const std::string side = facts.text("RadiusCompensation.Side");
  const std::optional<double> radius = facts.number("RadiusCompensation.Radius_mm");
  if (side.empty() || side == "None" || !radius) return {};
  const ExplainedValue& set = *facts.now("RadiusCompensation.Side");
  return fmt::format(", the tool {} of the path by its radius {}{}", side == "Left" ? "left" : "right",
                     short_number(*radius), facts.is_here(set.since) ? "" : " (" + facts.place(set.since) + ")");
}

/// The motion code in force; or a code of this block alone, such as G53, whose syntax moves in its own way.
std::string because_of_motion(const Facts& facts) {
  const ExplainedValue *const event = facts.now("MotionEvent.Form"), *const state = facts.now("MotionState.Term");
  if (event == nullptr || state == nullptr || event->writer == state->writer || facts.is_here(state->set))
    return because_of(facts, "MotionState.Term");
  for (const ExplainedWord& word : facts.block().words)
    if (word.value.empty() && !word.users.empty() && word.users.back() == event->writer)
      return fmt::format("because the line programs {}", word.text);
  return fmt::format("because {} moves it", event->writer);
}

std::string move_part(const Facts& facts) {
  const bool is_rapid = facts.text("MotionEvent.IsRapid") == "true", is_arc = facts.text("MotionEvent.Form") == "McArc";
  const std::string axes = changed_axes(facts);
  std::string out = axes.empty() && !is_arc ? "moves to where it already stands" : "moves";
  if (!axes.empty()) out += " to " + axes;
  if (is_arc) out += " " + arc_clause(facts);
  out += is_rapid ? " by rapid" : " " + feed_clause(facts);
  if (facts.text("MotionEvent.Form") == "ClLinear") out += " while rotary axes turn under the tip of the tool";
  out += radius_clause(facts);
  if (const std::string reason = because_of_motion(facts); !reason.empty()) out += ", " + reason;
  return out;
}

std::string stroke_part(const Facts& facts, const std::vector<Stroke>& strokes) {
  constexpr std::size_t most_shown = 6;
  const std::string term = facts.text("CompoundMotion.Term");
  std::string out = fmt::format("makes {} step{}", strokes.size(), strokes.size() == 1 ? "" : "s");
  if (!term.empty()) out += " of " + term;
  if (facts.now("CannedCycle.Term") != nullptr && facts.text("CannedCycle.Term") == term)
    if (const std::string reason = because_of(facts, "CannedCycle.Term"); !reason.empty()) out += ", " + reason;
  out += ": ";
  for (std::size_t i = 0; i < std::min(strokes.size(), most_shown); ++i) {
    const Stroke& s = strokes[i];
    out += (i == 0 ? "" : ", ") + s.does + (!s.to.empty() ? " to " + s.to : s.program ? " in place" : "");
    if (s.feed_mm_min && s.does != "rapid") out += fmt::format(" at {} mm/min", short_number(*s.feed_mm_min));
  }
  return out + (strokes.size() > most_shown ? ", …" : "") + radius_clause(facts);
}

/// What the block does besides moving.
std::vector<std::string> other_parts(const Facts& facts) {
  std::vector<std::string> out;
  if (const ExplainedBlock& b = facts.block(); !b.calls.empty())
    out.push_back(fmt::format("calls {}, {}:{}", b.calls, b.callee.file, b.callee.line));
  if (facts.text("ToolChange.IsChange") == "true")
    out.push_back("changes to tool " + facts.text("ToolChange.SpindleToolId"));
  if (const auto time = facts.number("Dwell.Time")) out.push_back(fmt::format("dwells {} s", short_number(*time)));
  if (facts.has_changed("SpindleSpeed.Direction"))
    out.push_back("sets the spindle to " + facts.text("SpindleSpeed.Direction"));
  if (facts.now("ProgramStop.Term") != nullptr)
    out.push_back("stops the program (" + facts.text("ProgramStop.Term") + ")");
  if (facts.now("ProgramEnd.Term") != nullptr)
    out.push_back("ends the program (" + facts.text("ProgramEnd.Term") + ")");
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
  std::vector<std::string> sets, words, lost;
  for (const ExplainedVariable& v : b.written)
    sets.push_back(v.name + " = " + (v.value.empty() ? "no value" : v.value));
  for (const ExplainedStep& step : b.steps)
    for (const ExplainedChange& c : step.changes)
      if (is_shown(c.path) && !c.after.empty()) sets.push_back(c.path + " = " + printable(c.after));
  for (const ExplainedWord& w : b.words) {
    if (w.name.empty()) continue;
    if (w.users.empty())
      lost.push_back(w.text);
    else if (!w.value.empty())
      words.push_back(w.text + " goes to " + w.users.back());
  }
  static constexpr std::size_t most = 3;
  const auto list = [](const std::vector<std::string>& parts) {
    std::string out;
    for (std::size_t i = 0; i < std::min(parts.size(), most); ++i) out += (i == 0 ? "" : ", ") + parts[i];
    return parts.size() > most ? out + fmt::format(" and {} more", parts.size() - most) : out;
  };
  std::vector<std::string> reasons;
  if (!lost.empty()) reasons.push_back("no syntax uses " + list(lost));
  if (!words.empty()) reasons.push_back(list(words));
  if (!sets.empty()) reasons.push_back("it sets " + list(sets));
  if (reasons.empty())
    reasons.push_back(facts.now("Comment.Text") != nullptr ? "it holds a comment" : "it changes no value");
  std::string out = "moves nothing: ";
  for (std::size_t i = 0; i < reasons.size(); ++i) out += (i == 0 ? "" : "; ") + reasons[i];
  return out;
}

}  // namespace

std::string changed_axes(const Facts& facts) {
  std::string out;
  const auto add = [&](const std::string& section, char axis) {
    const std::string path = section + axis;
    if (facts.has_changed(path))
      out += (out.empty() ? "" : " ") + std::string(1, axis) + short_number(facts.number(path).value_or(0));
  };
  for (const char axis : {'X', 'Y', 'Z'}) add("ProgramXyz.", axis);
  for (const char axis : {'A', 'B', 'C'}) add("MachineCoordinate.", axis);
  return out;
}

std::string sentence_of(const Facts& facts, const std::vector<Stroke>& strokes) {
  std::vector<std::string> parts = other_parts(facts);
  const bool moves = !strokes.empty() || facts.now("MotionEvent.Form") != nullptr;
  if (!strokes.empty())
    parts.insert(parts.begin(), stroke_part(facts, strokes));
  else if (moves)
    parts.insert(parts.begin(), move_part(facts));
  else if (parts.empty())
    parts.push_back(rest_part(facts));
  std::string out = fmt::format("Line {} ", facts.block().where.line);
  for (std::size_t i = 0; i < parts.size(); ++i) out += (i == 0 ? "" : "; it ") + parts[i];
  if (const std::string machine = moves ? machine_clause(facts) : std::string(); !machine.empty())
    out += "; " + machine;
  return printable(out) + ".";
}

}  // namespace isogloss::cli
