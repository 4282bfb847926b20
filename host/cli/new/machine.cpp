// The folder of a machine, commented.
#include <fmt/format.h>

#include <filesystem>

#include "isogloss/engine/machine.hpp"
#include "markup.hpp"
#include "new/folder.hpp"
#include "new/names.hpp"
#include "output_file.hpp"
#include "outputs.hpp"

namespace isogloss::cli {

namespace fs = std::filesystem;

namespace {

/// machine.xml with every kind of part, as comments where there is nothing to say yet.
std::string machine_text(const NewOptions& command, const Dialect& dialect, bool has_backup) {
  std::string tables;
  for (const DependencyElement& e : dialect.dependencies) tables += (tables.empty() ? "" : ", ") + e.alias;
  std::string out = fmt::format(
      R"(<?xml version="1.0" encoding="UTF-8"?>
<!-- What this machine has on top of its dialect. isogloss run PROGRAM -m NAME uses it; isogloss inspect NAME shows what
     it has and what it lacks, and isogloss lint -m NAME checks it. Paths are relative to this folder and stay in it. -->
<Machine xmlns="urn:isogloss:dialect:1" name="{0}" title="{1}" dialect="{2}">
)",
      escaped_xml(command.name), escaped_xml(command.title.empty() ? command.name : command.title),
      escaped_xml(command.dialect));
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

bool is_folder_name(const std::string& name) {
  return !name.empty() && name[0] != '.' && name.find('/') == std::string::npos && is_one_line(name);
}

bool lies_in(const fs::path& path, const fs::path& folder) {
  std::error_code error;
  const fs::path relative =
      fs::weakly_canonical(fs::absolute(path, error), error).lexically_relative(fs::canonical(folder, error));
  return !relative.empty() && *relative.begin() != "..";
}

/// Why a backup cannot be copied into the machine; empty when it can.
std::string backup_fault(const fs::path& backup, const fs::path& place) {
  std::error_code error;
  const bool exists = fs::exists(backup, error);
  if (error) return error.message();
  if (!exists) return std::make_error_code(std::errc::no_such_file_or_directory).message();
  if (!fs::is_directory(backup, error) && !fs::is_regular_file(backup, error))
    return "it is neither a file nor a folder";
  return fs::is_directory(backup, error) && lies_in(place, backup) ? "the new machine would lie in it" : "";
}

}  // namespace

int new_machine(const NewOptions& options) {
  Session session(options.common);
  if (!is_folder_name(options.name) || !is_one_line(options.title)) {
    session.report("IG-0513", {}, {"the name of a machine is that of its folder: without '/', one line as the title"});
    return cannot_start;
  }
  if (options.dialect.empty()) {
    session.report("IG-0513", {}, {"a machine stands on a dialect: -d NAME; isogloss list dialects shows them"});
    return cannot_start;
  }
  const std::optional<Dialect> base = session.read(options.dialect);
  if (!base) return cannot_start;
  const fs::path place = fs::path(options.folder) / options.name;
  std::error_code error;
  if (fs::exists(place / "machine.xml", error)) {
    session.report("IG-0511", {(place / "machine.xml").string()}, {"the machine is there already"});
    return cannot_start;
  }
  for (const std::string& backup : options.backups) {
    const std::string fault = backup_fault(backup, place);
    if (fault.empty()) continue;
    session.report("IG-0510", {backup}, {fault});
    return cannot_start;
  }
  fs::create_directories(options.backups.empty() ? place : place / "backup", error);
  for (const std::string& backup : options.backups) {
    const fs::path from = fs::path(backup).lexically_normal();
    const fs::path to = place / "backup";
    // The files of a folder lie in backup themselves.
    const bool is_folder = fs::is_directory(from, error);
    if (!error) fs::copy(from, is_folder ? to : to / from.filename(), fs::copy_options::recursive, error);
    if (!error) continue;
    session.report("IG-0511", {to.string()}, {backup + " cannot be copied there: " + error.message()});
    return cannot_start;
  }
  const std::string path = (place / "machine.xml").string();
  if (error) {
    session.report("IG-0511", {path}, {error.message()});
    return cannot_start;
  }
  if (!write_file(path, machine_text(options, *base, !options.backups.empty()), session)) return cannot_start;
  session.link(path);  // what it lacks to be a machine is reported now
  return print_written(options, place, {path}, session);
}

}  // namespace isogloss::cli
