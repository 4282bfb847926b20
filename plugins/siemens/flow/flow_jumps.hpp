/// GOTO, GOTOF, GOTOB and GOTOC, and CASE, which selects one of several jumps.
#pragma once

#include "flow/flow_words.hpp"
#include "flow/loop_stack.hpp"

namespace siemens {

using namespace ig::cnc;

class Jumps {
 public:
  Jumps(const Environment& environment, LoopStack& loops) : environment_(environment), loops_(loops) {}

  /// Executes GOTOF LABEL at `position`; LABEL is a name, a sequence number or a text.
  void go(ig::Block& b, std::string_view text, std::size_t position) {
    const std::size_t behind = skip_name(text, position);
    const std::string kind = upper(piece(text, position, behind));
    loops_.enter(environment_.flow.frame(b));
    if (kind == "GOTOS") {
      if (ends(b, text, behind)) environment_.flow.restart(b);
      return;
    }
    const std::size_t target = skip_blanks(text, behind);
    std::size_t end = skip_name(text, target);
    std::string label = upper(piece(text, target, end));
    const Variable* const variable = label.empty() ? nullptr : environment_.store().find(label);
    const std::size_t next = skip_blanks(text, end);
    if (label.empty() || (variable != nullptr && variable->value.is_text()) ||
        text.substr(std::min(next, text.size())).starts_with("<<")) {
      Expression e(b, environment_, text, target);
      const auto name = e.value();
      if (!name) return;
      if (!name->is_text()) {
        b.report(ig::diag("SIE-0148"), columns(text, target), text.substr(std::min(target, text.size())));
        return;
      }
      label = upper(trim(name->text));
      if (label.ends_with(':')) label.pop_back();
      end = e.position();
    }
    if (is_digit(label.empty() ? '0' : label[0])) {
      b.report(ig::diag("SIE-0148"), columns(text, target), text.substr(std::min(target, text.size())));
      return;
    }
    if (!ends(b, text, end)) return;
    drop_zeros(label);
    const ig_search search = kind == "GOTOF"   ? ig_search{IG_SEARCH_FORWARD}
                             : kind == "GOTOB" ? ig_search{IG_SEARCH_BACKWARD}
                                               : ig_search{IG_SEARCH_AROUND};
    const ig::Flow::Answer answer = environment_.flow.jump(b, label, search);
    if (answer.is_not_found()) {
      if (kind != "GOTOC")
        b.report(ig::diag("SIE-0149"), columns(text, target), std::string_view(label), answer.reason);
      return;
    }
    loops_.note_jump(environment_.flow.frame(b).id);
  }

  /// Executes GOTOF A IF c GOTOF B at `position`, after a condition whose value is `holds`: of several jumps in a
  /// block, the first one whose condition holds is executed.
  void by_conditions(ig::Block& b, std::string_view text, std::size_t position, bool holds) {
    for (;;) {
      const std::size_t other = find_word(text, position, "IF");
      if (holds) return go(b, text.substr(0, other), position);
      if (other == text.size()) return read_only(b, text, position);
      Expression e(b, environment_, text, other + 2);
      const auto condition = e.truth();
      if (!condition) return;
      environment_.examined().add(b, trim(piece(text, other + 2, e.position())), *condition);
      position = skip_blanks(text, e.position());
      if (flow_word(piece(text, position, skip_name(text, position))) != FlowWord::go) {
        ends(b, text, other);
        return;
      }
      holds = *condition;
    }
  }

  /// Executes CASE (x) OF 1 GOTOF A 2 GOTOF B DEFAULT GOTOF C.
  void by_case(ig::Block& b, std::string_view text, std::size_t begin, std::size_t behind_case) {
    Expression e(b, environment_, text, behind_case);
    const auto value = e.number();
    if (!value) return;
    std::size_t next = skip_blanks(text, e.position());
    if (!is_word(text, next, "OF")) {
      b.report(ig::diag("SIE-0144"), columns(text, begin));
      return;
    }
    next = skip_blanks(text, next + 2);
    while (next < text.size()) {
      const bool is_default = is_word(text, next, "DEFAULT");
      bool matches = is_default;
      if (is_default) {
        next += 7;
      } else {
        Expression constant(b, environment_, text, next);
        const auto n = constant.number();
        if (!n) return;
        matches = *n == *value;
        next = constant.position();
      }
      next = skip_blanks(text, next);
      const std::size_t behind = skip_name(text, next);
      if (flow_word(piece(text, next, behind)) != FlowWord::go) {
        b.report(ig::diag("SIE-0144"), columns(text, begin));
        return;
      }
      const std::size_t label = skip_blanks(text, behind), end = skip_name(text, label);
      if (matches) {
        if (is_default && !ends(b, text, end)) return;
        note_case(b, piece(text, behind_case, e.position()), is_default, *value);
        return go(b, text.substr(0, end), next);
      }
      next = skip_blanks(text, end);
    }
    if (environment_.examined().is_heard())
      environment_.examined().add_reason(
          b, shown_case(piece(text, behind_case, e.position()), *value) + ", for which CASE names no jump");
  }

 private:
  /// Of a jump whose condition does not hold: what stands behind a plain label is reported all the same.
  static void read_only(ig::Block& b, std::string_view text, std::size_t position) {
    const std::size_t label = skip_blanks(text, skip_name(text, position)), end = skip_name(text, label);
    const char next = at(text, skip_blanks(text, end));
    if (end != label && next != '<' && next != '[' && next != '(') ends(b, text, end);
  }
  static std::string shown_case(std::string_view expression, double value) {
    return std::string(trim(expression)).append(" is ").append(shown_number(value));
  }
  void note_case(ig::Block& b, std::string_view expression, bool is_default, double value) const {
    if (environment_.examined().is_heard())
      environment_.examined().add_reason(
          b, shown_case(expression, value) + (is_default ? ", for which only DEFAULT stands" : ""));
  }

  const Environment& environment_;
  LoopStack& loops_;
};

}  // namespace siemens
