/// What happens when a plugin crashes or hangs: the user learns which one, where, and gets a case that shows it.
#pragma once

#include <cstdint>

namespace isogloss::cli {

/// Handles the signals of a crash from here on, and a plugin that ends the process; a closed output is no signal any
/// more, nor is a file that has grown too large. `argv` must stay.
void guard_crashes(char** argv);

/// Ends the process with this status and no clean-up, whatever is at work.
[[noreturn]] void end_process(int status);

/// The work of the commands is done; what still runs are the libraries' own functions for the end of the process.
void expect_end();

/// Reports a call of a plugin that is at work for longer than this; 0: never.
void watch_calls(unsigned seconds);

/// While one of these lives, bytes are written: the time that takes is that of whoever reads them.
class Writing {
 public:
  Writing();
  ~Writing();
  Writing(const Writing&) = delete;
  Writing& operator=(const Writing&) = delete;

 private:
  std::uint64_t begin_;
};

/// While one of these lives, a signal that ends the process waits, but not for long: whole lines are to be written, or
/// a temporary file is made.
class WholeLines {
 public:
  WholeLines();
  ~WholeLines();  ///< the process ends here when a signal came
  WholeLines(const WholeLines&) = delete;
  WholeLines& operator=(const WholeLines&) = delete;
  static bool shall_end();  ///< a signal waits: no more lines than the one that was begun
};

/// From here on the run can be repeated (its programs are files), so a crash writes a reproducer: the command is
/// started anew with hidden options, and stops before the build that crashed.
void allow_reproducer();

/// A temporary file to remove when the process is killed. The text must stay until keep_when_killed().
void remove_when_killed(const char* path);
void keep_when_killed(const char* path);

/// This process can write no file and start no other from here on: a crash is reported, and nothing more.
void guard_confined();

/// In the process that writes a reproducer: called when it crashes, too.
void on_crash(void (*write_reproducer)());

}  // namespace isogloss::cli
