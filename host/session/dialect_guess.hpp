/// Which dialect a program is written in, where the user names none.
#pragma once

#include "isogloss/engine/runner.hpp"
#include "workspace.hpp"

namespace isogloss {

/// How much of a program is read to guess its dialect.
constexpr std::size_t guessed_head_bytes = 65536;

struct Guess {
  std::string dialect;  ///< the name of a dialect, or its file
  std::string name, why;
  /// The dialect that comes next, where less than one sign of the usual weight is between them; else empty.
  std::string next, next_name;
};

/// The dialect whose signatures and extensions fit best. Empty, and reported, when there is none.
std::optional<Guess> guess_dialect(const std::string& path, std::string_view head, Workspace& workspace);

/// Reports which dialect was selected; `parting` tells how the next one differs, or is empty.
void report_guess(const std::string& path, const Guess& guess, const std::string& parting, Workspace& workspace);

/// Guesses the dialect and reports it; the result is a value for --dialect.
std::optional<std::string> guessed(const std::string& path, std::string_view head, Workspace& workspace);

/// The place of the first move that two dialects make in different ways, "line 12". Runs the head of the program, and
/// no more than some thousand blocks of it; empty where the moves up to there are the same.
std::string where_moves_part(const LinkedDialect& taken, const LinkedDialect& next, const std::string& path,
                             std::string_view head, const RunOptions& options);

/// How the next candidate moves in another way, for report_guess(); empty where it does not, or where there is none.
/// `options` as for run(), without the places of called programs.
std::string parting(const Guess& guess, const LinkedDialect& taken, const LinkedDialect& next, const std::string& path,
                    std::string_view head, RunOptions options);

}  // namespace isogloss
