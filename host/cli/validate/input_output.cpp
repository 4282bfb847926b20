// What a plugin writes to the terminal, and what its build() asks of the system. The functions of the system that read
// and write are watched while a function of the plugin is at work.
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <pthread.h>
#include <sched.h>
#include <semaphore.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/random.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "validate/redirection.hpp"
#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

/// create() may read what it needs; no function changes anything outside.
enum class Watch { nothing, changes, everything };
thread_local Watch watch = Watch::nothing;
thread_local const char* called = nullptr;  // the first one of a call of the plugin

bool changes_something(std::string_view name) {
  // A thread that destroy() ends is no trace either; `leaves-nothing` sees others.
  constexpr std::string_view harmless[] = {"read",   "fopen", "fread", "fgets",  "getc",   "fflush",        "opendir",
                                           "access", "stat",  "open",  "getenv", "dlopen", "pthread_create"};
  return std::find(std::begin(harmless), std::end(harmless), name) == std::end(harmless);
}

void note_call(const char* name) {
  if (called != nullptr || watch == Watch::nothing) return;
  if (watch == Watch::everything || changes_something(name)) called = name;
}

/// Of what create() and restart() may call.
void note_call_of_build(const char* name) {
  if (called == nullptr && watch == Watch::everything) called = name;
}

/// Notes the call and does what the function does.
template <auto function>
struct Watched;
template <class R, class... A, bool throws_nothing, R (*function)(A...) noexcept(throws_nothing)>
struct Watched<function> {
  static inline const char* name = "";
  static inline void (*note)(const char*) = note_call;
  static R call(A... arguments) {
    note(name);
    return function(arguments...);
  }
};

template <auto function>
Replacement watched(const char* name) {
  Watched<function>::name = name;
  return {name, reinterpret_cast<void*>(&Watched<function>::call)};
}

template <auto function>
Replacement in_build(const char* name, const char* symbol = nullptr) {
  Watched<function>::note = note_call_of_build;
  Replacement out = watched<function>(name);
  if (symbol != nullptr) out.name = symbol;
  return out;
}

// Functions with any number of arguments, and those that the compiler puts in their place.
int watched_printf(const char* form, ...) {
  note_call("printf");
  va_list arguments;
  va_start(arguments, form);
  const int out = std::vprintf(form, arguments);
  va_end(arguments);
  return out;
}
int watched_printf_chk(int, const char* form, ...) {
  note_call("printf");
  va_list arguments;
  va_start(arguments, form);
  const int out = std::vprintf(form, arguments);
  va_end(arguments);
  return out;
}
int watched_fprintf(FILE* file, const char* form, ...) {
  note_call("fprintf");
  va_list arguments;
  va_start(arguments, form);
  const int out = std::vfprintf(file, form, arguments);
  va_end(arguments);
  return out;
}
int watched_fprintf_chk(FILE* file, int, const char* form, ...) {
  note_call("fprintf");
  va_list arguments;
  va_start(arguments, form);
  const int out = std::vfprintf(file, form, arguments);
  va_end(arguments);
  return out;
}
/// create() may read a file, but none that another working folder would not have.
void note_path(const char* path) {
  if (called == nullptr && watch != Watch::nothing && path != nullptr && path[0] != '/' && path[0] != '\0')
    called = "a function for a file in the working folder";
}
int watched_stat(const char* path, struct stat* out) {
  note_path(path);
  note_call("stat");
  return stat(path, out);
}
int watched_access(const char* path, int mode) {
  note_path(path);
  note_call("access");
  return access(path, mode);
}
std::FILE* watched_fopen(const char* path, const char* mode) {
  note_path(path);
  note_call(std::strpbrk(mode, "wa+") != nullptr ? "fopen (for writing)" : "fopen");
  return std::fopen(path, mode);
}
int watched_open(const char* path, int flags, ...) {
  note_path(path);
  note_call((flags & O_ACCMODE) == O_RDONLY ? "open" : "open (for writing)");
  va_list arguments;
  va_start(arguments, flags);
  const bool creates = (flags & O_CREAT) != 0;
  const int out = open(path, flags, creates ? va_arg(arguments, unsigned) : 0);
  va_end(arguments);
  return out;
}

