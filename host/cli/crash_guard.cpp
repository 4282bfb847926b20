// Everything in the handlers is async-signal-safe: write(2), fork(2), execve(2), waitpid(2), clocks, timers and plain
// memory.
#include "crash_guard.hpp"

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string_view>

#include "command.hpp"
#include "isogloss/engine/chain.hpp"

namespace isogloss::cli {

namespace {

constexpr int crash_signals[] = {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL};
constexpr int end_signals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGXCPU, SIGUSR1, SIGUSR2};
constexpr unsigned seconds_for_reproducer = 20;

char** own_arguments = nullptr;
bool may_reproduce = false, is_confined = false;
const char* volatile temporaries[64] = {};  // more than a command opens at once
void (*write_here)() = nullptr;
volatile bool is_reporting = false, is_ending = false;

// Of the watch: how long a call may take, and the time that writing took, which is not the call's.
volatile std::uint64_t patience = 0, time_written = 0;
volatile int writers = 0;

// Of the lines that a signal must not tear. Motions are written by a thread of their own, which a signal may not reach
// by itself.
std::atomic<int> whole_lines = 0, waiting_signal = 0, waits_left = 0;
std::atomic<bool> has_ended = false;
pthread_t writing_thread;
constexpr suseconds_t wait_interval = 50'000;  // microseconds
constexpr int most_waits = 40;                 // how long a reader may take for the end of a line

std::uint64_t nanoseconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::uint64_t>(now.tv_sec) * 1'000'000'000 + static_cast<std::uint64_t>(now.tv_nsec);
}

void remove_temporaries() {
  for (const char* volatile& path : temporaries)
    if (path != nullptr) unlink(path);
}

/// Text in a fixed buffer, for a handler.
class Line {
 public:
  Line& operator<<(std::string_view text) {
    for (const char c : text)
      if (used_ + 1 < text_.size()) text_[used_++] = c;
    text_[used_] = '\0';
    return *this;
  }
  Line& operator<<(std::uint64_t number) {
    char digits[20];
    std::size_t n = 0;
    do {
      digits[n++] = static_cast<char>('0' + number % 10);
      number /= 10;
    } while (number != 0);
    while (n > 0) *this << std::string_view(&digits[--n], 1);
    return *this;
  }
  /// Text of a program or a plugin: control characters are shown as question marks.
  Line& show(std::string_view text) {
    for (const char c : text.substr(0, 200))
      *this << std::string_view(static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? "?" : &c, 1);
    return *this;
  }
  const char* text() const { return text_.data(); }
  void show() const { [[maybe_unused]] const ssize_t n = write(STDERR_FILENO, text_.data(), used_); }

 private:
  std::array<char, 4096> text_{};
  std::size_t used_ = 0;
};

std::string_view name_of(int number) {
  switch (number) {
    case SIGSEGV: return "segmentation fault";
    case SIGABRT: return "abort";
    case SIGFPE: return "arithmetic fault";
    case SIGBUS: return "bus error";
    case SIGILL: return "illegal instruction";
    default: return "no end in sight";
  }
}

/// Starts the same command again, which stops before the build that crashed and writes the case. True when it did.
bool write_reproducer(const Breadcrumb& crumb, const char* file) {
  static Line builds, line, program;
  builds << crumb.document->chain->builds;
  line << crumb.document->source.line;
  program << crumb.document->source.file;
  static std::array<char*, 4096> argv;
  static char name_option[] = "--reproducer", builds_option[] = "--reproducer-build";
  static char line_option[] = "--reproducer-line", program_option[] = "--reproducer-program";
  std::size_t n = 0;
  while (own_arguments[n] != nullptr && n + 9 < argv.size()) {
    argv[n] = own_arguments[n];
    ++n;
  }
  for (const char* extra :
       {static_cast<const char*>(name_option), file, static_cast<const char*>(builds_option), builds.text(),
        static_cast<const char*>(line_option), line.text(), static_cast<const char*>(program_option), program.text()})
    argv[n++] = const_cast<char*>(extra);  // execve does not write them
  argv[n] = nullptr;

  const pid_t child = fork();
  if (child < 0) return false;
  if (child == 0) {
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    alarm(seconds_for_reproducer);
    // The first run has written its diagnostics already.
    if (const int nowhere = open("/dev/null", O_WRONLY); nowhere >= 0) {
      dup2(nowhere, STDOUT_FILENO);
      dup2(nowhere, STDERR_FILENO);
    }
    execve("/proc/self/exe", argv.data(), environ);
    end_process(internal_fault);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == success;
}

/// The report itself crashed: nothing more can be reported than what it wrote.
[[noreturn]] void give_up(int) {
  static constexpr std::string_view text =
      "\n  the rest of the report is lost, since the memory of the host is damaged\n";
  [[maybe_unused]] const ssize_t n = write(STDERR_FILENO, text.data(), text.size());
  end_process(internal_fault);
}

void handle(int number, void (*handler)(int), int flags) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(number, &action, nullptr);
}

