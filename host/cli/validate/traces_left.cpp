// What a plugin leaves in the process: threads, processes, files, and settings that belong to everyone.
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cfenv>
#include <cfloat>
#include <chrono>
#include <clocale>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <map>
#include <thread>

#include "crash_guard.hpp"
#include "validate/child.hpp"
#include "validate/subject.hpp"

namespace isogloss::cli {

namespace fs = std::filesystem;

namespace {

/// Loads, creates, builds on all blocks, and destroys.
void work_with_everything(Examination& e) {
  constexpr std::uint64_t random_ones = 50;
  Subject subject(e);
  for (const Stand& stand : stands_of(subject, e)) {
    Bench bench(stand.alone, {});
    bench.start();
    for (const TestBlock& block : many_blocks(stand, e, random_ones)) {
      e.attempt(std::string(stand.syntax->id) + ", " + block.name);
      bench.run(block, false);
    }
  }
  e.attempt("after all chains are destroyed");
}

/// How many entries such a folder of the system has; 0 where there is none.
std::size_t entries_of(const char* folder) {
  std::error_code error;
  std::size_t out = 0;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) ++out;
  return out;
}

constexpr const char* threads_of_process = "/proc/self/task";
constexpr const char* files_of_process = "/proc/self/fd";

/// A thread that is about to end has this long.
std::size_t threads_after(std::size_t expected) {
  std::size_t now = entries_of(threads_of_process);
  for (int i = 0; i < 50 && now > expected; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    now = entries_of(threads_of_process);
  }
  return now;
}

bool has_children() {
  siginfo_t info{};
  return waitid(P_ALL, 0, &info, WEXITED | WNOHANG | WNOWAIT) == 0;
}

std::string signals_held_back() {
  sigset_t set;
  sigemptyset(&set);
  pthread_sigmask(SIG_BLOCK, nullptr, &set);
  std::string out;
  for (int number = 1; number < NSIG; ++number)
    if (sigismember(&set, number) == 1) out += fmt::format("{}{}", out.empty() ? "" : " ", number);
  return out.empty() ? "none" : out;
}

std::string open_files_allowed() {
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  return std::to_string(limit.rlim_cur);
}

/// Settings of the process, by what people call them.
std::map<std::string, std::string> settings_of_process() {
  std::map<std::string, std::string> out;
  std::error_code error;
  out["the locale"] = std::setlocale(LC_ALL, nullptr);
  out["the locale of C++ streams"] = std::locale().name();
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view one = *variable;
    const std::size_t end = std::min(one.find('='), one.size());
    out["the environment variable " + std::string(one.substr(0, end))] = one.substr(std::min(end + 1, one.size()));
  }
  out["the arithmetic faults that end the process"] = std::to_string(fegetexcept());
  out["the signals that are held back"] = signals_held_back();
  out["the number of files that may be open"] = open_files_allowed();
  out["the rounding mode"] = std::to_string(std::fegetround());
  out["the working folder"] = fs::current_path(error).string();
  const mode_t mask = umask(0);
  umask(mask);
  out["the mask of file permissions"] = fmt::format("{:03o}", static_cast<unsigned>(mask));
  const volatile double least = DBL_MIN;
  out["the arithmetic of very small numbers"] = least / 2 == 0 ? "they are rounded to 0" : "they are kept";
  for (int number = 1; number < NSIG; ++number) {
    struct sigaction action {};
    if (sigaction(number, nullptr, &action) != 0) continue;
    out[fmt::format("the handler of signal {}", number)] =
        action.sa_handler == SIG_DFL   ? "the default"
        : action.sa_handler == SIG_IGN ? "none"
                                       : fmt::format("{}", reinterpret_cast<const void*>(action.sa_handler));
  }
  return out;
}

}  // namespace

void check_leaves_nothing(Examination& e) {
  const std::size_t threads = entries_of(threads_of_process), files = entries_of(files_of_process);
  const bool had_children = has_children();
  work_with_everything(e);
  if (const std::size_t now = threads_after(threads); now > threads)
    e.find("", fmt::format("{} of its threads go on after its chains are destroyed", now - threads));
  if (const std::size_t now = entries_of(files_of_process); now > files)
    e.find("", fmt::format("{} files that it opened are left open", now - files));
  if (!had_children && has_children()) e.find("", "a process that it started is left");
}

void check_end(Examination& e) {
  if (!e.may_fork) return e.remark("not looked at: the end of the process would end the command");
  const bool survived = survives(e, [&] {
    work_with_everything(e);
    expect_end();
    std::exit(success);  // not end_process(): functions of atexit() and static objects run here
  });
  if (!survived) e.find("", "it crashes or does not return when the process ends, after its chains are destroyed");
}

void check_process_state(Examination& e) {
  const std::map<std::string, std::string> before = settings_of_process();
  work_with_everything(e);
  const std::map<std::string, std::string> after = settings_of_process();
  const auto of = [](const std::map<std::string, std::string>& all, const std::string& what) {
    const auto found = all.find(what);
    return found == all.end() ? "not set" : found->second;
  };
  std::map<std::string, std::string> both = before;
  both.insert(after.begin(), after.end());
  for (const auto& [what, value] : both)
    if (of(before, what) != of(after, what))
      e.find("", fmt::format("it changes {}: {} was {}", what, of(after, what), of(before, what)));
}

}  // namespace isogloss::cli
