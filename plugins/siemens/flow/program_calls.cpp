/// Calls of programs, and what happens where none is found: MachineCodes, or the report of a cycle of the control.
#include <algorithm>
#include <utility>

#include "flow/call_reader.hpp"
#include "flow/control_procedures.hpp"

namespace siemens {

using namespace ig::cnc;

void CallReader::call_program(ig::Block& b, ig::Where where) {
  const auto ask = [&](const CalledProgram& program) {
    const CalledFiles files(program, environment_.store().call_path);
    ig::Flow::Call call;
    call.program = program.name;
    call.files = files.list();
    call.repeats = static_cast<std::uint32_t>(repeats_);
    call.tag = environment_.store().pass(arguments_);
    return environment_.flow.call(b, call);
  };
  ig::Flow::Answer answer = ask(program_);
  const bool is_of_control = std::exchange(is_of_control_, false);
  if (answer.is_done() && is_of_control) {
    b.set(term_, b.symbol(program_.name));
    // Only now is it worth to compute the parameters: those of a cycle that is not executed may be anything.
    const std::string_view text = b.source().substr(0, end_);
    if (at(text, open_) == '(' && !read_arguments(b, text, open_)) arguments_.clear();
    environment_.store().pass_again(arguments_);
  }
  if (answer.is_not_found()) {
    if (const ig_machine_code* const row = machine_.family(program_.name)) {
      const std::string_view text = b.source().substr(0, end_);
      if (row->does == IG_CODE_SETS && is_of_control && at(text, open_) == '(' && !read_arguments(b, text, open_))
        return;
      record_.add(b, *row, where, piece(b.source(), begin_, std::max(end_, begin_)), number_of_argument());
      codes_.put(b, *row, begin_, end_);
      if (row->does != IG_CODE_CALLS) return;
      if (is_of_control) read_arguments(b, b.source().substr(0, end_), open_);
      program_ = CalledProgram::at(ig::to_view(row->program));
      answer = ask(program_);
    } else if (is_of_control) {
      environment_.report_once(b, ig::diag("SIE-0181"), where, begin_, std::string_view(program_.name));
      return;
    } else if (machine_.ignores_unknown_programs()) {
      environment_.report_once(b, ig::diag("ISO-0573"), where, begin_, std::string_view(program_.name));
      return;
    }
  }
  if (answer.is_not_found())
    environment_.report_once(b, ig::diag("SIE-0165"), where, begin_, std::string_view(program_.name), answer.reason);
  else if (answer.status == IG_GO_TAKEN)
    b.report(ig::diag("SIE-0167"), where, std::string_view(program_.name));
}

std::size_t CallReader::of_control(ig::Block& b, std::string_view text, const std::string& name, std::size_t open,
                                   std::size_t close) {
  const auto where = columns_of(begin_, close);
  if (is_shopmill_step(name) || environment_.is_expanded() || b.find(modal_) || b.is_raised(call_)) {
    if (const ig_machine_code* const row = machine_.family(name)) return of_builder(b, text, close, open, *row);
    environment_.report_once(b, ig::diag("SIE-0181"), where, begin_, std::string_view(name));
    return close;
  }
  program_ = CalledProgram{name};
  repeats_ = 1;
  open_ = open;
  end_ = close;
  is_of_control_ = true;
  b.raise(call_);
  return close;
}

std::size_t CallReader::indirect(ig::Block& b, std::string_view text, std::size_t next, const std::string& how) {
  const bool is_name = is_name_start(at(text, next));
  const std::size_t name_end = skip_name(text, next);
  std::string name = upper(piece(text, next, name_end));
  const Variable* const variable = is_name ? environment_.store().find(name) : nullptr;
  CalledProgram program{name};
  const bool is_path = how == "PCALL" && at(text, next) == '/';  // PCALL /_N_WKS_DIR/_N_PART_WPD/NAME(1,2)
  if (is_path) {
    const std::size_t path_end = std::min(text.find_first_of("( \t", next), text.size());
    program = CalledProgram::at(piece(text, next, path_end));
    next = skip_blanks(text, path_end);
    if (program.name.empty()) {
      b.report(ig::diag("SIE-0169"), columns_of(begin_, text.size()), text.substr(begin_));
      return text.size();
    }
  } else if (!is_name || (variable != nullptr && variable->value.is_text())) {
    Expression e(b, environment_, text, next);
    const auto path = e.value();
    if (!path || !path->is_text()) {
      if (path || next >= text.size())
        b.report(ig::diag("SIE-0169"), columns_of(begin_, text.size()), text.substr(begin_));
      return text.size();
    }
    program = CalledProgram::at(path->text);
    next = e.position();
  } else {
    next = skip_blanks(text, name_end);
  }
  if ((is_name || is_path) && at(text, next) == '(') {
    const std::size_t close = skip_call(text, next);
    if (!read_arguments(b, text.substr(0, close), next)) return text.size();
    next = close;
  }
  next = skip_blanks(text, next);
  if (next < text.size() && how == "CALL") {
    b.report(ig::diag("SIE-0171"), columns_of(begin_, text.size()), text.substr(begin_));
    return text.size();
  }
  return request(b, text, next, std::move(program), next);
}

std::size_t CallReader::of_builder(ig::Block& b, std::string_view text, std::size_t end, std::size_t next,
                                   const ig_machine_code& row) {
  const bool has_bracket = at(text, next) == '(';
  const std::size_t close = has_bracket ? skip_call(text, next) : end;
  const auto where = columns_of(begin_, close);
  const bool acts = row.does == IG_CODE_ACTS || row.does == IG_CODE_MOVES || row.does == IG_CODE_SETS;
  if (acts && b.find(modal_)) {
    b.report(ig::diag("SIE-0174"), where, ig::to_view(row.name),
             std::string_view("its row in MachineCodes calls no program, so MCALL cannot repeat it"));
    return close;
  }
  if (row.does == IG_CODE_SETS && has_bracket && !read_arguments(b, text.substr(0, close), next)) return close;
  record_.add(b, row, where, piece(text, begin_, close), number_of_argument());
  if (row.does == IG_CODE_CALLS) {
    if (has_bracket && !read_arguments(b, text.substr(0, close), next)) return close;
    return request(b, text, has_bracket ? skip_blanks(text, close) : next, CalledProgram::at(ig::to_view(row.program)),
                   close);
  }
  codes_.put(b, row, begin_, close);
  return count_end(b, text, close);
}

std::size_t CallReader::count_end(ig::Block& b, std::string_view text, std::size_t end) {
  const std::size_t count = skip_blanks(text, end);
  if (to_upper(at(text, count)) != 'P' || is_name_start(at(text, count + 1))) return end;
  std::size_t value = skip_blanks(text, count + 1);
  if (at(text, value) == '=') value = skip_blanks(text, value + 1);
  Expression e(b, environment_, text, value);
  return e.number() ? e.position() : std::max(e.position(), value);
}

}  // namespace siemens
