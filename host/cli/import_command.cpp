// Files of controls as tables of a machine, and tables as such files.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "crash_guard.hpp"
#include "isogloss/engine/import.hpp"
#include "isogloss/engine/machine.hpp"
#include "json_text.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "session.hpp"

namespace isogloss::cli {

namespace fs = std::filesystem;

namespace {

/// NAME=VALUE of the importer; false, and reported, when it is not of that form.
bool read_settings(const std::vector<std::string>& texts, std::vector<Attribute>& out, Session& session) {
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
      session.report("IG-0513", {}, {"--set needs NAME=VALUE, not '" + text + "'"});
      return false;
    }
    out.push_back({text.substr(0, equals), text.substr(equals + 1), {}});
  }
  return true;
}

int write_output(const std::string& text, const std::string& path, Session& session) {
  if (path.empty()) return print(text, session.status());
  return write_file(path, text, session) ? session.status() : static_cast<int>(cannot_start);
}

Json json_of(const DependencyElement& table) {
  Json rows = Json::array();
  for (const TableRow& row : table.rows) {
    Json cells = Json::object();
    for (const Attribute& cell : row.attributes) cells[cell.name] = cell.value;
    Json one{{"Cells", std::move(cells)}};
    if (!row.where.file.empty()) one["File"] = row.where.file;
    if (row.where.line != 0) one["Line"] = row.where.line;
    rows.push_back(std::move(one));
  }
  return {{"Table", table.alias}, {"Rows", std::move(rows)}};
}

bool has_no_file(const std::string& place) {
  std::error_code error;
  if (!fs::is_directory(place, error)) return false;
  for (fs::directory_iterator at(place, error), end; !error && at != end; at.increment(error))
    if (at->is_regular_file(error)) return false;
  return true;
}

struct ImportCommand {
  CommonOptions common;
  std::vector<std::string> files, settings;
  std::string format, output;
  bool json = false;

  int run() const;
  int write_json(const Dialect& machine, const std::string& path, Session& session) const;
};

/// The rows, with the file that holds them where one is written.
int ImportCommand::write_json(const Dialect& machine, const std::string& path, Session& session) const {
  if (!path.empty() && !write_file(path, write_tables(machine.dependencies, true), session)) return cannot_start;
  Json tables = Json::array();
  for (const DependencyElement& table : machine.dependencies) tables.push_back(json_of(table));
  Json out{{"Isogloss", 1}, {"Files", files}, {"Tables", std::move(tables)}};
  if (!path.empty()) out["Output"] = path;
  return print(pretty(out), session.status());
}

int ImportCommand::run() const {
  Session session(common);
  std::error_code ignored;
  const bool is_folder = output.ends_with('/') || fs::is_directory(output, ignored);
  if (is_folder) fs::create_directories(output, ignored);
  const std::string path = is_folder ? (fs::path(output) / "imported.xml").string() : output;
  if (!are_apart(files, {path, common.diagnostics_output}, session)) return cannot_start;
  Dialect machine;
  bool are_there = true;
  for (const std::string& file : files) {
    const bool is_there = file == "-" || fs::exists(file, ignored);
    if (!is_there) session.report("IG-0510", {file}, {"no such file or folder"});
    are_there = are_there && is_there;
    Import import{file, format, {}, {}};
    if (!read_settings(settings, import.options, session)) return cannot_start;
    machine.imports.push_back(std::move(import));
  }
  if (!are_there) return cannot_start;
  session.progress().show(0, 0, "reading the files");
  if (!complete_machine(machine, session.library(), session.diagnostics())) return input_errors;
  session.progress().hide();
  if (machine.dependencies.empty() && std::all_of(files.begin(), files.end(), has_no_file)) {
    for (const std::string& file : files) session.report("IG-0124", {file}, {file});
    return input_errors;
  }
  if (json) return write_json(machine, path, session);
  std::size_t rows = 0;
  for (const DependencyElement& table : machine.dependencies) rows += table.rows.size();
  const int status = write_output(write_tables(machine.dependencies, true), path, session);
  const Writing writing;
  const std::string place = path.empty() ? ""
                                         : fmt::format(" in {}; a machine has them by <Include src=\"{}\"/>", path,
                                                       fs::path(path).filename().string());
  std::fputs(fmt::format("{} rows of {} tables{}\n", rows, machine.dependencies.size(), place).c_str(), stderr);
  return status;
}

