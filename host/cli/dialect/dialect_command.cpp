// A dialect with everything that it extends: as one file, as a graph, one syntax of it, or beside another dialect.
#include <fmt/format.h>

#include <filesystem>

#include "dialect/chain_map.hpp"
#include "dialect_files.hpp"
#include "json_text.hpp"
#include "output_file.hpp"
#include "outputs.hpp"

namespace isogloss::cli {

namespace fs = std::filesystem;

namespace {

struct DialectCommand {
  CommonOptions common;
  std::string operand, name, machine, base_directory, output, why, other;
  bool inline_tables = false, annotate = false, graph = false, json = false;

  int run();
  int write_effective(const Dialect& dialect, Session& session) const;
  int show_graph(const LinkedDialect& linked, Session& session) const;
  int show_why(const LinkedDialect& linked, Session& session) const;
  int show_difference(const Dialect& dialect, Session& session) const;
  bool is_apart(const Dialect& dialect, std::vector<std::string> side_files, Session& session) const;
  int write(const std::string& text, Session& session, int status) const;
};

/// No output replaces a file that something of the dialect stands in; what else lies in a machine's folder is not read.
bool DialectCommand::is_apart(const Dialect& dialect, std::vector<std::string> side_files, Session& session) const {
  side_files.insert(side_files.end(), {output, common.diagnostics_output});
  return are_apart(files_of_parts(dialect), side_files, session);
}

int DialectCommand::write(const std::string& text, Session& session, int status) const {
  if (output.empty()) return print(text, status);
  return write_file(output, text, session) ? status : static_cast<int>(cannot_start);
}

int DialectCommand::write_effective(const Dialect& dialect, Session& session) const {
  // Side files need a folder; without one everything stands in the one file.
  const bool is_inline = inline_tables || base_directory.empty();
  const WrittenDialect written =
      write_dialect(dialect, base_directory, is_inline, annotate ? Annotations::places : Annotations::none);
  std::vector<std::string> side_files;
  for (const auto& [path, text] : written.side_files) side_files.push_back((fs::path(base_directory) / path).string());
  if (!is_apart(dialect, side_files, session)) return cannot_start;
  for (const auto& [path, text] : written.side_files)
    if (!write_file((fs::path(base_directory) / path).string(), text, session)) return cannot_start;
  return write(written.xml, session, session.status());
}

/// The text or JSON stands on stdout; the drawing goes to a file that ends in .svg.
int DialectCommand::show_graph(const LinkedDialect& linked, Session& session) const {
  const Json chain = describe_chain(linked);
  if (output.ends_with(".svg") && !write_file(output, chain_as_svg(chain), session)) return cannot_start;
  const std::string text = json ? pretty(chain) : chain_as_text(chain);
  return output.ends_with(".svg") ? print(text, session.status()) : write(text, session, session.status());
}

int DialectCommand::show_why(const LinkedDialect& linked, Session& session) const {
  if (const std::optional<std::uint32_t> position = linked.position(why)) {
    const Json found = describe_why(linked, *position);
    return write(json ? pretty(found) : why_as_text(found), session, session.status());
  }
  std::vector<std::string> names;
  std::string instances;
  for (const LinkedSyntax& s : linked.chain) {
    names.push_back(s.element.alias);
    if (s.element.syntax == why) instances += (instances.empty() ? "" : ", ") + s.element.alias;
  }
  std::string hint = instances.empty() ? "" : "it stands there as " + instances;
  for (const AppliedEdit& edit : linked.dialect.edits)
    if (!edit.of_dependency && edit.anchor == why && (edit.kind == "Remove" || edit.kind == "Replace"))
      hint = fmt::format("dialect {} takes it out: {}:{}, <{}>", edit.dialect, edit.where.file, edit.where.line,
                         edit.kind);
  for (const Json& row : describe_codes(linked))
    if (hint.empty() && row["Code"] == why)
      hint = fmt::format("it is a code of programs: isogloss inspect {} -d {}", why, linked.dialect.name);
  if (const std::string near = nearest_name(why, names); hint.empty() && !near.empty())
    hint = "did you mean " + near + "?";
  session.report("IG-0172", {}, {why, linked.dialect.name}, hint);
  return input_errors;
}

/// Who asks why a syntax stands where it stands has a wrong order most often: its faults are reported already. Null
/// where parts of the chain are missing.
std::unique_ptr<LinkedDialect> linked_in_spite_of_faults(const std::string& name, Session& session) {
  DiagnosticList heard;
  const std::optional<Dialect> dialect = session.read(name, heard);
  return dialect ? link(*dialect, session.library(), heard, LinkMode::parts) : nullptr;
}

/// As `diff`: 0 nothing differs, 1 something does, 2 trouble.
int DialectCommand::show_difference(const Dialect& dialect, Session& session) const {
  const std::optional<Dialect> right = session.read(other);
  if (!right || !is_apart(*right, {}, session)) return cannot_start;
  const Json found = describe_difference(dialect, *right, session.library());
  const bool is_same = found["Same"].get<bool>();
  return write(json ? pretty(found) : difference_as_text(found), session, is_same ? success : input_errors);
}

int DialectCommand::run() {
  Session session(common);
  const int views = static_cast<int>(graph) + static_cast<int>(!why.empty()) + static_cast<int>(!other.empty());
  if (name.empty()) name = operand;
  const std::string_view wrong =
      name.empty() && machine.empty()       ? "dialect needs a DIALECT, or a machine: -m NAME"
      : !operand.empty() && name != operand ? "--effective and DIALECT name two dialects; name one"
      : views > 1                           ? "--graph, --why and --diff are three answers; ask for one of them"
      : views == 0 && json                  ? "--json belongs to --graph, --why or --diff; a dialect is written as XML"
      : views > 0 && (annotate || inline_tables || !base_directory.empty())
          ? "--annotate, --inline and --base-directory belong to the dialect as one file"
          : "";
  if (!wrong.empty()) {
    session.report("IG-0513", {}, {std::string(wrong)});
    return cannot_start;
  }
  if (graph && !is_name_of_svg(output, session)) return cannot_start;
  const std::optional<std::string> named = session.dialect_or_machine(name, machine);
  if (!named) return cannot_start;
  if (graph || !why.empty()) {
    std::unique_ptr<LinkedDialect> linked = session.link(*named);
    if (linked == nullptr && !why.empty()) linked = linked_in_spite_of_faults(*named, session);
    if (linked == nullptr) return session.status() == success ? static_cast<int>(cannot_start) : session.status();
    if (!is_apart(linked->dialect, {}, session)) return cannot_start;
    return graph ? show_graph(*linked, session) : show_why(*linked, session);
  }
  const std::optional<Dialect> dialect = session.read(*named);
  if (!dialect)
    return !other.empty() || session.status() == success ? static_cast<int>(cannot_start) : session.status();
  if (!is_apart(*dialect, {}, session)) return cannot_start;
  return other.empty() ? write_effective(*dialect, session) : show_difference(*dialect, session);
}

}  // namespace

int dialect_command(const Arguments& arguments) {
  CommandLine line("dialect",
                   "Shows a dialect with everything that it extends: as one file (without another option), its chain "
                   "as a graph,\none syntax and its place in the chain, or what differs from another dialect. Exit "
                   "status of --diff: 0 the same,\n1 differences, 2 trouble.",
                   "isogloss dialect --effective fanuc --annotate -o effective.xml\n"
                   "  isogloss dialect fanuc --graph -o fanuc.svg\n"
                   "  isogloss dialect syntec --why DwellSyntax\n"
                   "  isogloss dialect fanuc --diff syntec");
  DialectCommand command;
  line.option("DIALECT", command.operand, "The dialect, by name or file");
  line.option("--effective", command.name, "The dialect, too: for scripts that name it so").type_name("DIALECT");
  line.option("-m,--machine", command.machine, "The machine, by name, folder or file, as a dialect with its tables")
      .type_name("MACHINE");
  line.flag("--graph", command.graph,
            "Print the stages, the order, who writes what for whom; with -o FILE.svg, draw it too");
  line.option("--why", command.why, "Print which file put this syntax there, what stands before and after it, and why")
      .type_name("SYNTAX");
  line.option("--diff", command.other, "Print what differs in this other dialect, side by side").type_name("DIALECT");
  line.flag("--json", command.json, "Write --graph, --why or --diff as JSON");
  line.flag("--annotate", command.annotate, "Write the file and line of each part as comments");
  line.option("--base-directory", command.base_directory,
              "Write the tables to files in this folder, named relative to it")
      .existing_folder()
      .type_name("DIR");
  line.flag("--inline", command.inline_tables, "Write no side files (as without --base-directory)");
  line.option("-o,--output", command.output, "Write to a file").type_name("FILE");
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
