/// What happens when a plugin crashes or hangs: the user learns which one, where, and gets a case that shows it.
#pragma once

namespace isogloss::cli {

/// Handles the signals of a crash from here on; a closed output is no signal any more. `argv` must stay.
void guard_crashes(char** argv);

/// Reports a block that is at work for longer than this; 0: never.
void watch_blocks(unsigned seconds);

/// From here on the run can be repeated (its programs are files), so a crash writes a reproducer: the command is
/// started anew with hidden options, and stops before the build that crashed.
void allow_reproducer();

/// A temporary file to remove when the process is killed; null: none. The text must stay.
void remove_when_killed(const char* path);

/// In the process that writes a reproducer: called when it crashes, too.
void on_crash(void (*write_reproducer)());

}  // namespace isogloss::cli
