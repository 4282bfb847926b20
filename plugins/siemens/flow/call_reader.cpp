/// Which call a block holds: a subprogram by its name, by a text or by DEFINE, a cycle, a procedure of the control.
#include "flow/call_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "flow/control_procedures.hpp"
#include "flow/flow_words.hpp"
#include "language/system_assignment.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

bool is_synchronized(std::string_view text, std::size_t position, std::string_view name) {
  for (const std::string_view word : {"WHEN", "WHENEVER", "EVERY", "FROM", "DO"})
    if (name == word) return true;
  return (name == "ID" || name == "IDS") && at(text, skip_blanks(text, skip_name(text, position))) == '=';
}

/// The action sets outputs and data of the PLC alone: no axis, no feed and no variable of the program depends on it.
bool switches_outputs(std::string_view statement) {
  const std::size_t action = find_word(statement, 0, "DO");
  std::size_t position = skip_blanks(statement, std::min(action + 2, statement.size()));
  if (position >= statement.size()) return false;
  while (position < statement.size()) {
    const std::size_t end = std::min(statement.find_first_of(" \t", position), statement.size());
    const std::string word = upper(piece(statement, position, end));
    const bool is_value = word[0] == '=' || is_digit(word[0]);
    if (!is_value && !is_output(word)) return false;
    position = skip_blanks(statement, end);
  }
  return true;
}

/// Behind a call: nothing, or a word, which stands wrong, but is read. Else the line is no statement at all.
bool is_alone(std::string_view text, std::size_t rest) {
  if (rest >= text.size() || std::string_view(";\r\n").find(text[rest]) != std::string_view::npos) return true;
  return is_name_start(text[rest]) && !is_name_start(at(text, rest + 1));
}

}  // namespace

std::size_t CallReader::scan(ig::Block& b, std::string_view text, std::size_t position) {
  const std::size_t end = skip_name(text, position);
  const bool is_l = to_upper(text[position]) == 'L' && end > position + 1 && skip_digits(text, position + 1) == end;
  const std::string* const macro = macro_at(b, text, position, end);
  if (macro == nullptr && (end - position < 2 || (is_digit(at(text, position + 1)) && !is_l))) return position;
  if (!b.is_in_turn()) return position;
  if (environment_.flow.is_indexing()) {
    for (const CycleSignature& s : pattern_signatures)
      if (equals_ignoring_case(piece(text, position, end), s.name))
        environment_.flow.label(b, pattern_label(environment_.flow.here(b).line));
    return statement_end(text, position);
  }
  std::string name = upper(piece(text, position, end));
  if (macro != nullptr) return expand(b, text, position, end, *macro);
  begin_ = position;
  std::size_t next = skip_blanks(text, end);
  if (is_synchronized(text, position, name)) {
    const std::size_t last = statement_text_end(text, position);
    const std::string_view statement = piece(text, position, last);
    b.report(switches_outputs(statement) ? ig::diag("SIE-0374") : ig::diag("SIE-0168"), columns_of(position, last),
             statement);
    return statement_end(text, position);
  }
  if (const auto behind = curve(b, name, text, position, next)) return *behind;
  environment_.enter(b);
  arguments_.clear();
  if (const ig_machine_code* const row = machine_.find(name)) return of_builder(b, text, end, next, *row);
  if (name == "CALL" || name == "PCALL" || name == "EXTCALL" || name == "ISOCALL") {
    const std::string_view statement = text.substr(0, statement_text_end(text, position));
    return indirect(b, statement, std::min(next, statement.size()), name);
  }
  const bool has_bracket = at(text, next) == '(';
  if (has_bracket) {
    const std::size_t close = skip_call(text, next);
    if (const CycleFields* const cycle = cycle_of(name)) {
      pass(b, *cycle, text, next, close);
      return close;
    }
    if (is_foreign_cycle(name) && !silent_.holds(name)) return of_control(b, text, name, next, close);
    if (is_known(b, text, name, next, close)) return name == "SETINT" ? statement_end(text, close) : close;
    if (!read_arguments(b, text.substr(0, close), next)) return close;
    next = skip_blanks(text, close);
  } else if (is_foreign_cycle(name) && !silent_.holds(name)) {
    return of_control(b, text, name, end, end);
  } else if (const std::string_view missing = not_executed(name); !missing.empty()) {
    b.report(ig::diag("SIE-0174"), columns_of(position, end), std::string_view(name), missing);
    return end;
  } else if (name == "CALLPATH") {
    environment_.store().call_path.clear();
    return end;
  } else if (silent_.holds(name)) {
    if (name == "SETMS") environment_.store().master_spindle.reset();
    return end;
  }
  return request(b, text, next, CalledProgram{std::move(name)}, has_bracket ? next : end);
}

