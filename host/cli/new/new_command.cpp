// Makes the folder of a machine, a plugin or a dialect.
#include <array>

#include "json_text.hpp"
#include "new/folder.hpp"
#include "output_file.hpp"

namespace isogloss::cli {

namespace {

/// An option that was given and means nothing for what is made; empty: none.
std::string stray_option(const NewOptions& options) {
  struct Row {
    const char* option;
    bool is_given;
    std::string_view of;
  };
  const std::array rows{Row{"--dialect", !options.dialect.empty(), "machine"},
                        Row{"--backup", !options.backups.empty(), "machine"},
                        Row{"--extends", !options.base.empty(), "plugin dialect"},
                        Row{"--cycle", !options.cycle.empty(), "plugin"},
                        Row{"--word", !options.word.empty(), "plugin"},
                        Row{"--switch", !options.switch_codes.empty(), "plugin"},
                        Row{"--table", !options.table.empty(), "plugin"},
                        Row{"--language", !options.language.empty(), "plugin"},
                        Row{"--prefix", !options.prefix.empty(), "plugin"},
                        Row{"--vendor", !options.vendor.empty(), "plugin"}};
  for (const Row& row : rows)
    if (row.is_given && row.of.find(options.what) == std::string_view::npos) return row.option;
  return {};
}

}  // namespace

int print_written(const NewOptions& options, const std::filesystem::path& place, const std::vector<std::string>& files,
                  Session& session) {
  if (options.json)
    return print(pretty({{"Isogloss", 1},
                         {"What", options.what},
                         {"Name", options.name},
                         {"Folder", place.string()},
                         {"Files", files}}),
                 session.status());
  std::string out;
  for (const std::string& path : files) out += path + "\n";
  return print(out, session.status());
}

int new_command(const Arguments& arguments) {
  CommandLine line(
      "new",
      "Makes the folder of a machine, a plugin or a dialect, and prints the paths of its files.\n\n"
      "A plugin is a folder with one syntax, its page with cases, a dialect that uses it, and tests. It "
      "builds against the installed package, and its tests pass at once. Exit status: 0 when the folder is "
      "made, 2 when it is not.",
      "isogloss new plugin acme --cycle G181\n  isogloss new plugin acme --cycle G181 --language c\n"
      "  isogloss new plugin acme --word E --extends heidenhain\n"
      "  isogloss new plugin acme --switch M171,M172 --extends heidenhain\n"
      "  isogloss new plugin acme --table ClampTable\n  isogloss new dialect acme --extends siemens\n"
      "  isogloss new machine dmu58 --dialect heidenhain --backup TOOL.T --backup PRESET.PR");
  NewOptions options;
  line.option("WHAT", options.what, "machine, plugin or dialect").required().one_of({"machine", "plugin", "dialect"});
  line.option("NAME", options.name, "Name of it and of its folder").required();
  line.option("--title", options.title, "What people call it").type_name("TEXT");
  line.option("--in", options.folder, "The folder in which the new folder is made; otherwise this one")
      .type_name("DIR");

  const std::string machine = "Machine", plugin = "Plugin";
  line.option("-d,--dialect", options.dialect, "The dialect that it stands on").type_name("DIALECT").group(machine);
  line.option("--backup", options.backups, "Copy this file, or the files of this folder, into the machine (repeatable)")
      .type_name("PATH")
      .group(machine);

  line.option("--extends", options.base, "The dialect that the new one extends; otherwise fanuc")
      .type_name("DIALECT")
      .group("Plugin, dialect");
  line.option("--cycle", options.cycle,
              "A canned cycle with this code: drilling with a dwell; G181 where nothing else is asked for")
      .type_name("CODE")
      .group(plugin);
  line.option(
          "--word", options.word,
          "A syntax that reads this word and keeps its value, instead of a cycle; in Klartext, the word stands in a "
          "statement FUNCTION NAME")
      .type_name("LETTER")
      .group(plugin);
  line.option("--table", options.table, "A table of this name, of which a word (--word, otherwise E) names a row")
      .type_name("NAME")
      .group(plugin);
  line.option("--switch", options.switch_codes,
              "Two M codes, on and off, for every dialect; M171,M172 where there is no template for a cycle")
      .type_name("ON,OFF")
      .group(plugin);
  line.option("--language", options.language, "c++ (otherwise), or c: the same in C, without a C++ compiler")
      .one_of({"c++", "c"})
      .group(plugin);
  line.option("--prefix", options.prefix, "Prefix of the diagnostics; otherwise the first letters of NAME")
      .type_name("LETTERS")
      .group(plugin);
  line.option("--vendor", options.vendor, "Who makes the plugin; otherwise NAME").type_name("TEXT").group(plugin);
  line.flag("--json", options.json, "Write JSON (schemas/new.schema.json): the folder and the paths of its files");
  options.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;

  if (const std::string stray = stray_option(options); !stray.empty()) {
    Session(options.common).report("IG-0513", {}, {stray + " does not apply to `isogloss new " + options.what + "`"});
    return cannot_start;
  }
  return options.what == "machine"  ? new_machine(options)
         : options.what == "plugin" ? new_plugin(options)
                                    : new_dialect(options);
}

}  // namespace isogloss::cli
