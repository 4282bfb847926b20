#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isogloss/engine/printable.hpp"
#include "lsp/features.hpp"

namespace isogloss::editors {

namespace {

std::string code_span(const std::string& text) { return "`" + text + "`"; }

const LinkedSyntax* syntax_of(const Setup& setup, const std::string& alias) {
  for (const LinkedSyntax& s : setup.linked->chain)
    if (s.element.alias == alias) return &s;
  return nullptr;
}

std::string summary_of(const Setup& setup, const std::string& alias) {
  const LinkedSyntax* const s = syntax_of(setup, alias);
  return s != nullptr && s->syntax->summary != nullptr ? s->syntax->summary : "";
}

std::string field_doc(const Setup& setup, const std::string& path) {
  const auto field = setup.linked->layout.find(path);
  if (!field) return {};
  const FieldInfo& info = setup.linked->layout.fields[*field];
  return info.unit.empty() ? info.doc : info.unit + (info.doc.empty() ? "" : "; " + info.doc);
}

/// What the syntax has changed in the block, a line each.
std::string changes_of(const ExplainedBlock& block, const std::string& alias, const Setup& setup) {
  constexpr std::size_t most = 8;
  std::string out;
  std::size_t count = 0;
  for (const ExplainedStep& step : block.steps) {
    if (step.is_scan || step.syntax != alias) continue;
    for (const ExplainedChange& c : step.changes) {
      if (c.after.empty() || c.path.starts_with("Parsing.") || c.path.find("Mat4d") != std::string::npos) continue;
      if (++count > most) continue;
      const std::string doc = field_doc(setup, c.path);
      out += fmt::format("- {} = {}{}{}\n", code_span(c.path), code_span(printable(c.after)),
                         c.before.empty() ? "" : " (was " + printable(c.before) + ")", doc.empty() ? "" : " – " + doc);
    }
  }
  if (count > most) out += fmt::format("- … and {} more\n", count - most);
  return out;
}

std::string word_text(const ExplainedWord& word, const ExplainedBlock& block, const Setup& setup) {
  std::string out = "**" + printable(word.name.empty() ? word.text : word.name) + "**";
  if (!word.value.empty()) out += " = " + code_span(word.value);
  out += "\n\n";
  if (word.users.empty() && !word.name.empty()) out += "No syntax uses this word.\n\n";
  const std::vector<std::string> readers{word.reader};
  for (const std::string& user : word.users.empty() ? readers : word.users) {
    if (user.empty()) continue;
    const LinkedSyntax* const s = syntax_of(setup, user);
    out +=
        fmt::format("{} by {}: {}\n\n", word.users.empty() ? "Read" : "Used", code_span(user), summary_of(setup, user));
    if (const std::string changes = changes_of(block, user, setup); !changes.empty()) out += changes + "\n";
    if (s != nullptr && s->syntax->page != nullptr)
      out += fmt::format("Page: `isogloss inspect {}`\n\n", s->syntax->id);
  }
  return out;
}

std::string variables_text(const ExplainedBlock& block, const OpenProgram& program) {
  std::string out;
  for (const ExplainedVariable& v : block.variables) {
    out += fmt::format("- {} = {}", code_span(v.name), v.value.empty() ? "no value" : code_span(printable(v.value)));
    if (v.written.line != 0)
      out += v.written.file == program.path ? fmt::format(" (line {})", v.written.line)
                                            : fmt::format(" ({}:{})", v.written.file, v.written.line);
    out += "\n";
  }
  for (const ExplainedVariable& v : block.written)
    out += fmt::format("- {} becomes {}\n", code_span(v.name), code_span(printable(v.value)));
  return out.empty() ? out : "Variables:\n\n" + out + "\n";
}

std::string machine_text(const ExplainedBlock& block) {
  std::string out;
  for (const char axis : std::string_view("XYZABC"))
    for (const ExplainedValue& v : block.values)
      if (v.path == std::string("MachineCoordinate.") + axis) out += fmt::format(" {}{}", axis, v.value);
  return out.empty() ? out : "Machine:" + code_span(out.substr(1)).insert(0, " ") + "\n\n";
}

/// The explanations of the diagnostics that stand here.
std::string diagnostics_text(const OpenProgram& program, std::uint32_t line, std::uint32_t column, Toolbox& toolbox) {
  std::string out;
  if (!program.analysis) return out;
  for (const Diagnostic& d : program.analysis->diagnostics) {
    const bool is_here = d.where.file == program.path && d.where.line == line && d.where.column <= column &&
                         (d.end_column == 0 || column < d.end_column);
    const DiagnosticInfo* const info = is_here ? toolbox.diagnostic(d.code) : nullptr;
    if (info != nullptr && out.find(d.code) == std::string::npos)
      out += fmt::format("**{}**: {}\n\n", d.code, info->explanation);
  }
  return out;
}

/// The block of the line that holds the column.
const ExplainedBlock* block_at(const std::vector<ExplainedBlock>& blocks, std::uint32_t column) {
  const ExplainedBlock* out = blocks.empty() ? nullptr : &blocks.front();
  for (const ExplainedBlock& b : blocks)
    if (b.where.column <= column) out = &b;
  return out;
}

const ExplainedWord* word_at(const ExplainedBlock& block, std::uint32_t column) {
  for (const ExplainedWord& w : block.words) {
    const std::uint32_t begin = block.where.column + w.column - 1;
    if (column >= begin && column < begin + std::max<std::size_t>(w.text.size(), 1)) return &w;
  }
  return nullptr;
}

}  // namespace

Json hover(OpenProgram& program, const Position& at, const Surroundings& around) {
  if (program.setup == nullptr) return nullptr;
  const std::size_t offset = program.text.offset_of(at);
  const std::uint32_t line = program.text.run_line_of(offset);
  const auto column = static_cast<std::uint32_t>(offset - program.text.run_line_begin(line)) + 1;
  if (program.text.run_line(line).find_first_not_of(" \t\r") == std::string_view::npos) return nullptr;
  std::string out = diagnostics_text(program, line, column, around.toolbox);
  ExplainTarget target;
  target.line = line;
  target.most_blocks = 20;
  RunOptions options = program.setup->options;
  options.goes_on = around.goes_on;
  DiagnosticList ignored;
  ExplainReach reach;
  const std::unique_ptr<Source> source = memory_source(program.text.text());
  const std::vector<ExplainedBlock> blocks =
      explain(*program.setup->linked, *source, program.path, target, options, ignored, &reach);
  const ExplainedBlock* const block = block_at(blocks, column);
  Range range = line_range(program.text, line);
  if (block == nullptr) {
    out += "The run has no block here: " + around.toolbox.why_no_block(reach, target, program.path);
  } else {
    if (const ExplainedWord* const word = word_at(*block, column)) {
      out += word_text(*word, *block, *program.setup);
      const std::size_t begin = program.text.offset_in_run(line, block->where.column + word->column - 1);
      range = program.text.range_of(begin, begin + word->text.size());
    }
    out += variables_text(*block, program) + machine_text(*block);
    out += around.toolbox.sentence(*block, program.path, program.text.text());
  }
  return {{"contents", {{"kind", "markdown"}, {"value", out}}}, {"range", to_json(range)}};
}

}  // namespace isogloss::editors
