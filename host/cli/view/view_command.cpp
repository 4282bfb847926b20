// Shows the path of a program in a page: one file, or served from this machine and made anew at each change.
#include "output_file.hpp"
#include "outputs.hpp"
#include "sandbox/untrusted.hpp"
#include "view/server.hpp"

namespace isogloss::cli {

namespace {

struct ViewCommand {
  viewing::ViewOptions view;
  std::string output;
  bool serve = false;
  UntrustedOptions untrusted;
  std::uint32_t port = 0;

  void add_to(CommandLine& line);
  int run();
  UntrustedWork untrusted_work() const;

 private:
  bool is_usage_sound(Session& session) const;
};

void ViewCommand::add_to(CommandLine& line) {
  line.option("PROGRAM", view.path, "The program; - is standard input").required();
  line.option("-o,--output", output, "Write to a file, which appears only when it is complete").type_name("FILE");
  line.option("-a", view.dialects[0], "Dialect of side A, where two are compared (default: -d)")
      .type_name("DIALECT")
      .group("Two sides");
  line.option("-b", view.dialects[1], "Dialect of side B (default: -d)").type_name("DIALECT").group("Two sides");
  line.option("--machine-a", view.machines[0], "Machine of side A (default: -m)")
      .type_name("MACHINE")
      .group("Two sides");
  line.option("--machine-b", view.machines[1], "Machine of side B (default: -m)")
      .type_name("MACHINE")
      .group("Two sides");
  line.option(
          "--explain-lines", view.page.explained_lines,
          "Explain each line in the page itself, for programs of up to N lines; --serve explains lines of any program")
      .type_name("N")
      .shows_default();
  line.option("--max-moves", view.moves.most_moves, "Stop after N moves, which the page holds")
      .at_least(1)
      .type_name("N")
      .shows_default();
  line.flag("--serve", serve,
            "Print an address of this machine that shows the page until Ctrl-C, and reloads it when program, tables or "
            "dialect change");
  line.option("--port", port, "With --serve: the port (0: one that is free)").type_name("N").shows_default();
  view.program.add_to(line);
  untrusted.add_to(line);
  view.common.add_to(line);
}

UntrustedWork ViewCommand::untrusted_work() const {
  UntrustedWork out = cli::untrusted_work(view.common, view.program);
  out.programs.push_back(view.path);
  out.outputs.push_back(output);
  out.reads.insert(out.reads.end(), view.machines.begin(), view.machines.end());
  for (const std::string& dialect : view.dialects) out.add_dialect(dialect);
  return out;
}

bool ViewCommand::is_usage_sound(Session& session) const {
  constexpr std::uint32_t last_port = 65535;
  std::string fault;
  if (serve && !output.empty()) fault = "--serve and -o contradict each other; leave one out";
  if (serve && untrusted.on) fault = "--untrusted writes a page: the server of --serve needs what it forbids";
  if (!serve && port != 0) fault = "--port belongs to --serve";
  if (port > last_port) fault = "--port must be 0 to 65535, not " + std::to_string(port);
  if (fault.empty()) return view.program.serves_a_side(view.dialects, view.machines, session);
  session.report("IG-0513", {}, {fault});
  return false;
}

int ViewCommand::run() {
  Session session(view.common);
  if (!is_usage_sound(session)) return cannot_start;
  if (output.empty() || output == "-") session.progress().data_goes_to_stdout();
  std::vector<std::string> inputs = view.program.files();
  inputs.insert(inputs.end(), {view.path, view.dialects[0], view.dialects[1], view.machines[0], view.machines[1]});
  if (!are_apart(inputs, {output, view.common.diagnostics_output}, session)) return cannot_start;
  auto viewer = std::make_unique<viewing::Viewer>(std::move(view));
  if (serve) viewer->serve(1);
  if (!viewer->load(session)) return cannot_start;
  if (serve) return viewing::serve(*viewer, static_cast<std::uint16_t>(port), session);
  const std::string page = viewer->page(session);
  const int status = viewer->status();
  keep_to_the_end(std::move(viewer));
  if (output.empty() || output == "-") return print(page, status);
  return write_file(output, page, session) ? status : cannot_start;
}

}  // namespace

int view_command(const Arguments& arguments) {
  CommandLine line(
      "view",
      "Shows the path of a program in a page of its own: in 3D with a time line, the program beside it, what "
      "each line does, and what was reported. The page is one file that needs no network.",
      "isogloss view part.nc -o part.html\n"
      "  isogloss view part.nc -a fanuc -b syntec -o both.html\n"
      "  isogloss view part.nc -m vmc850 --serve");
  ViewCommand command;
  command.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  // A server connects: is_usage_sound() refuses it.
  const bool is_refused = command.serve && command.untrusted.on;
  const auto done = is_refused ? std::nullopt : enter_untrusted(command.untrusted, command.untrusted_work());
  return done ? *done : command.run();
}

}  // namespace isogloss::cli
