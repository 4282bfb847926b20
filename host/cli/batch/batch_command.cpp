// `isogloss batch`: many programs on all cores, each in a process of its own; their results in the order of their
// names.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <thread>

#include "batch/journal.hpp"
#include "batch/results.hpp"
#include "batch/run_surroundings.hpp"
#include "batch/slurm.hpp"
#include "outputs.hpp"

namespace isogloss::cli {

namespace batch {

namespace {

/// "2/8"; empty where it is none.
std::optional<Shard> read_shard(const std::string& text) {
  Shard out;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, out.number);
  if (number.ec != std::errc() || number.ptr == end || *number.ptr != '/') return std::nullopt;
  const auto count = std::from_chars(number.ptr + 1, end, out.count);
  const bool is_read = count.ec == std::errc() && count.ptr == end;
  return is_read && out.number >= 1 && out.number <= out.count ? std::optional(out) : std::nullopt;
}

bool is_killed_by_others(const ChildEnd& end) {
  return end.how == ChildEnd::How::killed_by_signal &&
         (end.number == SIGKILL || end.number == SIGTERM || end.number == SIGINT || end.number == SIGHUP);
}

/// Without links, also where the end of the path does not exist; an empty one is this folder.
std::filesystem::path real_path(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(path.empty() ? "." : path, error);
  return std::filesystem::weakly_canonical(whole, error);
}

void say(const std::string& line) { std::fputs((line + "\n").c_str(), stderr); }

class Batch {
 public:
  Batch(const BatchArguments& arguments, Session& session)
      : arguments_(arguments),
        session_(session),
        limits_{arguments.maximum_seconds, arguments.budgets.memory_mib + arguments.budgets.memory_mib / 4} {}
  int run();

 private:
  int do_part(const std::vector<std::string>& programs);
  bool take_over(const std::string& program);
  bool do_rest();
  std::string changed_file();
  bool has_changed(std::size_t number, const std::optional<Work>& work);
  std::vector<std::string> arguments_for(const std::string& program) const;
  bool finish(std::size_t number, const ChildEnd& end);
  void find_common_folders();
  bool is_own(const std::filesystem::path& folder, const std::string& file) const;
  void keep(const Finished& finished);
  int write_results(const std::vector<std::string>& programs);

