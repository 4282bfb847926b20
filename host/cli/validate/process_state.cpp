// Settings of the process and of its thread, by what people call them.
#include "validate/process_state.hpp"

#include <fmt/format.h>
#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cfloat>
#include <clocale>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <locale>
#include <new>

namespace isogloss::cli {

namespace fs = std::filesystem;

namespace {

std::string signals_held_back() {
  sigset_t set;
  sigemptyset(&set);
  pthread_sigmask(SIG_BLOCK, nullptr, &set);
  std::string out;
  for (int number = 1; number < NSIG; ++number)
    if (sigismember(&set, number) == 1) out += fmt::format("{}{}", out.empty() ? "" : " ", number);
  return out.empty() ? "none" : out;
}

std::string limit_of(decltype(RLIMIT_NOFILE) what) {
  rlimit limit{};
  getrlimit(what, &limit);
  return std::to_string(limit.rlim_cur);
}

std::string interval_of(decltype(ITIMER_REAL) timer) {
  itimerval value{};
  getitimer(timer, &value);
  return fmt::format("{} us", value.it_interval.tv_sec * 1'000'000 + value.it_interval.tv_usec);
}

std::size_t lines_of(const char* file) {
  std::ifstream in(file);
  std::size_t out = 0;
  for (std::string line; std::getline(in, line);) out += line.starts_with("ID:") ? 1 : 0;
  return out;
}

std::string signal_stack() {
  stack_t stack{};
  sigaltstack(nullptr, &stack);
  return fmt::format("{} bytes at {}", stack.ss_size, stack.ss_sp);
}

template <class Function>
std::string address_of(Function* function) {
  return fmt::format("{}", reinterpret_cast<const void*>(function));
}

#if defined(__x86_64__)
/// Of both units of the processor, without the marks that results leave.
void add_arithmetic(std::map<std::string, std::string>& out) {
  constexpr unsigned marks = 0x3f;
  std::fenv_t state;
  std::fegetenv(&state);
  out["the control word of the x87 unit"] = fmt::format("{:#x}", state.__control_word);
  out["the control word of the SSE unit (MXCSR)"] = fmt::format("{:#x}", state.__mxcsr & ~marks);
}
#else
void add_arithmetic(std::map<std::string, std::string>&) {}
#endif

void add_of_thread(std::map<std::string, std::string>& out) {
  cpu_set_t processors;
  CPU_ZERO(&processors);
  sched_getaffinity(0, sizeof processors, &processors);
  out["the processors of the thread"] = std::to_string(CPU_COUNT(&processors));
  std::array<char, 32> name{};
  pthread_getname_np(pthread_self(), name.data(), name.size());
  out["the name of the thread"] = name.data();
  out["the locale of the thread"] = uselocale(nullptr) == LC_GLOBAL_LOCALE ? "that of the process" : "its own";
  out["the stack for signals"] = signal_stack();
  out["the priority"] = std::to_string(getpriority(PRIO_PROCESS, 0));
}

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
  out["the number of files that may be open"] = limit_of(RLIMIT_NOFILE);
  out["the limit of the stack"] = limit_of(RLIMIT_STACK);
  out["the limit of memory"] = limit_of(RLIMIT_AS);
  out["the timer of real time"] = interval_of(ITIMER_REAL);
  out["the timer of the process's time"] = interval_of(ITIMER_VIRTUAL);
  out["the profiling timer"] = interval_of(ITIMER_PROF);
  out["the number of timers"] = std::to_string(lines_of("/proc/self/timers"));
  out["the handler of std::terminate()"] = address_of(std::get_terminate());
  out["the handler of operator new"] = address_of(std::get_new_handler());
  out["the form of std::cout"] =
      fmt::format("{:#x}, {} digits", static_cast<unsigned>(std::cout.flags()), std::cout.precision());
  add_arithmetic(out);
  add_of_thread(out);
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

ProcessState::ProcessState() : settings_(settings_of_process()) {}

std::vector<std::string> ProcessState::changes() const {
  const std::map<std::string, std::string> after = settings_of_process();
  const auto of = [](const std::map<std::string, std::string>& all, const std::string& what) {
    const auto found = all.find(what);
    return found == all.end() ? "not set" : found->second;
  };
  std::map<std::string, std::string> both = settings_;
  both.insert(after.begin(), after.end());
  std::vector<std::string> out;
  for (const auto& [what, value] : both)
    if (of(settings_, what) != of(after, what))
      out.push_back(fmt::format("it changes {}: {} was {}", what, of(after, what), of(settings_, what)));
  return out;
}

}  // namespace isogloss::cli
