// The loops of the control. A loop is known by the line of its beginning; its end sends the run back there.
#include "flow/flow_loops.hpp"

#include <cmath>

#include "flow/branch_index.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

std::string_view begin_of(LoopKind kind) {
  return kind == LoopKind::while_ ? "WHILE" : kind == LoopKind::for_ ? "FOR" : "LOOP";
}
std::string_view end_of(LoopKind kind) {
  return kind == LoopKind::while_ ? "ENDWHILE" : kind == LoopKind::for_ ? "ENDFOR" : "ENDLOOP";
}

}  // namespace

void FlowLoops::enter(ig::Block& b, const FlowStatement& s, LoopKind kind) {
  const ig_frame f = environment_.flow.frame(b);
  if (Loop* const loop = loops_.at_line(f.id, s.line, kind)) {
    loop->jumped = false;
    return;
  }
  Loop loop{
      .kind = kind, .frame = f.id, .pass = f.pass, .line = s.line, .place = environment_.flow.here(b), .until = {}};
  if (!enter_loop(b, s, loops_, std::move(loop)) || kind == LoopKind::until) return;
  const std::string label = BranchIndex::named(std::string(end_of(kind)).append("@"), s.line);
  if (!environment_.flow.has_label(b, label, IG_SEARCH_FORWARD))
    b.report(ig::diag("SIE-0142"), s.where(), end_of(kind));
}

void FlowLoops::leave(ig::Block& b, const FlowStatement& s, LoopKind kind) {
  if (loops_.at_line(frame(b), s.line, kind) != nullptr) loops_.pop();
  jump_behind(b, environment_, s, end_of(kind));
}

void FlowLoops::begin(ig::Block& b, const FlowStatement& s, LoopKind kind) {
  if (s.ends_here(b)) enter(b, s, kind);
}

void FlowLoops::begin_while(ig::Block& b, const FlowStatement& s) {
  std::size_t after = 0;
  const auto holds = condition(b, environment_, s, after);
  if (holds && is_word(s.text, after, "DO")) after = skip_name(s.text, after);  // programs write WHILE (…) DO as well
  if (!holds || !ends(b, s.text, after) || !*holds) return leave(b, s, LoopKind::while_);
  enter(b, s, LoopKind::while_);
}

void FlowLoops::begin_for(ig::Block& b, const FlowStatement& s) {
  const std::string_view text = s.text;
  Expression e(b, environment_, text, skip_blanks(text, s.behind));
  const auto variable = e.reference();
  if (!variable) return leave(b, s, LoopKind::for_);
  std::size_t next = skip_blanks(text, e.position());
  Expression first(b, environment_, text, next + 1);
  const auto from = at(text, next) == '=' ? first.number() : std::nullopt;
  if (from) next = skip_blanks(text, first.position());
  Expression last(b, environment_, text, next + 2);
  const bool is_complete = from && is_word(text, next, "TO");
  const auto to = is_complete ? last.number() : std::nullopt;
  if (!is_complete && (at(text, next) != '=' || from)) b.report(ig::diag("SIE-0144"), s.where());
  if (!to || !ends(b, text, last.position())) return leave(b, s, LoopKind::for_);
  Loop* const running = loops_.at_line(frame(b), s.line, LoopKind::for_);
  double value = *from;
  if (running != nullptr && running->goes_on) {
    Expression now(b, environment_, text, variable->begin);
    value = now.number().value_or(*to) + 1;
    running->goes_on = false;
  }
  const Stored stored = set(*variable, value);
  environment_.note_write(b, variable->name, Value::real(value));
  if (stored == Stored::unknown || stored == Stored::wrong_type) {
    b.report(ig::diag("SIE-0124"), columns(text, variable->begin), std::string_view(variable->name));
    return leave(b, s, LoopKind::for_);
  }
  if (environment_.examined().is_heard())
    environment_.examined().add_reason(b, variable->name + " = " + shown_number(value) +
                                              (value > *to ? " is above " : " is not above ") + shown_number(*to));
  if (value > *to) return leave(b, s, LoopKind::for_);
  if (stored != Stored::yes) {
    environment_.report_not_stored(b, columns(text, variable->begin), variable->name, Value::real(value), stored);
    return leave(b, s, LoopKind::for_);
  }
  enter(b, s, LoopKind::for_);
}

Stored FlowLoops::set(const Expression::Reference& to, double value) const {
  VariableStore& store = environment_.store();
  if (!to.is_r) return store.find(to.name) ? store.assign(to.name, Value::real(value)) : Stored::unknown;
  store.assign_r(to.r, value);
  return Stored::yes;
}

void FlowLoops::end(ig::Block& b, const FlowStatement& s, LoopKind kind) {
  if (!s.ends_here(b)) return;
  bool doubtful = false;
  Loop* const loop = loops_.ending(frame(b), s.line, kind, doubtful);
  if (loop == nullptr) {
    b.report(ig::diag("SIE-0145"), s.where(), s.text.substr(s.begin), begin_of(kind));
    return;
  }
  if (doubtful) b.report(ig::diag("SIE-0146"), s.where(), begin_of(kind), static_cast<double>(loop->line));
  loop->goes_on = true;
  environment_.flow.go_to(b, loop->place);
}

void FlowLoops::until(ig::Block& b, const FlowStatement& s) {
  bool doubtful = false;
  Loop* const loop = loops_.ending(frame(b), s.line, LoopKind::until, doubtful);
  if (loop == nullptr) {
    b.report(ig::diag("SIE-0145"), s.where(), std::string_view("UNTIL"), std::string_view("REPEAT"));
    return;
  }
  std::size_t after = 0;
  const auto holds = condition(b, environment_, s, after);
  if (!holds || *holds || !ends(b, s.text, after))
    loops_.pop();
  else
    environment_.flow.go_to(b, loop->place);
}

}  // namespace siemens
