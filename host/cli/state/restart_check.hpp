/// Does a preamble restore the state? It is run, with the rest of the program, and compared with the whole.
#pragma once

#include <string>
#include <vector>

#include "isogloss/engine/runner.hpp"
#include "state/program_point.hpp"

namespace isogloss::cli {

struct StateDifference {
  std::string path, wanted, found;  ///< JSON text; empty: absent
  bool is_vital = false;            ///< the motions behind it may be the same, and the machine does another thing
  ProgramLine since{};              ///< gave it the value that is wanted; line 0: none did
};

struct RestartCheck {
  bool comes_to_rest = false;                ///< the run comes to the first line after the preamble
  std::vector<StateDifference> differences;  ///< of the two states there
  std::uint32_t line = 0;                    ///< of the program, where the motions part first; 0: they do not
  std::string line_file;
  std::uint32_t cuts_at = 0;       ///< line of the preamble that cuts on another way than down to the point; 0: none
  std::vector<Diagnostic> errors;  ///< of the preamble's own blocks
};

/// `rest` begins at the point's line. Of the motions the first 64 MiB of JSON Lines are compared.
RestartCheck check_restart(const LinkedDialect& linked, const std::string& whole, const std::string& preamble,
                           const std::string& rest, const std::string& name, const ProgramPoint& point,
                           const RunOptions& options);

}  // namespace isogloss::cli
