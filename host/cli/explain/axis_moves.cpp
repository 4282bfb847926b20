#include "explain/axis_moves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "explain/frame_text.hpp"
#include "explain/ladder_text.hpp"
#include "isogloss/engine/document.hpp"

namespace isogloss::cli {

namespace {

using Point = std::array<double, 3>;
constexpr double same_place_mm = 1e-6;
constexpr std::string_view entry = "ProgramToMcTransform[", matrix_of_entry = "].Mat4d";

std::string axis_name(std::size_t axis) { return std::string(1, "XYZ"[axis]); }

std::optional<Frame> back_to_program(const Facts& facts) {
  Frame all;
  for (const ExplainedRung& rung : facts.block().ladder.rungs) {
    if (rung.is_moving) return std::nullopt;
    all = all * Frame::from(rung.matrix.data());
  }
  return all.inverse();
}

/// The place of the machine as program coordinates of the frame behind the block.
std::optional<Point> machine_place(const Facts& facts, bool before_the_block) {
  const std::optional<Frame> back = back_to_program(facts);
  if (!back || !facts.block().ladder.is_there) return std::nullopt;
  double machine[3], program[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string path = "MachineCoordinate." + axis_name(i);
    const std::optional<double> value = before_the_block ? facts.number_before(path) : facts.number(path);
    if (!value) return std::nullopt;
    machine[i] = *value;
  }
  back->map(machine, program);
  return Point{program[0], program[1], program[2]};
}

bool has_side(const ExplainedValue* side) { return side != nullptr && side->value != R"("None")"; }

/// The tool's centre moves otherwise than the programmed point.
bool is_compensated(const Facts& facts) {
  return has_side(facts.now("RadiusCompensation.Side")) || has_side(facts.before("RadiusCompensation.Side"));
}

bool differs(std::optional<double> a, std::optional<double> b) {
  return a.has_value() != b.has_value() || (a && std::abs(*a - *b) > same_place_mm);
}

/// Programmed in this block, and the run has not known before where the axis stands.
bool is_first_position(const Facts& facts, std::size_t axis) {
  const ExplainedValue* const was = facts.before("ProgramXyz." + axis_name(axis));
  return facts.word(axis_name(axis)) != nullptr && (was == nullptr || was->since.line == 0);
}

/// "G54 replaces G55"; "the tool length compensation is cancelled".
std::string end_of_frame(const Facts& facts, const std::string& source) {
  const auto code_of = [&](const std::vector<ExplainedValue>& values) -> std::string {
    for (const ExplainedValue& v : values)
      if (v.path.starts_with(source + ".") && v.value.size() > 2 && v.value.front() == '"')
        return v.value.substr(1, v.value.size() - 2);
    return {};
  };
  const std::string now = code_of(facts.block().values), was = code_of(facts.block().carried);
  if (!now.empty() && !was.empty() && now != was) return now + " replaces " + was;
  return "the " + section_words(source) + " is cancelled";
}

/// "because G55 adds Z0.03": what the block has changed on the way to the machine.
std::string changed_frames(const Facts& facts) {
  std::vector<std::string> parts;
  for (const LadderRow& row : ladder_rows(facts, facts.unit()))
    if (facts.is_here(row.since) && row.does != changes_nothing)
      parts.push_back((row.name == section_words(row.source) ? "the " : "") + row.name + " " + row.does);
  for (const ExplainedValue& v : facts.block().carried) {
    if (!v.path.starts_with(entry) || !v.path.ends_with(matrix_of_entry)) continue;
    const std::string source = v.path.substr(entry.size(), v.path.size() - entry.size() - matrix_of_entry.size());
    const auto& rungs = facts.block().ladder.rungs;
    const bool is_present = std::any_of(rungs.begin(), rungs.end(), [&](const auto& r) { return r.source == source; });
    if (!is_present && effect_of_json(v.value) != changes_nothing) parts.push_back(end_of_frame(facts, source));
  }
  std::string out;
  for (std::size_t i = 0; i < parts.size(); ++i)
    out += (i == 0 ? ", because " : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return out;
}

}  // namespace

std::optional<std::array<double, 3>> start_of_block(const Facts& facts) {
  return is_compensated(facts) ? std::nullopt : machine_place(facts, true);
}

std::array<AxisChange, 3> axis_changes(const Facts& facts) {
  std::array<AxisChange, 3> out{};
  const std::optional<Point> start = start_of_block(facts),
                             end = start ? machine_place(facts, false) : std::optional<Point>();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string path = "ProgramXyz." + axis_name(i);
    const bool has_new_value = differs(facts.number_before(path), facts.number(path));
    if (!start || !end)
      out[i] = has_new_value ? AxisChange::moves : AxisChange::none;
    else if (std::abs((*start)[i] - (*end)[i]) > same_place_mm || is_first_position(facts, i))
      out[i] = AxisChange::moves;
    else if (has_new_value)
      out[i] = AxisChange::reads_anew;
  }
  return out;
}

std::string reading_clause(const Facts& facts) {
  const std::array<AxisChange, 3> changes = axis_changes(facts);
  std::string values, axes;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const ExplainedValue* const was = facts.before("ProgramXyz." + axis_name(i));
    if (changes[i] != AxisChange::reads_anew || was == nullptr) continue;
    values += (count == 0 ? "" : ", ") + axis_name(i) + " now reads " +
              facts.length(facts.number("ProgramXyz." + axis_name(i)).value_or(0));
    axes += (count++ == 0 ? "" : " ") + axis_name(i);
  }
  if (count == 0) return {};
  return fmt::format("{}{}; the machine stands still in {}", values, changed_frames(facts), axes);
}

}  // namespace isogloss::cli
