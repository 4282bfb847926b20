#include <algorithm>

#include "lsp/features.hpp"
#include "lsp/names.hpp"
#include "lsp/same_motions.hpp"

namespace isogloss::editors {

namespace {

Json location(const OpenProgram& program, const Span& span) {
  return {{"uri", program.uri}, {"range", to_json(program.text.range_of(span.begin, span.end))}};
}

/// The last line before this one that writes the variable; where none does, every line that writes it.
Json variable_definition(const OpenProgram& program, const NameAt& name, std::uint32_t line,
                         const Surroundings& around) {
  const VariableUse* last = nullptr;
  Json all = Json::array();
  for (const VariableUse& use : program.analysis->variables) {
    if (!use.is_write || use.name != name.name) continue;
    all.push_back(location_of(program, around, use.file, use.line));
    if (use.file == program.path && use.line < line && (last == nullptr || last->line < use.line)) last = &use;
  }
  return last != nullptr ? Json::array({location_of(program, around, last->file, last->line)}) : all;
}

/// Calls and jumps of the line.
Json move_targets(const OpenProgram& program, std::uint32_t line, const Surroundings& around) {
  Json out = Json::array();
  if (!program.analysis) return out;
  for (const Move& m : program.analysis->moves)
    if (m.file == program.path && m.line == line && !m.label.empty())
      out.push_back(location_of(program, around, m.to_file, m.to_line));
  return out;
}

/// Is "T01" or "G54" the name of this row?
bool names_row(std::string_view word, std::string_view row) {
  if (word == row) return true;
  while (!word.empty() && (word.front() < '0' || word.front() > '9')) word.remove_prefix(1);
  while (word.size() > 1 && word.front() == '0') word.remove_prefix(1);
  if (const std::size_t dot = word.find('.'); dot != std::string_view::npos) word = word.substr(0, dot);
  return !word.empty() && word == row;
}

/// The rows of tables that this word has asked for.
Json row_places(OpenProgram& program, std::size_t offset, const Surroundings& around) {
  Json out = Json::array();
  const std::uint32_t line = program.text.run_line_of(offset);
  const auto [first, last] = program.scan_map().between(offset, offset + 1);
  if (first >= last || !program.analysis) return out;
  const Token& token = program.scan_map().tokens[first];
  const std::string_view word = std::string_view(program.text.text()).substr(token.begin, token.end - token.begin);
  for (const RowUse& use : program.analysis->rows) {
    if (use.line != line || !names_row(word, use.row)) continue;
    const LinkedDependency& table = program.setup->linked->dependencies[use.dependency];
    for (const TableRow& row : table.element.rows)
      for (const Attribute& a : row.attributes)
        if (table.dependency->row_key != nullptr && a.name == table.dependency->row_key && a.value == use.row &&
            !row.where.file.empty())
          out.push_back(location_of(program, around, row.where.file, row.where.line));
  }
  return out;
}

/// The lines that change to the tool that this line changes to.
Json tool_changes(const OpenProgram& program, std::uint32_t line, const Surroundings& around) {
  Json out = Json::array();
  if (!program.analysis) return out;
  for (const ToolUse& here : program.analysis->tools) {
    if (here.line != line) continue;
    for (const ToolUse& other : program.analysis->tools)
      if (other.tool == here.tool) out.push_back(location_of(program, around, program.path, other.line));
    break;
  }
  return out;
}

}  // namespace

Json definition(OpenProgram& program, const Position& at, const Surroundings& around) {
  if (program.setup == nullptr) return Json::array();
  const std::size_t offset = program.text.offset_of(at);
  const std::uint32_t line = program.text.run_line_of(offset);
  const std::optional<NameAt> name = name_at(program, offset);
  if (name && name->kind == NameAt::Kind::variable) return variable_definition(program, *name, line, around);
  const auto label = [&] { return Json::array({location(program, {name->place->begin, name->place->end})}); };
  if (name && name->place->line != line) return label();
  if (Json rows = row_places(program, offset, around); !rows.empty()) return rows;
  if (Json targets = move_targets(program, line, around); !targets.empty()) return targets;
  return name ? label() : Json::array();
}

Json references(OpenProgram& program, const Position& at, bool with_declaration, const Surroundings& around) {
  const std::size_t offset = program.text.offset_of(at);
  const std::uint32_t line = program.text.run_line_of(offset);
  const std::optional<NameAt> name = name_at(program, offset);
  if (!name) return tool_changes(program, line, around);
  Json out = Json::array();
  for (const Occurrence& o : occurrences(program, *name))
    if (with_declaration || !o.declares) out.push_back(location(program, o.span));
  if (name->kind == NameAt::Kind::variable)
    for (const VariableUse& use : program.analysis->variables)
      if (use.name == name->name && use.file != program.path)
        out.push_back(location_of(program, around, use.file, use.line));
  return out;
}

Json highlights(OpenProgram& program, const Position& at, const Surroundings&) {
  Json out = Json::array();
  const std::optional<NameAt> name = name_at(program, program.text.offset_of(at));
  if (!name) return out;
  for (const Occurrence& o : occurrences(program, *name))
    out.push_back({{"range", to_json(program.text.range_of(o.span.begin, o.span.end))}, {"kind", o.declares ? 3 : 2}});
  return out;
}

Json prepare_rename(OpenProgram& program, const Position& at, const Surroundings&) {
  const std::optional<NameAt> name = name_at(program, program.text.offset_of(at));
  if (!name || (name->place != nullptr && name->place->is_program)) return nullptr;
  return {{"range", to_json(program.text.range_of(name->span.begin, name->span.end))},
          {"placeholder", program.text.text().substr(name->span.begin, name->span.end - name->span.begin)}};
}

Json rename(OpenProgram& program, const Position& at, const std::string& new_name, const Surroundings& around) {
  const std::optional<NameAt> name = name_at(program, program.text.offset_of(at));
  if (!name || (name->place != nullptr && name->place->is_program))
    throw Refusal("Here stands no label and no variable that this program names.");
  if (new_name.empty() || new_name.find_first_of(" \t\r\n;()[]\"") != std::string::npos)
    throw Refusal("A name holds no blank, bracket or quotation mark: '" + new_name + "' is none.");
  if (name->kind == NameAt::Kind::variable)
    for (const VariableUse& use : program.analysis->variables) {
      if (use.name == new_name) throw Refusal("The program uses a variable " + new_name + " already.");
      if (use.name == name->name && use.file != program.path)
        throw Refusal(name->name + " is used in " + use.file + " as well, which a renaming here does not change.");
    }
  std::string text = program.text.text();
  std::vector<Occurrence> places = occurrences(program, *name);
  std::reverse(places.begin(), places.end());  // the places of those that come before stay as they are
  Json edits = Json::array();
  for (const Occurrence& o : places) {
    if (o.span.begin == o.span.end)
      throw Refusal("Line " + std::to_string(program.text.run_line_of(o.span.begin)) + " refers to " + name->name +
                    " without its name: nothing is renamed.");
    text.replace(o.span.begin, o.span.end - o.span.begin, new_name);
    edits.push_back({{"range", to_json(program.text.range_of(o.span.begin, o.span.end))}, {"newText", new_name}});
  }
  if (const std::string why = why_not_same(*program.setup, program.path, program.text.text(), text, around);
      !why.empty())
    throw Refusal("With the name " + new_name + " " + why + ": nothing is renamed.");
  return {{"changes", {{program.uri, std::move(edits)}}}};
}

}  // namespace isogloss::editors
