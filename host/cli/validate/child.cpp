#include "validate/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "crash_guard.hpp"

namespace isogloss::cli {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::string_view end_mark = "end\n";

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

void perform(const Check& check, Examination& e) {
  try {
    check.run(e);
  } catch (const std::exception& error) {
    e.find("", std::string("the check could not go on: ") + error.what());
  }
}

void limit(const ValidateOptions& options) {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  const rlim_t bytes = rlim_t{options.memory_limit} << 20;
  const rlimit memory{bytes, bytes};
  setrlimit(RLIMIT_AS, &memory);
#endif
  watch_calls(options.call_limit);
}

[[noreturn]] void be_child(const Check& check, const ValidateOptions& options, const std::string& file,
                           SharedText& attempt, int results, int talk) {
  dup2(talk, STDERR_FILENO);
  dup2(talk, STDOUT_FILENO);
  limit(options);
  std::size_t told = 0;
  const auto write = [&](const Json& line) {
    write_all(results, line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
  };
  Examination e(options, file, &attempt,
                {.find =
                     [&](const Finding& found) {
                       // The rest is only counted.
                       write(++told > Outcome::most_findings ? Json::array() : Json{found.where, found.what});
                     },
                 .remark = [&](const std::string& text) { write(Json::array({text})); },
                 .skip =
                     [&](const std::string& why) {
                       write(Json{{"skipped", why}});
                     }});
  perform(check, e);
  write_all(results, end_mark);
  end_process(success);
}

/// A process that stopped itself goes on for nobody: a child is not of the terminal's group.
bool child_has_stopped(pid_t child) {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(child), &info, WSTOPPED | WNOHANG | WNOWAIT) == 0 && info.si_pid == child;
}

/// Of a process, of those that it started, and of others of its group.
struct GroupWork {
  double done = 0;    ///< seconds of the processor, also for processes that have ended
  double wanted = 0;  ///< seconds for which those that live worked or waited for the processor
};

GroupWork work_of(pid_t child) {
  GroupWork out;
  std::error_code error;
  for (std::filesystem::directory_iterator it("/proc", error), end; !error && it != end; it.increment(error)) {
    std::ifstream file(it->path() / "stat");
    std::string line;
    if (!std::getline(file, line)) continue;
    const std::size_t name_end = line.rfind(')');
    if (name_end == std::string::npos) continue;
    std::istringstream rest(line.substr(name_end + 1));
    std::string word;
    std::vector<std::string> words;
    constexpr std::size_t group = 2, first_time = 11, times = 4;
    while (words.size() < first_time + times && rest >> word) words.push_back(word);
    if (words.size() < first_time + times) continue;
    if (it->path().filename() != std::to_string(child) && words[group] != std::to_string(child)) continue;
    for (std::size_t i = first_time; i < first_time + times; ++i) {
      std::uint64_t ticks = 0;
      std::from_chars(words[i].data(), words[i].data() + words[i].size(), ticks);
      out.done += static_cast<double>(ticks) / static_cast<double>(sysconf(_SC_CLK_TCK));
    }
    std::ifstream schedule(it->path() / "schedstat");
    double worked = 0, waited = 0;
    if (schedule >> worked >> waited) out.wanted += (worked + waited) / 1e9;
  }
  return out;
}

enum class Ending { complete, over, stopped, starved };

/// From the limit of time on, once a second: a check that sleeps waits for nothing, and one that has worked for so long
/// has had its time; on a busy machine it goes on.
class Deadline {
 public:
  Deadline(pid_t child, double limit) : child_(child), limit_(limit), next_(limit) {}
  double next() const { return next_; }

  std::optional<Ending> look(double passed) {
    constexpr double interval = 1, asleep = 0.02, most_patience = 6;
    const GroupWork now = work_of(child_);
    if (now.done >= limit_) return Ending::over;
    const double since = before_ < 0 ? -1 : now.wanted - before_;
    if (since >= 0 && since < asleep * interval) return Ending::over;
    if (passed >= most_patience * limit_) return Ending::starved;
    before_ = now.wanted;
    next_ = passed + interval;
    return std::nullopt;
  }

