// Makes the folder of a machine, commented.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "isogloss/engine/machine.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "session.hpp"

namespace isogloss::cli {

namespace fs = std::filesystem;

namespace {

struct NewCommand {
  CommonOptions common;
  std::string what, name, dialect, title, folder;
  std::vector<std::string> backups;

  int run() const;
};

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

/// machine.xml with every kind of part, as comments where there is nothing to say yet.
std::string machine_text(const NewCommand& command, const Dialect& dialect, bool has_backup) {
  std::string tables;
  for (const DependencyElement& e : dialect.dependencies) tables += (tables.empty() ? "" : ", ") + e.alias;
  std::string out = fmt::format(
      R"(<?xml version="1.0" encoding="UTF-8"?>
<!-- What this machine has on top of its dialect. isogloss run PROGRAM -m NAME uses it; isogloss inspect NAME shows what
     it has and what it lacks, and isogloss lint -m NAME checks it. Paths are relative to this folder and stay in it. -->
<Machine xmlns="urn:isogloss:dialect:1" name="{0}" title="{1}" dialect="{2}">
)",
      escaped(command.name), escaped(command.title.empty() ? command.name : command.title), escaped(command.dialect));
  out += has_backup
             ? "  <!-- The control's own files. What is not read of them: isogloss lint -m NAME -->\n"
               "  <Backup src=\"backup\"/>\n\n"
             : "  <!-- The control's own files, in a folder or one by one; isogloss list importers shows the formats.\n"
               "  <Backup src=\"backup\"/>\n  -->\n\n";
  out += fmt::format(R"(  <!-- Folders in which called programs are looked for, in this order.
  <Programs src="programs"/>
  -->

  <!-- Tables in files of their own.
  <Include src="tables.xml"/>
  -->

  <!-- Rows here go over those of the files above, which go over those of the dialect. The dialect has the tables
       {}. -->
  <Dependencies>
    <!-- Travel and rapid rate in machine coordinates: mm, degrees, mm/min.
    <MachineAxes>
      <Axis name="X" Minimum="0" Maximum="800" RapidRate="30000"/>
    </MachineAxes>
    -->
    <!-- Rotary axes; isogloss inspect MachineKinematics explains the columns.
    <MachineKinematics>
      <Axis name="C" Place="table" Order="1" PivotX="0" PivotY="0" PivotZ="0"/>
    </MachineKinematics>
    -->
  </Dependencies>
</Machine>
)",
                     tables);
  return out;
}

bool is_line(const std::string& text) {
  return std::none_of(text.begin(), text.end(),
                      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

bool is_folder_name(const std::string& name) {
  return !name.empty() && name[0] != '.' && name.find('/') == std::string::npos && is_line(name);
}

int NewCommand::run() const {
  Session session(common);
  if (!is_folder_name(name) || !is_line(title)) {
    session.report("IG-0513", {}, {"the name of a machine is that of its folder: without '/', one line as the title"});
    return cannot_start;
  }
  const std::optional<Dialect> base = session.read(dialect);
  if (!base) return cannot_start;
  const fs::path place = fs::path(folder) / name;
  std::error_code error;
  if (fs::exists(place / "machine.xml", error)) {
    session.report("IG-0511", {(place / "machine.xml").string()}, {"the machine is there already"});
    return cannot_start;
  }
  fs::create_directories(backups.empty() ? place : place / "backup", error);
  for (const std::string& backup : backups) {
    const fs::path from = fs::path(backup).lexically_normal();
    const fs::path to = place / "backup";
    // The files of a folder lie in backup themselves.
    const bool is_folder = fs::is_directory(from, error);
    if (!error) fs::copy(from, is_folder ? to : to / from.filename(), fs::copy_options::recursive, error);
    if (!error) continue;
    session.report("IG-0510", {backup}, {error.message()});
    return cannot_start;
  }
  const std::string path = (place / "machine.xml").string();
  if (error) {
    session.report("IG-0511", {path}, {error.message()});
    return cannot_start;
  }
  if (!write_file(path, machine_text(*this, *base, !backups.empty()), session)) return cannot_start;
  session.link(path);  // what it lacks to be a machine is reported now
  return print(path + "\n", session.status());
}

}  // namespace

int new_command(const Arguments& arguments) {
  CommandLine line("new",
                   "Makes the folder of a machine with a commented machine.xml, and prints the path of that file.",
                   "isogloss new machine dmu58 --dialect heidenhain --backup TOOL.T --backup PRESET.PR");
  NewCommand command;
  line.option("WHAT", command.what, "machine").required().one_of({"machine"});
  line.option("NAME", command.name, "Name of the machine and of its folder").required();
  line.option("-d,--dialect", command.dialect, "The dialect that it stands on").required().type_name("DIALECT");
  line.option("--title", command.title, "What people call it").type_name("TEXT");
  line.option("--backup", command.backups, "Copy this file, or the files of this folder, into the machine (repeatable)")
      .type_name("PATH");
  line.option("--in", command.folder, "The folder in which the machine's own folder is made; otherwise this one")
      .type_name("DIR");
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
