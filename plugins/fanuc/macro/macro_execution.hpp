/// Executes the statements of custom macro B: finds where each ends, and runs it on the text of its block.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <isogloss_flow.h>
#include <isogloss/cnc/scan.hpp>

#include "macro/macro_environment.hpp"
#include "macro/macro_loops.hpp"
#include "macro/macro_output.hpp"
#include "macro/macro_statement_text.hpp"

namespace fanuc {

using namespace ig::cnc;

/// The one member of the syntax.
class MacroExecution {
 public:
  /// Where the statement at `position` ends; `position` where none stands there.
  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position);

  ig::Status restart();

  ig::Status build(ig::Block& b);

 private:
  enum class Governs { statement, rest_of_block };

  ig::IntegerOption loops_{"loops", "3", {1, 99}, "The largest loop number after DO and END."};
  ig::Choice<Governs> governs_{
      "if-governs", "statement|rest-of-block", "statement",
      "What the condition of IF governs: the one macro statement after THEN, or everything after the condition in the "
      "block, with or without THEN; with the latter also [condition] M99."};
  MacroEnvironment environment_;
  ig::Service<ig_flow_1> flow_{IG_FLOW_SERVICE, ig::Need::optional, "Whether a loop has its END."};
  ig::TextField program_{"Source.Program", ig::read | ig::wake};
  ig::TextField tape_{"TapeBoundary.Text", ig::read | ig::wake};
  ig::Codes program_end_{{"M02", "M30"}, ig::read | ig::wake};
  ig::Call return_{{"M99"}, "", ig::read | ig::wake};
  ig::In<double> p_{"Parsing.P"};
  ig::Signal statement_{"Parsing.~MacroStatement", ig::read | ig::write | ig::wake};
  ig::Out<std::int64_t> variable_{"Vars.Variable", {ig::Life::block, "", "Number of the variable that was assigned."}};
  ig::Out<double> value_{"Vars.Value", {ig::Life::block, "", "The value that was assigned; absent: null."}};
  ig::Out<ig::Symbol> stop_{"ProgramStop.Term"};
  ig::Name message_stop_{"#3006"};

  // ---- macro_execution.cpp: which statement it is

  /// M99 P in the main program is a jump.
  void end_of_program(ig::Block& b);
  void note_jump(ig::Block& b) {
    for (MacroLoops::Loop& loop : own_loops(b)) loop.jumped = true;
  }

  /// #4115 of the main program. Another program number ends the one before it.
  void note_program(ig::Block& b);

  /// The statement with blanks for its comments, so that columns stay.
  void blank_comments(std::string_view text);
  void report_label(ig::Block& b, std::string_view text, std::size_t position) const;
  Outcome evaluate_at(ig::Block& b, std::string_view text, std::size_t position) const;

  void execute(ig::Block& b, std::string_view text, std::size_t position);

  static ig::Where columns(std::string_view text, std::size_t position) {
    return ig::Where::columns(position, std::max(text.size(), position + 1));
  }
  static void incomplete(ig::Block& b, std::string_view text, std::size_t position, std::string_view what,
                         std::string_view missing);
  /// False, and said, when something stands behind the statement.
  static bool ends(ig::Block& b, std::string_view text, std::size_t position);

  // ---- macro_condition.cpp: IF, and what it governs

  /// Nothing where it has no answer, which is said. `after`: behind it.
  std::optional<bool> condition(ig::Block& b, std::string_view text, std::size_t position, std::string_view what,
                                std::size_t& after) const;

  /// IF […] THEN before words.
  std::size_t scan_words(ig::Block& b, std::string_view text, std::size_t position, std::size_t words, std::size_t end);

  /// Everything behind the condition of IF, with or without THEN.
  std::size_t scan_governed(ig::Block& b, std::string_view text, std::size_t position, std::size_t rest,
                            std::size_t end);

  /// [#100 LT 10] M99: an M99 if it holds. With P10 it is a GOTO10, and so a statement.
  std::size_t scan_return(ig::Block& b, std::string_view text, std::size_t position);

  void execute_return_to(ig::Block& b, std::string_view text, std::size_t position);

  void execute_if(ig::Block& b, std::string_view text, std::size_t position);

  // ---- macro_assignment.cpp

  void assign(ig::Block& b, std::string_view text, std::size_t position);

  /// #3000=1(TEXT) and #3006=1(TEXT)
  void message(ig::Block& b, std::string_view text, std::size_t position, std::uint32_t number, const MacroValue& value,
               std::size_t end);

  // ---- macro_flow.cpp: GOTO and loops

  /// `by_condition`: IF was asked, and holds.
  void execute_go_to(ig::Block& b, std::string_view text, std::size_t position, std::size_t behind,
                     bool by_condition = false);

  std::span<MacroLoops::Loop> own_loops(ig::Block& b) { return loops_here_.own(b, environment_.flow); }

  void execute_while(ig::Block& b, std::string_view text, std::size_t position);

  /// The last condition read a signal of the machine, and else nothing that changes by itself.
  bool asked_only_signals() const { return environment_.signals().last != 0 && !environment_.signals().others_also; }

  /// A condition that goes back holds here with nothing written since it last did: the program waits for the machine,
  /// which is not here. True, and said, when it came so a second time: what it waits for has come.
  bool waits_again(ig::Block& b);

  /// Does no block of that name stand behind this one in the program?
  bool lacks(ig::Block& b, std::string_view label) const;

  std::string_view end_label(std::int64_t number);

  /// The number behind DO or END at `position`; nothing, and said, where it is none.
  std::optional<std::int64_t> loop_number(ig::Block& b, std::string_view text, std::size_t position,
                                          std::string_view word);

  /// The loop of a faulty WHILE or DO: its END is no fault of its own.
  void note_unbegun(std::string_view text, std::size_t position);

  /// WHILE […] DO m that holds, and DO m alone. `position`: of the block's statement, `at_do`: of DO.
  void execute_do(ig::Block& b, std::string_view text, std::size_t position, std::size_t at_do);

  void execute_end(ig::Block& b, std::string_view text, std::size_t position);

  std::size_t begin_ = 0, end_ = 0;  // of the statement that scan() found
  bool has_comment_ = false;         // inside it
  std::string blanked_;
  ReportedOutput reported_output_;
  struct Wait {
    std::uint64_t frame = 0, offset = 0;
    std::uint32_t pass = 0;
    std::uint64_t writes = ~std::uint64_t{0};
    bool operator==(const Wait&) const = default;
  };
  Wait wait_;                          // the last condition that went back
  std::vector<std::uint32_t> waited_;  // signals whose wait was said
  MacroLoops loops_here_;
  std::array<bool, 100> unbegun_{};  // by number: a faulty DO came, and was said
  std::array<char, 24> label_{'E', 'N', 'D'};
};

}  // namespace fanuc
