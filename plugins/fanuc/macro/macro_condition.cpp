/// IF, and [condition] M99. Where the condition governs words of its block, it is asked while the block is scanned.
#include "macro/macro_execution.hpp"

namespace fanuc {

using namespace ig::cnc;

std::optional<bool> MacroExecution::condition(ig::Block& b, std::string_view text, std::size_t position,
                                              std::string_view what, std::size_t& after) const {
  const std::size_t bracket = skip_blanks(text, skip_while(text, position, is_letter));
  if (at(text, bracket) != '[') {
    incomplete(b, text, position, what, "[");
    return std::nullopt;
  }
  environment_.forget_signals();
  const Outcome o = evaluate_at(b, text, bracket);
  if (!o.ok()) return std::nullopt;
  after = skip_blanks(text, o.end);
  if (o.value.kind != Kind::truth && !environment_.rules().truth_is_number) {
    b.report(ig::diag("FAN-0116"), ig::Where::columns(bracket, o.end), piece(text, bracket, o.end));
    return std::nullopt;
  }
  environment_.note_condition(b, piece(text, bracket, o.end), o.value.number != 0);
  return o.value.number != 0;
}

std::size_t MacroExecution::scan_words(ig::Block& b, std::string_view text, std::size_t position, std::size_t words,
                                       std::size_t end) {
  environment_.enter(b);
  std::size_t after = 0;
  const std::optional<bool> holds = condition(b, text.substr(0, end), position, "IF", after);
  if (!holds || !*holds) return end;
  b.report(ig::diag("FAN-0143"), ig::Where::columns(words, end));
  return words;
}

std::size_t MacroExecution::scan_governed(ig::Block& b, std::string_view text, std::size_t position, std::size_t rest,
                                          std::size_t end) {
  environment_.enter(b);
  std::size_t after = 0;
  const std::optional<bool> holds = condition(b, text.substr(0, end), position, "IF", after);
  if (!holds || !*holds) return end;
  if (is_letter(text[rest])) return rest;
  begin_ = rest;
  end_ = assignment_end(text, rest, end);
  b.raise(statement_);
  return end_;
}

std::size_t MacroExecution::scan_return(ig::Block& b, std::string_view text, std::size_t position) {
  if (governs_ != Governs::rest_of_block || !stands_first(text, position)) return position;
  bool has_comment = false;
  const std::size_t end = statement_end(text, position, has_comment);
  const std::size_t rest = skip_blanks(text, skip_bracketed(text.substr(0, end), position));
  const std::size_t behind = return_end(text.substr(0, end), rest);
  if (behind == 0) return position;
  if (environment_.flow.is_indexing()) return end;
  if (to_upper(at(text, behind)) == 'P') {
    begin_ = position;
    end_ = end;
    has_comment_ = has_comment;
    b.raise(statement_);
    return end;
  }
  environment_.enter(b);
  const Outcome o = evaluate_at(b, text.substr(0, end), position);
  if (o.ok()) environment_.note_condition(b, piece(text, position, o.end), o.value.number != 0);
  return o.ok() && o.value.number != 0 ? rest : end;
}

void MacroExecution::execute_return_to(ig::Block& b, std::string_view text, std::size_t position) {
  const Outcome o = evaluate_at(b, text, position);
  if (!o.ok()) return;
  environment_.note_condition(b, piece(text, position, o.end), o.value.number != 0);
  if (o.value.number == 0) return;
  execute_go_to(b, text, position, return_end(text, skip_blanks(text, o.end)) + 1);
}

void MacroExecution::execute_if(ig::Block& b, std::string_view text, std::size_t position) {
  std::size_t after = 0;
  const std::optional<bool> holds = condition(b, text, position, "IF", after);
  if (!holds) return;
  std::size_t behind = 0;
  const Word next = is_letter(at(text, after)) ? keyword_or_short(text, after, behind) : Word::none;
  if (next == Word::go_to) {
    if (*holds) return execute_go_to(b, text, after, behind, true);
    // A jump that is not executed is read all the same, as far as it is a number.
    const std::size_t target = skip_blanks(text, behind), end = skip_while(text, target, is_digit);
    if (end != target && at(text, end) != '.') ends(b, text, end);
    return;
  }
  if (next != Word::then) {
    if (after < text.size())
      b.report(ig::diag("FAN-0123"), ig::Where::columns(after, text.size()), text.substr(after));
    else
      incomplete(b, text, position, "IF", "GOTO or THEN");
    return;
  }
  const std::size_t statement = skip_blanks(text, behind);
  if (statement >= text.size()) return incomplete(b, text, position, "THEN", "the statement");
  const Word inner = is_letter(text[statement]) ? keyword_or_short(text, statement, behind) : Word::none;
  const bool is_plain = text[statement] == '#' || inner == Word::go_to || inner == Word::output;
  if (!is_plain) {
    b.report(ig::diag("FAN-0123"), ig::Where::columns(statement, text.size()), text.substr(statement));
  } else if (*holds) {
    execute(b, text, statement);
  }
}

}  // namespace fanuc
