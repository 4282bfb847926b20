#include "batch/children.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <list>
#include <optional>
#include <set>
#include <thread>

#include "noted_signals.hpp"
#include "process_use.hpp"
#include "stopped_time.hpp"

namespace isogloss::cli::batch {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

struct Child {
  pid_t process = 0;
  std::size_t work = 0;
  std::array<int, 2> pipes{-1, -1};  // its standard output and standard error
  Clock::time_point begin = Clock::now(), silent_since{};
  ChildEnd end;

  bool is_heard() const { return pipes[0] >= 0 || pipes[1] >= 0; }
};

void close_pipe(int& pipe) {
  if (pipe >= 0) ::close(pipe);
  pipe = -1;
}

bool start(Child& child, const std::vector<std::string>& words) {
  int out[2], errors[2];
  if (::pipe2(out, O_CLOEXEC) != 0) return child.end.number = errno, false;
  if (::pipe2(errors, O_CLOEXEC) != 0) {
    child.end.number = errno;
    ::close(out[0]), ::close(out[1]);
    return false;
  }
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, out[1], STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, errors[1], STDERR_FILENO);
  // In a group of its own, so that Ctrl-C on a terminal is heard here alone, and no child is taken for one that
  // crashed.
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));  // which spawn keeps
  arguments.push_back(nullptr);
  child.end.number = ::posix_spawn(&child.process, "/proc/self/exe", &actions, &attributes, arguments.data(), environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(out[1]), ::close(errors[1]);
  child.pipes = {out[0], errors[0]};
  for (const int pipe : child.pipes) ::fcntl(pipe, F_SETFL, O_NONBLOCK);
  return child.end.number == 0;
}

/// Reads what is there, but not for ever from one that writes without an end; closes the pipe at its end.
void hear(Child& child, std::size_t which) {
  constexpr std::size_t most_errors = 1u << 16, most_out = 1u << 24;
  std::string& text = which == 0 ? child.end.out : child.end.errors;
  const std::size_t most = which == 0 ? most_out : most_errors;
  constexpr int most_reads = 64;
  char buffer[1u << 14];
  for (int i = 0; i < most_reads; ++i) {
    const ssize_t n = ::read(child.pipes[which], buffer, sizeof buffer);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 && errno == EAGAIN) return;
    if (n <= 0) return close_pipe(child.pipes[which]);
    text.append(buffer, std::min(static_cast<std::size_t>(n), most - std::min(most, text.size())));
  }
}

std::vector<pid_t> children_of(const std::string& process) {
  std::vector<pid_t> out;
  std::error_code error;
  for (fs::directory_iterator thread("/proc/" + process + "/task", error), end; !error && thread != end;
       thread.increment(error)) {
    std::ifstream children(thread->path() / "children");
    for (pid_t one = 0; children >> one;) out.push_back(one);
  }
  return out;
}

/// With what it has started: under --untrusted the work is done there.
std::uint64_t resident_mib(pid_t process) {
  std::uint64_t out = use_of(process).resident_mib;
  for (const pid_t one : children_of(std::to_string(process))) out += resident_mib(one);
  return out;
}

/// With what it has started and left in its group.
void kill_all_of(const Child& child) { ::kill(-child.process, SIGKILL); }

