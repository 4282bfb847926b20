// Writes a dialect and everything that it extends as one file.
#include <filesystem>

#include "output_file.hpp"
#include "outputs.hpp"
#include "session.hpp"

namespace isogloss::cli {

namespace fs = std::filesystem;

namespace {

struct DialectCommand {
  CommonOptions common;
  std::string name, machine, base_directory, output;
  bool inline_tables = false;

  int run() const;
};

int DialectCommand::run() const {
  Session session(common);
  if (name.empty() && machine.empty()) {
    session.report("IG-0513", {}, {"dialect needs --effective DIALECT, or a machine: -m NAME"});
    return cannot_start;
  }
  const std::optional<std::string> named = session.dialect_or_machine(name, machine);
  if (!named) return cannot_start;
  const std::optional<Dialect> dialect = session.read(*named);
  if (!dialect) return session.status() == success ? static_cast<int>(cannot_start) : session.status();
  // Side files need a folder; without one everything stands in the one file.
  const bool is_inline = inline_tables || base_directory.empty();
  const WrittenDialect written = write_dialect(*dialect, base_directory, is_inline);
  for (const auto& [path, text] : written.side_files)
    if (!write_file((fs::path(base_directory) / path).string(), text, session)) return cannot_start;
  if (output.empty()) return print(written.xml, session.status());
  return write_file(output, written.xml, session) ? session.status() : static_cast<int>(cannot_start);
}

}  // namespace

int dialect_command(const Arguments& arguments) {
  CommandLine line("dialect", "Writes a dialect and everything that it extends as one file.",
                   "isogloss dialect --effective fanuc --inline -o effective.xml");
  DialectCommand command;
  line.option("--effective", command.name, "The dialect, by name or file").type_name("DIALECT");
  line.option("-m,--machine", command.machine, "The machine, by name, folder or file, as a dialect with its tables")
      .type_name("MACHINE");
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
