/// A statement of the program flow while it is executed, and what IF and the loops share.
#pragma once

#include "flow/flow_words.hpp"
#include "flow/loop_stack.hpp"

namespace siemens {

struct FlowStatement {
  FlowWord word;
  std::string_view text;      ///< of the block, up to the end of the statement
  std::size_t begin, behind;  ///< of the first word
  std::int64_t line;

  ig::Where where() const { return columns(text, begin); }
  /// True where the statement ends with its first word; false, with a diagnostic, where other text follows.
  bool ends_here(ig::Block& b) const { return ends(b, text, behind); }
};

/// The value of the condition behind the first word; `after` receives the position where it ends. Nothing, with a
/// diagnostic, where it has none.
std::optional<bool> condition(ig::Block& b, const Environment& environment, const FlowStatement& s, std::size_t& after);

/// Goes on behind the ENDIF, ENDWHILE, … that BranchIndex has labelled for this statement; reports where there is none.
void jump_behind(ig::Block& b, const Environment& environment, const FlowStatement& s, std::string_view end);

/// Makes `loop` the innermost one. False, with a diagnostic and the end of the program, where loops are nested too
/// deeply.
bool enter_loop(ig::Block& b, const FlowStatement& s, LoopStack& loops, Loop loop);

}  // namespace siemens
