/// REPEAT BEGIN END P=3, REPEATB LABEL and CALL BLOCK BEGIN TO END: a section of the program between labels or block
/// numbers, executed again.
#pragma once

#include "flow/flow_statement.hpp"

namespace siemens {

class RepeatedSections {
 public:
  /// `numbers_end` is raised once a section ends at a block number: such blocks then have to be looked at.
  RepeatedSections(const Environment& environment, LoopStack& loops, const ig::Signal& numbers_end)
      : environment_(environment), loops_(loops), numbers_end_(numbers_end) {}

  /// Executes REPEAT, REPEATB or CALL BLOCK with a label: begins the next pass, or goes on behind the statement after
  /// the last one.
  void repeat(ig::Block& b, const FlowStatement& s);
  /// Ends the pass at its end label or number.
  void end(ig::Block& b, std::string_view label);

 private:
  /// The section that the statement names. Nothing, with a diagnostic, where it names none.
  std::optional<Loop> section_of(ig::Block& b, const FlowStatement& s) const;

  const Environment& environment_;
  LoopStack& loops_;
  const ig::Signal& numbers_end_;
};

}  // namespace siemens