struct ExportCommand {
  CommonOptions common;
  std::vector<std::string> settings;
  std::string machine, format, output;
  bool json = false;

  int run() const;
  int write_json(const std::string& text, const std::vector<UnusedPart>& unused, Session& session) const;
};

/// What the file lacks, and its text where it is not written.
int ExportCommand::write_json(const std::string& text, const std::vector<UnusedPart>& unused, Session& session) const {
  if (!output.empty() && !write_file(output, text, session)) return cannot_start;
  Json left_out = Json::array();
  for (const UnusedPart& part : unused)
    left_out.push_back({{"What", part.what}, {"Why", part.why}, {"Count", part.count}});
  Json out{{"Isogloss", 1}, {"Machine", machine}, {"Format", format}, {"LeftOut", std::move(left_out)}};
  if (output.empty())
    out["Text"] = text;
  else
    out["Output"] = output;
  return print(pretty(out), session.status());
}

int ExportCommand::run() const {
  Session session(common);
  Import asked{output.empty() ? "standard output" : output, format, {}, {}};
  if (!read_settings(settings, asked.options, session)) return cannot_start;
  const std::optional<std::string> named = session.dialect_or_machine({}, machine);
  const std::optional<Dialect> dialect = named ? session.read(*named) : std::nullopt;
  if (!dialect) return session.status() == success ? static_cast<int>(cannot_start) : session.status();
  if (!are_apart(files_of_machine(dialect->file.string()), {output, common.diagnostics_output}, session))
    return cannot_start;
  std::vector<UnusedPart> unused;
  const std::optional<std::string> text =
      export_tables(asked, dialect->dependencies, session.library(), unused, session.diagnostics());
  if (!text) return cannot_start;
  if (json) return write_json(*text, unused, session);
  for (const UnusedPart& part : unused)
    session.report("IG-0133", {}, {part.what, part.why, std::to_string(part.count)});
  return write_output(*text, output, session);
}

}  // namespace

int import_command(const Arguments& arguments) {
  CommandLine line(
      "import",
      "Reads files of controls (tool tables, presets, parameters, archives, CAM tool libraries) and writes "
      "their rows as tables of a machine, each with its source. What is not read is listed.",
      "isogloss import TOOL.T PRESET.PR -o machines/dmu58/");
  ImportCommand command;
  command.common.repeats = 0;  // what is not read is listed as a whole
  line.option("FILE", command.files, "Files, or folders of files").required();
  line.option("--format", command.format, "The importer; otherwise the content decides (isogloss list importers)")
      .type_name("NAME");
  line.option("--set", command.settings, "An option of the importer, such as unit=inch (repeatable)")
      .type_name("NAME=VALUE")
      .names_once();
  line.option("-o,--output", command.output, "Write to this file, or to imported.xml in this folder")
      .type_name("FILE|DIR");
  line.flag("--json", command.json,
            "Write the rows as JSON (schemas/import.schema.json) instead of XML; with -o beside the file");
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  return command.run();
}

int export_command(const Arguments& arguments) {
  CommandLine line("export", "Writes tables of a machine as a file of its control, where the format is documented.",
                   "isogloss export -m dmu58 --format HeidenhainToolTable -o TOOL.T");
  ExportCommand command;
  line.option("-m,--machine", command.machine, "The machine, by name, folder or file").required().type_name("MACHINE");
  line.option("--format", command.format, "The format (isogloss list importers)").required().type_name("NAME");
  line.option("--set", command.settings, "An option of the format, such as unit=inch (repeatable)")
      .type_name("NAME=VALUE")
      .names_once();
  line.option("-o,--output", command.output, "Write to a file").type_name("FILE");
  line.flag("--json", command.json,
            "Write JSON (schemas/export.schema.json): what the file lacks, and its text where -o does not name it");
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
