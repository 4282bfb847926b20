#include "run/explain_values.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace isogloss {

namespace {

constexpr std::string_view transform_section = "ProgramToMcTransform.";

}  // namespace

std::string number_text(double value) {
  constexpr double largest = 1e15;
  const bool is_whole = std::abs(value) < largest && value == std::trunc(value);
  return is_whole ? std::to_string(static_cast<std::int64_t>(value)) : nlohmann::json(value).dump();
}

ig_field ValueOrigins::field_of(const Document& document, const std::string& path) {
  const Layout& layout = document.layout();
  if (const auto f = layout.find(path)) return *f;
  const std::size_t bracket = path.find('[');
  if (bracket != std::string::npos) {
    const std::size_t close = path.find(']', bracket);
    return layout.id(path.substr(0, bracket) + "." + path.substr(bracket + 1, close - bracket - 1));
  }
  for (ig_field f = 0; f < document.size(); ++f)
    if (document.present(f) && layout.fields[f].type == IG_CODE && layout.fields[f].path.starts_with(path + "."))
      return f;
  return IG_NO_FIELD;
}

std::string ValueOrigins::writer_of(const Document& document, ig_field f) const {
  const std::uint16_t writer = document.writer(f);
  return writer != 0 && writer <= linked_.chain.size() ? linked_.chain[writer - 1u].element.alias : std::string();
}

ProgramLine ValueOrigins::set_at(const Document& document, ig_field f) const {
  if (f >= document.origins.size()) return {};
  const Document::Origin& origin = document.origins[f];
  return {std::string(chain_.file_name(origin.file)), origin.line};
}

ProgramLine ValueOrigins::since(const Document& document, ig_field f, std::string_view name) const {
  if (f >= document.origins.size()) return {};
  const Document::Origin& origin = document.origins[f];
  if (origin.since == 0 && !name.empty())
    for (const char* const codes : {"Parsing.Flags.", "Parsing."})
      if (const ig_field code = document.layout().id(codes + std::string(name)); code != IG_NO_FIELD)
        if (ProgramLine line = set_at(document, code); line.line != 0) return line;
  return {std::string(chain_.file_name(origin.since_file)), origin.since};
}

ExplainedValue ValueOrigins::describe(const Document& document, const std::string& path,
                                      const std::string& value) const {
  const ig_field f = field_of(document, path);
  if (f == IG_NO_FIELD) return {path, value, "", {}, {}};
  const bool is_name = document.layout().fields[f].type == IG_SYMBOL && value.size() > 2;
  const std::string_view name = is_name ? std::string_view(value).substr(1, value.size() - 2) : std::string_view();
  return {path, value, writer_of(document, f), set_at(document, f), since(document, f, name)};
}

/// The first name that the section of a transform holds is what a programmer knows it by.
ig_field ValueOrigins::label_of(const Document& document, std::string_view section) {
  const Layout& layout = document.layout();
  for (const ig_field f : layout.shown) {
    const FieldInfo& info = layout.fields[f];
    const bool is_of_section =
        info.path.size() > section.size() && info.path.starts_with(section) && info.path[section.size()] == '.';
    if (is_of_section && info.type == IG_SYMBOL && document.present(f)) return f;
  }
  return IG_NO_FIELD;
}

std::string ValueOrigins::label(const Document& document, const SymbolTable& symbols, std::string_view section) {
  const ig_field f = label_of(document, section);
  return f == IG_NO_FIELD ? std::string() : std::string(symbols.text(static_cast<ig_symbol>(document.value(f).symbol)));
}

ExplainedLadder ValueOrigins::ladder(const Document& document, const SymbolTable& symbols,
                                     const FrameHistory& frames) const {
  ExplainedLadder out;
  const Layout& layout = document.layout();
  const ig_field axes[] = {layout.id("ProgramXyz.X"), layout.id("ProgramXyz.Y"), layout.id("ProgramXyz.Z")};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!document.present(axes[i])) return out;
    out.program[i] = document.number(axes[i]);
  }
  out.is_there = true;
  double point[3] = {out.program[0], out.program[1], out.program[2]};
  for (const ig_field f : layout.transforms) {
    if (!document.present(f)) continue;
    const Frame& frame = document.frame(f);
    if (frame.kind == Frame::Kind::identity) continue;
    const double before[3] = {point[0], point[1], point[2]};
    frame.map(before, point);
    ExplainedRung rung;
    rung.source = layout.fields[f].path.substr(transform_section.size());
    rung.is_moving = frame.is_moving;
    rung.point = {point[0], point[1], point[2]};
    rung.writer = writer_of(document, f);
    rung.since = since(document, f);
    if (const ig_field label = label_of(document, rung.source); label != IG_NO_FIELD) {
      rung.label = symbols.text(static_cast<ig_symbol>(document.value(label).symbol));
      rung.label_since = since(document, label, rung.label);
      if (rung.since.line == 0) rung.since = rung.label_since;
    }
    std::copy(std::begin(frame.matrix), std::end(frame.matrix), rung.matrix.begin());
    if (const auto& parts = frames.parts(f); parts.size() > 1) {
      double at[3] = {before[0], before[1], before[2]};
      for (const FrameHistory::Part& part : parts) {
        const double from[3] = {at[0], at[1], at[2]};
        part.frame.map(from, at);
        ExplainedPart one{{}, part.label, part.since, {at[0], at[1], at[2]}};
        std::copy(std::begin(part.frame.matrix), std::end(part.frame.matrix), one.matrix.begin());
        rung.parts.push_back(std::move(one));
      }
    }
    out.rungs.push_back(std::move(rung));
  }
  return out;
}

}  // namespace isogloss
