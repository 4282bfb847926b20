// Conditions, jumps to the end of a statement, and the limit of nested loops.
#include "flow/flow_statement.hpp"

#include "flow/branch_index.hpp"

namespace siemens {

using namespace ig::cnc;

std::optional<bool> condition(ig::Block& b, const Environment& environment, const FlowStatement& s,
                              std::size_t& after) {
  Expression e(b, environment, s.text, s.behind);
  const auto holds = e.truth();
  after = skip_blanks(s.text, e.position());
  if (holds) environment.examined().add(b, trim(piece(s.text, s.behind, e.position())), *holds);
  return holds;
}

void jump_behind(ig::Block& b, const Environment& environment, const FlowStatement& s, std::string_view end) {
  const std::string label = BranchIndex::named(std::string(end).append("@"), s.line);
  if (environment.flow.jump(b, label, IG_SEARCH_FORWARD, IG_GO_BEHIND).is_not_found())
    b.report(ig::diag("SIE-0142"), s.where(), end);
}

bool enter_loop(ig::Block& b, const FlowStatement& s, LoopStack& loops, Loop loop) {
  if (loops.push(std::move(loop))) return true;
  b.report(ig::diag("SIE-0143"), s.where(), static_cast<double>(LoopStack::deepest));
  b.end_program();
  return false;
}

}  // namespace siemens
