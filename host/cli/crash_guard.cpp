// Everything in the handlers is async-signal-safe: write(2), fork(2), execve(2), waitpid(2) and plain memory.
#include "crash_guard.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "command.hpp"
#include "isogloss/engine/chain.hpp"

namespace isogloss::cli {

namespace {

constexpr int crash_signals[] = {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL};
constexpr unsigned seconds_for_reproducer = 20;

char** own_arguments = nullptr;
bool may_reproduce = false;
const char* volatile temporary = nullptr;
void (*write_here)() = nullptr;

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
  const char* text() const { return text_.data(); }
  void say() const { [[maybe_unused]] const ssize_t n = write(STDERR_FILENO, text_.data(), used_); }

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
    default: return "no end of the block in sight";
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
    // What the first run said need not be said again.
    if (const int nowhere = open("/dev/null", O_WRONLY); nowhere >= 0) {
      dup2(nowhere, STDOUT_FILENO);
      dup2(nowhere, STDERR_FILENO);
    }
    execve("/proc/self/exe", argv.data(), environ);
    _exit(internal_fault);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == success;
}

[[noreturn]] void report_and_exit(int number) {
  for (const int s : crash_signals) signal(s, SIG_DFL);  // a crash in here ends it
  if (temporary != nullptr) unlink(temporary);
  if (write_here != nullptr) {
    write_here();
    _exit(internal_fault);
  }
  const Breadcrumb crumb = Chain::breadcrumb();
  Line line;
  line << "isogloss: internal fault: " << name_of(number);
  if (crumb.syntax != nullptr) {
    const BlockSource& source = crumb.document->source;
    line << " in " << crumb.syntax << " of plugin " << crumb.plugin << "\n  at " << source.file << ":" << source.line
         << ": " << source.text.substr(0, 200);
  } else if (const char* const plugin = Library::loading(); plugin != nullptr) {
    line << " while loading the plugin " << plugin;
  } else {
    line << " outside any syntax";
  }
  line << "\n";
  line.say();
  if (crumb.syntax != nullptr && may_reproduce) {
    static Line file;
    file << "isogloss-crash-" << static_cast<std::uint64_t>(getpid()) << ".md";
    Line result;
    if (write_reproducer(crumb, file.text()))
      result << "  a case that shows it: " << file.text() << " (isogloss case " << file.text() << ")\n";
    else
      result << "  a case that shows it could not be written\n";
    result.say();
  }
  _exit(internal_fault);
}

void on_alarm(int number) {
  static volatile std::uint64_t last_builds = 0;
  static const void* volatile last_text = nullptr;
  static volatile bool seen = false;
  const Breadcrumb crumb = Chain::breadcrumb();
  if (crumb.syntax == nullptr) {
    seen = false;
    return;
  }
  const std::uint64_t builds = crumb.document->chain->builds;
  const void* const text = crumb.document->source.text.data();
  if (seen && builds == last_builds && text == last_text) report_and_exit(number);
  seen = true;
  last_builds = builds;
  last_text = text;
}

void on_end(int number) {
  if (temporary != nullptr) unlink(temporary);
  signal(number, SIG_DFL);
  raise(number);
}

void handle(int number, void (*handler)(int), int flags) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(number, &action, nullptr);
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
  for (const int s : crash_signals) handle(s, report_and_exit, SA_ONSTACK);
  for (const int s : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    sigaction(s, nullptr, &before);
    if (before.sa_handler != SIG_IGN) handle(s, on_end, 0);  // nohup stays nohup
  }
  signal(SIGPIPE, SIG_IGN);
}

void watch_blocks(unsigned seconds) {
  handle(SIGALRM, on_alarm, SA_RESTART | SA_ONSTACK);
  const itimerval interval{{static_cast<time_t>(seconds), 0}, {static_cast<time_t>(seconds), 0}};
  setitimer(ITIMER_REAL, &interval, nullptr);
}

void allow_reproducer() { may_reproduce = true; }

void remove_when_killed(const char* path) { temporary = path; }

void on_crash(void (*write_reproducer)()) { write_here = write_reproducer; }

}  // namespace isogloss::cli
