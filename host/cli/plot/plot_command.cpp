// Draws the path of a program: three views and an isometric one, as SVG.
#include "output_file.hpp"
#include "outputs.hpp"
#include "plot/svg_page.hpp"
#include "sandbox/untrusted.hpp"

namespace isogloss::cli {

namespace {

struct PlotCommand {
  CommonOptions common;
  ProgramOptions program;
  ToolPathOptions drawn;
  UntrustedOptions untrusted;
  std::string path, output;

  int run();
};

int PlotCommand::run() {
  Session session(common);
  if (output.empty() || output == "-") session.progress().data_goes_to_stdout();
  std::vector<std::string> inputs = program.files();
  inputs.push_back(path);
  if (!is_name_of_svg(output, session) || !are_apart(inputs, {output, common.diagnostics_output}, session))
    return cannot_start;
  const std::unique_ptr<KeptProgram> kept = KeptProgram::open(path, session);
  if (kept == nullptr) return cannot_start;
  std::unique_ptr<PathRun> made = run_path(*kept, program, drawn, {}, session);
  if (made == nullptr) return cannot_start;
  if (made->path.extent.is_empty) session.report("IG-0651", {path}, {});
  const std::string page = plotting::svg_page(path, *made);
  session.diagnostics().finish_program();
  keep_to_the_end(std::move(made));
  if (output.empty() || output == "-") return print(page, session.status());
  return write_file(output, page, session) ? session.status() : cannot_start;
}

}  // namespace

int plot_command(const Arguments& arguments) {
  CommandLine line("plot",
                   "Draws the path of a program as a picture in SVG, the only form that it writes: from above, from "
                   "the front, from the right and "
                   "isometric; rapids dashed, feeds in the colour of their tool, with extents and scale.",
                   "isogloss plot part.nc -o part.svg\n"
                   "  isogloss plot part.nc -d fanuc --tools tools.xml | rsvg-convert -o part.png");
  PlotCommand command;
  line.option("PROGRAM", command.path, "The program; - is standard input").required();
  line.option("-o,--output", command.output, "Write to a file, PART.svg, which appears only when it is complete")
      .type_name("FILE");
  command.program.add_to(line);
  line.option("--max-moves", command.drawn.most_moves, "Stop after N moves, which the picture keeps in memory")
      .at_least(1)
      .type_name("N")
      .shows_default();
  command.untrusted.add_to(line);
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  UntrustedWork work = untrusted_work(command.common, command.program);
  work.programs.push_back(command.path);
  work.outputs.push_back(command.output);
  if (const auto done = enter_untrusted(command.untrusted, work)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