[[noreturn]] void report_and_end(std::string_view what) {
  is_reporting = true;
  for (const int s : crash_signals) handle(s, give_up, SA_ONSTACK | SA_NODEFER);
  sigset_t crashes;
  sigemptyset(&crashes);
  for (const int s : crash_signals) sigaddset(&crashes, s);
  sigprocmask(SIG_UNBLOCK, &crashes, nullptr);
  remove_temporaries();
  if (write_here != nullptr) {
    write_here();
    end_process(internal_fault);
  }
  // Written step by step: each step trusts more of the memory that the fault may have damaged.
  Line line;
  line << "isogloss: internal fault: " << what;
  line.show();
  const Breadcrumb crumb = Chain::breadcrumb();
  const bool is_block = crumb.syntax != nullptr && crumb.document != nullptr;
  Line place;
  if (crumb.syntax != nullptr) {
    (place << " in ").show(crumb.syntax) << " of plugin ";
    place.show(crumb.plugin) << ", at work in " << crumb.phase << "()";
  } else if (const char* const plugin = Library::loading(); plugin != nullptr) {
    (place << " while loading the plugin ").show(plugin) << (Library::is_in_entry() ? ", in its entry function" : "");
  } else {
    place << (is_ending ? " in a function of a plugin for the end of the process" : " outside any syntax");
  }
  place.show();
  Line block;
  if (is_block) {
    const BlockSource& source = crumb.document->source;
    (block << "\n  at ").show(source.file) << ":" << source.line << ": ";
    block.show(source.text);
  }
  block << "\n";
  block.show();
  if (is_block && may_reproduce) {
    static Line file;
    file << "isogloss-crash-" << static_cast<std::uint64_t>(getpid()) << ".md";
    Line result;
    if (write_reproducer(crumb, file.text()))
      result << "  a case that shows it: " << file.text() << " (isogloss case " << file.text() << ")\n";
    else
      result << "  a case that shows it could not be written\n";
    result.show();
  }
  end_process(internal_fault);
}

[[noreturn]] void on_crash_signal(int number) { report_and_end(name_of(number)); }

bool is_plugin_at_work() { return Chain::breadcrumb().syntax != nullptr || Library::loading() != nullptr; }

/// Runs at exit() and quick_exit(), which no plugin may call: half an output would look complete.
void on_exit_call() {
  if (!is_reporting && is_plugin_at_work()) report_and_end("a call of exit()");
}

[[noreturn]] void end_by(int number) {
  has_ended = true;
  remove_temporaries();
  signal(number, SIG_DFL);
  sigset_t one;
  sigemptyset(&one);
  sigaddset(&one, number);
  raise(number);
  sigprocmask(SIG_UNBLOCK, &one, nullptr);
  end_process(128 + number);
}

/// Identifies the call that is under way, so that the watch can tell it from later calls.
struct Work {
  const void* what = nullptr;
  const void* phase = nullptr;
  std::uint64_t builds = 0;
  const void* text = nullptr;
  bool operator==(const Work&) const = default;
};

Work work_now() {
  const Breadcrumb crumb = Chain::breadcrumb();
  if (crumb.syntax == nullptr) {
    const char* const plugin = Library::loading();
    return {plugin != nullptr ? plugin : is_ending ? "end" : nullptr, nullptr, 0, nullptr};
  }
  Work work{crumb.syntax, crumb.phase, 0, nullptr};
  if (crumb.document != nullptr) {
    work.builds = crumb.document->chain->builds;
    work.text = crumb.document->source.text.data();
  }
  return work;
}