  const BatchArguments& arguments_;
  Session& session_;
  ChildLimits limits_;  // of memory a quarter more than a run allows itself, which can tell more
  Surroundings surroundings_;
  std::set<std::filesystem::path> common_folders_;  // that each program may read
  Journal journal_, before_;
  FileHashes hashes_;
  std::map<std::string, const Finished*> done_;
  std::vector<std::string> rest_;
  struct Begun {
    std::string state, content;
  };
  std::map<std::size_t, Begun> begun_;           // programs of rest_ as they were when they began
  std::map<std::string, unsigned> begun_again_;  // how often, because of what has changed meanwhile
  std::set<std::string> killed_;                 // once, by others
  std::string changed_;                          // file of the surroundings: all has to begin anew
  std::string fault_;                            // that lets nothing go on
};

int Batch::run() {
  std::optional<Surroundings> surroundings = surroundings_of(arguments_, hashes_, session_);
  const std::optional<ProgramList> list = surroundings ? list_programs(arguments_.places, session_) : std::nullopt;
  if (!list) return cannot_start;
  surroundings_ = std::move(*surroundings);
  if (arguments_.untrusted.on) find_common_folders();
  if (list->left_out != 0) session_.report("IG-0671", {}, {std::to_string(list->left_out)});
  journal_.read(arguments_.output);
  for (const std::string& folder : arguments_.changed_since)
    if (!before_.read(folder)) session_.report("IG-0677", {folder}, {});
  if (const std::uint64_t damaged = journal_.damaged_lines() + before_.damaged_lines(); damaged != 0)
    session_.report("IG-0672", {arguments_.output}, {std::to_string(damaged)});
  if (!arguments_.merges) {
    const auto part = part_of(list->programs, arguments_.shard.number, arguments_.shard.count);
    if (const int status = do_part(part); status != success) return status;
    if (arguments_.shard.count > 1) {
      say(fmt::format("part {} of {} is finished: {}; --merge writes the results of all parts", arguments_.shard.number,
                      arguments_.shard.count, programs_in_words(part.size())));
      return session_.status();
    }
  }
  return write_results(list->programs);
}

int Batch::do_part(const std::vector<std::string>& programs) {
  if (const std::string error = journal_.open(arguments_.output); !error.empty()) {
    session_.report("IG-0511", {arguments_.output}, {error});
    return cannot_start;
  }
  constexpr int most_times = 3;
  for (int times = 1;; ++times) {
    rest_.clear();
    for (const std::string& program : programs)
      if (!take_over(program)) rest_.push_back(program);
    if (const std::size_t done = programs.size() - rest_.size(); done != 0)
      say(fmt::format("{} of {} programs were finished before and have not changed", done, programs.size()));
    const bool is_done = do_rest();
    session_.progress().hide();
    if (fault_.empty() && !journal_.is_kept()) fault_ = "its folder was moved or its journal removed meanwhile";
    if (fault_.empty() && !changed_.empty() && times == most_times) fault_ = changed_ + " changes again and again";
    if (!fault_.empty()) {
      session_.report("IG-0675", {arguments_.output}, {fault_});
      return cannot_start;
    }
    if (!is_done) {
      say("ended by a signal: what is finished is kept, and the same command goes on from there");
      return cannot_start;
    }
    if (changed_.empty()) return success;
    say(changed_ + " has changed since the batch began: it begins anew");
    changed_.clear();
    done_.clear();
    hashes_ = {};
    std::optional<Surroundings> surroundings = surroundings_of(arguments_, hashes_, session_);
    if (!surroundings) return cannot_start;
    surroundings_ = std::move(*surroundings);
    if (arguments_.untrusted.on) find_common_folders();
  }
}

/// True: the program is finished.
bool Batch::take_over(const std::string& program) {
  const auto is_taken = [&](const Finished* finished) {
    return finished != nullptr && !(arguments_.retries && finished->is_failure);
  };
  if (const Finished* const known = journal_.find(program, surroundings_.hash, hashes_); is_taken(known)) {
    done_[program] = known;
    return true;
  }
  const Finished* const old = before_.find(program, surroundings_.hash, hashes_);
  if (!is_taken(old)) return false;
  keep(*old);
  return true;
}

bool Batch::do_rest() {
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  std::size_t begun = 0, done = 0;
  const auto next = [&](std::size_t& work) {
    if (begun == rest_.size() || !fault_.empty() || !changed_.empty()) return std::vector<std::string>();
    work = begun++;
    std::string state = state_of(rest_[work]);
    begun_[work] = {std::move(state), hashes_.of_now(rest_[work])};
    return arguments_for(rest_[work]);
  };
  const auto ended = [&](std::size_t work, const ChildEnd& end) {
    if (end.how == ChildEnd::How::not_started) {
      fault_ = "no process can be started: " + std::string(std::strerror(end.number));
      return;
    }
    if (changed_.empty()) changed_ = changed_file();
    if (!changed_.empty()) return;
    // Whoever has killed it may be about to kill this process as well, and then it has not crashed.
    const bool is_first_kill = is_killed_by_others(end) && killed_.insert(rest_[work]).second;
    if (is_first_kill || !finish(work, end)) {
      rest_.push_back(rest_[work]);
      return;
    }
    session_.progress().show(++done, rest_.size(), rest_[work]);
  };
  return Children::run(arguments_.jobs == 0 ? cores : arguments_.jobs, limits_, next, ended);
}

/// Of the machine, the dialect, the tables or the plugins one that is not what it was. A result may be of either.
std::string Batch::changed_file() {
  for (const auto& [file, hash] : surroundings_.files)
    if (hashes_.of_now(file) != hash) return file;
  return {};
}

std::vector<std::string> Batch::arguments_for(const std::string& program) const {
  std::vector<std::string> out{"isogloss", "batch", "--parent", std::to_string(::getpid()), "--work", program};
  out.insert(out.end(), arguments_.given.begin(), arguments_.given.end());
  return out;
}

/// The program or one that it calls is not what it was when it was read.
bool Batch::has_changed(std::size_t number, const std::optional<Work>& work) {
  const Begun& begun = begun_[number];
  if (state_of(rest_[number]) != begun.state && hashes_.of_now(rest_[number]) != begun.content) return true;
  if (!work) return false;
  const auto is_other = [](const auto& file) { return state_of(file.first) != file.second; };
  const auto is_other_place = [](const auto& place) {
    return state_of_place(place.first, place.second.inside) != place.second.state;
  };
  return std::any_of(work->called.begin(), work->called.end(), is_other) ||
         std::any_of(work->places.begin(), work->places.end(), is_other_place);
}

/// False: it has to run once more.
bool Batch::finish(std::size_t number, const ChildEnd& end) {
  const std::string& program = rest_[number];
  std::optional<Work> work = end.how == ChildEnd::How::exited ? read_work(end.out) : std::nullopt;
  if (work && arguments_.untrusted.on) {
    const std::filesystem::path folder = real_path(std::filesystem::path(program).parent_path());
    std::erase_if(work->called, [&](const auto& file) { return !is_own(folder, file.first); });
    std::erase_if(work->places, [&](const auto& place) { return !is_own(folder, place.first); });
  }
  const Json result = result_of(program, end, work, limits_);
  Finished finished{program, surroundings_.hash, begun_[number].content, {}, {}, {}};
  if (work)
    for (const auto& [file, state] : work->called) finished.called[file] = hashes_.of_now(file);
  if (work)
    for (const auto& [place, how] : work->places) finished.places[place] = hashes_.of_place_now(place, how.inside);
  if (!work) {  // where it has looked for what it calls is not known
    for (const std::string& place : arguments_.program.subprograms)
      finished.places[place] = hashes_.of_place_now(place, false);
    const std::string folder = std::filesystem::path(program).parent_path().string();
    finished.places[folder] = hashes_.of_place_now(folder, false);
  }
  constexpr unsigned most_times = 3;
  if (has_changed(number, work)) {
    if (++begun_again_[program] < most_times) return false;
    finished.content = "changed while it ran";  // no hash: it runs again the next time
  }
  finished.result = result.dump(-1, ' ', false, Json::error_handler_t::replace);
  finished.is_failure = result["Status"] != "ok" && result["Status"] != "errors";
  keep(finished);
  return true;
}

/// Once: an archive has many programs, and the folders of dialects and plugins hold many files.
void Batch::find_common_folders() {
  std::set<std::string> folders(arguments_.program.subprograms.begin(), arguments_.program.subprograms.end());
  for (const auto& [file, hash] : surroundings_.files)
    if (!file.starts_with("/proc/")) folders.insert(std::filesystem::path(file).parent_path());
  common_folders_.clear();
  for (const std::string& folder : folders) common_folders_.insert(real_path(folder));
}

/// What a hostile plugin says that it has called is read here only where its program can have called it.
bool Batch::is_own(const std::filesystem::path& folder, const std::string& file) const {
  std::filesystem::path place = real_path(file);
  while (place != folder && !common_folders_.contains(place)) {
    if (place == place.parent_path()) return false;
    place = place.parent_path();
  }
  return true;
}

void Batch::keep(const Finished& finished) {
  std::string error;
  if (const Finished* const kept = journal_.append(finished, error))
    done_[finished.program] = kept;
  else
    fault_ = "the journal takes no more lines: " + error;
}

int Batch::write_results(const std::vector<std::string>& programs) {
  ResultFiles files;
  std::uint64_t missing = 0;
  int status = success;
  for (const std::string& program : programs) {
    // What has changed since it was run here runs the next time.
    const auto known = done_.find(program);
    const Finished* const finished =
        known != done_.end() ? known->second : journal_.find(program, surroundings_.hash, hashes_);
    if (finished == nullptr) {
      ++missing;
      continue;
    }
    const Json result = Json::parse(finished->result);
    status = std::max(status, status_of(result));
    files.add(result);
  }
  if (missing != 0) {
    session_.report("IG-0673", {arguments_.output}, {std::to_string(missing), std::to_string(programs.size())});
    return cannot_start;
  }
  if (!files.write(arguments_.output, session_)) return cannot_start;
  say(files.in_words() + "; " + (std::filesystem::path(arguments_.output) / "overview.html").string());
  return std::max(status, session_.status());
}

void add_to(CommandLine& line, BatchArguments& a) {
  line.option(
      "PLACE", a.places.places,
      "Programs, folders with all programs below them, and lists with the path of a program or folder in each line");
  line.option("--list", a.places.list,
              "A list whose first line may be a bare name, which PLACE takes for a program; - is standard input")
      .type_name("FILE");
  line.option("--include", a.places.include,
              "In folders, run only files whose name, or path below the folder, fits this pattern, e.g. '*.nc' "
              "(repeatable)")
      .type_name("PATTERN");
  line.option("--exclude", a.places.exclude,
              "In folders, run no files whose name, or path below the folder, fits this pattern (repeatable)")
      .type_name("PATTERN");
  line.option("-o,--output", a.output,
              "Folder for the results; programs that are finished there and have not changed do not run again")
      .type_name("FOLDER")
      .required();
  line.option("-j,--jobs", a.jobs, "How many programs run at once (0: as many as there are processors)")
      .type_name("N")
      .shows_default()
      .not_with("--merge");
  line.option("--shard", a.shard_text, "Run only part I of N, e.g. 2/8; --merge writes the results").type_name("I/N");
  line.option("--slurm", a.slurm_parts,
              "Submit N parts as a job array of Slurm, and a job that merges them (0: run here)")
      .at_least(0)
      .type_name("N");
  line.option("--slurm-options", a.slurm_options,
              "Options of sbatch for both jobs, e.g. '--partition=night --time=8:00:00'")
      .type_name("TEXT")
      .only_with("--slurm");
  line.flag("--no-submit", a.holds_back, "With --slurm: write the scripts, and submit nothing").only_with("--slurm");
  line.flag("--merge", a.merges, "Run nothing: write the results of all parts");
  line.option("--changed-since", a.changed_since,
              "Folder of an earlier batch: a program keeps its result from there where its text, called programs, "
              "options, tables, dialect and plugins have not changed (repeatable)")
      .type_name("FOLDER")
      .not_with("--merge");
  line.flag("--retry", a.retries, "Run again what crashed, ran out of time or memory, or could not run")
      .not_with("--merge");
  line.option("--max-time", a.maximum_seconds, "Stop a program that takes longer (0: never)")
      .type_name("SECONDS")
      .shows_default();
  a.program.add_to(line);
  a.budgets.add_to(line);
  a.untrusted.add_flag_to(line);
  line.option("--work", a.work).group("");
  line.option("--parent", a.parent).group("");
  a.common.add_to(line);
}

}  // namespace

}  // namespace batch