std::vector<Replacement> watched_functions() {
  std::vector<Replacement> out{watched<&read>("read"),
                               watched<&write>("write"),
                               watched<&writev>("writev"),
                               watched<&fread>("fread"),
                               watched<&fwrite>("fwrite"),
                               watched<&fputs>("fputs"),
                               watched<&fputc>("fputc"),
                               watched<&putc>("putc"),
                               watched<&putchar>("putchar"),
                               watched<&puts>("puts"),
                               watched<&fgets>("fgets"),
                               watched<&getc>("getc"),
                               watched<&fflush>("fflush"),
                               watched<&vprintf>("vprintf"),
                               watched<&vfprintf>("vfprintf"),
                               watched<&opendir>("opendir"),
                               watched<&mkdir>("mkdir"),
                               watched<&unlink>("unlink"),
                               watched<&rename>("rename"),
                               watched<&chdir>("chdir"),
                               watched<&socket>("socket"),
                               watched<&system>("system"),
                               watched<&popen>("popen"),
                               watched<&fork>("fork"),
                               watched<&pthread_create>("pthread_create"),
                               watched<&dlopen>("dlopen"),
                               watched<&getenv>("getenv"),
                               watched<&setenv>("setenv")};
  const auto add = [&out](const char* name, auto function) {
    out.push_back({name, reinterpret_cast<void*>(function)});
  };
  add("printf", &watched_printf);
  add("__printf_chk", &watched_printf_chk);
  add("fprintf", &watched_fprintf);
  add("__fprintf_chk", &watched_fprintf_chk);
  add("stat", &watched_stat);
  add("stat64", &watched_stat);
  add("lstat", &watched_stat);
  add("access", &watched_access);
  add("open", &watched_open);
  add("open64", &watched_open);
  add("fopen", &watched_fopen);
  add("fopen64", &watched_fopen);
  return out;
}

long watched_syscall(long number, long a, long b, long c, long d, long e, long f) {
  note_call_of_build("syscall");
  return syscall(number, a, b, c, d, e, f);
}
int watched_fcntl(int file, int command, long argument) {
  note_call_of_build("fcntl");
  return fcntl(file, command, argument);
}
unsigned watched_random_device(void* self) {
  note_call_of_build("std::random_device");
  using Function = unsigned (*)(void*);
  static const auto real = reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, "_ZNSt13random_device9_M_getvalEv"));
  return real != nullptr ? real(self) : 0;
}

/// What a build has no use for and create() may call. Libraries of the system lock and ask clocks for themselves, so
/// these are watched in the plugin alone.
std::vector<Replacement> watched_in_build() {
  using std::chrono::steady_clock, std::chrono::system_clock;
  return {in_build<&pthread_mutex_lock>("pthread_mutex_lock"),
          in_build<&pthread_mutex_trylock>("pthread_mutex_trylock"),
          in_build<&pthread_rwlock_rdlock>("pthread_rwlock_rdlock"),
          in_build<&pthread_rwlock_wrlock>("pthread_rwlock_wrlock"),
          in_build<&pthread_spin_lock>("pthread_spin_lock"),
          in_build<&pthread_cond_wait>("pthread_cond_wait"),
          in_build<&pthread_barrier_wait>("pthread_barrier_wait"),
          in_build<&sem_wait>("sem_wait"),
          in_build<&flock>("flock"),
          in_build<&lockf>("lockf"),
          in_build<&sched_yield>("sched_yield"),
          in_build<&sleep>("sleep"),
          in_build<&usleep>("usleep"),
          in_build<&nanosleep>("nanosleep"),
          in_build<&clock_nanosleep>("clock_nanosleep"),
          in_build<&poll>("poll"),
          in_build<&select>("select"),
          in_build<&time>("time"),
          in_build<&clock>("clock"),
          in_build<&clock_gettime>("clock_gettime"),
          in_build<&gettimeofday>("gettimeofday"),
          in_build<&localtime>("localtime"),
          in_build<&localtime_r>("localtime_r"),
          in_build<static_cast<system_clock::time_point (*)() noexcept>(&system_clock::now)>(
              "std::chrono::system_clock::now", "_ZNSt6chrono3_V212system_clock3nowEv"),
          in_build<static_cast<steady_clock::time_point (*)() noexcept>(&steady_clock::now)>(
              "std::chrono::steady_clock::now", "_ZNSt6chrono3_V212steady_clock3nowEv"),
          in_build<&rand>("rand"),
          in_build<&random>("random"),
          in_build<&drand48>("drand48"),
          in_build<&getrandom>("getrandom"),
          in_build<&getentropy>("getentropy"),
          in_build<&getpid>("getpid"),
          in_build<&gethostname>("gethostname"),
          in_build<&getcwd>("getcwd"),
          in_build<&secure_getenv>("secure_getenv"),
          {"syscall", reinterpret_cast<void*>(&watched_syscall)},
          {"fcntl", reinterpret_cast<void*>(&watched_fcntl)},
          {"fcntl64", reinterpret_cast<void*>(&watched_fcntl)},
          {"_ZNSt13random_device9_M_getvalEv", reinterpret_cast<void*>(&watched_random_device)}};
}

