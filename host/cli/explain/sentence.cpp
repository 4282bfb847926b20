#include "explain/sentence.hpp"

#include <fmt/format.h>

#include "explain/axis_moves.hpp"
#include "explain/frame_text.hpp"
#include "explain/go_clause.hpp"
#include "explain/move_clause.hpp"
#include "explain/rest_clause.hpp"
#include "isogloss/engine/printable.hpp"

namespace isogloss::cli {

namespace {

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

/// "5", "\"DRILL 8.5\", number 1 of this run": a tool that the block calls by its name.
std::string tool_text(const Facts& facts, const std::string& number) {
  const std::string name = facts.text("ToolName.Text");
  const bool is_named = !name.empty() && facts.text("ToolChange.ToolId") == number;
  return is_named ? fmt::format("\"{}\", number {} of this run", name, number) : number;
}

/// The tool that the block names for a later change; empty: none.
std::string preselected_tool(const Facts& facts) {
  const ExplainedValue* const tool = facts.now("ToolChange.ToolId");
  if (tool == nullptr || !facts.is_here(tool->set) || facts.text("ToolChange.IsChange") == "true") return {};
  return tool_text(facts, facts.text("ToolChange.ToolId"));
}

/// What the block does besides moving.
std::vector<std::string> other_parts(const Facts& facts) {
  std::vector<std::string> out;
  if (facts.text("ToolChange.IsChange") == "true")
    out.push_back("changes to tool " + tool_text(facts, facts.text("ToolChange.SpindleToolId")));
  if (const std::string tool = preselected_tool(facts); !tool.empty()) out.push_back("preselects tool " + tool);
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

}  // namespace

std::string sentence_of(const Facts& facts, const std::vector<Stroke>& strokes) {
  std::vector<std::string> parts = other_parts(facts);
  const bool moves = !strokes.empty() || facts.now("MotionEvent.Form") != nullptr;
  const bool is_at_rest = !moves && !parts.empty();
  if (!strokes.empty())
    parts.insert(parts.begin(), stroke_clause(facts, strokes));
  else if (moves)
    parts.insert(parts.begin(), move_clause(facts));
  else if (parts.empty())
    parts.push_back(rest_clause(facts));
  const std::vector<std::string> modes = is_at_rest ? mode_clauses(facts) : std::vector<std::string>();
  std::string out = fmt::format("Line {} ", facts.block().where.line);
  for (std::size_t i = 0; i < parts.size(); ++i) out += (i == 0 ? "" : "; it ") + parts[i];
  for (const std::string& mode : modes) out += "; " + mode;
  if (const std::string reading = reading_clause(facts); !reading.empty()) out += "; " + reading;
  if (const std::string machine = moves ? machine_clause(facts) : std::string(); !machine.empty())
    out += "; " + machine;
  return printable(out) + ".";
}

}  // namespace isogloss::cli
