#include "explain/move_clause.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "explain/axis_moves.hpp"
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
  // The longest piece of a line that is text and no words: PLANE SPATIAL …
  const ExplainedWord* longest = nullptr;
  for (const ExplainedWord& word : facts.block().words)
    if (!word.reader.empty() && word.name.empty() && facts.is_here(value->set) &&
        (longest == nullptr || word.text.size() > longest->text.size()))
      longest = &word;
  if (longest != nullptr) return "because the line says so: " + facts.function_of(longest->reader);
  return fmt::format("because {} has set {} in {}", facts.function_of(value->writer), code, facts.place(value->since));
}

std::string feed_clause(const Facts& facts) {
  const std::optional<double> feed = facts.number("MotionEvent.Feedrate_mmds");
  if (!feed) return "without a feed rate";
  std::string out = "at " + facts.feed(*feed * 60);
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
  std::vector<std::pair<char, double>> centres;
  for (std::size_t i = 0; i < 3; ++i)
    if (plane.find("XYZ"[i]) != std::string::npos) centres.emplace_back("XYZ"[i], centre[i]);
  out += fmt::format(" {}, radius {} in plane {}", facts.words(centres), facts.length(std::sqrt(radius)), plane);
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
                     facts.length(*radius), facts.is_here(set.since) ? "" : " (" + facts.place(set.since) + ")");
}

/// A word in inch has become the same length in mm.
bool is_conversion(const Facts& facts, const ExplainedChange& c) {
  const Json before = Json::parse(c.before, nullptr, false), after = Json::parse(c.after, nullptr, false);
  return facts.is_inch() && before.is_number() && after.is_number() &&
         std::abs(before.get<double>() * facts.unit() - after.get<double>()) < 1e-6;
}

/// Axes whose programmed value a function has changed: " (X20 becomes X-20 by G51.1, line 2)"; empty: none.
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
        if (is_conversion(facts, c)) continue;
        if (before.empty()) before = c.before;
        after = c.after;
        syntax = step.syntax;
      }
    if (syntax.empty() || before == after) continue;
    const auto shown = [&](const std::string& value) {
      const Json number = Json::parse(value, nullptr, false);
      return number.is_number() ? facts.words({{axis, number.get<double>()}}) : axis + value;
    };
    out += fmt::format("{}{} becomes {} by {}", out.empty() ? " (" : ", ", shown(before), shown(after),
                       facts.function_of(syntax));
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
  return fmt::format("because of this function: {}", facts.function_of(event->writer));
}

}  // namespace

std::string changed_axes(const Facts& facts) {
  const std::array<AxisChange, 3> changes = axis_changes(facts);
  std::vector<std::pair<char, double>> axes;
  for (std::size_t i = 0; i < 3; ++i)
    if (changes[i] == AxisChange::moves)
      axes.emplace_back("XYZ"[i], facts.number(std::string("ProgramXyz.") + "XYZ"[i]).value_or(0));
  for (const char axis : {'A', 'B', 'C'}) {
    const std::string path = std::string("MachineCoordinate.") + axis;
    if (facts.has_changed(path)) axes.emplace_back(axis, facts.number(path).value_or(0));
  }
  return facts.words(axes);
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
  // Compensation has made them of one move of the program.
  if (!term.empty() && term == facts.text("RadiusCompensation.Term"))
    out = strokes.size() == 1 ? "moves the tool centre"
                              : fmt::format("moves the tool centre in {} steps", strokes.size());
  else if (!term.empty())
    out += " of " + term;
  if (facts.now("CannedCycle.Term") != nullptr && facts.text("CannedCycle.Term") == term)
    if (const std::string reason = because_of(facts, "CannedCycle.Term"); !reason.empty()) out += ", " + reason;
  const bool moves =
      std::any_of(strokes.begin(), strokes.end(), [](const Stroke& s) { return !s.program || !s.to.empty(); });
  if (!moves) return out + ", but stands at their end already, as far as this run knows" + radius_clause(facts);
  out += ": ";
  for (std::size_t i = 0; i < std::min(strokes.size(), most_shown); ++i) {
    const Stroke& s = strokes[i];
    out += (i == 0 ? "" : ", ") + s.does + (!s.to.empty() ? " to " + s.to : s.program ? " in place" : "");
    if (s.feed_mm_min && s.does != "rapid") out += " at " + facts.feed(*s.feed_mm_min);
  }
  return out + (strokes.size() > most_shown ? ", …" : "") + radius_clause(facts);
}

}  // namespace isogloss::cli
