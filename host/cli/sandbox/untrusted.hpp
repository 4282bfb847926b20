/// --untrusted: the work of a command in a process that can neither write, nor connect, nor start or signal others.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "program_options.hpp"

namespace isogloss::cli {

struct UntrustedOptions {
  static constexpr std::uint64_t usual_seconds = 600;
  bool on = false;
  std::optional<std::uint64_t> seconds;  ///< as given

  /// --untrusted and --max-time.
  void add_to(CommandLine& line);
  /// --untrusted alone, where the command has a --max-time of its own.
  void add_flag_to(CommandLine& line);
  /// A time was given, and nothing keeps it.
  bool is_time_unused() const { return !on && seconds; }
  /// 0: none.
  std::uint64_t time_limit() const { return seconds.value_or(usual_seconds); }
};

/// What the work needs from outside.
struct UntrustedWork {
  CommonOptions common;               ///< whose folders are read, and which say how diagnostics are written
  std::vector<std::string> programs;  ///< their folders are read; "-" is standard input
  std::vector<std::string> reads;     ///< tables, dialects and machines: their folders are read; places: they are
  std::vector<std::string> outputs;   ///< files that it writes, which appear when it has ended well
  std::uint64_t memory_mib = 4096, output_bytes = std::uint64_t{1} << 34;

  /// One that is named by its file; the others stand in the folders of dialects.
  void add_dialect(const std::string& dialect);
};

/// Of a command that runs no program.
UntrustedWork untrusted_work(const CommonOptions& common, const std::string& dialect, const std::string& machine);
/// Of a run with these options; the caller adds its programs and outputs.
UntrustedWork untrusted_work(const CommonOptions& common, const ProgramOptions& program);

/// The program of PROGRAM:LINE.
std::string program_of_lines(const std::string& named);

/// To be called before any plugin is loaded. Empty in the process that works, and without --untrusted: the command
/// goes on. Else the exit status of the command, in the process that has watched over the work.
std::optional<int> enter_untrusted(const UntrustedOptions& options, const UntrustedWork& work);

/// In the process that works: its work is done, with this exit status. Without --untrusted nothing.
void end_untrusted(int status);

}  // namespace isogloss::cli
