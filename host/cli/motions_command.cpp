// Reads what `run --emit motions --format binary` has written, and writes it as text.
#include "isogloss/engine/motion_stream.hpp"

#include "command.hpp"
#include "isogloss/engine/runner.hpp"
#include "output_file.hpp"
#include "outputs.hpp"
#include "session.hpp"

namespace isogloss::cli {

namespace {

struct MotionsCommand {
  CommonOptions common;
  std::string stream, format = "csv", output;
  bool exact = false;

  int run() const;
};

int MotionsCommand::run() const {
  Session session(common);
  if (!are_apart({stream}, {output, common.diagnostics_output}, session)) return cannot_start;
  std::error_code code;
  std::string error = std::filesystem::is_directory(stream, code) ? "it is a folder" : "";
  const std::unique_ptr<Source> source = error.empty() ? open_file(stream, error) : nullptr;
  if (source == nullptr) {
    session.report("IG-0510", {stream}, {error});
    return cannot_start;
  }
  const std::unique_ptr<OutputFile> file =
      output.empty() ? OutputFile::standard_output() : OutputFile::open(output, error);
  if (file == nullptr) {
    session.report("IG-0511", {output}, {error});
    return cannot_start;
  }
  MotionOptions options;
  options.format = format == "jsonl" ? Format::jsonl : format == "text" ? Format::text : Format::csv;
  options.exact = exact;
  convert_motions(*source, stream, *file, options, session.diagnostics());
  // Half a table shall not replace a whole one, and what is no stream makes no table, either.
  const bool is_file = !output.empty() && output != "-";
  const bool is_no_stream = session.diagnostics().by_code().contains("IG-0640");
  if ((is_file || is_no_stream) && session.diagnostics().errors() > 0) return session.status();
  if (file->commit() || file->reader_is_gone()) return session.status();
  session.report("IG-0511", {output.empty() ? "standard output" : output}, {file->error()});
  return cannot_start;
}

}  // namespace

int motions_command(const Arguments& arguments) {
  CommandLine line("motions",
                   "Reads a binary motion stream and writes it as text: the bytes that `isogloss run --emit motions` "
                   "writes itself.",
                   "isogloss run part.nc --emit motions --format binary -o part.igm\n"
                   "  isogloss motions part.igm --format csv\n"
                   "  isogloss run part.nc --format binary | isogloss motions -");
  MotionsCommand command;
  line.option("FILE", command.stream, "A binary motion stream; - is standard input").required();
  line.option("--format", command.format, "Form of the output")
      .one_of({"csv", "jsonl", "text"})
      .type_name("csv|jsonl|text")
      .shows_default();
  line.flag_for("--format", command.format, "jsonl", "--json", ": one JSON object a line (schemas/motion.schema.json)");
  line.option("-o,--output", command.output, "Write to a file, which appears only when it is complete")
      .type_name("FILE");
  line.flag("--exact", command.exact, "Numbers that read back to the same value instead of 6 decimals");
  command.common.add_to(line);
  if (const auto done = line.parse(arguments)) return *done;
  return command.run();
}

}  // namespace isogloss::cli
