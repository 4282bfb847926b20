// The arguments of a call are in the store; an array is passed with its elements, and VAR refers to a variable of the
// caller.
#include "language/program_parameters.hpp"

#include "flow/flow_words.hpp"
#include "language/declared_type.hpp"
#include "language/declared_value.hpp"

namespace siemens {

using namespace ig::cnc;

bool ProgramParameters::define(ig::Block& b, std::string_view text, std::size_t open) const {
  const ig_frame frame = environment_.flow.frame(b);
  const std::vector<Argument>& passed = environment_.store().passed(frame.tag);
  const bool has_bracket = at(text, open) == '(';
  std::size_t index = 0, next = has_bracket ? skip_blanks(text, open + 1) : text.size();
  while (next < text.size() && text[next] != ')') {
    if (!parameter(b, text, next, index < passed.size() ? passed[index] : Argument{}, frame.depth > 0)) return false;
    ++index;
    next = skip_blanks(text, next);
    if (at(text, next) == ',') next = skip_blanks(text, next + 1);
  }
  environment_.report_values_beyond(b, columns(text, std::min(open, text.size() - 1)),
                                    VariableStore::given_values(passed), index);
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
  VariableStore& store = environment_.store();
  std::optional<Value> value;
  if (at(text, next) == '=') {
    value = value_of(b, environment_, text, ++next, *type);
    if (!value) return false;
  }
  if (argument.value) {
    value = argument.value;
  } else if (const Variable* const given = is_called ? nullptr : store.user_data(name)) {
    value = given->value;
  } else if (!value && !is_called) {
    b.report(ig::diag("SIE-0164"), ig::Where::columns(begin, end), std::string_view(name));
  }
  if (!store.define(name, *type, is_array)) {
    b.report(ig::diag("SIE-0114"), columns(text, begin), std::string_view(name));
    return false;
  }
  const auto assign = [&](const std::string& to, const Value& from) {
    environment_.note_write(b, to, from);
    environment_.report_not_stored(b, columns(text, begin), to, from, store.assign(to, from));
  };
  if (value) assign(name, *value);
  if (is_array) {
    store.find_own(name)->sizes = argument.sizes;
    for (const auto& [element, own] : argument.elements) assign(name + element, own);
  }
  if (is_reference && !argument.name.empty()) store.refer(name, argument.name);
  return true;
}

}  // namespace siemens
