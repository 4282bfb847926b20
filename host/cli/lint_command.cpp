// Reads and links dialects, starts their chains, and reports what is wrong with them.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "isogloss/engine/chain.hpp"
#include "order_patch.hpp"
#include "output_file.hpp"
#include "session.hpp"

namespace isogloss::cli {

namespace {

struct LintCommand {
  CommonOptions common;
  std::vector<std::string> dialects, machines;
  bool suggest = false;

  int run() const;
};

std::string suggestion(const Dialect& dialect, Library& library) {
  const std::vector<std::string> wanted = suggest_order(dialect, library);
  if (wanted.empty()) return fmt::format("{}: no order satisfies every syntax\n", dialect.name);
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
std::string rivals(const LinkedDialect& linked) {
  std::string out;
  for (const Provision& p : provisions(linked)) {
    if (p.dependencies.size() == 1) continue;
    const auto alias = [&](std::size_t i) { return linked.dependencies[p.dependencies[i]].element.alias; };
    out += fmt::format("  {}: {} answers, not {}", p.service, alias(0), alias(1));
    for (std::size_t i = 2; i < p.dependencies.size(); ++i) out += ", " + alias(i);
    out += '\n';
  }
  return out;
}

/// False when a dependency or a syntax rejects what the dialect gives it; it reports the reason.
bool starts(const LinkedDialect& linked, DiagnosticSink& diagnostics) {
  try {
    const Chain chain(linked, {}, diagnostics);
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

/// Notes on a shipped dialect are not for those who set up a machine that stands on it.
class OwnNotes : public DiagnosticSink {
 public:
  OwnNotes(DiagnosticSink& sink, const Dialect& dialect) : sink_(sink), dialect_(dialect) {}
  void add(Diagnostic d) override {
    if (dialect_.is_machine && d.severity == Severity::note && !is_of_machine(d.where.file)) return;
    sink_.add(std::move(d));
  }

 private:
  bool is_of_machine(const std::string& file) const {
    const std::filesystem::path folder = dialect_.file.parent_path();
    return file.empty() || folder.empty() || file.starts_with((folder / "").string());
  }
  DiagnosticSink& sink_;
  const Dialect& dialect_;
};

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
  std::string out;
  for (const std::string& name : all) {
    const std::optional<Dialect> dialect = session.read(name);
    if (dialect) {
      OwnNotes notes(session.diagnostics(), *dialect);
      const std::unique_ptr<LinkedDialect> linked = link(*dialect, session.library(), notes);
      if (linked != nullptr)
        for (Diagnostic& d : review(*linked)) notes.add(std::move(d));
      if (linked != nullptr && starts(*linked, session.diagnostics()))
        out += fmt::format("{}: {} syntaxes, {} dependencies, {} fields\n", dialect->name, linked->chain.size(),
                           linked->dependencies.size(), linked->layout.fields.size()) +
               rivals(*linked);
      if (suggest) out += suggestion(*dialect, session.library());
    }
    for (Diagnostic& d : session.library().shared_codes()) session.diagnostics().add(std::move(d));
    session.diagnostics().finish_program();
  }
  return print(out, session.status());
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
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
