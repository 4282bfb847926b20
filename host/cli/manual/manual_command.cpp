// Writes manual pages from what the commands say of themselves: what --help shows and a page says cannot differ.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "json_text.hpp"
#include "manual/roff.hpp"
#include "output_file.hpp"
#include "session.hpp"
#include "usage.hpp"

namespace isogloss::cli {

namespace {

std::string heading(std::string_view page, std::string_view summary) {
  std::string title(page);
  std::transform(title.begin(), title.end(), title.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? char(c - 32) : c; });
  return fmt::format(".TH {} 1 \"{}\" \"isogloss {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n", roff(title),
                     ISOGLOSS_DATE, ISOGLOSS_VERSION, roff(page), roff(summary));
}

std::string exit_status() {
  return ".SH EXIT STATUS\n"
         ".TP\n0\nAt most warnings.\n.TP\n1\nErrors in the input: a program, a dialect, a page, a plugin.\n"
         ".TP\n2\nThe command cannot start: wrong usage, a missing file, a dialect that does not link.\n"
         ".TP\n3\nAn internal fault, such as a crash of a plugin.\n";
}

std::string item(const UsageItem& item, bool is_operand) {
  std::string out = ".TP\n";
  for (const std::string& name : item.names)
    out += (&name == item.names.data() ? "" : ", ") + fmt::format("\\f{}{}\\fR", is_operand ? 'I' : 'B', roff(name));
  if (!is_operand && !item.value.empty()) out += fmt::format(" \\fI{}\\fR", roff(item.value));
  out += item.is_repeatable ? " ...\n" : "\n";
  std::string text = item.description;
  if (!item.words.empty() && item.value.find('|') == std::string::npos) {
    text += text.empty() ? "One of: " : ". One of: ";
    for (const std::string& word : item.words) text += (word == item.words.front() ? "" : ", ") + word;
  }
  if (!item.default_value.empty()) text += " (default: " + item.default_value + ")";
  return out + roff_paragraphs(text.empty() ? "See above." : text + ".");
}

std::string synopsis(const Usage& usage) {
  std::string out = fmt::format(".SH SYNOPSIS\n.B isogloss {}\n.RI [ OPTION ...]\n", roff(usage.name));
  for (const UsageItem& o : usage.operands) {
    const std::string more = o.is_repeatable ? " ..." : "";
    out += o.is_required ? fmt::format(".I {}{}\n", roff(o.names[0]), more)
                         : fmt::format(".RI [ {}{} ]\n", roff(o.names[0]), more.empty() ? "" : "\\~...");
  }
  return out;
}

std::string page_of(const Command& command) {
  const Usage usage = usage_of(command);
  std::string out = heading("isogloss-" + std::string(command.name), command.summary) + synopsis(usage) +
                    ".SH DESCRIPTION\n" + roff_paragraphs(usage.description);
  if (!usage.operands.empty()) out += ".SH OPERANDS\n";
  for (const UsageItem& o : usage.operands) out += item(o, true);
  out += ".SH OPTIONS\n";
  std::string group = usage.options.empty() ? "" : usage.options.front().group;
  for (const UsageItem& o : usage.options) {
    if (o.group != group) out += fmt::format(".SS {}\n", roff(group = o.group));
    out += item(o, false);
  }
  // A command with statuses of its own describes them.
  if (usage.description.find("Exit status") == std::string::npos) out += exit_status();
  return out + ".SH EXAMPLES\n" + roff_example(usage.example) + ".SH SEE ALSO\n.BR isogloss (1)\n";
}

std::string page_of_isogloss() {
  std::string out = heading("isogloss", "controller dialects of CNC part programs as data and plugins") +
                    ".SH SYNOPSIS\n.B isogloss\n.I COMMAND\n.RI [ OPTION ...]\n.SH DESCRIPTION\n" +
                    roff_paragraphs(
                        "Isogloss resolves CNC part programs: text goes in; blocks, motions in machine coordinates, "
                        "diagnostics and explanations come out. A controller dialect is an XML file that puts the "
                        "syntaxes of plugins in order.\n\nData goes to standard output, messages to standard error. "
                        "Each command has a manual page of its own, isogloss-COMMAND. The pages of syntaxes, "
                        "dependencies and dialects are in the plugins: isogloss inspect NAME prints one.") +
                    ".SH COMMANDS\n";
  for (const Command& c : commands)
    out += fmt::format(".TP\n.BR isogloss\\-{} (1)\n{}\n", roff(c.name), roff_paragraphs(std::string(c.summary) + "."));
  out += ".SH OPTIONS OF ALL COMMANDS\n";
  for (const CommonOption& o : common_options)
    out +=
        fmt::format(".TP\n\\fB{}\\fR{}\n", roff(o.name), o.value.empty() ? "" : fmt::format(" \\fI{}\\fR", o.value)) +
        roff_paragraphs(std::string(o.summary) + ".");
  out += exit_status() + ".SH ENVIRONMENT\n";
  for (const auto& [name, text] : {
           std::pair("ISOGLOSS_PLUGIN_PATH", "Folders with plugins, separated by colons."),
           std::pair("ISOGLOSS_ANY_PLUGINS", "1: load plugins that other users can write or replace, too."),
           std::pair("ISOGLOSS_DIALECT_PATH", "Folders with dialects."),
           std::pair("ISOGLOSS_MACHINES", "Folders with machines."),
           std::pair("NO_COLOR", "Where it is set, diagnostics have no colours on a terminal."),
       })
    out += fmt::format(".TP\n.B {}\n{}\n", name, text);
  out += ".SH FILES\n";
  for (const auto& [name, text] : {
           std::pair("$XDG_CONFIG_HOME/isogloss/machines",
                     "Machines of the user (otherwise ~/.config/isogloss/machines)."),
           std::pair("PREFIX/lib/isogloss/plugins", "Plugins of the installation."),
           std::pair("PREFIX/share/isogloss/dialects", "Its dialects; machines below it."),
       })
    out += fmt::format(".TP\n.I {}\n{}", roff(name), roff_paragraphs(text));
  return out + ".SH EXAMPLES\n" +
         roff_example(
             "isogloss run part.nc --emit motions --format text\nisogloss explain part.nc:42\n"
             "isogloss list dialects") +
         ".SH SEE ALSO\n.BR isogloss\\-run (1),\n.BR isogloss\\-explain (1)\n";
}

std::map<std::string, std::string> all_pages() {
  std::map<std::string, std::string> out{{"isogloss.1", page_of_isogloss()}};
  for (const Command& c : commands) out["isogloss-" + std::string(c.name) + ".1"] = page_of(c);
  return out;
}

Json as_json(const UsageItem& item) {
  Json out{{"Names", item.names}, {"Description", item.description}};
  if (!item.value.empty()) out["Value"] = item.value;
  if (!item.words.empty()) out["Words"] = item.words;
  if (!item.default_value.empty()) out["Default"] = item.default_value;
  if (!item.group.empty()) out["Group"] = item.group;
  out["IsRequired"] = item.is_required;
  out["IsRepeatable"] = item.is_repeatable;
  return out;
}

Json as_json(const Command& command) {
  const Usage usage = usage_of(command);
  Json operands = Json::array(), options = Json::array();
  for (const UsageItem& o : usage.operands) operands.push_back(as_json(o));
  for (const UsageItem& o : usage.options) options.push_back(as_json(o));
  return {{"Name", std::string(command.name)}, {"Summary", std::string(command.summary)},
          {"Description", usage.description},  {"Operands", std::move(operands)},
          {"Options", std::move(options)},     {"Example", usage.example}};
}

/// Of one command, or of all.
int print_json(const std::string& name) {
  Json list = Json::array();
  for (const Command& c : commands)
    if (name.empty() || c.name == name) list.push_back(as_json(c));
  return print(pretty({{"Isogloss", 1}, {"Commands", std::move(list)}}), success);
}

int write_all(const std::string& folder) {
  Session session{CommonOptions{}};
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  for (const auto& [name, page] : all_pages()) {
    const std::string path = (std::filesystem::path(folder) / name).string();
    std::string error;
    const auto file = OutputFile::open(path, error);
    if (file != nullptr && file->write(page) && file->commit()) continue;
    session.report("IG-0511", {path}, {file == nullptr ? error : file->error()});
    return cannot_start;
  }
  return success;
}

}  // namespace

int manual_command(const Arguments& arguments) {
  CommandLine line("manual",
                   "Prints the manual page of the command, or of one of its commands, made from what --help shows.",
                   "isogloss manual run | man -l -\n  isogloss manual -o man");
  std::vector<std::string> names;
  for (const Command& c : commands) names.emplace_back(c.name);
  std::string name, folder;
  bool json = false;
  line.option("COMMAND", name, "The command; without it the page that lists them").one_of(names);
  line.option("-o,--output", folder, "Write all pages into this folder instead").type_name("DIR").not_with("COMMAND");
  line.flag("--json", json, "Write JSON (schemas/manual.schema.json): options and operands of the command, or of all");
  if (const auto done = line.parse(arguments)) return *done;
  if (json && !folder.empty()) {
    Session(CommonOptions{}).report("IG-0513", {}, {"-o writes manual pages and --json none; leave one of them out"});
    return cannot_start;
  }
  if (json) return print_json(name);
  if (!folder.empty()) return write_all(folder);
  for (const Command& c : commands)
    if (c.name == name) return print(page_of(c), success);
  return print(page_of_isogloss(), success);
}

}  // namespace isogloss::cli