/// The process stays a zombie, so that its number stays its own.
bool has_ended(const Child& child) {
  siginfo_t info{};
  return ::waitid(P_PID, static_cast<id_t>(child.process), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid != 0;
}

/// Kills a child that has used up what it may. One that has ended kept its limits, even where this process was stopped
/// meanwhile and looks late.
void hold(Child& child, const ChildLimits& limits) {
  if (child.end.how != ChildEnd::How::exited || has_ended(child)) return;
  const bool is_late = limits.seconds != 0 && Clock::now() - child.begin >= std::chrono::seconds(limits.seconds);
  const bool is_large = limits.memory_mib != 0 && resident_mib(child.process) > limits.memory_mib;
  if (!is_late && !is_large) return;
  child.end.how = is_late ? ChildEnd::How::out_of_time : ChildEnd::How::out_of_memory;
  kill_all_of(child);
}

void wait_for(Child& child) {
  int status = 0;
  while (::waitpid(child.process, &status, 0) < 0 && errno == EINTR) {
  }
  if (child.end.how != ChildEnd::How::exited) return;
  if (WIFSIGNALED(status)) child.end.how = ChildEnd::How::killed_by_signal;
  child.end.number = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
}

/// Its pipes may be open still, where it has started others: what they print is no result.
void end(Child& child) {
  for (std::size_t which = 0; which < 2; ++which)
    if (child.pipes[which] >= 0) hear(child, which);
  kill_all_of(child);
  for (int& pipe : child.pipes) close_pipe(pipe);
  wait_for(child);
}

/// For at most `milliseconds`, and hardly at all where a child has just closed its pipes: it is about to end.
void hear_all(std::list<Child>& children, int milliseconds) {
  constexpr auto time_to_end = std::chrono::milliseconds(100);
  std::vector<pollfd> waited;
  std::vector<std::pair<Child*, std::size_t>> whose;
  for (Child& child : children) {
    for (std::size_t which = 0; which < 2; ++which)
      if (child.pipes[which] >= 0) {
        waited.push_back({child.pipes[which], POLLIN, 0});
        whose.emplace_back(&child, which);
      }
    if (!child.is_heard() && Clock::now() - child.silent_since < time_to_end) milliseconds = 1;
  }
  if (::poll(waited.data(), waited.size(), milliseconds) <= 0) return;
  for (std::size_t i = 0; i < waited.size(); ++i)
    if (waited[i].revents != 0) hear(*whose[i].first, whose[i].second);
}

/// What a program has started and moved to a group of its own becomes a child of this process when its parent ends.
/// Such a process belongs to no program that is at work: it is killed.
class Orphans {
 public:
  Orphans() {
    ::prctl(PR_GET_CHILD_SUBREAPER, &before_);
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    const std::vector<pid_t> others = children_of("self");
    others_.insert(others.begin(), others.end());
  }
  ~Orphans() {
    // Each one that dies may leave its own children here.
    constexpr auto most_time = std::chrono::seconds(5);
    for (const auto begin = Clock::now(); kill_all({}) && Clock::now() - begin < most_time;)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ::prctl(PR_SET_CHILD_SUBREAPER, before_);
  }
  Orphans(const Orphans&) = delete;
  Orphans& operator=(const Orphans&) = delete;

  /// True: there were any.
  bool kill_all(const std::list<Child>& children) const {
    bool were_any = false;
    for (const pid_t process : children_of("self")) {
      const auto is_it = [&](const Child& child) { return child.process == process; };
      if (others_.contains(process) || std::any_of(children.begin(), children.end(), is_it)) continue;
      were_any = true;
      ::kill(process, SIGKILL);
      ::waitpid(process, nullptr, WNOHANG);
    }
    return were_any;
  }

 private:
  int before_ = 0;
  std::set<pid_t> others_;  // which this process had already
};

}  // namespace

bool Children::run(unsigned most, const ChildLimits& limits, const Next& next, const Ended& ended) {
  constexpr int tick_ms = 100;  // how exact the limits are
  const NotedSignals signals;
  std::optional<Orphans> orphans(std::in_place);
  std::list<Child> children;
  std::optional<Child> waiting;  // that the system did not start beside the others
  std::vector<std::string> words;
  auto last_look = Clock::now();
  // Of the processor, on programs and results, since the last look: the children run meanwhile. The clock would count a
  // stop that comes there as work.
  Clock::duration at_work{0};
  const auto take_time = [&](const auto& work) {
    const std::clock_t begin = std::clock();
    work();
    at_work += std::chrono::microseconds((std::clock() - begin) * 1'000'000 / CLOCKS_PER_SEC);
  };
  const auto fill = [&] {
    while (NotedSignals::last() == 0 && children.size() < most) {
      if (!waiting) {
        waiting.emplace();
        take_time([&] { words = next(waiting->work); });
      }
      if (words.empty()) return waiting.reset();
      waiting->begin = Clock::now();
      if (start(*waiting, words)) {
        children.push_back(std::move(*waiting));
      } else {
        for (int& pipe : waiting->pipes) close_pipe(pipe);
        if (!children.empty()) return;
        waiting->end.how = ChildEnd::How::not_started;
        ended(waiting->work, std::move(waiting->end));
      }
      waiting.reset();
    }
  };
  for (fill(); !children.empty(); fill()) {
    if (NotedSignals::last() != 0)
      for (const Child& child : children) kill_all_of(child);
    hear_all(children, tick_ms);
    if (Clock::now() - last_look >= std::chrono::milliseconds(tick_ms)) {
      const auto stopped = time_stopped(last_look + at_work, std::chrono::milliseconds(tick_ms));
      for (Child& child : children) {
        child.begin = std::min(child.begin + stopped, Clock::now());  // it may have begun behind the stop
        hold(child, limits);
      }
      orphans->kill_all(children);
      last_look = Clock::now();
      at_work = {};
    }
    for (auto child = children.begin(); child != children.end();) {
      if (!has_ended(*child)) {
        if (!child->is_heard() && child->silent_since == Clock::time_point{}) child->silent_since = Clock::now();
        ++child;
        continue;
      }
      end(*child);
      if (NotedSignals::last() == 0) take_time([&] { ended(child->work, std::move(child->end)); });
      child = children.erase(child);
    }
  }
  orphans.reset();  // which may take a while: a signal still counts
  return NotedSignals::last() == 0;
}

void end_with_parent(std::uint64_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (static_cast<std::uint64_t>(::getppid()) != parent) ::_exit(0);  // it was gone before that
}

}  // namespace isogloss::cli::batch
