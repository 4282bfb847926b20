// What a plugin leaves in the process: threads, processes, files, and settings that belong to everyone.
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "crash_guard.hpp"
#include "validate/child.hpp"
#include "validate/process_state.hpp"
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
  const ProcessState before;
  work_with_everything(e);
  for (const std::string& change : before.changes()) e.find("", change);
}

}  // namespace isogloss::cli
