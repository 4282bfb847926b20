#include <algorithm>
#include <charconv>

#include "lsp/features.hpp"

namespace isogloss::editors {

namespace {

int severity_of(Severity severity) {
  switch (severity) {
    case Severity::error: return 1;
    case Severity::warning: return 2;
    default: return 3;
  }
}

/// The lines that the message names: "since line 36".
std::vector<std::uint32_t> lines_in(std::string_view message) {
  constexpr std::string_view word = "line ";
  std::vector<std::uint32_t> out;
  for (std::size_t at = message.find(word); at != std::string_view::npos; at = message.find(word, at + 1)) {
    std::uint32_t line = 0;
    const char* const begin = message.data() + at + word.size();
    if (std::from_chars(begin, message.data() + message.size(), line).ec == std::errc() && line > 0)
      out.push_back(line);
  }
  return out;
}

Range range_of(const Diagnostic& d, const TextDocument& text) {
  if (d.where.line == 0) return {};
  if (d.where.column == 0) return line_range(text, d.where.line);
  const std::size_t begin = text.offset_in_run(d.where.line, d.where.column);
  std::size_t end = d.end_column > d.where.column ? text.offset_in_run(d.where.line, d.end_column) : begin;
  if (end == begin) {
    // A place without an end: the editor shows the rest of the word.
    const std::string& all = text.text();
    while (end < all.size() && all[end] != ' ' && all[end] != '\n' && all[end] != '\r') ++end;
  }
  return text.range_of(begin, end);
}

/// The line of the program from which the run came to this file.
std::uint32_t calling_line(const OpenProgram& program, std::string file) {
  for (int depth = 0; depth < 100; ++depth)
    for (const Move& m : program.analysis->moves) {
      if (m.kind != FlowStep::Kind::call || m.to_file != file || m.file == file) continue;
      if (m.file == program.path) return m.line;
      file = m.file;
      break;
    }
  return 1;
}

}  // namespace

Json diagnostic_json(const Diagnostic& d, const TextDocument& text, Toolbox& toolbox) {
  Json out{{"range", to_json(range_of(d, text))},
           {"severity", severity_of(d.severity)},
           {"code", d.code},
           {"source", "isogloss"},
           {"message", d.hint.empty() ? d.message : d.message + " (" + d.hint + ")"}};
  out["data"] = {{"hint", d.hint}};
  if (const DiagnosticInfo* const info = toolbox.diagnostic(d.code)) out["data"]["explanation"] = info->explanation;
  return out;
}

Json diagnostics_of(const OpenProgram& program, const Surroundings& around) {
  Json out = Json::array();
  for (const Diagnostic& d : program.setup_faults) {
    Diagnostic here = d;
    if (!d.where.file.empty() && d.where.file != program.path) {
      here.message = d.where.file + ":" + std::to_string(d.where.line) + ": " + d.message;
      here.where = {};
    }
    out.push_back(diagnostic_json(here, program.text, around.toolbox));
  }
  if (!program.analysis) return out;
  for (const Diagnostic& d : program.analysis->diagnostics) {
    const bool is_here = d.where.file == program.path || d.where.file.empty();
    Diagnostic shown = d;
    Json related = Json::array();
    if (!is_here) {
      shown.where = {program.path, calling_line(program, d.where.file), 0};
      shown.message = "in the called program: " + d.message;
      related.push_back(
          {{"location", location_of(program, around, d.where.file, d.where.line)}, {"message", d.message}});
    }
    Json one = diagnostic_json(shown, program.text, around.toolbox);
    for (const std::uint32_t line : lines_in(d.message))
      if (line != d.where.line && is_here && line <= program.text.run_lines())
        related.push_back({{"location", location_of(program, around, program.path, line)},
                           {"message", "line " + std::to_string(line)}});
    if (!related.empty()) one["relatedInformation"] = std::move(related);
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace isogloss::editors
