// Why the machine stands where it stands: what each rung of the ladder adds to the axes that move.
#include <fmt/format.h>

#include <cmath>

#include "explain/axis_moves.hpp"
#include "explain/frame_text.hpp"
#include "explain/ladder_text.hpp"
#include "explain/rest_clause.hpp"
#include "explain/sentence.hpp"

namespace isogloss::cli {

namespace {

constexpr double smallest_step = 1e-6;

/// "G55 adds -161.8 (line 37)": of a name in words "the work offset".
std::string placed_row(const Facts& facts, const LadderRow& row, const std::string& does) {
  const bool is_in_words = row.name == section_words(row.source);
  const std::string place = facts.is_here(row.since) ? std::string() : fmt::format(" ({})", facts.place(row.since));
  return fmt::format("{}{} {}{}", is_in_words ? "the " : "", row.name, does, place);
}

/// "because G55 adds -161.8 (line 37)"; empty: nothing moves the axis. `beside`: what is added behind the ladder, and
/// by whom.
std::string reason_of_axis(const Facts& facts, std::size_t axis, double beside, const std::string& writer) {
  std::vector<std::string> parts;
  for (const LadderRow& row : ladder_rows(facts, facts.unit()))
    if (const double shift = effect_of(row.matrix).shift[axis]; std::abs(shift) > 1e-9)
      parts.push_back(placed_row(facts, row, "adds " + facts.length(shift)));
  if (std::abs(beside) > smallest_step)
    parts.push_back(fmt::format("{} adds {}", facts.function_of(writer), facts.length(beside)));
  return parts.empty() ? std::string() : "because " + series_of(parts);
}

std::string reason_of_point(const Facts& facts, const std::array<double, 3>& beside, const std::string& writer) {
  std::vector<std::string> parts;
  for (const LadderRow& row : ladder_rows(facts, facts.unit())) parts.push_back(placed_row(facts, row, row.does));
  if (const std::string words = axis_words(beside, facts.unit()); !words.empty())
    parts.push_back(facts.function_of(writer) + " adds " + words);
  return "because " + series_of(parts);
}

/// " (zero here: G55, tool length 3)": offsets that the program has selected and that change nothing, as those of empty
/// tables do.
std::string zero_offsets(const Facts& facts) {
  std::string out;
  if (const ExplainedValue* const work = facts.now("CoordinateOffset.CoordinateId"); work != nullptr)
    out = facts.text("CoordinateOffset.CoordinateId");
  const std::optional<double> length = facts.number("ToolHeightCompensation.Offset_mm"),
                              row = facts.number("ToolHeightCompensation.OffsetId");
  if (length && row && *row > 0 && *length == 0)
    out += (out.empty() ? "tool length " : ", tool length ") + short_number(*row);
  return out.empty() ? out : " (zero here: " + out + ")";
}

}  // namespace

std::string machine_clause(const Facts& facts) {
  const ExplainedLadder& ladder = facts.block().ladder;
  if (!ladder.is_there) return {};
  std::array<double, 3> end = ladder.rungs.empty() ? ladder.program : ladder.rungs.back().point;
  std::array<std::optional<double>, 3> machine;
  bool only_shifts = true, any = false;
  std::array<double, 3> beside{};
  std::string writer;
  std::vector<std::pair<char, double>> values;
  const std::array<AxisChange, 3> changes = axis_changes(facts);
  for (const ExplainedRung& rung : ladder.rungs) only_shifts = only_shifts && effect_of(rung.matrix).is_shift;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string axis(1, "XYZ"[i]), path = "MachineCoordinate." + axis;
    machine[i] = facts.number(path);
    if (!machine[i]) continue;
    beside[i] = std::abs(*machine[i] - end[i]) < smallest_step ? 0 : *machine[i] - end[i];
    if (!facts.has_changed(path) && changes[i] != AxisChange::moves) {
      machine[i].reset();
      continue;
    }
    any = true;
    writer = facts.now(path)->writer;
    values.emplace_back(axis[0], *machine[i]);
  }
  if (!any) return {};
  const std::string moved = facts.words(values);
  const ExplainedValue* const programmed = facts.now("ProgramXyz.X");
  const bool is_direct = programmed != nullptr && programmed->writer == writer && !writer.empty();
  if (is_direct)
    return fmt::format("machine {}, which {} sets directly: no offset is added", moved, facts.function_of(writer));
  if (ladder.rungs.empty() && axis_words(beside).empty())
    return "machine " + moved + " is the same point, because no active offset changes it" + zero_offsets(facts);
  if (!only_shifts) return "machine " + moved + ", " + reason_of_point(facts, beside, writer);
  std::vector<std::string> parts;
  std::string same;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!machine[i]) continue;
    const std::string reason = reason_of_axis(facts, i, beside[i], writer), axis(1, "XYZ"[i]);
    if (reason.empty())
      same += (same.empty() ? "" : " ") + axis;
    else
      parts.push_back(fmt::format("machine {} is {} {}", axis, facts.length(*machine[i]), reason));
  }
  std::string out;
  for (const std::string& part : parts) out += (out.empty() ? "" : "; ") + part;
  if (out.empty())
    return "machine " + moved + " is the same point, because no active offset changes it" + zero_offsets(facts);
  return out;
}

}  // namespace isogloss::cli
