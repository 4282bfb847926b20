// The arguments of a call are in the store; an array is passed with its elements, and VAR refers to a variable of the
// caller.
#include "language/program_parameters.hpp"

#include "flow/flow_words.hpp"
#include "language/declared_type.hpp"

namespace siemens {

using namespace ig::cnc;

bool ProgramParameters::define(ig::Block& b, std::string_view text, std::size_t open) const {
  const ig_frame frame = environment_.flow.frame(b);
  const std::vector<Argument>& passed = environment_.store().passed(frame.tag);
  if (at(text, open) != '(') return true;
  std::size_t index = 0, next = skip_blanks(text, open + 1);
  while (next < text.size() && text[next] != ')') {
    if (!parameter(b, text, next, index < passed.size() ? passed[index] : Argument{}, frame.depth > 0)) return false;
    ++index;
    next = skip_blanks(text, next);
    if (at(text, next) == ',') next = skip_blanks(text, next + 1);
  }
  return true;
}

bool ProgramParameters::parameter(ig::Block& b, std::string_view text, std::size_t& next, const Argument& argument,
                                  bool is_called) const {
  const std::size_t begin = next;
  const bool is_reference = is_word(text, next, "VAR");
  if (is_reference) next = skip_blanks(text, skip_name(text, next));
  const auto type = type_at(text, next);
  const std::size_t end = skip_name(text, next);
  const std::string name = upper(piece(text, next, end));
  if (!type || name.empty()) {
    b.report(ig::diag("SIE-0162"), columns(text, begin), text.substr(begin));
    return false;
  }
  next = skip_blanks(text, end);
  const bool is_array = at(text, next) == '[';
  if (is_array) next = skip_blanks(text, std::min(text.find(']', next), text.size() - 1) + 1);
  Value value = empty_value(*type);
  bool has_default = false;
  if (at(text, next) == '=') {
    Expression e(b, environment_, text, next + 1);
    const auto v = e.value();
    if (!v) return false;
    if (const auto fitting = v->as(*type)) value = *fitting;
    has_default = true;
    next = e.position();
  }
  if (argument.value) {
    if (const auto fitting = argument.value->as(*type))
      value = *fitting;
    else
      b.report(ig::diag("SIE-0130"), columns(text, begin), std::string_view(name));
  } else if (const auto given = is_called ? std::nullopt : environment_.store().given(name)) {
    value.number = *given;
  } else if (!has_default && !is_called) {
    b.report(ig::diag("SIE-0164"), ig::Where::columns(begin, end), std::string_view(name));
  }
  if (!environment_.store().define(name, std::move(value), is_array)) {
    b.report(ig::diag("SIE-0114"), columns(text, begin), std::string_view(name));
    return false;
  }
  if (is_array) environment_.store().find(name)->sizes = argument.sizes;
  if (is_array)
    for (const auto& [element, own] : argument.elements)
      if (auto fitting = own.as(*type)) environment_.store().define(name + element, std::move(*fitting));
  if (is_reference && !argument.name.empty()) environment_.store().refer(name, argument.name);
  return true;
}

}  // namespace siemens