int batch_command(const Arguments& arguments) {
  auto line = std::make_unique<CommandLine>("batch",
                                            "Runs many programs on all cores and writes one result for each: "
                                            "results.jsonl, results.csv, results.xml (JUnit) and "
                                            "overview.html.",
                                            "isogloss batch archive -d fanuc --tools tools.xml -o results");
  batch::BatchArguments request;
  batch::add_to(*line, request);
  if (const auto done = line->parse(arguments)) return *done;
  keep_to_the_end(std::move(line));
  if (!request.work.empty()) return batch::do_work(request);
  request.given = arguments;
  request.places.results = request.output;
  request.places.are_strangers = request.untrusted.on;
  // What plugins do here nobody confines.
  CommonOptions common = request.common;
  common.loads_plugins = !request.untrusted.on;
  Session session(common);
  if (!request.shard_text.empty()) {
    const std::optional<batch::Shard> shard = batch::read_shard(request.shard_text);
    if (!shard || request.merges) {
      session.report("IG-0513", {},
                     {request.merges ? "--merge takes all parts: leave --shard out"
                                     : "--shard needs I/N such as 2/8, not '" + request.shard_text + "'"});
      return cannot_start;
    }
    request.shard = *shard;
  }
  if (request.places.places.empty() && request.places.list.empty()) {
    session.report("IG-0513", {}, {"batch needs programs: a folder, files, or --list FILE"});
    return cannot_start;
  }
  std::vector<std::string> inputs = request.program.files();
  inputs.insert(inputs.end(), request.places.places.begin(), request.places.places.end());
  inputs.push_back(request.places.list);
  if (!are_apart(inputs, {request.common.diagnostics_output}, session)) return cannot_start;
  if (request.slurm_parts != 0) {
    const bool is_piped = request.places.list == "-";
    if (request.merges || !request.shard_text.empty() || is_piped) {
      session.report("IG-0513", {},
                     {is_piped ? "the parts of --slurm cannot read standard input: --list needs a file"
                               : "--slurm makes parts and merges them: leave --shard and --merge out"});
      return cannot_start;
    }
    return batch::run_on_slurm(request, session);
  }
  return batch::Batch(request, session).run();
}

}  // namespace isogloss::cli
