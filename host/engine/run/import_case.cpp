#include "run/import_case.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "isogloss/engine/import.hpp"
#include "run/case_dialect.hpp"

namespace isogloss {

namespace {

/// Without blanks around them; empty lines are left out.
std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> out;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
    while (!line.empty() && (line.back() == ' ' || line.back() == '\t' || line.back() == '\r')) line.remove_suffix(1);
    if (line.empty()) continue;
    std::string& kept = out.emplace_back(line);
    if (kept.ends_with(" />")) kept.erase(kept.size() - 3, 1);  // both ways are written
  }
  return out;
}

std::string difference(std::string_view what, const std::vector<std::string>& wanted,
                       const std::vector<std::string>& got) {
  if (wanted == got) return {};
  std::string out = fmt::format("  {}:\n", what);
  for (const std::string& line : wanted)
    if (std::find(got.begin(), got.end(), line) == got.end()) out += "    expected: " + line + "\n";
  for (const std::string& line : got)
    if (std::find(wanted.begin(), wanted.end(), line) == wanted.end()) out += "    got:      " + line + "\n";
  return out + fmt::format("    {} lines expected, {} given, or their order differs\n", wanted.size(), got.size());
}

std::string fault_line(const Diagnostic& d) {
  return fmt::format("  {}: {} [{}]\n", to_string(d.severity), d.message, d.code);
}

std::vector<std::string> table_lines(const std::vector<DependencyElement>& tables) {
  std::vector<std::string> lines = lines_of(write_tables(tables, false));
  const auto is_frame = [](const std::string& line) {
    return line.starts_with("<?xml") || line.starts_with("<Dependencies") || line == "</Dependencies>";
  };
  std::erase_if(lines, is_frame);
  return lines;
}

}  // namespace

std::string run_import_case(const Page& page, const Case& one, const std::string& file, Library& library) {
  DiagnosticList said;
  Import asked{one.file_name, page.syntax, {}, {file, one.line, 0}};
  if (one.options)
    for (const std::string& line : lines_of(one.options->text)) {
      const std::size_t equals = line.find('=');
      asked.options.push_back(
          {line.substr(0, equals), equals == std::string::npos ? "" : line.substr(equals + 1), asked.where});
    }
  std::optional<CaseDependencies> machine;
  if (one.dependencies) {
    machine = read_case_dependencies(one.dependencies->text, page.syntax, {file, one.dependencies->line, 0}, said);
    if (!machine) return fault_line(said.all.back());
    for (const DependencyElement& table : machine->dependencies) asked.machine_tables.push_back(&table);
  }
  const std::optional<ImportedFile> given = import_bytes(asked, one.file->text, library, said);
  std::vector<std::string> reports, unused;
  std::string out;
  for (const Diagnostic& d : said.all) {
    // What the host reports of the case itself, not of a place in its file, is a fault of the case.
    if (d.code.starts_with("IG-") && d.where.file != asked.file)
      out += fault_line(d);
    else
      reports.push_back(fmt::format("{} {}:{}", d.code, d.where.line, d.where.column));
  }
  std::vector<std::string> tables;
  if (given) {
    tables = table_lines(given->tables);
    for (const UnusedPart& part : given->unused)
      unused.push_back(fmt::format("{}:{} {}", part.first.line, part.first.column, part.what));
  }
  const auto wanted = [](const std::optional<Fence>& fence) {
    return fence ? lines_of(fence->text) : std::vector<std::string>();
  };
  out += difference("tables", wanted(one.tables), tables);
  out += difference("parts that are not read", wanted(one.unused), unused);
  if (!one.accepts_any_code) out += difference("diagnostics", wanted(one.diagnostics), reports);
  if (one.written && given) {
    std::vector<UnusedPart> left_out;
    DiagnosticList faults;
    const std::optional<std::string> written = export_tables(asked, given->tables, library, left_out, faults);
    for (const Diagnostic& d : faults.all) out += fault_line(d);
    if (written) out += difference("the file written", lines_of(one.written->text), lines_of(*written));
    std::vector<std::string> parts;
    for (const UnusedPart& part : left_out) parts.push_back(part.what);
    out += difference("parts without a place in the file", wanted(one.left_out), parts);
  }
  return out;
}

}  // namespace isogloss
