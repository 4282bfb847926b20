// Finds the subcommand. Options that stand before it belong to it as well: `isogloss --plugins DIR run …`.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>

#include "command.hpp"
#include "isogloss/engine/diagnostic.hpp"
#include "output_file.hpp"
#include "session.hpp"
#include "terminal.hpp"
#include "usage.hpp"

namespace isogloss::cli {

namespace {

std::string usage() {
  std::string out =
      "Isogloss: controller dialects of CNC part programs as data and plugins.\n\n"
      "Usage: isogloss COMMAND [options]\n\nCommands:\n";
  for (const Command& c : commands)
    if (!c.is_hidden)
      out += "  " + std::string(c.name) + std::string(10 - c.name.size(), ' ') + std::string(c.summary) + "\n";
  out += "\nOptions of all commands:\n";
  for (const CommonOption& o : common_options) {
    const std::string shown = std::string(o.name) + (o.value.empty() ? "" : " ") + std::string(o.value);
    out += "  " + shown + std::string(16 - shown.size(), ' ') + std::string(o.summary) + "\n";
  }
  return out +
         "\nExit status: 0 at most warnings, 1 errors in the input, 2 cannot start or cannot write an output, 3 "
         "internal fault.\n\n"
         "Example:\n  isogloss run part.nc --emit motions --format text\n";
}

bool takes_value(std::string_view option) {
  for (const CommonOption& o : common_options)
    if (o.name == option) return !o.value.empty();
  return false;
}

int dispatch(Arguments arguments) {
  std::size_t at = 0;
  while (at < arguments.size() && arguments[at].starts_with('-') && arguments[at] != "-") {
    if (arguments[at] == "--help" || arguments[at] == "-h")
      return print(fitted(usage(), columns_of(STDOUT_FILENO)), success);
    if (arguments[at] == "--version") {
      arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(at));
      return version_command(arguments);
    }
    at += takes_value(arguments[at]) ? 2 : 1;
  }
  if (at >= arguments.size()) {
    std::fputs(fitted(usage(), columns_of(STDERR_FILENO)).c_str(), stderr);
    return cannot_start;
  }
  const std::string name = arguments[at];
  arguments.erase(arguments.begin() + static_cast<std::ptrdiff_t>(at));
  if (name == "help") {
    if (at >= arguments.size()) return print(fitted(usage(), columns_of(STDOUT_FILENO)), success);
    return dispatch({arguments[at], "--help"});
  }
  std::vector<std::string> names;
  for (const Command& c : commands) {
    if (c.name == name) return c.run(arguments);
    names.emplace_back(c.name);
  }
  const std::string near = nearest_name(name, names);
  std::fprintf(stderr, "isogloss: no command '%s'%s; isogloss --help lists them\n", name.c_str(),
               near.empty() ? "" : (" (did you mean '" + near + "'?)").c_str());
  return cannot_start;
}

}  // namespace

int run_main(Arguments arguments) {
  try {
    const int status = dispatch(std::move(arguments));
    return diagnostics_were_lost() ? std::max<int>(status, cannot_start) : status;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "isogloss: internal fault: %s\n", e.what());
  } catch (...) {
    std::fputs("isogloss: internal fault: an exception that is no std::exception\n", stderr);
  }
  return internal_fault;
}

}  // namespace isogloss::cli
