/// Why a block did what it did: each syntax that touched it, what it changed, and the previous value.
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

/// Which dependency answers a syntax that asks for a service.
struct ExplainedAnswer {
  std::string service;
  std::string dependency;  ///< alias
};

/// A row of a table that has answered in this block.
struct ExplainedRow {
  std::string dependency;  ///< alias
  std::string row;         ///< its name
  Location where;          ///< in the XML or in the file of the control; no file: not given by a file
  friend bool operator==(const ExplainedRow& a, const ExplainedRow& b) {
    return a.dependency == b.dependency && a.row == b.row;
  }
};

struct ExplainedStep {
  std::string syntax;  ///< alias
  std::string plugin;
  std::vector<ExplainedAnswer> answers{};
  std::vector<ExplainedRow> rows{};
  std::vector<ExplainedChange> changes;  ///< empty: it was called and changed nothing
};

struct SleepingSyntax {
  std::string syntax;
  std::string wakes_on;  ///< "Parsing.Flags.…, Parsing.…"
};

/// A program under way: the main one, or one that was called.
struct ExplainedFrame {
  std::string file;
  std::string program;          ///< the name by which it was called; empty: the main program
  std::uint32_t call_line = 0;  ///< in the file of the frame before
  std::uint32_t pass = 1, passes = 1;
};

struct ExplainedBlock {
  Location where;
  std::uint64_t pass = 1;              ///< how often the run had come to this line
  std::vector<ExplainedFrame> frames;  ///< the main program's first
  std::string text;
  std::string calls;                    ///< the program that the block calls, by its name; empty: none
  Location callee;                      ///< where this program begins
  std::vector<ExplainedValue> carried;  ///< what the block began with
  std::vector<ExplainedStep> steps;     ///< in order; the scanners first
  std::vector<SleepingSyntax> slept;
  std::string document;                ///< JSON, after the last syntax
  std::vector<ExplainedValue> values;  ///< the same, value by value with its writer
};

/// Which blocks are explained: those of a line, when the run comes to it for the pass-th time.
struct ExplainTarget {
  std::uint32_t line = 0;
  std::string file{};      ///< a called program's, by its name with or without folder; empty: the main program's
  std::uint64_t pass = 1;  ///< from 1
};

/// What is known about a target that the run does not reach. Lines count from 1; 0: there is none.
struct ExplainReach {
  std::uint64_t passes = 0;                      ///< how often the run came to the line
  std::uint32_t first = 0;                       ///< the first line of the target's file that was run
  std::uint32_t jumped_from = 0, jumped_to = 0;  ///< two lines run one after the other, the target between them
  Location last{};                               ///< the last block of the run, in whatever file
  std::string last_text{};
};

/// Runs `source` up to the target and explains its blocks; none when the run does not reach it; `reach`
/// then tells why. Diagnostics of the whole run go to `sink`.
std::vector<ExplainedBlock> explain(const LinkedDialect& linked, Source& source, const std::string& name,
                                    const ExplainTarget& target, RunOptions options, DiagnosticSink& sink,
                                    ExplainReach* reach = nullptr);

}  // namespace isogloss
