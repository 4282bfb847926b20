// The conformance test of a plugin. This process never loads it: each check does so in a child of its own.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "json_text.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "session.hpp"
#include "validate/report.hpp"
#include "validate/side_by_side.hpp"

namespace isogloss::cli {

namespace {

/// The checks of all plugins, as a line of progress counts them.
struct Steps {
  Progress& progress;
  std::size_t total = 0, done = 0;

  void show(const std::string& plugin, const Check& check, std::string_view at_work) const {
    progress.show(done, total,
                  fmt::format("{}, {}{}{}", plugin, check.name, at_work.empty() ? "" : ": ", at_work.substr(0, 200)));
  }
};

struct ValidateCommand {
  ValidateOptions options;
  std::vector<std::string> files, only;
  std::string format = "text";
  bool lists = false, is_strict = false, in_process = false;
  unsigned jobs = 0;

  int run(const CommandLine& line) const;

 private:
  void report_idle_options(const CommandLine& line, std::span<const Check* const> checks, Session& session) const;
  int list(const std::vector<const Check*>& checks) const;
  std::string report(const std::vector<PluginOutcome>& plugins) const;
  std::vector<const Check*> chosen(Session& session) const;
  std::vector<Outcome> perform(const std::string& file, std::span<const Check* const> checks, Steps& steps) const;
  PluginOutcome validate(const std::string& file, const std::vector<const Check*>& checks, Steps& steps) const;
  int status(const std::vector<PluginOutcome>& plugins) const;
};

int ValidateCommand::list(const std::vector<const Check*>& checks) const {
  if (format == "json") {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const Check* c : checks)
      rows.push_back({{"Name", c->name}, {"Level", to_string(c->level)}, {"Summary", c->summary}, {"Help", c->help}});
    return print(pretty({{"Isogloss", 1}, {"Checks", std::move(rows)}}), success);
  }
  std::string out;
  for (const Check* c : checks) out += fmt::format("{:<16}  {:<6}  {}\n", c->name, to_string(c->level), c->summary);
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

std::vector<Outcome> ValidateCommand::perform(const std::string& file, std::span<const Check* const> checks,
                                              Steps& steps) const {
  const std::string name = std::filesystem::path(file).filename().string();
  const SideBySideListener listener{
      [&](const Check& check, std::string_view at_work) { steps.show(name, check, at_work); }, [&] { ++steps.done; }};
  const unsigned most = jobs == 0 ? std::max(1u, std::thread::hardware_concurrency()) : jobs;
  if (!in_process && most > 1 && checks.size() > 1) return run_side_by_side(checks, most, options, file, listener);
  std::vector<Outcome> out;
  for (const Check* const check : checks) {
    const auto watcher = [&](std::string_view at_work) { listener.at_work(*check, at_work); };
    watcher("");
    out.push_back(in_process ? run_here(*check, options, file) : run_in_child(*check, options, file, watcher));
    listener.ended();
  }
  return out;
}

PluginOutcome ValidateCommand::validate(const std::string& file, const std::vector<const Check*>& checks,
                                        Steps& steps) const {
  PluginOutcome out{file, {}};
  // A plugin that does not load, or whose descriptor is refused, has nothing that the other checks could look at.
  std::string refused;
  std::vector<const Check*> others;
  for (const Check& check : all_checks()) {
    const bool is_first = check.name == "loads" || check.name == "descriptor";
    const bool is_chosen = std::find(checks.begin(), checks.end(), &check) != checks.end();
    if (!is_first && is_chosen && refused.empty()) {
      others.push_back(&check);
    } else if (is_first && refused.empty()) {
      Steps unseen = steps;
      Outcome one = perform(file, std::array{&check}, is_chosen ? steps : unseen).front();
      if (!one.held()) refused = fmt::format("the check '{}' failed", check.name);
      if (is_chosen || !one.held()) out.checks.push_back(std::move(one));
    } else if (is_chosen || is_first) {
      out.checks.push_back({.check = &check, .skipped = refused});
      steps.done += is_chosen ? 1 : 0;
    }
  }
  for (Outcome& one : perform(file, others, steps)) out.checks.push_back(std::move(one));
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

std::string ValidateCommand::report(const std::vector<PluginOutcome>& plugins) const {
  return format == "json"    ? as_json(plugins, options)
         : format == "junit" ? as_junit(plugins)
         : format == "sarif" ? as_sarif(plugins)
                             : as_text(plugins, options);
}

/// Options for which none of the checks that --only names has a use.
void ValidateCommand::report_idle_options(const CommandLine& line, std::span<const Check* const> checks,
                                          Session& session) const {
  for (const char* const option : {"--seed", "--blocks", "--random-limit", "--budget"}) {
    const bool has_use =
        std::any_of(checks.begin(), checks.end(), [&](const Check* check) { return has_use_for(*check, option); });
    if (!has_use && line.is_given(option))
      session.report("IG-0519", {}, {option, "--only leaves no check that uses it"});
  }
}

int ValidateCommand::run(const CommandLine& line) const {
  Session session(options.common);
  const auto misused = [&](const std::string& why) {
    session.report("IG-0513", {}, {why});
    return cannot_start;
  };
  const std::vector<const Check*> checks = chosen(session);
  if (checks.empty()) return cannot_start;
  if (lists) {
    if (!files.empty()) return misused("--list names checks and looks at no plugin: leave " + files.front() + " out");
    if (format != "text" && format != "json") return misused("--list writes text or JSON, and no " + format);
    return list(checks);
  }
  if (files.empty()) return misused("name the file of a plugin, or --list for the checks");
  report_idle_options(line, checks, session);
  if (!options.dialect.empty() && !session.reader().read(options.dialect, session.diagnostics())) return cannot_start;
  if (!are_apart(files, {options.common.diagnostics_output}, session)) return cannot_start;
  std::vector<PluginOutcome> plugins;
  Steps steps{session.progress(), checks.size() * files.size()};
  bool is_missing = false;
  for (const std::string& file : files) {
    std::error_code error;
    const std::filesystem::path path = std::filesystem::absolute(file, error);
    if (std::filesystem::is_regular_file(path, error)) {
      plugins.push_back(validate(path.string(), checks, steps));
      plugins.back().file = file;
    } else {
      session.report("IG-0510", {file},
                     {std::filesystem::exists(path, error) ? "it is no file" : "there is no such file"});
      is_missing = true;
    }
  }
  session.progress().hide();
  if (plugins.empty()) return cannot_start;
  return print(report(plugins), is_missing ? cannot_start : status(plugins));
}

}  // namespace

int validate_command(const Arguments& arguments) {
  CommandLine line(
      "validate",
      "Tests whether plugins keep the contract. Each check loads the plugin in a process of its own, beside "
      "the installed plugins.\n"
      "Exit status: 0 every must-check held (with --strict every should-check, too), 1 one failed, 2 a file "
      "or a name is wrong; the other files are looked at all the same.",
      "isogloss validate ./build/acme.so --pages ./syntaxes\n"
      "  isogloss validate ./build/acme.so --format sarif > acme.sarif");
  ValidateCommand command;
  ValidateOptions& options = command.options;
  line.option("PLUGIN", command.files, "Files of plugins");
  line.flag("--list", command.lists, "List the checks with their levels (with --json also what to do when one fails)");
  line.option("--only", command.only, "Run this check alone (repeatable)").type_name("CHECK");
  line.flag("--strict", command.is_strict, "Exit status 1 when a should-check fails, too").not_with("--list");
  line.option("--format", command.format, "Form of the result")
      .one_of({"text", "json", "junit", "sarif"})
      .type_name("text|json|junit|sarif")
      .shows_default();
  line.flag_for("--format", command.format, "json", "--json");
  line.option("--pages", options.pages, "Take pages and cases from this folder in place of those in the plugin")
      .type_name("DIR")
      .existing_folder()
      .not_with("--list");
  line.option("-d,--dialect", options.dialect,
              "Take vocabulary, options and dependencies from this dialect (default: as `isogloss case`)")
      .type_name("DIALECT")
      .not_with("--list");
  line.option("--seed", options.seed, "Seed of the random blocks").type_name("N").shows_default().not_with("--list");
  line.option("--blocks", options.blocks, "Random blocks of a plugin, spread over its syntaxes")
      .type_name("N")
      .shows_default()
      .not_with("--list");
  line.option("--random-limit", options.random_limit, "End the random blocks of a plugin after this time")
      .type_name("S")
      .at_least(1)
      .shows_default()
      .not_with("--list");
  line.option("-j,--jobs", command.jobs,
              "Checks at once (0: as many as there are processors); those of times are alone")
      .type_name("N")
      .shows_default()
      .not_with("--list")
      .not_with("--in-process");
  line.option("--budget", options.budget, "Budget of one build").type_name("NS").shows_default().not_with("--list");
  line.option("--time-limit", options.time_limit, "End a check after this time")
      .type_name("S")
      .at_least(1)
      .shows_default()
      .not_with("--list")
      .not_with("--in-process");
  line.option("--memory-limit", options.memory_limit, "Memory of a check")
      .type_name("MIB")
      .at_least(64)
      .shows_default()
      .not_with("--list")
      .not_with("--in-process");
  line.option("--call-limit", options.call_limit, "End a check whose plugin does not return for this time")
      .type_name("S")
      .at_least(1)
      .shows_default()
      .not_with("--list")
      .not_with("--in-process");
  line.flag("--in-process", command.in_process, "No child processes and no limits: for a debugger").not_with("--list");
  options.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  return command.run(line);
}

}  // namespace isogloss::cli