ig::Status CallReader::build(ig::Block& b) {
  bool calls = b.is_raised(call_);
  recorded_.for_each(b, IG_CODE_CALLS, [&](const ig_machine_code& row) {
    const std::string_view name = ig::to_view(row.name);
    const bool is_code = name.size() > 1 && (name[0] == 'M' || name[0] == 'G') && (is_digit(name[1]) || name[1] == '*');
    if (!is_code) return;  // a name, whose call scan() has requested or refused
    report_lost_arguments(b, row, ig::Where::block());
    if (calls) {
      b.report(ig::diag("SIE-0167"), ig::Where::block(), name);
      return;
    }
    begin_ = end_ = 0;
    is_of_control_ = false;
    arguments_.clear();
    program_ = CalledProgram::at(ig::to_view(row.program));
    repeats_ = 1;
    calls = true;
  });
  if (!calls) return ig::Status::unchanged;
  const auto where = ig::Where::columns(begin_, std::max(end_, begin_));
  if (!is_of_control_) b.set(term_, b.symbol(program_.name));
  if (b.find(modal_)) {
    if (repeats_ != 1) b.report(ig::diag("SIE-0311"), where, repeats_, std::string_view(program_.name));
    environment_.store().modal = {program_, std::move(arguments_), environment_.flow.frame(b).id};
    b.raise(modal_call_);
    return ig::Status::changed;
  }
  if (repeats_ < 1) {
    environment_.report_once(b, ig::diag("SIE-0394"), where, begin_, std::string_view(program_.name));
    return ig::Status::changed;
  }
  call_program(b, where);
  return ig::Status::changed;
}

std::optional<std::size_t> CallReader::curve(ig::Block& b, std::string_view name, std::string_view text,
                                             std::size_t position, std::size_t next) {
  std::uint32_t& begins = environment_.store().curve_begins;
  if (name == "CTABDEF") {
    other_meaning_.raise(b);
    begins = std::max(environment_.flow.here(b).line, 1u);
  }
  if (begins == 0 || name == "CTABDEF") return std::nullopt;
  if (name == "CTABEND") begins = 0;
  return at(text, next) == '(' ? skip_call(text, next) : skip_name(text, position);
}

const std::string* CallReader::macro_at(ig::Block& b, std::string_view text, std::size_t position,
                                        std::size_t end) const {
  if (environment_.is_expanded() || !environment_.has_macros() || environment_.flow.is_indexing()) return nullptr;
  return environment_.macro(b, upper(piece(text, position, end)));
}

std::size_t CallReader::expand(ig::Block& b, std::string_view text, std::size_t position, std::size_t end,
                               const std::string& macro) {
  const ExpandedText as(text, position, end, macro);
  const bool is_flow = flow_word(piece(macro, 0, skip_name(macro, 0))) != FlowWord::none;
  const Environment::Reading reading(environment_, as);
  const std::size_t behind = is_flow ? position : scan(b, as.text(), position);
  end_ = as.original(end_);
  if (behind <= position || skip_blanks(as.text(), behind) < as.macro_end()) {
    b.report(ig::diag("SIE-0288"), ig::Where::columns(position, end), std::string_view(macro));
    return end;
  }
  return as.original(behind);
}

std::size_t CallReader::request(ig::Block& b, std::string_view text, std::size_t next, CalledProgram program,
                                std::size_t end) {
  repeats_ = 1;
  end_ = end;
  const char behind = at(text, next + 1);
  if (to_upper(at(text, next)) == 'P' && !is_name_start(behind)) {
    std::size_t value = skip_blanks(text, next + 1);
    if (at(text, value) == '=') value = skip_blanks(text, value + 1);
    Expression e(b, environment_, text, value);
    const auto times = e.number();
    if (!times) return std::max(e.position(), value);
    end_ = e.position();
    repeats_ = *times;
    if (!(repeats_ >= 0 && repeats_ <= 9999) || repeats_ != std::floor(repeats_)) {
      b.report(ig::diag("SIE-0172"), columns_of(next, end_), std::string_view(program.name), *times);
      repeats_ = 0;
      return end_;
    }
  }
  if (const std::size_t rest = skip_blanks(text, end_); !is_alone(text, rest)) {
    const std::size_t last = statement_text_end(text, rest);
    environment_.report_once(b, ig::diag("SIE-0173"), columns_of(begin_, last), begin_, std::string_view(program.name),
                             piece(text, rest, last));
    return statement_end(text, rest);
  }
  if (b.is_raised(call_)) {
    b.report(ig::diag("SIE-0167"), columns_of(begin_, end_), std::string_view(program.name));
    return statement_end(text, end_);
  }
  program_ = std::move(program);
  is_of_control_ = false;
  b.raise(call_);
  return end_;
}

std::vector<CycleFields> CallReader::all_cycles() {
  std::vector<CycleFields> out;
  for (const CycleSignature& s : drilling_signatures) out.emplace_back(s, ig::write);
  for (const CycleSignature& s : pattern_signatures) out.emplace_back(s, ig::write);
  out.emplace_back(swivel_signature, ig::write);
  return out;
}

const CycleFields* CallReader::cycle_of(std::string_view name) const {
  for (const CycleFields& c : cycles_)
    if (c.name() == name) return &c;
  return nullptr;
}

}  // namespace siemens
