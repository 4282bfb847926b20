#include "dap/strokes.hpp"

#include <fmt/format.h>

#include <cmath>

namespace isogloss::dap {

namespace {

struct BlockValues {
  const Document& d;
  bool present(ig_field f) const { return d.present(f) && d.fresh(f); }
  ig_value value(ig_field f) const { return d.value(f); }
};

/// Record fields are asked by their place in the record.
struct RecordValues {
  const ig_value* values;
  std::uint64_t mask;
  bool present(ig_field f) const { return f < 64 && (mask >> f & 1) != 0; }
  ig_value value(ig_field f) const { return values[f]; }
};

constexpr double same_place = 1e-9;

template <class Values>
void read_axes(const Values& values, const ig_field* fields, unsigned count, AxisValues& out) {
  for (unsigned i = 0; i < count; ++i)
    if (values.present(fields[i])) {
      out.at[i] = values.value(fields[i]).number;
      out.known |= 1u << i;
    }
}

}  // namespace

StrokeReader::StrokeReader(const Layout& layout) {
  const auto fill = [](Fields& to, const auto& id) {
    const std::string letters = "XYZABC";
    for (std::size_t i = 0; i < 3; ++i) to.program[i] = id("ProgramXyz." + letters.substr(i, 1));
    for (std::size_t i = 0; i < 6; ++i) to.machine[i] = id("MachineCoordinate." + letters.substr(i, 1));
    to.form = id("MotionEvent.Form");
    to.is_rapid = id("MotionEvent.IsRapid");
    to.feed = id("MotionEvent.Feedrate_mmds");
    to.dwell = id("Dwell.Time");
    to.orient = id("SpindleOrientation.Angle_deg");
    to.direction = id("SpindleControl.Direction");
  };
  const std::string items = "CompoundMotion.Items";
  fill(root_, [&](const std::string& path) { return layout.id(path); });
  for (std::size_t i = 0; i < layout.lists.size(); ++i)
    if (layout.lists[i].path == items) list_ = i;
  fill(item_, [&](const std::string& path) {
    const ig_field f = layout.record(items, path);
    return f == IG_NO_FIELD ? f : static_cast<ig_field>(index_in_record(f));
  });
}

template <class Values>
bool StrokeReader::read_motion(const Values& values, const Fields& fields, const SymbolTable& symbols, Stroke& out) {
  if (!values.present(fields.form)) return false;
  const bool is_rapid = values.present(fields.is_rapid) && values.value(fields.is_rapid).integer != 0;
  const bool is_arc = symbols.text(static_cast<ig_symbol>(values.value(fields.form).symbol)) == "McArc";
  out.kind = is_rapid ? Stroke::Kind::rapid : is_arc ? Stroke::Kind::arc : Stroke::Kind::feed;
  if (!is_rapid && values.present(fields.feed)) out.feed_mm_min = values.value(fields.feed).number * 60;
  return true;
}

void StrokeReader::read_items(const ListData& list, const SymbolTable& symbols, std::vector<Stroke>& out) const {
  for (std::uint32_t i = 0; i < list.count; ++i) {
    const RecordValues item{list.values.data() + std::size_t{i} * list.stride, list.present[i]};
    Stroke stroke;
    if (read_motion(item, item_, symbols, stroke)) {
      read_axes(item, item_.program, 3, stroke.program);
      read_axes(item, item_.machine, 6, stroke.machine);
    } else if (item.present(item_.dwell)) {
      stroke.kind = Stroke::Kind::dwell;
      stroke.value = item.value(item_.dwell).number;
    } else if (item.present(item_.orient)) {
      stroke.kind = Stroke::Kind::orient;
      stroke.value = item.value(item_.orient).number;
    } else if (item.present(item_.direction)) {
      stroke.kind = Stroke::Kind::spindle;
      stroke.term = symbols.text(static_cast<ig_symbol>(item.value(item_.direction).symbol));
    } else {
      continue;
    }
    out.push_back(stroke);
  }
}

void StrokeReader::read(const Document& d, const SymbolTable& symbols, std::vector<Stroke>& out) const {
  out.clear();
  Stroke stroke;
  if (read_motion(BlockValues{d}, root_, symbols, stroke)) {
    for (unsigned i = 0; i < 6; ++i) {
      if (i < 3 && d.present(root_.program[i])) stroke.program.at[i] = d.number(root_.program[i]);
      if (i < 3 && d.present(root_.program[i])) stroke.program.known |= 1u << i;
      if (!d.present(root_.machine[i])) continue;
      stroke.machine.at[i] = d.number(root_.machine[i]);
      stroke.machine.known |= 1u << i;
    }
    out.push_back(stroke);
  } else if (list_ < d.lists.size()) {
    read_items(d.lists[list_], symbols, out);
  }
}

std::size_t StrokeReader::count(const Document& d) const {
  if (d.present(root_.form) && d.fresh(root_.form)) return 1;
  return list_ < d.lists.size() ? d.lists[list_].count : 0;
}

std::string number_text(double value) {
  std::string out = fmt::format("{:.6f}", value);
  while (out.ends_with('0')) out.pop_back();
  if (out.ends_with('.')) out.pop_back();
  return out == "-0" ? "0" : out;
}

std::string describe(const Stroke& stroke, const AxisValues& before) {
  switch (stroke.kind) {
    case Stroke::Kind::dwell: return "dwell " + number_text(stroke.value) + " s";
    case Stroke::Kind::orient: return "spindle stop at " + number_text(stroke.value) + " deg";
    case Stroke::Kind::spindle: return "spindle " + std::string(stroke.term);
    case Stroke::Kind::rapid:
    case Stroke::Kind::feed:
    case Stroke::Kind::arc: break;
  }
  std::string to;
  for (unsigned i = 0; i < 3; ++i) {
    const bool stays = before.has(i) && std::abs(before.at[i] - stroke.program.at[i]) < same_place;
    if (stroke.program.has(i) && !stays) to += std::string(" ") + "XYZ"[i] + number_text(stroke.program.at[i]);
  }
  for (unsigned i = 3; i < 6 && to.empty(); ++i)
    if (stroke.machine.has(i)) to += std::string(" ") + "XYZABC"[i] + number_text(stroke.machine.at[i]);
  std::string out = stroke.kind == Stroke::Kind::rapid ? "rapid" : stroke.kind == Stroke::Kind::arc ? "arc" : "feed";
  if (!to.empty()) out += " to" + to;
  if (stroke.feed_mm_min) out += " at " + number_text(*stroke.feed_mm_min) + " mm/min";
  return out;
}

}  // namespace isogloss::dap
