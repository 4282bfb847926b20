#include "explain/strokes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "explain/axis_moves.hpp"
#include "explain/frame_text.hpp"

namespace isogloss::cli {

namespace {

constexpr double same_value = 1e-6;

std::optional<std::array<double, 3>> point_of(const Json& item, const char* section) {
  const auto found = item.find(section);
  if (found == item.end()) return std::nullopt;
  std::array<double, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = found->find(std::string(1, "XYZ"[i]));
    if (value == found->end() || !value->is_number()) return std::nullopt;
    out[i] = value->get<double>();
  }
  return out;
}

/// A level or depth of the cycle that has this value, with the line that gave it.
std::string level_of(const Facts& facts, char axis, double value) {
  for (const std::string& path : {std::string("CannedCycle.Params.") + axis, std::string("CannedCycle.Params.R"),
                                  std::string("CannedCycle.InitialLevel")})
    if (const std::optional<double> level = facts.number(path); level && std::abs(*level - value) < same_value)
      return fmt::format("{} is {} ({})", axis, path, facts.place(facts.now(path)->since));
  return {};
}

/// The rotary axes that the step turns, with the angles at its end.
void add_rotary_axes(const Json& item, std::map<char, double>& at, std::vector<std::pair<char, double>>& out) {
  const auto machine = item.find("MachineCoordinate");
  if (machine == item.end()) return;
  for (const char axis : {'A', 'B', 'C'}) {
    const auto value = machine->find(std::string(1, axis));
    if (value == machine->end() || !value->is_number()) continue;
    const double angle = value->get<double>();
    const auto was = at.find(axis);
    if (was != at.end() && std::abs(was->second - angle) < same_value) continue;
    at[axis] = angle;
    out.emplace_back(axis, angle);
  }
}

std::string other_event(const Json& item) {
  if (const auto dwell = item.find("Dwell"); dwell != item.end())
    return fmt::format("dwell {} s", short_number(dwell->value("Time", 0.0)));
  if (const auto spindle = item.find("SpindleControl"); spindle != item.end())
    return "spindle " + spindle->value("Direction", std::string());
  if (const auto stop = item.find("SpindleOrientation"); stop != item.end())
    return fmt::format("spindle stop at {}°", short_number(stop->value("Angle_deg", 0.0)));
  return "step";
}

}  // namespace

std::vector<Stroke> strokes_of(const Facts& facts) {
  std::vector<Stroke> out;
  const auto compound = facts.document().find("CompoundMotion");
  if (compound == facts.document().end() || !compound->contains("Items")) return out;
  std::array<std::optional<double>, 3> at;
  for (std::size_t i = 0; i < 3; ++i) at[i] = facts.number_before(std::string("ProgramXyz.") + "XYZ"[i]);
  if (const auto start = start_of_block(facts)) std::copy(start->begin(), start->end(), at.begin());
  std::map<char, double> rotary;
  for (const char axis : {'A', 'B', 'C'})
    if (const auto value = facts.number_before(std::string("MachineCoordinate.") + axis)) rotary[axis] = *value;
  for (const Json& item : (*compound)["Items"]) {
    Stroke stroke;
    stroke.program = point_of(item, "ProgramXyz");
    stroke.machine = point_of(item, "MachineCoordinate");
    const auto event = item.find("MotionEvent");
    if (event == item.end()) {
      stroke.does = other_event(item);
      out.push_back(std::move(stroke));
      continue;
    }
    const bool is_rapid = event->value("IsRapid", false);
    stroke.does = is_rapid ? "rapid" : event->value("Form", std::string()) == "McArc" ? "arc" : "feed";
    if (const auto feed = event->find("Feedrate_mmds"); feed != event->end() && feed->is_number())
      stroke.feed_mm_min = feed->get<double>() * 60;
    std::vector<std::pair<char, double>> axes;
    for (std::size_t i = 0; stroke.program && i < 3; ++i) {
      const double value = (*stroke.program)[i];
      if (at[i] && std::abs(*at[i] - value) < same_value) continue;
      at[i] = value;
      axes.emplace_back("XYZ"[i], value);
      if (const std::string level = level_of(facts, "XYZ"[i], value); !level.empty() && "XYZ"[i] == 'Z')
        stroke.reason = level;
    }
    add_rotary_axes(item, rotary, axes);
    stroke.turns = !axes.empty() && axes.back().first < 'X';
    stroke.to = facts.words(axes);
    out.push_back(std::move(stroke));
  }
  return out;
}

}  // namespace isogloss::cli
