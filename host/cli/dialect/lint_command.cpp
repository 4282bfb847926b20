// Reads and links dialects, starts their chains, and reports what is wrong with them.
#include <fmt/format.h>

#include <algorithm>

#include "diagnostic_json.hpp"
#include "dialect/lint.hpp"
#include "dialect/order_patch.hpp"
#include "json_text.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "sandbox/untrusted.hpp"
#include "session.hpp"

namespace isogloss::cli {

namespace {

struct LintCommand {
  CommonOptions common;
  std::vector<std::string> dialects, machines;
  bool suggest = false, json = false;

  int run() const;
  Json check(const std::string& name, Session& session) const;
};

std::string suggestion(const Dialect& dialect, Library& library) {
  const std::vector<std::string> wanted = suggest_order(dialect, library);
  if (wanted.empty()) {
    std::string out = fmt::format("{}: no order satisfies every syntax\n", dialect.name);
    for (const std::string& link : order_ring(dialect, library)) out += "  " + link + "\n";
    return out;
  }
  const bool is_same = std::equal(dialect.chain.begin(), dialect.chain.end(), wanted.begin(), wanted.end(),
                                  [](const ChainElement& e, const std::string& alias) { return e.alias == alias; });
  if (is_same) return fmt::format("{}: the order is right\n", dialect.name);
  std::string reason;
  std::string patch = order_patch(dialect, wanted, reason);
  if (reason.empty()) return patch;
  return fmt::format("{}: no change of {} alone gives a valid order: {}\n", dialect.name, dialect.file.string(),
                     reason);
}

/// Services that several dependencies offer: the first one answers for all.
Json rivals(const LinkedDialect& linked) {
  Json out = Json::array();
  for (const Provision& p : provisions(linked)) {
    if (p.dependencies.size() == 1) continue;
    Json others = Json::array();
    for (std::size_t i = 1; i < p.dependencies.size(); ++i)
      others.push_back(linked.dependencies[p.dependencies[i]].element.alias);
    out.push_back({{"Service", p.service},
                   {"Answers", linked.dependencies[p.dependencies[0]].element.alias},
                   {"Others", std::move(others)}});
  }
  return out;
}

std::string lint_text(const Json& checked) {
  std::string out;
  if (checked["Starts"].get<bool>()) {
    out = fmt::format("{}: {} syntaxes, {} dependencies, {} fields\n", checked["Name"].get<std::string>(),
                      checked["Syntaxes"].get<std::size_t>(), checked["Dependencies"].get<std::size_t>(),
                      checked["Fields"].get<std::size_t>());
    for (const Json& rival : checked["Rivals"]) {
      out += fmt::format("  {}: {} answers", rival["Service"].get<std::string>(), rival["Answers"].get<std::string>());
      const char* separator = ", not ";
      for (const Json& other : rival["Others"]) {
        out += separator + other.get<std::string>();
        separator = ", ";
      }
      out += '\n';
    }
  }
  return checked.contains("Suggestion") ? out + checked["Suggestion"].get<std::string>() : out;
}

/// What `lint --json` says about one dialect or machine.
Json LintCommand::check(const std::string& name, Session& session) const {
  CopyingSink diagnostics(session.diagnostics());
  Json out{{"Name", name}, {"Starts", false}};
  const Linted linted = lint_dialect(name, session, diagnostics);
  if (linted.dialect) {
    out["Name"] = linted.dialect->name;
    out["File"] = linted.dialect->file.string();
    if (linted.starts) {
      out["Starts"] = true;
      out["Syntaxes"] = linted.linked->chain.size();
      out["Dependencies"] = linted.linked->dependencies.size();
      out["Fields"] = linted.linked->layout.fields.size();
      out["Rivals"] = rivals(*linted.linked);
    }
    if (suggest) out["Suggestion"] = suggestion(*linted.dialect, session.library());
  }
  for (Diagnostic& d : session.library().shared_codes()) diagnostics.add(std::move(d));
  session.diagnostics().finish_program();
  out["Diagnostics"] = std::move(diagnostics.copies);
  return out;
}

int LintCommand::run() const {
  Session session(common);
  if (dialects.empty() && machines.empty()) {
    session.report("IG-0513", {}, {"lint needs a dialect, or a machine: -m NAME"});
    return cannot_start;
  }
  std::vector<std::string> all = dialects;
  for (const std::string& machine : machines) {
    const std::optional<std::string> file = session.dialect_or_machine("", machine);
    if (!file) return cannot_start;
    all.push_back(*file);
  }
  if (!are_apart(all, {common.diagnostics_output}, session)) return cannot_start;
  std::string text;
  Json checked = Json::array();
  for (const std::string& name : all) {
    session.progress().show(checked.size(), all.size(), name);
    checked.push_back(check(name, session));
    text += lint_text(checked.back());
  }
  session.progress().hide();
  return print(json ? pretty(Json{{"Isogloss", 1}, {"Checked", std::move(checked)}}) : text, session.status());
}

}  // namespace

int lint_command(const Arguments& arguments) {
  CommandLine line("lint",
                   "Checks files of dialects and machines: reads them with what they extend, links and starts their "
                   "chains.",
                   "isogloss lint fanuc ./my-dialect.xml\n  isogloss lint my-dialect.xml --suggest | patch -p0\n  "
                   "isogloss lint -m ./machines/dmu85");
  LintCommand command;
  command.common.repeats = 0;  // what is wrong is listed as a whole
  line.option("DIALECT", command.dialects, "Dialects, by name or file");
  line.option("-m,--machine", command.machines, "A machine, by name, folder or file (repeatable)").type_name("MACHINE");
  line.flag("--suggest", command.suggest,
            "Print a patch of the dialect's file that makes the order valid and moves as little as possible");
  line.flag("--json", command.json, "Write JSON; diagnostics stand in it, and on standard error as ever");
  UntrustedOptions untrusted;
  untrusted.add_to(line);
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  UntrustedWork work = untrusted_work(command.common, "", "");
  work.reads = command.machines;
  for (const std::string& dialect : command.dialects) work.add_dialect(dialect);
  if (const auto done = enter_untrusted(untrusted, work)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
