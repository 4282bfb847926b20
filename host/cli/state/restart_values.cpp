#include "state/restart_values.hpp"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <set>

#include "isogloss/engine/program_text.hpp"
#include "json_text.hpp"
#include "state/frame_parts.hpp"

namespace isogloss::cli {

namespace {

constexpr double mm_per_inch = 25.4;
constexpr std::string_view transform = "ProgramToMcTransform[", matrix = "].Mat4d";

std::optional<double> number_of(std::string_view text) {
  double out = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(out) : std::nullopt;
}

bool is_same(std::string_view a, std::string_view b) {
  if (b.ends_with('*')) return a.starts_with(b.substr(0, b.size() - 1));
  const auto x = number_of(a), y = number_of(b);
  return x && y ? *x == *y : a == b;
}

/// The parts of a list in turn, until `is_last` holds for one.
template <class IsLast>
bool any_part(std::string_view list, char separator, IsLast is_last) {
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(separator, begin), list.size());
    if (is_last(list.substr(begin, end - begin))) return true;
    begin = end + 1;
  }
  return false;
}

bool holds_one(std::string_view condition, const StateFields& state) {
  const bool is_denied = condition.starts_with('!');
  if (is_denied) condition.remove_prefix(1);
  const std::size_t sign = std::min(condition.find_first_of("=<>"), condition.size());
  const bool differs = sign > 0 && sign < condition.size() && condition[sign - 1] == '!';
  const auto found = state.find(condition.substr(0, sign - (differs ? 1 : 0)));
  if (sign == condition.size()) return (found != state.end()) != is_denied;
  if (found == state.end()) return false;
  std::string_view choices = condition.substr(sign + 1);
  if (condition[sign] != '=') {
    const auto value = number_of(found->second), limit = number_of(choices);
    return value && limit && (condition[sign] == '<' ? *value < *limit : *value > *limit);
  }
  if (choices.starts_with('@')) {
    const auto other = state.find(choices.substr(1));
    choices = other == state.end() ? std::string_view() : other->second;
  }
  return any_part(choices, '|', [&](std::string_view choice) { return is_same(found->second, choice); }) != differs;
}

void add_frame(std::string_view source, const std::string& json, StateFields& state) {
  const Json values = Json::parse(json, nullptr, false);
  if (!values.is_array() || values.size() != 16) return;
  std::array<double, 16> m{};
  for (std::size_t i = 0; i < 16; ++i) m[i] = values[i].is_number() ? values[i].get<double>() : 0;
  const auto parts = FrameParts::of(m);
  if (!parts) return;
  const std::string name = "Frame." + std::string(source) + ".";
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string letter(1, "XYZ"[axis]);
    state[name + letter] = block_number(parts->shift[axis], true);
    state[name + "R" + letter] = block_number(parts->turn_deg[axis], true);
    state[name + "S" + letter] = block_number(parts->scale[axis], true);
    if (parts->is_mirrored[axis]) state[name + "M" + letter] = "1";
    if (std::abs(parts->turn_deg[axis]) > 1e-12) state[name + "IsTurned"] = "1";
    if (std::abs(parts->scale[axis] - 1) > 1e-12) state[name + "IsScaled"] = "1";
  }
}

void add_tool_names(const ProgramPoint& point, StateFields& state) {
  for (const char* const tool : {"SpindleTool", "Tool"}) {
    const auto number = state.find(std::string("ToolChange.") + tool + "Id");
    const auto value = number == state.end() ? std::optional<double>() : number_of(number->second);
    const std::string name = value ? point.tools.of(static_cast<std::int64_t>(*value)) : std::string();
    if (!name.empty()) state[std::string("ToolChange.") + tool + "Name"] = name;
  }
}

/// Only what the program has given is a position to go to. The others go where the program has sent them otherwise.
void keep_given_places(const ProgramPoint& point, StateFields& state) {
  std::string given, by_machine, by_reference;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string letter(1, "XYZ"[axis]);
    const AxisPlace place = point.places[axis];
    if (place == AxisPlace::program) {
      given += letter;
      continue;
    }
    state.erase("ProgramXyz." + letter);
    state.erase("ClearLevel." + letter);
    if (place == AxisPlace::reference) state["Reference." + letter] = "0", by_reference += letter;
    const auto machine = state.find("MachineCoordinate." + letter);
    if (place != AxisPlace::machine || machine == state.end()) continue;
    state["MachinePlace." + letter] = machine->second;
    by_machine += letter;
  }
  for (const auto& [name, axes] :
       {std::pair("ProgramXyz.", given), std::pair("MachinePlace.", by_machine), std::pair("Reference.", by_reference)})
    for (const std::string_view plane : {"XY", "ZX", "YZ"})
      if (axes.find(plane[0]) != std::string::npos || axes.find(plane[1]) != std::string::npos)
        state[std::string(name) + "In" + std::string(plane)] = "1";
}

