// The conformance test of a plugin. This process never loads it: each check does so in a child of its own.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "output_file.hpp"
#include "session.hpp"
#include "validate/report.hpp"

namespace isogloss::cli {

namespace {

struct ValidateCommand {
  ValidateOptions options;
  std::vector<std::string> files, only;
  std::string format = "text";
  bool lists = false, is_strict = false, in_process = false;

  int run() const;

 private:
  int list() const;
  std::vector<const Check*> chosen(Session& session) const;
  PluginOutcome validate(const std::string& file, const std::vector<const Check*>& checks) const;
  int status(const std::vector<PluginOutcome>& plugins) const;
};

int ValidateCommand::list() const {
  std::string out;
  for (const Check& c : all_checks()) out += fmt::format("{:<16}  {:<6}  {}\n", c.name, to_string(c.level), c.summary);
  return print(out, success);
}

/// Empty, and reported, when a name is wrong.
std::vector<const Check*> ValidateCommand::chosen(Session& session) const {
  std::vector<const Check*> out;
  std::vector<std::string> names;
  for (const Check& c : all_checks()) {
    names.emplace_back(c.name);
    if (only.empty() || std::find(only.begin(), only.end(), c.name) != only.end()) out.push_back(&c);
  }
  for (const std::string& name : only) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::string near = nearest_name(name, names);
    session.report("IG-0155", {}, {name}, near.empty() ? "" : "did you mean " + near + "?");
    out.clear();
  }
  return out;
}

PluginOutcome ValidateCommand::validate(const std::string& file, const std::vector<const Check*>& checks) const {
  const auto perform = [&](const Check& check) {
    return in_process ? run_here(check, options, file) : run_in_child(check, options, file);
  };
  PluginOutcome out{file, {}};
  // A plugin that does not load, or whose descriptor is refused, has nothing that the other checks could look at.
  std::string refused;
  for (const Check& check : all_checks()) {
    const bool is_first = check.name == "loads" || check.name == "descriptor";
    const bool is_chosen = std::find(checks.begin(), checks.end(), &check) != checks.end();
    if (!is_chosen && !is_first) continue;
    Outcome one = refused.empty() ? perform(check) : Outcome{.check = &check, .skipped = refused};
    if (is_first && refused.empty() && !one.held()) refused = fmt::format("the check '{}' failed", check.name);
    if (is_chosen || !one.held()) out.checks.push_back(std::move(one));
  }
  return out;
}

int ValidateCommand::status(const std::vector<PluginOutcome>& plugins) const {
  for (const PluginOutcome& plugin : plugins)
    for (const Outcome& o : plugin.checks) {
      const Level level = o.check->level;
      if (!o.findings.empty() && (level == Level::must || (is_strict && level == Level::should))) return input_errors;
    }
  return success;
}

int ValidateCommand::run() const {
  if (lists) return list();
  Session session(options.common);
  if (files.empty()) {
    session.report("IG-0513", {}, {"name the file of a plugin, or --list for the checks"});
    return cannot_start;
  }
  const std::vector<const Check*> checks = chosen(session);
  if (checks.empty()) return cannot_start;
  if (!options.dialect.empty() && !session.reader().read(options.dialect, session.diagnostics())) return cannot_start;
  std::vector<PluginOutcome> plugins;
  for (const std::string& file : files) {
    std::error_code error;
    const std::filesystem::path path = std::filesystem::absolute(file, error);
    if (!std::filesystem::is_regular_file(path, error)) {
      session.report("IG-0510", {file}, {"it is no file"});
      return cannot_start;
    }
    plugins.push_back(validate(path.string(), checks));
    plugins.back().file = file;
  }
  return print(format == "json"    ? as_json(plugins, options)
               : format == "junit" ? as_junit(plugins)
                                   : as_text(plugins, options),
               status(plugins));
}

}  // namespace

int validate_command(const Arguments& arguments) {
  CommandLine line(
      "validate",
      "Tests whether plugins keep the contract. Each check loads the plugin in a process of its own, beside "
      "the installed plugins.\n"
      "Exit status: 0 every must-check held (with --strict every should-check, too), 1 one failed, 2 cannot "
      "start.",
      "isogloss validate ./build/acme.so --pages ./syntaxes");
  ValidateCommand command;
  ValidateOptions& options = command.options;
  line.option("PLUGIN", command.files, "Files of plugins");
  line.flag("--list", command.lists, "List the checks with their levels");
  line.option("--only", command.only, "Run this check alone (repeatable)").type_name("CHECK");
  line.flag("--strict", command.is_strict, "Exit status 1 when a should-check fails, too");
  line.option("--format", command.format, "Form of the result")
      .one_of({"text", "json", "junit"})
      .type_name("text|json|junit")
      .shows_default();
  bool json = false;
  line.flag("--json", json, "The same as --format json");
  line.option("--pages", options.pages, "Take pages and cases from this folder in place of those in the plugin")
      .type_name("DIR")
      .existing_folder();
  line.option("-d,--dialect", options.dialect,
              "Take vocabulary, options and dependencies from this dialect (default: as `isogloss case`)")
      .type_name("DIALECT");
  line.option("--seed", options.seed, "Seed of the random blocks").type_name("N").shows_default();
  line.option("--blocks", options.blocks, "Random blocks for each syntax").type_name("N").shows_default();
  line.option("--budget", options.budget, "Budget of one build").type_name("NS").shows_default();
  line.option("--time-limit", options.time_limit, "End a check after this time")
      .type_name("S")
      .at_least(1)
      .shows_default();
  line.option("--memory-limit", options.memory_limit, "Memory of a check")
      .type_name("MIB")
      .at_least(64)
      .shows_default();
  line.option("--call-limit", options.call_limit, "End a check whose plugin does not return for this time")
      .type_name("S")
      .at_least(1)
      .shows_default();
  line.flag("--in-process", command.in_process, "No child processes and no limits: for a debugger");
  options.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  if (json) command.format = "json";
  return command.run();
}

}  // namespace isogloss::cli
