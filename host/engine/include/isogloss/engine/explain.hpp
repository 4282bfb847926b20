/// Why a block did what it did: each syntax that touched it, what it changed, and the previous value.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "isogloss/engine/runner.hpp"

namespace isogloss {

/// A line of a program. Lines count from 1; 0: before the first block, by the dialect or when the run began.
struct ProgramLine {
  std::string file;
  std::uint32_t line = 0;
  bool operator==(const ProgramLine&) const = default;
};

/// A value by its path in the block document, as JSON text.
struct ExplainedValue {
  std::string path;
  std::string value;
  std::string writer;  ///< syntax, by alias; empty: the dialect's initial state
  ProgramLine set;     ///< set it last
  ProgramLine since;   ///< set it to this value; the lines between have repeated it
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
  bool is_scan = false;  ///< it has read text of the block; the others have built it
  std::vector<ExplainedAnswer> answers{};
  std::vector<ExplainedRow> rows{};
  std::vector<ExplainedChange> changes{};  ///< empty: it was called and changed nothing
};

struct SleepingSyntax {
  std::string syntax;
  std::string wakes_on;  ///< "Parsing.Flags.…, Parsing.…"
};

/// A piece of the block's text.
struct ExplainedWord {
  std::string text;                  ///< as written
  std::uint32_t column = 0;          ///< from 1
  std::string name;                  ///< "X", "F"; a code by its own name; empty: text that is no word
  std::string value;                 ///< of a word: JSON text, in the units of the document
  std::string reader;                ///< the syntax that has read the text; empty: none
  std::vector<std::string> users{};  ///< those that have used the word, in their order; empty: none
};

/// A variable of the program that the block has read.
struct ExplainedVariable {
  std::string name;           ///< as a program writes it: "#101", "R5"
  std::string value;          ///< JSON text; empty: it has none
  std::string writer;         ///< the syntax that has written it last; empty: no block has
  ProgramLine written{};      ///< by this line
  std::string written_value;  ///< to this value
};

/// A condition that decides where the run goes on, or which words of the block count.
struct ExplainedCondition {
  std::string text;  ///< as the program writes it; a reason in words where `is_reason`
  bool holds = false;
  bool is_reason = false;  ///< "pass 2 of 3": it neither holds nor fails
  bool operator==(const ExplainedCondition&) const = default;
};

/// Where the run goes on after the block.
struct ExplainedGo {
  enum class Kind : std::uint8_t {
    next,   ///< behind the block
    call,   ///< in `program`, which the block calls
    leave,  ///< in the program that has called this one
    again,  ///< at the beginning of the called program, whose call repeats it
    jump    ///< at another block of this program
  };
  Kind kind = Kind::next;
  std::string program;                 ///< the program that is called, left or repeated, by its name
  Location to;                         ///< line 0: behind the block
  bool is_behind = false;              ///< not with the block of that line: with the one behind it
  std::uint32_t call_line = 0;         ///< leave: the line of the call, in the file of `to`
  std::uint32_t pass = 1, passes = 1;  ///< again: the pass that begins; call: how many there are
};

/// A function of the program that is a part of a transform.
struct ExplainedPart {
  std::array<double, 16> matrix;
  std::string label;  ///< the first name that the section had in the line; empty: it had none
  ProgramLine since;
  std::array<double, 3> point{};  ///< behind it
};

/// One transform on the way from the program to the machine that changes something.
struct ExplainedRung {
  std::string source;             ///< who contributes it, by the section's name: "CoordinateOffset"
  std::string label;              ///< the first name among the section's values; empty: it has none
  std::array<double, 16> matrix;  ///< row vectors, translation in elements 12 to 14
  bool is_moving = false;         ///< it moves with the axes during the block
  std::array<double, 3> point{};  ///< behind it
  std::string writer;
  ProgramLine since;        ///< made it this transform
  ProgramLine label_since;  ///< gave the section its label
  /// The functions that make it up, in the order in which they act; empty: it comes from one, or only their product is
  /// known.
  std::vector<ExplainedPart> parts{};
};

/// The way of the block's last point from the program to the machine; mm.
struct ExplainedLadder {
  bool is_there = false;  ///< the block, or one before it, has a program point
  std::array<double, 3> program{};
  std::vector<ExplainedRung> rungs;
};

/// A program under way: the main one, or one that was called.
struct ExplainedFrame {
  std::string file;
  std::string program;          ///< the name by which it was called; empty: the main program
  std::uint32_t call_line = 0;  ///< in the file of the frame before
  std::uint32_t pass = 1, passes = 1;
  std::uint64_t call = 0;  ///< tells the calls of a run apart
};

struct ExplainedBlock {
  Location where;
  std::uint64_t pass = 1;              ///< how often the run had come to this line
  std::vector<ExplainedFrame> frames;  ///< the main program's first
  std::string text;
  ExplainedGo go;
  std::vector<ExplainedCondition> conditions;  ///< in the order in which they were examined
  std::vector<ExplainedValue> carried;         ///< what the block began with
  std::vector<ExplainedStep> steps;            ///< in order; the scanners first
  std::vector<SleepingSyntax> slept;
  std::vector<ExplainedWord> words;          ///< by column
  std::vector<ExplainedVariable> variables;  ///< in the order in which they were read
  std::vector<ExplainedVariable> written;    ///< variables that the block has written, with the values written
  ExplainedLadder ladder;
  std::string document;                ///< JSON, after the last syntax
  std::vector<ExplainedValue> values;  ///< the same, value by value with its writer
  /// Of each syntax of the chain, by its alias, the summary in one sentence.
  std::shared_ptr<const std::map<std::string, std::string, std::less<>>> summaries;
};

/// Which blocks are explained: those of a line, when the run comes to it for the pass-th time.
struct ExplainTarget {
  std::uint32_t line = 0;
  std::uint32_t last_line = 0;  ///< of a range that begins at `line`; 0: there is only this line
  std::string file{};           ///< a called program's, by its name with or without folder; empty: the main program's
  std::uint64_t pass = 1;       ///< from 1
  std::size_t most_blocks = 1'000;  ///< the run ends when so many are explained
  std::uint32_t last() const { return last_line != 0 ? last_line : line; }
};

/// What is known about a target that the run does not reach. Lines count from 1; 0: there is none.
struct ExplainReach {
  std::uint64_t passes = 0;                      ///< how often the run came to the line
  std::uint32_t first = 0;                       ///< the first line of the target's file that was run
  std::uint32_t jumped_from = 0, jumped_to = 0;  ///< two lines run one after the other, the target between them
  Location last{};                               ///< the last block of the run, in whatever file
  std::string last_text{};
  bool is_cut = false;  ///< most_blocks has ended the run
};

/// Runs `source` up to the target and explains its blocks; none when the run does not reach it; `reach`
/// then tells why. Diagnostics of the whole run go to `sink`.
std::vector<ExplainedBlock> explain(const LinkedDialect& linked, Source& source, const std::string& name,
                                    const ExplainTarget& target, RunOptions options, DiagnosticSink& sink,
                                    ExplainReach* reach = nullptr);

}  // namespace isogloss
