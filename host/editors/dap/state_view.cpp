#include "dap/state_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "isogloss/engine/printable.hpp"

namespace isogloss::dap {

namespace {

constexpr const char* axes = "XYZABC";

Json source_of(std::string_view file) {
  return {{"name", std::filesystem::path(file).filename().string()}, {"path", canonical_path(std::string(file))}};
}

/// The strokes make a frame of their own where there are several.
bool has_stroke_frame(const Standing& standing) { return standing.position.is_within && standing.strokes.size() > 1; }

std::string name_of_stroke(const Standing& standing) {
  const std::size_t count = standing.strokes.size(), done = standing.position.done;
  if (done >= count) return fmt::format("after stroke {} of {}", count, count);
  const AxisValues before = done > 0         ? standing.strokes[done - 1].program
                            : standing.start ? standing.start->program
                                             : AxisValues{};
  return fmt::format("stroke {} of {}: {}", done + 1, count, describe(standing.strokes[done], before));
}

std::string name_of_frame(const ExplainedFrame& frame) {
  std::string name = frame.program.empty() ? std::filesystem::path(frame.file).filename().string() : frame.program;
  if (frame.passes > 1) name += fmt::format(" (pass {} of {})", frame.pass, frame.passes);
  return name;
}

Json row(std::string name, std::string value, const std::string& type = {}, const std::string& evaluated = {}) {
  Json out{{"name", std::move(name)}, {"value", std::move(value)}, {"variablesReference", 0}};
  if (!type.empty()) out["type"] = type;
  if (!evaluated.empty()) out["evaluateName"] = evaluated;
  return out;
}

Json folder(std::string name, std::string value, std::int64_t reference) {
  Json out = row(std::move(name), std::move(value));
  out["variablesReference"] = reference;
  return out;
}

std::string section_of(const std::string& path) { return path.substr(0, path.find('.')); }

std::string with_unit(std::string value, const std::string& unit) { return unit.empty() ? value : value + " " + unit; }

std::string field_text(const Standing& standing, ig_field f) {
  const Document& d = *standing.document;
  const FieldInfo& info = d.layout().fields[f];
  switch (info.type) {
    case IG_NUMBER: return with_unit(number_text(d.number(f)), info.unit);
    case IG_INTEGER: return with_unit(std::to_string(d.value(f).integer), info.unit);
    case IG_BOOLEAN: return d.value(f).integer != 0 ? "true" : "false";
    case IG_SYMBOL: return std::string(standing.symbols->text(static_cast<ig_symbol>(d.value(f).symbol)));
    case IG_TEXT: return printable(d.text(f));
    default: return {};
  }
}

bool is_listed(const Document& d, ig_field f) {
  const FieldInfo& info = d.layout().fields[f];
  return d.present(f) && !info.hidden && info.type != IG_CODE && info.type != IG_TRANSFORM && info.type != IG_SWITCH;
}

bool is_modal(const Document& d, ig_field f) { return is_listed(d, f) && is_carried(d.layout().fields[f].life); }

}  // namespace

std::int64_t StateView::add(Node node) {
  nodes_.push_back(std::move(node));
  return static_cast<std::int64_t>(nodes_.size());
}

Json StateView::frames(const Standing& standing) {
  Json out = Json::array();
  const BlockEntry& entry = standing.entry;
  std::int64_t id = 0;
  if (has_stroke_frame(standing))
    out.push_back({{"id", ++id},
                   {"name", name_of_stroke(standing)},
                   {"source", source_of(entry.file)},
                   {"line", entry.line},
                   {"column", entry.column + 1},
                   {"presentationHint", "subtle"}});
  const Frames& frames = *entry.frames;
  std::uint32_t line = entry.line;
  for (std::size_t i = frames.size(); i-- > 0;) {
    if (i + 1 < frames.size()) line = frames[i + 1].call_line;
    std::string name = name_of_frame(frames[i]);
    const bool is_top = i + 1 == frames.size();
    if (is_top && standing.position.is_within && !has_stroke_frame(standing)) name += ", after the block";
    Json frame{{"id", ++id},
               {"name", name},
               {"source", source_of(frames[i].file)},
               {"line", line},
               {"column", is_top ? entry.column + 1 : 1}};
    if (is_top && entry.lines > 1) frame["endLine"] = entry.line + entry.lines - 1, frame["endColumn"] = 1;
    out.push_back(std::move(frame));
  }
  return out;
}

Json StateView::scope(const char* name, Node node, const char* hint) {
  Json out{{"name", name}, {"variablesReference", add(std::move(node))}, {"expensive", false}};
  if (hint != nullptr) out["presentationHint"] = hint;
  return out;
}

Json StateView::scopes(const Standing& standing, std::int64_t frame, std::string& fault) {
  const std::size_t strokes = has_stroke_frame(standing) ? 1 : 0;
  const std::size_t count = standing.entry.frames->size() + strokes;
  if (frame < 1 || static_cast<std::uint64_t>(frame) > count) {
    fault = fmt::format("there is no frame {}", frame);
    return Json::array();
  }
  const std::size_t from_top = static_cast<std::size_t>(frame) - 1;
  const std::size_t level = count - 1 - std::max(from_top, strokes);
  Json out = Json::array();
  if (from_top <= strokes) out.push_back(scope("Positions", {Kind::positions}));
  out.push_back(scope("Variables", {Kind::program, level}, "locals"));
  if (from_top > strokes) return out;
  out.push_back(scope("Modal state", {Kind::modal}));
  out.push_back(scope(standing.position.is_within ? "Block" : "Block before", {Kind::block}));
  out.push_back(scope("Tables", {Kind::tables}));
  return out;
}

bool StateView::is_settable(std::int64_t reference) const {
  return reference >= 1 && static_cast<std::size_t>(reference) <= nodes_.size() &&
         nodes_[static_cast<std::size_t>(reference) - 1].kind == Kind::program;
}

Json StateView::variables(const Standing& standing, const ProgramVariables& variables, std::int64_t reference,
                          std::string& fault) {
  Json out = Json::array();
  if (reference < 1 || static_cast<std::size_t>(reference) > nodes_.size()) {
    fault = fmt::format("the reference {} belongs to a place that the run has left", reference);
    return out;
  }
  const Node node = nodes_[static_cast<std::size_t>(reference) - 1];
  switch (node.kind) {
    case Kind::positions: add_positions(standing, out); break;
    case Kind::modal: add_sections(standing, out); break;
    case Kind::section: add_fields(standing, node.name, out); break;
    case Kind::program: add_program(standing, variables, node.index, out); break;
    case Kind::block: add_block(standing, out); break;
    case Kind::words: add_words(standing, out); break;
    case Kind::motions: add_motions(standing, out); break;
    case Kind::motion: add_motion(standing, node.index, out); break;
    case Kind::written: add_written(standing, out); break;
    case Kind::tables: add_tables(standing, out); break;
    case Kind::table: add_rows(standing, node.index, out); break;
    case Kind::row: add_cells(standing, node.index, node.name, out); break;
  }
  return out;
}

void StateView::add_positions(const Standing& standing, Json& out) const {
  const Document& d = *standing.document;
  const Stroke* const stroke = standing.stroke();
  for (const bool is_machine : {false, true})
    for (unsigned i = 0; i < (is_machine ? 6u : 3u); ++i) {
      const std::string axis(1, axes[i]);
      const char* const unit = i < 3 ? "mm" : "deg";
      const char* const title = is_machine ? "Machine coordinates." : "Program coordinates.";
      const std::string name = (is_machine ? "machine." : "") + axis;
      const ig_field f = d.layout().id((is_machine ? "MachineCoordinate." : "ProgramXyz.") + axis);
      const AxisValues* const at = stroke == nullptr ? nullptr : is_machine ? &stroke->machine : &stroke->program;
      if (at != nullptr && at->has(i))
        out.push_back(row(name, with_unit(number_text(at->at[i]), unit), title, name));
      else if (d.present(f))
        out.push_back(row(name, with_unit(number_text(d.number(f)), unit), title, name));
    }
}

void StateView::add_sections(const Standing& standing, Json& out) {
  const Document& d = *standing.document;
  std::vector<std::pair<std::string, std::string>> sections;
  for (const ig_field f : d.layout().shown) {
    if (!is_modal(d, f)) continue;
    const std::string section = section_of(d.layout().fields[f].path);
    if (sections.empty() || sections.back().first != section) sections.emplace_back(section, "");
    std::string& summary = sections.back().second;
    if (summary.size() < 60) summary += (summary.empty() ? "" : ", ") + field_text(standing, f);
  }
  for (const auto& [section, summary] : sections)
    out.push_back(folder(section, summary, add({Kind::section, 0, section})));
}

void StateView::add_fields(const Standing& standing, const std::string& section, Json& out) const {
  const Document& d = *standing.document;
  for (const ig_field f : d.layout().shown) {
    const FieldInfo& info = d.layout().fields[f];
    if (!is_modal(d, f) || section_of(info.path) != section) continue;
    const std::string name = info.path.size() > section.size() ? info.path.substr(section.size() + 1) : info.path;
    out.push_back(row(name, field_text(standing, f), info.doc, info.path));
  }
}

void StateView::add_program(const Standing& standing, const ProgramVariables& variables, std::size_t frame,
                            Json& out) const {
  const Frames& frames = *standing.entry.frames;
  const auto add_one = [&](const ProgramVariables::Variable& v) {
    const bool is_text = v.value.kind == Value::Kind::text;
    const std::string value = is_text ? "\"" + printable(v.value.text) + "\"" : shown(v.value);
    const char* const type = v.scope == 0 ? "Variable of the program." : "Local variable of the call.";
    out.push_back(row(v.name, v.value.kind == Value::Kind::none ? "empty" : value, type, "var(\"" + v.name + "\")"));
  };
  const auto own = variables.of_call(frames[frame].call);
  for (const ProgramVariables::Variable* const v : own) add_one(*v);
  // The main program's local variables have the scope of the whole program: a call hides them.
  for (const ProgramVariables::Variable* const v : variables.of_program())
    if (std::ranges::none_of(own, [&](const auto* hiding) { return hiding->name == v->name; })) add_one(*v);
}

}  // namespace isogloss::dap