/// What goes to standard output while one of these lives, and nowhere else. Standard error stays: a crash is told
/// there.
class CapturedOutput {
 public:
  CapturedOutput() : own_(dup(STDOUT_FILENO)), memory_(memfd_create("output", 0)) { dup2(memory_, STDOUT_FILENO); }
  ~CapturedOutput() { end(); }
  CapturedOutput(const CapturedOutput&) = delete;
  CapturedOutput& operator=(const CapturedOutput&) = delete;

  /// The first line, or a part of it.
  std::string end() {
    if (memory_ < 0) return {};
    std::fflush(nullptr);
    dup2(own_, STDOUT_FILENO);
    close(own_);
    constexpr std::size_t most = 200;
    std::string out(most, '\0');
    const ssize_t n = pread(memory_, out.data(), out.size(), 0);
    out.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
    close(memory_);
    memory_ = -1;
    return out.substr(0, out.find('\n'));
  }

 private:
  int own_, memory_;
};

void watch_builds(Examination& e) {
  constexpr std::uint64_t random_ones = 50;
  constexpr std::size_t often = 1200;
  Subject subject(e);
  redirect(watched_functions(), Redirected::libraries);
  redirect(watched_in_build(), Redirected::libraries, e.file);
  for (const Stand& stand : stands_of(subject, e)) {
    e.attempt(stand.syntax->id);
    called = nullptr;
    watch = Watch::changes;
    Bench bench(stand.alone, in_mode(Mode::fast));
    bench.start();
    watch = Watch::nothing;
    if (called != nullptr)
      e.find(stand.syntax->id,
             fmt::format("its create() or restart() calls {} of the system and so changes what is not "
                         "its own",
                         called));
    std::vector<TestBlock> blocks = many_blocks(stand, e, random_ones);
    // What a build does once in a while, too.
    const TestBlock full = full_block(stand.alone, fields_of(stand.alone));
    blocks.resize(blocks.size() + (stand.dependencies.empty() ? often : 0), full);
    for (const TestBlock& block : blocks) {
      const std::string where = std::string(stand.syntax->id) + ", " + block.name;
      e.attempt(where);
      bench.prepare(block);
      called = nullptr;
      watch = Watch::everything;
      bench.scan();
      bench.build();
      watch = Watch::nothing;
      if (called == nullptr) continue;
      e.find(where, fmt::format("it calls {} of the system, while a block gets nothing but its own text", called));
      break;
    }
  }
}

}  // namespace

void check_input_output(Examination& e) {
  CapturedOutput output;
  watch_builds(e);
  if (const std::string written = output.end(); !written.empty())
    e.find("", fmt::format("it writes to standard output, where the data of the command goes: {}", written));
}

}  // namespace isogloss::cli
