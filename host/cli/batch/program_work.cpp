#include "batch/program_work.hpp"

#include <algorithm>

#include "crash_guard.hpp"
#include "run/runs.hpp"
#include "run/summary_text.hpp"

namespace isogloss::cli::batch {

namespace {

/// The first error, or else the first warning, of diagnostics that come as JSON Lines.
class FirstSaid {
 public:
  void hear(std::string_view lines) {
    while (!lines.empty() && rank_ < 3) {
      const std::string_view line = lines.substr(0, lines.find('\n'));
      lines.remove_prefix(std::min(lines.size(), line.size() + 1));
      const Json said = Json::parse(line, nullptr, false);
      if (!said.is_object()) continue;
      const std::string severity = said.value("Severity", "");
      const int rank = severity == "error" ? 3 : severity == "warning" ? 2 : 0;
      if (rank <= rank_) continue;
      rank_ = rank;
      said_ = said;
    }
  }
  const Json& said() const { return said_; }

 private:
  int rank_ = 0;
  Json said_;
};

}  // namespace

int do_work(const BatchArguments& arguments) {
  end_with_parent(arguments.parent);
  RunArguments request;
  request.common = arguments.common;
  request.common.diagnostics = "json";
  request.common.diagnostics_output.clear();
  request.program = arguments.program;
  request.budgets = arguments.budgets;
  request.emit = "none";
  request.summary = true;
  Session session(request.common);
  FirstSaid first;
  session.report_to([&](std::string_view lines) { first.hear(lines); });
  watch_calls(request.program.watchdog);
  std::optional<RunOptions> options = request.program.make(session);
  std::vector<std::string> called;
  int status = cannot_start;
  Json summary;
  if (options) {
    options->called = [&](std::string_view, const std::string& file) { called.push_back(file); };
    request.takes_summary = [&](const std::string& program, const std::string& dialect, const Summary& totals) {
      summary = Json::parse(summary_json(program, dialect, totals, session.diagnostics()), nullptr, false);
    };
    const std::unique_ptr<OutputFile> nowhere = OutputFile::standard_output();
    Runs runs(request, session, *options, nowhere.get());
    status = runs.run(arguments.work);
  }
  std::sort(called.begin(), called.end());
  called.erase(std::unique(called.begin(), called.end()), called.end());
  const Json out{{"Summary", std::move(summary)}, {"First", first.said()}, {"Called", called}};
  return print(out.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n", status);
}

std::optional<Work> read_work(const std::string& written) {
  const Json all = Json::parse(written, nullptr, false);
  if (!all.is_object() || !all.contains("Summary") || !all.contains("First") || !all.contains("Called")) return {};
  return Work{all["Summary"], all["First"], all["Called"].get<std::vector<std::string>>()};
}

}  // namespace isogloss::cli::batch
