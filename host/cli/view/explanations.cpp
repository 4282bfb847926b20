#include "view/explanations.hpp"

#include <chrono>
#include <stdexcept>

#include "asked_reports.hpp"
#include "explain/sentence.hpp"

namespace isogloss::cli::viewing {

Sentences explain_lines(const PathRun& run, const KeptProgram& program, const std::string& file, std::uint32_t first,
                        std::uint32_t last, std::size_t most, Session& session) {
  constexpr std::chrono::seconds patience{10};
  Sentences out;
  const std::unique_ptr<Source> source = program.source(session);
  if (source == nullptr) return out;
  ExplainTarget target;
  target.line = first;
  target.last_line = last;
  target.file = file;
  target.most_blocks = most;
  RunOptions options = run.options;
  options.progress = {};
  options.goes_on = [end = std::chrono::steady_clock::now() + patience] {
    return std::chrono::steady_clock::now() < end;
  };
  AskedReports said([&](const Diagnostic& d) { return d.where.line >= first && d.where.line <= last; });
  LineTexts lines;
  try {
    for (const ExplainedBlock& block : explain(*run.linked, *source, program.path(), target, options, said)) {
      const Facts facts(block, lines, said.all);
      std::string& text = out[block.where.line];
      // Several blocks may stand in one line.
      if (block.pass == 1 && text.size() < 1000)
        text += (text.empty() ? "" : " ") + sentence_of(facts, strokes_of(facts));
    }
  } catch (const std::runtime_error&) {
    out.clear();  // a syntax could not be created, which the run for the path has reported
  }
  return out;
}

}  // namespace isogloss::cli::viewing
