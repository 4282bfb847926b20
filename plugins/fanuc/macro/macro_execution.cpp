/// Which statement a block holds, and where it ends.
#include "macro/macro_execution.hpp"

#include <algorithm>

namespace fanuc {

using namespace ig::cnc;

std::size_t MacroExecution::scan(ig::Block& b, std::string_view text, std::size_t position) {
  if (text[position] == '[') return b.is_in_turn() ? scan_return(b, text, position) : position;
  const Word word = statement_at(text, position);
  if (word == Word::none || !b.is_in_turn()) return position;
  const bool is_first = stands_first(text, position);
  has_comment_ = false;
  const std::size_t end = statement_end(text, position, has_comment_);
  if (word == Word::foreign || !is_first) {
    if (word == Word::foreign)
      leave(b, IG_LEFT_STATEMENT, piece(text, position, end), position, end);
    else
      b.report(ig::diag("FAN-0125"), ig::Where::columns(position, end), piece(text, position, end));
    return end;
  }
  if (environment_.flow.is_indexing()) {
    if (word == Word::end) report_label(b, text, position);
    return end;
  }
  begin_ = position;
  end_ = end;
  if (word == Word::if_ && governs_ == Governs::rest_of_block)
    if (const std::size_t rest = governed(text, position, end); rest != 0)
      return scan_governed(b, text, position, rest, end);
  if (word == Word::if_)
    if (const std::size_t words = words_behind_then(text, position, end); words != 0)
      return scan_words(b, text, position, words, end);
  b.raise(statement_);
  return end;
}

ig::Status MacroExecution::restart() {
  loops_here_.clear();
  unbegun_.fill(false);
  reported_output_.clear();
  wait_ = {};
  waited_.clear();
  return ig::Status::unchanged;
}

ig::Status MacroExecution::build(ig::Block& b) {
  if (b.has(program_)) note_program(b);
  if (b.has(tape_) || b.find(program_end_) || b.find(return_)) end_of_program(b);
  if (!b.is_raised(statement_) || end_ > b.source().size()) return ig::Status::unchanged;
  environment_.enter(b);
  std::string_view text = b.source().substr(0, end_);
  if (has_comment_ && !has_message(text.substr(begin_))) {
    blank_comments(text);
    text = blanked_;
  }
  execute(b, text, begin_);
  return ig::Status::changed;
}

void MacroExecution::end_of_program(ig::Block& b) {
  if (b.find(return_) && b.has(p_) && environment_.flow.frame(b).depth == 0)
    note_jump(b);
  else
    loops_here_.end_frame(b, environment_.flow);
}

void MacroExecution::note_program(ig::Block& b) {
  loops_here_.end_frame(b, environment_.flow);
  if (environment_.flow.frame(b).depth == 0) environment_.store().main_program = program_number(b.text(program_));
}

void MacroExecution::blank_comments(std::string_view text) {
  blanked_.assign(text);
  for (std::size_t i = begin_; i < blanked_.size(); ++i)
    if (blanked_[i] == '(') {
      const std::size_t close = skip_bracketed(text, i);
      std::fill(blanked_.begin() + static_cast<std::ptrdiff_t>(i),
                blanked_.begin() + static_cast<std::ptrdiff_t>(close), ' ');
      i = close - 1;
    }
}

void MacroExecution::report_label(ig::Block& b, std::string_view text, std::size_t position) const {
  std::int64_t number = 0;
  if (!fanuc::loop_number(text, skip_while(text, position, is_letter), number)) return;
  const std::string name = "END" + std::to_string(number);
  environment_.flow.label(b, name);
}

Outcome MacroExecution::evaluate_at(ig::Block& b, std::string_view text, std::size_t position) const {
  const Outcome o = evaluate(text, position, environment_.rules(), environment_.reader(b));
  if (!o.ok()) {
    environment_.report(b, o, text);
  } else if (environment_.has_deep_brackets(o)) {
    environment_.warn_of_depth(b, o, position, o.end);
  }
  return o;
}

void MacroExecution::execute(ig::Block& b, std::string_view text, std::size_t position) {
  if (text[position] == '#') return assign(b, text, position);
  if (text[position] == '[') return execute_return_to(b, text, position);
  std::size_t behind = 0;
  switch (keyword_or_short(text, position, behind)) {
    case Word::if_: return execute_if(b, text, position);
    case Word::while_: return execute_while(b, text, position);
    case Word::do_: return execute_do(b, text, position, position);
    case Word::end: return execute_end(b, text, position);
    case Word::go_to: return execute_go_to(b, text, position, behind);
    case Word::output: return put_out(b, environment_, reported_output_, text, position, behind);
    case Word::set_name:
      if (reported_output_.is_first("SETVN"))
        b.report(ig::diag("FAN-0141"), columns(text, position), text.substr(position));
      return;
    default: incomplete(b, text, position, text.substr(position), "IF");
  }
}

void MacroExecution::incomplete(ig::Block& b, std::string_view text, std::size_t position, std::string_view what,
                                std::string_view missing) {
  b.report(ig::diag("FAN-0131"), columns(text, position), what, missing);
}

bool MacroExecution::ends(ig::Block& b, std::string_view text, std::size_t position) {
  const std::size_t rest = skip_blanks(text, position);
  if (rest >= text.size()) return true;
  b.report(ig::diag("FAN-0123"), ig::Where::columns(rest, text.size()), text.substr(rest));
  return false;
}

}  // namespace fanuc
