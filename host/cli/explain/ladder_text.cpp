#include "explain/ladder_text.hpp"

#include <fmt/format.h>

#include "explain/frame_text.hpp"
#include "isogloss/engine/printable.hpp"

namespace isogloss::cli {

namespace {

constexpr const char* row_form = "  {:<40}{}\n";

std::string who_set(const Facts& facts, const std::string& writer, const ProgramLine& line) {
  std::string out = "      " + facts.place(line);
  if (const std::string text = facts.line_text(line); !text.empty()) out += ": " + cut(printable(text), 50);
  return out + (writer.empty() ? "" : " (" + writer + ")") + "\n";
}

LadderRow row_of(const Facts& facts, const ExplainedRung& rung, double unit_mm) {
  const FrameEffect effect = effect_of(rung.matrix, unit_mm);
  return {facts.name_of(rung), effect.text, rung.source, rung.writer,
          rung.since,          rung.matrix, rung.point,  rung.is_moving};
}

/// A section that keeps an angle R and a shift X Y Z, which different lines have set: the turn acts first.
std::vector<LadderRow> turn_and_shift(const Facts& facts, const ExplainedRung& rung, double unit_mm) {
  const ExplainedValue* const turn = facts.now(rung.source + ".R");
  const ExplainedValue* shift = nullptr;
  for (const char axis : {'X', 'Y', 'Z'})
    if (const ExplainedValue* const v = facts.now(rung.source + "." + axis);
        v != nullptr && (shift == nullptr || v->since.line > shift->since.line))
      shift = v;
  if (turn == nullptr || shift == nullptr || turn->since == shift->since) return {};
  std::array<double, 16> only_turn = rung.matrix, only_shift{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  LadderRow first = row_of(facts, rung, unit_mm), then = first;
  for (std::size_t i = 0; i < 3; ++i) {
    first.point[i] = rung.point[i] - rung.matrix[12 + i];
    only_turn[12 + i] = 0;
    only_shift[12 + i] = rung.matrix[12 + i];
  }
  first.matrix = only_turn;
  then.matrix = only_shift;
  first.does = effect_of(only_turn, unit_mm).text;
  first.since = turn->since;
  first.writer = turn->writer;
  then.does = effect_of(only_shift, unit_mm).text;
  then.since = shift->since;
  then.writer = shift->writer;
  return {first, then};
}

std::string machine_rows(const Facts& facts) {
  const ExplainedLadder& ladder = facts.block().ladder;
  std::array<double, 3> machine{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = facts.number(std::string("MachineCoordinate.") + "XYZ"[i]);
    if (!value) return {};
    machine[i] = *value;
  }
  const ExplainedValue& x = *facts.now("MachineCoordinate.X");
  const std::array<double, 3>& end = ladder.rungs.empty() ? ladder.program : ladder.rungs.back().point;
  const std::array<double, 3> beside{machine[0] - end[0], machine[1] - end[1], machine[2] - end[2]};
  std::string out;
  if (const std::string words = axis_words(beside, facts.unit()); !words.empty())
    out += fmt::format("  {} adds {}\n", x.writer.empty() ? "the initial state" : facts.function_of(x.writer), words);
  out += fmt::format(row_form, "machine", point_columns(machine, facts)) + who_set(facts, x.writer, x.set);
  if (facts.is_inch())
    out += fmt::format("  {:<40}{:>11.3f}{:>11.3f}{:>11.3f}\n", "machine, in mm", machine[0] + 0.0, machine[1] + 0.0,
                       machine[2] + 0.0);
  std::string rotary;
  for (const char axis : {'A', 'B', 'C'})
    if (const auto value = facts.number(std::string("MachineCoordinate.") + axis))
      rotary += fmt::format("{} {:.3f}°  ", axis, *value + 0.0);
  return rotary.empty() ? out : out + fmt::format("  rotary axes: {}\n", rotary.substr(0, rotary.size() - 2));
}

}  // namespace

std::string cut(std::string_view text, std::size_t size) {
  if (text.size() <= size) return std::string(text);
  while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0u) == 0x80u) --size;
  return std::string(text.substr(0, size)) + "…";
}

std::string point_columns(const std::array<double, 3>& p, const Facts& facts) {
  const double unit = facts.unit();
  const int decimals = facts.is_inch() ? 4 : 3;
  return fmt::format("{:>11.{}f}{:>11.{}f}{:>11.{}f}", p[0] / unit + 0.0, decimals, p[1] / unit + 0.0, decimals,
                     p[2] / unit + 0.0, decimals);
}

std::vector<LadderRow> ladder_rows(const Facts& facts, double unit_mm) {
  std::vector<LadderRow> out;
  for (const ExplainedRung& rung : facts.block().ladder.rungs) {
    for (const ExplainedPart& part : rung.parts)
      out.push_back({part.label.empty() ? section_words(rung.source) : part.label, effect_of(part.matrix, unit_mm).text,
                     rung.source, rung.writer, part.since, part.matrix, part.point, rung.is_moving});
    if (!rung.parts.empty()) continue;
    const std::vector<LadderRow> two = turn_and_shift(facts, rung, unit_mm);
    out.insert(out.end(), two.begin(), two.end());
    if (two.empty()) out.push_back(row_of(facts, rung, unit_mm));
  }
  return out;
}

std::string ladder_text(const Facts& facts) {
  const ExplainedLadder& ladder = facts.block().ladder;
  if (!ladder.is_there) return {};
  std::string out = fmt::format(
      "\n{:<42}{:>11}{:>11}{:>11}\n",
      facts.is_inch() ? "From the program to the machine, in inch:" : "From the program to the machine, in mm:", "X",
      "Y", "Z");
  out += fmt::format(row_form, "program point", point_columns(ladder.program, facts));
  if (const ExplainedValue* const x = facts.now("ProgramXyz.X")) {
    const ExplainedValue* last = x;
    for (const char* const path : {"ProgramXyz.Y", "ProgramXyz.Z"})
      if (const ExplainedValue* const v = facts.now(path); v != nullptr && v->set.line > last->set.line) last = v;
    out += who_set(facts, last->writer, last->set);
  }
  for (const LadderRow& row : ladder_rows(facts, facts.unit())) {
    std::string what = row.name + " " + row.does;
    if (row.is_moving) what += ", moving with the rotary axes";
    if (what.size() > 39) {
      out += "  " + what + "\n";
      what.clear();
    }
    out += fmt::format(row_form, what, point_columns(row.point, facts)) + who_set(facts, row.writer, row.since);
  }
  return out + machine_rows(facts);
}

}  // namespace isogloss::cli
