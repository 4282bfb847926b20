#include "batch/program_work.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "batch/content_hash.hpp"
#include "batch/journal.hpp"
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

UntrustedWork untrusted_work_of(const BatchArguments& arguments) {
  UntrustedWork out = untrusted_work(arguments.common, arguments.program);
  out.common.diagnostics = "text";
  out.outputs.clear();
  out.programs.push_back(arguments.work);
  out.memory_mib = arguments.budgets.memory_mib;
  out.output_bytes = arguments.budgets.output_bytes;
  return out;
}

/// A little more time and memory than the batch allows, which it can tell more of when it ends the work itself.
std::optional<int> enter_untrusted(const BatchArguments& arguments) {
  UntrustedOptions options = arguments.untrusted;
  if (options.on) options.seconds = arguments.maximum_seconds == 0 ? 0 : arguments.maximum_seconds + 2;
  UntrustedWork work = untrusted_work_of(arguments);
  work.memory_mib += work.memory_mib / 2;
  return cli::enter_untrusted(options, work);
}

/// Deeper JSON than a result is would exhaust the stack of whoever writes it again, and an object of more names would
/// take hours, since each one is looked for among those before it.
bool is_too_large(std::string_view json) {
  constexpr std::size_t deepest = 100, most_names = 1'000;
  std::vector<std::size_t> names;  // of the objects and lists that are open
  bool is_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (is_text && c == '\\') ++i;
    if (c == '"') is_text = !is_text;
    if (is_text) continue;
    if (c == '[' || c == '{') names.push_back(0);
    if (c == ':' && !names.empty()) ++names.back();
    if (names.size() > deepest || (!names.empty() && names.back() > most_names)) return true;
    if ((c == ']' || c == '}') && !names.empty()) names.pop_back();
  }
  return false;
}

}  // namespace

int do_work(const BatchArguments& arguments) {
  end_with_parent(arguments.parent);
  if (const auto done = enter_untrusted(arguments)) return *done;
  // What a plugin prints is no result.
  const int out = ::dup(STDOUT_FILENO);
  if (out < 0 || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return cannot_start;
  RunArguments request;
  request.common = arguments.common;
  request.common.diagnostics = "json";
  request.common.diagnostics_output.clear();
  request.common.tells_missing_folders = false;
  request.program = arguments.program;
  request.budgets = arguments.budgets;
  request.emit = "none";
  request.summary = true;
  Session session(request.common);
  FirstSaid first;
  session.report_to([&](std::string_view lines) { first.hear(lines); });
  watch_calls(request.program.watchdog);
  std::optional<RunOptions> options = request.program.make(session);
  std::map<std::string, std::string> called;
  std::map<std::string, Work::Searched> places;
  int status = cannot_start;
  Json summary;
  if (options) {
    options->called = [&](std::string_view, const std::string& file) { called.emplace(file, state_of(file)); };
    options->searched = [&](const std::vector<std::string>& in, bool inside_files) {
      for (const std::string& place : in) {
        Work::Searched& known = places.try_emplace(place, Work::Searched{state_of(place)}).first->second;
        if (!inside_files || known.inside) continue;
        known.inside = true;
        // One that has changed since its names were read keeps a state that it no longer has.
        if (known.state == state_of(place)) known.state = state_of_place(place, true);
      }
    };
    request.takes_summary = [&](const std::string& program, const std::string& dialect, const Summary& totals) {
      summary = Json::parse(summary_json(program, dialect, totals, session.diagnostics()), nullptr, false);
    };
    const std::unique_ptr<OutputFile> nowhere = OutputFile::standard_output();
    Runs runs(request, session, *options, nowhere.get());
    status = runs.run(arguments.work);
  }
  // Lists, since a program may call more files than an object should have names.
  Json::array_t called_files, searched_places;
  for (const auto& [file, state] : called) called_files.push_back(Json::array({text_of_name(file), state}));
  for (const auto& [place, how] : places)
    searched_places.push_back(Json::array({text_of_name(place), how.state, how.inside}));
  const Json all{{"Summary", std::move(summary)},
                 {"First", first.said()},
                 {"Called", std::move(called_files)},
                 {"Places", std::move(searched_places)}};
  std::fflush(nullptr);
  if (::dup2(out, STDOUT_FILENO) < 0) return cannot_start;
  return print(all.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n", status);
}

std::optional<Work> read_work(const std::string& written) {
  const std::string_view line = std::string_view(written).substr(0, written.find('\n'));
  if (is_too_large(line)) return std::nullopt;
  try {
    const Json all = Json::parse(line);
    Work out{all.at("Summary"), all.at("First"), {}, {}};
    for (const Json& one : all.at("Called").get<Json::array_t>())
      out.called[name_of_text(one.at(0).get<std::string>())] = one.at(1).get<std::string>();
    for (const Json& one : all.at("Places").get<Json::array_t>())
      out.places[name_of_text(one.at(0).get<std::string>())] = {one.at(1).get<std::string>(), one.at(2).get<bool>()};
    return out;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace isogloss::cli::batch
