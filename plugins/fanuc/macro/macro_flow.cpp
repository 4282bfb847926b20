/// GOTO, WHILE, DO and END; and loops that wait for a signal of the machine.
#include "macro/macro_execution.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace fanuc {

using namespace ig::cnc;

void MacroExecution::execute_go_to(ig::Block& b, std::string_view text, std::size_t position, std::size_t behind,
                                   bool by_condition) {
  const bool may_wait = by_condition && asked_only_signals();
  const std::size_t target = skip_blanks(text, behind);
  if (target >= text.size()) return incomplete(b, text, position, "GOTO", "the sequence number");
  const Outcome o = evaluate_at(b, text, target);
  if (!o.ok() || !ends(b, text, o.end)) return;
  const double n = o.value.number;
  if (o.value.kind != Kind::number || !(n >= 0 && n <= 99'999'999) || n != std::floor(n)) {
    b.report(ig::diag("FAN-0132"), ig::Where::columns(target, o.end), piece(text, target, o.end));
    return;
  }
  std::array<char, 24> name{'N'};
  char* const end = std::to_chars(name.data() + 1, name.data() + name.size(), static_cast<std::int64_t>(n)).ptr;
  const std::string_view label(name.data(), static_cast<std::size_t>(end - name.data()));
  if (may_wait && lacks(b, label) && waits_again(b)) return;
  const ig::Flow::Answer answer = environment_.flow.jump(b, label);
  if (answer.is_not_found())
    b.report(ig::diag("FAN-0133"), ig::Where::columns(target, o.end), label.substr(1), answer.reason);
  note_jump(b);
}

void MacroExecution::execute_while(ig::Block& b, std::string_view text, std::size_t position) {
  std::size_t after = 0;
  const std::optional<bool> holds = condition(b, text, position, "WHILE", after);
  if (!holds) return note_unbegun(text, position);
  std::size_t behind = 0;
  if (!is_letter(at(text, after)) || keyword(text, after, behind) != Word::do_)
    return incomplete(b, text, position, "WHILE", "DO");
  if (*holds && !(asked_only_signals() && waits_again(b))) return execute_do(b, text, position, after);
  const auto number = loop_number(b, text, after, "DO");
  if (!number) return;
  loops_here_.leave(b, environment_.flow, *number);
  const ig::Flow::Answer answer = environment_.flow.jump(b, end_label(*number), IG_SEARCH_FORWARD, IG_GO_BEHIND);
  if (answer.is_not_found())
    b.report(ig::diag("FAN-0135"), columns(text, after), static_cast<double>(*number), answer.reason);
}

bool MacroExecution::waits_again(ig::Block& b) {
  const ig_place place = environment_.flow.here(b);
  const Wait now{place.frame, place.offset, environment_.flow.frame(b).pass, environment_.store().writes()};
  if (now != wait_) {
    wait_ = now;
    return false;
  }
  wait_ = {};
  const std::uint32_t signal = environment_.signals().last;
  if (std::find(waited_.begin(), waited_.end(), signal) == waited_.end()) {
    waited_.push_back(signal);
    b.report(ig::diag("FAN-0173"), columns(b.source().substr(0, end_), begin_), static_cast<double>(signal));
  }
  return true;
}

bool MacroExecution::lacks(ig::Block& b, std::string_view label) const {
  if (!flow_) return false;
  ig_go go{};
  go.struct_size = sizeof go;
  go.kind = IG_ASK_LABEL;
  go.label = ig::to_text(label);
  go.search = IG_SEARCH_FORWARD;
  return flow_->go(b.raw(), &go) == IG_GO_NOT_FOUND;
}

std::string_view MacroExecution::end_label(std::int64_t number) {
  char* const end = std::to_chars(label_.data() + 3, label_.data() + label_.size(), number).ptr;
  return {label_.data(), static_cast<std::size_t>(end - label_.data())};
}

std::optional<std::int64_t> MacroExecution::loop_number(ig::Block& b, std::string_view text, std::size_t position,
                                                        std::string_view word) {
  std::int64_t number = 0;
  const std::size_t behind = skip_while(text, position, is_letter);
  if (!fanuc::loop_number(text, behind, number)) {
    incomplete(b, text, position, word, "its number");
    return std::nullopt;
  }
  const std::size_t digits = skip_blanks(text, behind);
  if (!ends(b, text, skip_digits(text, digits))) {
    if (word == "DO") note_unbegun(text, position);
    return std::nullopt;
  }
  if (number < 1 || number > loops_) {
    b.report(ig::diag("FAN-0134"), columns(text, position), word, static_cast<double>(number),
             static_cast<double>(loops_));
    return std::nullopt;
  }
  return number;
}

void MacroExecution::note_unbegun(std::string_view text, std::size_t position) {
  for (std::size_t i = position; i + 2 < text.size(); ++i) {
    std::int64_t number = 0;
    if (equals_ignoring_case(text.substr(i, 2), "DO") && fanuc::loop_number(text, i + 2, number) && number >= 1 &&
        number < static_cast<std::int64_t>(unbegun_.size())) {
      unbegun_[static_cast<std::size_t>(number)] = true;
      return;
    }
  }
}

void MacroExecution::execute_do(ig::Block& b, std::string_view text, std::size_t position, std::size_t at_do) {
  const auto number = loop_number(b, text, at_do, "DO");
  if (!number) return;
  const ig_place place = environment_.flow.here(b);
  std::span<MacroLoops::Loop> open = own_loops(b);
  if (!open.empty() && open.back().number == *number && open.back().place.offset == place.offset) {
    open.back().jumped = false;  // the next pass
    return;
  }
  for (const MacroLoops::Loop& loop : open) {
    if (loop.number != *number) continue;
    if (!loop.jumped && loop.place.offset != place.offset)
      b.report(ig::diag("FAN-0138"), columns(text, position), static_cast<double>(*number),
               static_cast<double>(loop.place.line));
    loops_here_.leave(b, environment_.flow, *number);
    break;
  }
  unbegun_[static_cast<std::size_t>(*number)] = false;
  loops_here_.begin(*number, place);
  if (lacks(b, end_label(*number))) b.report(ig::diag("FAN-0144"), columns(text, at_do), static_cast<double>(*number));
}

void MacroExecution::execute_end(ig::Block& b, std::string_view text, std::size_t position) {
  const auto number = loop_number(b, text, position, "END");
  if (!number) return;
  std::span<MacroLoops::Loop> open = own_loops(b);
  while (!open.empty() && open.back().number != *number) {
    const MacroLoops::Loop inner = open.back();
    const bool is_open =
        std::any_of(open.begin(), open.end(), [&](const MacroLoops::Loop& l) { return l.number == *number; });
    if (!is_open) break;
    if (!inner.jumped)
      b.report(ig::diag("FAN-0137"), columns(text, position), static_cast<double>(*number),
               static_cast<double>(inner.number), static_cast<double>(inner.place.line));
    loops_here_.end_innermost();
    open = own_loops(b);
  }
  if (open.empty() || open.back().number != *number) {
    if (std::exchange(unbegun_[static_cast<std::size_t>(*number)], false)) return;  // why it was not begun is said
    b.report(ig::diag("FAN-0136"), columns(text, position), static_cast<double>(*number));
    return;
  }
  environment_.flow.go_to(b, open.back().place);
}

}  // namespace fanuc