 private:
  pid_t child_;
  double limit_, next_;
  double before_ = -1;  // wanted at the last look; negative: there was none
};

/// The last of what a check writes: its end says how it ended.
void keep(std::string& text, std::string_view more) {
  constexpr std::size_t most_bytes = 16 << 20;
  text += more;
  if (text.size() > most_bytes) text.erase(0, text.size() - most_bytes / 2);
}

/// Reads both pipes until the child ends or stops, or to the time limit. Processes that the plugin started may hold
/// the pipes open for longer: they end with the child.
Ending listen(pid_t child, const int (&pipes)[2], std::string (&texts)[2], double seconds,
              const std::function<void()>& tell) {
  constexpr double interval = 0.02;
  const Clock::time_point begin = Clock::now();
  Deadline deadline(child, seconds);
  bool is_open[2] = {true, true};
  for (bool is_last = false; is_open[0] || is_open[1];) {
    tell();
    const double passed = seconds_since(begin);
    if (passed >= deadline.next())
      if (const std::optional<Ending> ending = deadline.look(passed)) return *ending;
    if (!is_last && child_has_stopped(child)) return Ending::stopped;
    const double left = deadline.next() - passed;
    pollfd polled[2] = {{is_open[0] ? pipes[0] : -1, POLLIN, 0}, {is_open[1] ? pipes[1] : -1, POLLIN, 0}};
    if (!is_last && child_has_ended(child)) {
      is_last = true;
      kill(-child, SIGKILL);
    }
    if (poll(polled, 2, is_last ? 0 : static_cast<int>(std::min(left, interval) * 1000) + 1) <= 0) {
      if (is_last) return Ending::complete;
      continue;
    }
    for (int i = 0; i < 2; ++i) {
      if (polled[i].revents == 0) continue;
      char buffer[4096];
      const ssize_t n = read(pipes[i], buffer, sizeof buffer);
      if (n <= 0)
        is_open[i] = false;
      else
        keep(texts[i], {buffer, static_cast<std::size_t>(n)});
    }
  }
  return Ending::complete;
}

/// What the crash guard told, or else the first line that the plugin wrote.
std::string reason(const std::string& text) {
  constexpr std::string_view ours = "isogloss: internal fault: ";
  constexpr std::size_t longest = 1000;
  const std::size_t at = text.rfind(ours);
  const std::string_view told = std::string_view(text).substr(at == std::string::npos ? 0 : at + ours.size());
  return std::string(told.substr(0, std::min(told.find('\n'), longest)));
}

/// For a process that told nothing.
std::string ending(int status) {
  if (!WIFSIGNALED(status)) return fmt::format("the process ended itself with exit status {}", WEXITSTATUS(status));
  return fmt::format("the process was ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)));
}

/// A process whose pipes are closed is about to end, as a rule.
bool ends_soon(pid_t child) {
  for (int i = 0; i < 50 && !child_has_ended(child); ++i) usleep(4000);
  return child_has_ended(child);
}

void add(Outcome& out, Finding finding) {
  if (out.findings.size() < Outcome::most_findings)
    out.findings.push_back(std::move(finding));
  else
    ++out.more;
}

void read_results(const std::string& text, Outcome& out) {
  for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    const Json line = Json::parse(text.substr(begin, end - begin), nullptr, false);
    if (line.is_object()) out.skipped = line.value("skipped", "");
    if (!line.is_array()) continue;
    if (line.size() == 2)
      add(out, {line[0].get<std::string>(), line[1].get<std::string>()});
    else if (line.size() == 1 && std::find(out.remarks.begin(), out.remarks.end(), line[0]) == out.remarks.end())
      out.remarks.push_back(line[0].get<std::string>());
    else
      ++out.more;
  }
}

}  // namespace

void write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = write(descriptor, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
}

bool child_has_ended(pid_t child) {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == child;
}

Outcome run_in_child(const Check& check, const ValidateOptions& options, const std::string& file,
                     const Watcher& watcher) {
  Outcome out{.check = &check};
  const Clock::time_point begin = Clock::now();
  int results[2], talk[2];
  if (pipe2(results, O_CLOEXEC) != 0 || pipe2(talk, O_CLOEXEC) != 0) throw std::runtime_error("no pipe for a check");
  SharedText attempt;
  const pid_t parent = getpid(), child = fork();
  if (child < 0) throw std::runtime_error("no process for a check");
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody else would end a check of a command that was stopped
    if (getppid() != parent) end_process(internal_fault);
    setpgid(0, 0);  // a process that the plugin starts ends with the check
    be_child(check, options, file, attempt, results[1], talk[1]);
  }
  setpgid(child, child);
  close(results[1]);
  close(talk[1]);
  std::string texts[2];
  const Ending how = listen(child, {results[0], talk[0]}, texts, options.time_limit, [&] { watcher(attempt.read()); });
  const bool has_told_all = texts[0].ends_with(end_mark);
  const bool is_complete = how == Ending::complete;
  const bool is_ours_to_end = is_complete && !has_told_all && !ends_soon(child);
  kill(-child, SIGKILL);
  kill(child, SIGKILL);  // it may have left its group
  int status = 0;
  waitpid(child, &status, 0);
  close(results[0]);
  close(talk[0]);
  read_results(texts[0], out);
  const std::string last = attempt.read();
  if (how == Ending::starved)
    out.skipped = fmt::format("it did not finish: the machine was busy for more than its {} s", options.time_limit);
  else if (how == Ending::stopped)
    add(out, {last, "the process stopped itself, as by SIGSTOP"});
  else if (!is_complete)
    add(out, {last, "the check took longer than " + std::to_string(options.time_limit) + " s"});
  else if (is_ours_to_end)
    add(out, {last, "the process closed its output and went on"});
  else if (!has_told_all)
    add(out, {last, texts[1].empty() ? ending(status) : reason(texts[1])});
  out.seconds = seconds_since(begin);
  return out;
}

Outcome run_here(const Check& check, const ValidateOptions& options, const std::string& file) {
  Outcome out{.check = &check};
  const Clock::time_point begin = Clock::now();
  watch_calls(0);  // a debugger may stop a call for longer than any limit
  Examination e(options, file, nullptr,
                {.find = [&](const Finding& found) { add(out, found); },
                 .remark = [&](const std::string& text) { out.remarks.push_back(text); },
                 .skip = [&](const std::string& why) { out.skipped = why; }});
  e.may_fork = false;
  perform(check, e);
  out.seconds = seconds_since(begin);
  return out;
}

bool survives(const Examination& e, const std::function<void()>& work) {
  if (!e.may_fork) {
    work();
    return true;
  }
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process for a block");
  if (child == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDERR_FILENO);
    watch_calls(e.options.call_limit);
    work();
    end_process(success);
  }
  int status = 0;
  waitpid(child, &status, WUNTRACED);
  if (WIFSTOPPED(status)) {
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
    return false;
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == success;
}

}  // namespace isogloss::cli
