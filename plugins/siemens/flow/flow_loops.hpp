/// WHILE, FOR, LOOP and REPEAT … UNTIL: where each begins, goes on and ends.
#pragma once

#include "flow/flow_statement.hpp"

namespace siemens {

class FlowLoops {
 public:
  FlowLoops(const Environment& environment, LoopStack& loops) : environment_(environment), loops_(loops) {}

  /// Executes LOOP, or REPEAT without a label.
  void begin(ig::Block& b, const FlowStatement& s, LoopKind kind);
  void begin_while(ig::Block& b, const FlowStatement& s);
  /// Executes FOR i=1 TO 10: the variable increases in steps of 1; the pass with the end value is made, too.
  void begin_for(ig::Block& b, const FlowStatement& s);
  /// Executes ENDWHILE, ENDFOR or ENDLOOP.
  void end(ig::Block& b, const FlowStatement& s, LoopKind kind);
  void until(ig::Block& b, const FlowStatement& s);

 private:
  /// Enters the loop that begins at this line, where it is not running yet.
  void enter(ig::Block& b, const FlowStatement& s, LoopKind kind);
  /// Goes on behind the loop that begins at this line.
  void leave(ig::Block& b, const FlowStatement& s, LoopKind kind);
  Stored set(const Expression::Reference& to, double value) const;
  std::uint64_t frame(const ig::Block& b) const { return environment_.flow.frame(b).id; }

  const Environment& environment_;
  LoopStack& loops_;
};

}  // namespace siemens
