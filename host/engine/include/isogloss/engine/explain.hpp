/// Why a block came out as it did: each syntax that touched it, what it changed, and what was there before.
#pragma once

#include <string>
#include <vector>

#include "isogloss/engine/runner.hpp"

namespace isogloss {

/// A value by its path in the block document, as JSON text.
struct ExplainedValue {
  std::string path;
  std::string value;
  std::string writer;      ///< syntax, by alias; empty: the dialect's initial state
  std::uint32_t line = 0;  ///< that set it; 0: before the first block
};

struct ExplainedChange {
  std::string path;
  std::string before, after;  ///< JSON text; empty: absent
};

struct ExplainedStep {
  std::string syntax;  ///< alias
  std::string plugin;
  std::vector<ExplainedChange> changes;  ///< empty: it was called and changed nothing
};

struct SleepingSyntax {
  std::string syntax;
  std::string wakes_on;  ///< "Parsing.Flags.…, Parsing.…"
};

struct ExplainedBlock {
  Location where;
  std::string text;
  std::vector<ExplainedValue> carried;  ///< what the block began with
  std::vector<ExplainedStep> steps;     ///< in order; the scanners first
  std::vector<SleepingSyntax> slept;
  std::string document;                ///< JSON, after the last syntax
  std::vector<ExplainedValue> values;  ///< the same, value by value with its writer
};

/// Runs `source` up to `line` and explains the blocks of that line; none when the line holds no block. Diagnostics of
/// the whole run go to `sink`.
std::vector<ExplainedBlock> explain(const LinkedDialect& linked, Source& source, const std::string& name,
                                    std::uint32_t line, RunOptions options, DiagnosticSink& sink);

}  // namespace isogloss