void on_alarm(int number) {
  static Work last;
  static std::uint64_t begin = 0, written_before = 0;
  if (waiting_signal != 0) {
    if (pthread_equal(pthread_self(), writing_thread) == 0) pthread_kill(writing_thread, SIGALRM);
    if (--waits_left <= 0) end_by(waiting_signal);
    return;
  }
  if (writers != 0 || is_reporting) return;
  const Work work = work_now();
  const std::uint64_t now = nanoseconds();
  if (work.what == nullptr || !(work == last)) {
    last = work;
    begin = now;
    written_before = time_written;
    return;
  }
  if (now - begin - (time_written - written_before) < patience) return;
  report_and_end(work.text != nullptr ? "no end of the block in sight" : name_of(number));
}

void on_end(int number) {
  if (whole_lines == 0 || waiting_signal != 0) end_by(number);
  waiting_signal = number;
  waits_left = most_waits;
  // Interrupts a write that waits for its reader, repeatedly, so that it notices the signal.
  handle(SIGALRM, on_alarm, SA_ONSTACK);
  const itimerval interval{{0, wait_interval}, {0, wait_interval}};
  setitimer(ITIMER_REAL, &interval, nullptr);
}

}  // namespace

void guard_crashes(char** argv) {
  own_arguments = argv;
  // A stack of its own: running out of stack is one of the crashes.
  constexpr std::size_t stack_size = std::size_t{256} << 10;
  void* const memory = mmap(nullptr, stack_size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (memory != MAP_FAILED) {
    const stack_t stack{.ss_sp = memory, .ss_flags = 0, .ss_size = stack_size};
    sigaltstack(&stack, nullptr);
  }
  for (const int s : crash_signals) handle(s, on_crash_signal, SA_ONSTACK);
  std::atexit(on_exit_call);
  std::at_quick_exit(on_exit_call);
  for (const int s : end_signals) {
    struct sigaction before {};
    sigaction(s, nullptr, &before);
    if (before.sa_handler != SIG_IGN) handle(s, on_end, 0);  // nohup stays nohup
  }
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);  // the write fails instead, and its error is reported
}

void end_process(int status) {
  syscall(SYS_exit_group, status);
  __builtin_unreachable();
}

void expect_end() { is_ending = true; }

void watch_calls(unsigned seconds) {
  patience = std::uint64_t{seconds} * 900'000'000;  // a tick may come a little early
  handle(SIGALRM, on_alarm, SA_RESTART | SA_ONSTACK);
  const itimerval interval{{static_cast<time_t>(seconds), 0}, {static_cast<time_t>(seconds), 0}};
  setitimer(ITIMER_REAL, &interval, nullptr);
}

void allow_reproducer() { may_reproduce = !is_confined; }

void guard_confined() {
  is_confined = true;
  may_reproduce = false;
  for (const char* volatile& slot : temporaries) slot = nullptr;  // they belong to the process that supervises
}

Writing::Writing() : begin_(nanoseconds()) { writers = writers + 1; }
Writing::~Writing() {
  time_written = time_written + (nanoseconds() - begin_);
  writers = writers - 1;
}

WholeLines::WholeLines() {
  writing_thread = pthread_self();
  ++whole_lines;
  while (has_ended) pause();
}
WholeLines::~WholeLines() {
  if (--whole_lines == 0 && waiting_signal != 0) end_by(waiting_signal);
}
bool WholeLines::shall_end() { return waiting_signal != 0; }

void remove_when_killed(const char* path) {
  for (const char* volatile& slot : temporaries) {
    if (slot != nullptr) continue;
    slot = path;
    return;
  }
}

void keep_when_killed(const char* path) {
  for (const char* volatile& slot : temporaries)
    if (slot == path) slot = nullptr;
}

void on_crash(void (*write_reproducer)()) { write_here = write_reproducer; }

}  // namespace isogloss::cli

/// A plugin that calls _exit() or _Exit() comes here: the command's own functions go before those of the C library.
extern "C" [[gnu::visibility("default")]] void _exit(int status) {
  using namespace isogloss::cli;
  if (!is_reporting && is_plugin_at_work()) report_and_end("a call of _exit()");
  end_process(status);
}
extern "C" [[gnu::visibility("default")]] void _Exit(int status) noexcept { _exit(status); }
