// One syntax on one block: JSON in, JSON out.
#include "crash_guard.hpp"
#include "isogloss/engine/cases.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "sandbox/untrusted.hpp"
#include "surroundings.hpp"

namespace isogloss::cli {

namespace {

struct ApplyCommand {
  CommonOptions common;
  SurroundingOptions around;
  std::string syntax, previous, ahead, dependencies;

  int run() const;
};

int ApplyCommand::run() const {
  Session session(common);
  for (const std::string& file : {previous, ahead, dependencies})
    if (file == "-") {
      session.report("IG-0513", {},
                     {"standard input is the block itself: --previous, --ahead and --dependencies need files"});
      return cannot_start;
    }
  const std::vector<std::string> inputs = {previous, ahead, dependencies, around.dialect, around.machine};
  if (!are_apart(inputs, {common.diagnostics_output}, session)) return cannot_start;
  const std::optional<Surroundings> surroundings = around.make(session);
  if (!surroundings) return cannot_start;
  Application application{syntax, {}, {}, {}, {"standard input", 1, 0}};
  application.previous_at = {previous, 1, 0};
  application.ahead_at = {ahead, 1, 0};
  application.dependencies_at = {dependencies, 1, 0};
  std::string error;
  const auto read = [&](const std::string& path) {
    std::optional<std::string> text = read_text(path, error);
    if (!text) session.report("IG-0510", {path}, {error});
    return text;
  };
  if (!previous.empty()) {
    application.previous = read(previous);
    if (!application.previous) return cannot_start;
  }
  if (!ahead.empty()) {
    application.ahead = read(ahead);
    if (!application.ahead) return cannot_start;
  }
  if (!dependencies.empty()) {
    const std::optional<std::string> xml = read(dependencies);
    if (!xml) return cannot_start;
    application.dependencies = *xml;
  }
  application.before = read("-").value_or("");
  const std::optional<std::string> after = apply(application, *surroundings, session.library(), session.diagnostics());
  if (!after) {
    // A block that is not a document is a fault of the input; an unknown syntax is a fault of the command.
    return session.diagnostics().by_code().contains("IG-0502") || session.diagnostics().by_code().contains("IG-0503")
               ? input_errors
               : cannot_start;
  }
  return print(*after + "\n", session.status());
}

}  // namespace

int apply_command(const Arguments& arguments) {
  CommandLine line(
      "apply",
      "Runs one syntax on one block: reads the block document from standard input, writes it to standard output.",
      R"(echo '{"Parsing": {"G04": {"P": 0.5}}}' | isogloss apply DwellSyntax)");
  ApplyCommand command;
  line.option("SYNTAX", command.syntax, "Id of a syntax, or its alias in the dialect").required();
  line.option("--previous", command.previous, "The whole previous block, as JSON").type_name("FILE");
  line.option("--ahead", command.ahead, "The executed blocks that follow, as a JSON list").type_name("FILE");
  line.option("--dependencies", command.dependencies, "Dependencies and options as XML, as a case has them")
      .type_name("FILE");
  bool json = false;
  line.flag("--json", json, "Write JSON, which is its only form");
  command.around.add_to(line);
  UntrustedOptions untrusted;
  untrusted.add_to(line);
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  UntrustedWork work = untrusted_work(command.common, command.around.dialect, command.around.machine);
  work.programs.push_back("-");
  work.reads.insert(work.reads.end(), {command.previous, command.ahead, command.dependencies});
  if (const auto done = enter_untrusted(untrusted, work)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
