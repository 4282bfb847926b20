// The library itself: what the loader sees before any syntax exists.
#include <dlfcn.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>

#include "crash_guard.hpp"
#include "validate/child.hpp"
#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

constexpr double most_milliseconds = 50;

/// The plugin's refusal, as code and reason; empty when it loads.
Finding refusal(Examination& e) {
  e.attempt("loading the library");
  Library library({});
  if (library.load_file(e.file)) return {};
  const RefusedPlugin& refused = library.refused().back();
  return {refused.code, refused.reason};
}

bool is_of_descriptor(const std::string& code) { return code == "IG-0305"; }

/// The entry of the plugin with this major version, for hosts to come.
bool is_entry(const std::string& symbol) { return symbol.starts_with("ig_plugin_v"); }

}  // namespace

namespace {

/// Loads, asks and closes once. False, and told, when nothing further can be tried.
bool load_and_close(Examination& e, const std::string& time) {
  e.attempt("loading the library" + time);
  void* const library = dlopen(e.file.c_str(), RTLD_NOW | RTLD_LOCAL);
  const auto entry = library == nullptr ? nullptr : reinterpret_cast<ig_plugin_fn>(dlsym(library, "ig_plugin_v1"));
  if (entry == nullptr) {
    const char* const reason = dlerror();
    e.find("", "loading it again fails: " + std::string(reason == nullptr ? "no entry" : reason));
    return false;
  }
  e.attempt("calling the entry" + time);
  const ig_plugin* const plugin = entry();
  if (plugin == nullptr)
    e.find("", "the entry returns nothing; return a descriptor");
  else if (entry() != plugin)
    e.find("", "two calls of the entry give two answers; return the same static descriptor each time");
  e.attempt("closing the library" + time);
  dlclose(library);
  return true;
}

}  // namespace

void check_loads(Examination& e) {
  // In another process, since a library that the host has loaded stays: none of the times below would be the first.
  Finding refused;
  const bool survived = survives(e, [&] {
    refused = refusal(e);
    if (!refused.where.empty() && !is_of_descriptor(refused.where) && e.may_fork) end_process(input_errors);
  });
  if (!survived) refused = refusal(e);
  if (!refused.where.empty() && !is_of_descriptor(refused.where)) {
    e.find("", refused.what + " [" + refused.where + "]");
    return;
  }
  for (const char* const time : {"", ", a second time", ", a third time"})
    if (!load_and_close(e, time)) return;
}

void check_descriptor(Examination& e) {
  if (const Finding refused = refusal(e); is_of_descriptor(refused.where))
    e.find("", refused.what + " [" + refused.where + "]");
}

void check_exports(Examination& e) {
  const Subject subject(e);
  for (const std::string& symbol : subject.loaded().extra_exports)
    if (!is_entry(symbol)) e.find(symbol, "is exported, so other plugins may bind to it; export the entry alone");
}

void check_unloads(Examination& e) {
  if (!e.may_fork) return e.remark("not looked at: the checks before this one hold the library in the command");
  if (void* const library = dlopen(e.file.c_str(), RTLD_NOW | RTLD_LOCAL)) dlclose(library);
  if (dlopen(e.file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NOLOAD) != nullptr)
    e.find("", "the library stays in memory when it is closed; with g++ build it with -fno-gnu-unique");
}

void check_load_time(Examination& e) {
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 5; ++i) {
    const Clock::time_point begin = Clock::now();
    void* const library = dlopen(e.file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) return;
    if (const auto entry = reinterpret_cast<ig_plugin_fn>(dlsym(library, "ig_plugin_v1"))) entry();
    best = std::min(best, std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
    dlclose(library);
  }
  if (best > most_milliseconds)
    e.find("", "loading takes " + std::to_string(static_cast<int>(best)) + " ms, more than " +
                   std::to_string(static_cast<int>(most_milliseconds)) + " ms; initialize less before the entry");
}

}  // namespace isogloss::cli