StateFields fields_of(const ProgramPoint& point) {
  StateFields out;
  for (const ExplainedValue& v : point.block.carried) {
    const bool is_name = v.value.size() >= 2 && v.value.front() == '"';
    out[v.path] = is_name ? v.value.substr(1, v.value.size() - 2) : v.value;
    if (v.path.starts_with(transform) && v.path.ends_with(matrix))
      add_frame(v.path.substr(transform.size(), v.path.size() - transform.size() - matrix.size()), v.value, out);
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (const auto& place = point.place[axis])
      out[std::string("ProgramXyz.") + "XYZ"[axis]] = block_number(*place, true);
  add_tool_names(point, out);
  // Down from the level goes a feed move, so there must be a feed that a block can set.
  const auto unit = out.find("Feedrate.Unit");
  const bool has_feed = out.contains("Feedrate.FeedrateValue") && unit != out.end() && unit->second.starts_with("mm");
  for (std::size_t axis = 0; has_feed && axis < 3; ++axis)
    if (const auto& level = point.clear_level[axis])
      out[std::string("ClearLevel.") + "XYZ"[axis]] = block_number(*level, true);
  keep_given_places(point, out);
  return out;
}

/// Fields of this class alone; no layout knows them.
bool is_length(std::string_view name) {
  return name.starts_with("ClearLevel.") || name.starts_with("MachinePlace.") ||
         (name.starts_with("Frame.") && name[name.size() - 2] == '.');
}

}  // namespace

bool holds(std::string_view when, const StateFields& state) {
  return !any_part(when, ' ', [&](std::string_view one) { return !one.empty() && !holds_one(one, state); });
}

RestartValues::RestartValues(const ProgramPoint& point, const ProgramLines& lines, const Layout& layout)
    : point_(point), lines_(lines), layout_(layout), state_(fields_of(point)) {
  const auto unit = state_.find("Unit.System");
  is_inch_ = unit != state_.end() && unit->second == "Inch";
}

bool RestartValues::write_number(std::string_view name, std::string_view format, double value, std::string& out) const {
  const auto field = layout_.find(name);
  bool is_in_unit = is_length(name) || (field && layout_.fields[*field].unit == "mm");
  bool is_plain = field && layout_.fields[*field].type != IG_NUMBER, has_sign = false;
  any_part(format, ' ', [&](std::string_view one) {
    is_in_unit |= one == "length";
    is_plain |= one == "n" || one == "+";
    has_sign |= one == "+";
    if (one.starts_with('*')) value *= number_of(one.substr(1)).value_or(1);
    return false;
  });
  if (is_in_unit && is_inch_) value /= mm_per_inch;
  // Eight decimals: an inch needs more than a millimetre.
  const std::string text = block_number(std::round(value * 1e8) / 1e8, true, is_plain);
  if (has_sign && !text.starts_with('-')) out += '+';
  out += text;
  return true;
}

bool RestartValues::write_blocks(std::string_view name, std::string_view format, std::string& out) const {
  const std::size_t before = out.size();
  std::set<std::pair<std::string, std::uint32_t>> written;
  for (const ExplainedValue& v : point_.block.carried) {
    if (v.set.line == 0 || !is_same(v.path, name)) continue;
    written.emplace(v.set.file, v.set.line);
  }
  for (const auto& [file, line] : written) {
    // A part that sets a value itself has come with the first one.
    if (format == "parts" && out.find(lines_.block({file, line}), before) != std::string::npos) continue;
    const std::string block = format == "parts" ? lines_.parts({file, line}) : lines_.block({file, line});
    if (block.empty()) return false;
    if (out.size() > before) out += '\n';
    out += block;
  }
  return out.size() > before;
}

bool RestartValues::operator()(std::string_view name, std::string_view format, std::string& out) const {
  if (name == "LINE") return out += std::to_string(point_.block.where.line), true;
  if (name == "PROGRAM") return out += std::filesystem::path(point_.block.where.file).stem().string(), true;
  if (constexpr std::string_view last = "Last "; name.starts_with(last)) {
    const std::string code = point_.codes.last_of(name.substr(last.size()));
    return out += code, !code.empty();
  }
  if (format == "blocks" || format == "parts") return write_blocks(name, format, out);
  const auto found = state_.find(name);
  if (found == state_.end()) return false;
  std::string_view value = found->second;
  if (const std::size_t at = format.find("behind "); at != std::string_view::npos) {
    const std::string_view head = format.substr(at + 7);
    if (!value.starts_with(head)) return false;
    return out += value.substr(head.size()), true;
  }
  if (const auto number = number_of(value)) return write_number(name, format, *number, out);
  return out += value, true;
}

}  // namespace isogloss::cli
