#include "explain/move_clause.hpp"

#include <fmt/format.h>

#include <cmath>

#include "explain/frame_text.hpp"
#include "explain/sentence.hpp"

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

/// What the way of an arc is in its plane: an arc, a full circle, or a helix where the third axis moves, too.
std::string shape_of_arc(const Facts& facts, const std::string& plane) {
  bool moves_in_plane = false, moves_across = false;
  for (const char axis : {'X', 'Y', 'Z'}) {
    const bool moves = facts.has_changed(std::string("ProgramXyz.") + axis);
    (plane.find(axis) != std::string::npos ? moves_in_plane : moves_across) |= moves;
  }
  std::string out = moves_across ? "helix" : moves_in_plane ? "arc" : "full circle";
  if (const double turns = facts.number("MotionEvent.AdditionalCircleNum").value_or(0); turns > 0)
    out += fmt::format(" of {} further turn{}", short_number(turns), turns == 1 ? "" : "s");
  return out;
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
  const std::string shape = shape_of_arc(facts, plane);
  std::string out = fmt::format("on {} {} {} about", shape[0] == 'a' ? "an" : "a", shape, sense);
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

/// Axes whose programmed value a syntax has changed: " (ProgrammableMirrorSyntax makes X-20 of X20)"; empty: none.
std::string changed_words(const Facts& facts) {
  std::string out;
  for (const char axis : {'X', 'Y', 'Z'}) {
    const std::string word = std::string("Parsing.") + axis, point = std::string("ProgramXyz.") + axis;
    std::string before, after, syntax, in_block;
    for (const ExplainedStep& step : facts.block().steps)
      for (const ExplainedChange& c : step.changes) {
        const bool is_word = c.path == word && !step.is_scan && !c.before.empty() && !c.after.empty();
        const bool is_point = c.path == point && !in_block.empty() && !c.after.empty() && c.after != in_block;
        if (c.path == point) in_block = c.after;
        if (!is_word && !is_point) continue;
        if (before.empty()) before = c.before;
        after = c.after;
        syntax = step.syntax;
      }
    if (syntax.empty() || before == after) continue;
    const auto shown = [axis](const std::string& value) {
      const Json number = Json::parse(value, nullptr, false);
      return std::string(1, axis) + (number.is_number() ? short_number(number.get<double>()) : value);
    };
    out += fmt::format("{}{} makes {} of {}", out.empty() ? " (" : ", ", syntax, shown(after), shown(before));
  }
  return out.empty() ? out : out + ")";
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

std::string move_clause(const Facts& facts) {
  const bool is_rapid = facts.text("MotionEvent.IsRapid") == "true", is_arc = facts.text("MotionEvent.Form") == "McArc";
  const std::string axes = changed_axes(facts);
  std::string out = axes.empty() && !is_arc ? "moves to where it already stands" : "moves";
  if (!axes.empty()) out += " to " + axes + changed_words(facts);
  if (is_arc) out += " " + arc_clause(facts);
  out += is_rapid ? " by rapid" : " " + feed_clause(facts);
  if (facts.text("MotionEvent.Form") == "ClLinear") out += " while rotary axes turn under the tip of the tool";
  out += radius_clause(facts);
  if (const std::string reason = because_of_motion(facts); !reason.empty()) out += ", " + reason;
  return out;
}

std::string stroke_clause(const Facts& facts, const std::vector<Stroke>& strokes) {
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

}  // namespace isogloss::cli
