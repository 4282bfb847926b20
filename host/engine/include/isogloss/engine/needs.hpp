/// What a program asks of a machine: rows of its tables, and programs that it calls.
#pragma once

#include <string>
#include <vector>

#include "isogloss/engine/runner.hpp"

namespace isogloss {

/// A row whose values the program's blocks asked for.
struct NeededRow {
  std::string dependency;  ///< alias
  std::string row;
  bool is_there = false;  ///< before the program began; false: a default holds, or a diagnostic reports it
  Location where{};       ///< of the row in the dialect's or the machine's files; no file: the table comes with it
};

struct NeededProgram {
  std::string name, file;
};

struct ProgramNeeds {
  std::vector<NeededRow> rows;          ///< by dependency in the dialect's order, then by name
  std::vector<NeededProgram> programs;  ///< found in files, in the order of their first calls
};

/// Runs `source` to its end. Diagnostics of the run go to `sink`: they tell what the machine does not answer.
ProgramNeeds find_needs(const LinkedDialect& linked, Source& source, const std::string& name, RunOptions options,
                        DiagnosticSink& sink);

}  // namespace isogloss
