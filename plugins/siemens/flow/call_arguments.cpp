/// The parameters of a call: values, and the variables that a VAR parameter may change.
#include "flow/call_reader.hpp"

#include <algorithm>
#include <array>

namespace siemens {

using namespace ig::cnc;

bool CallReader::read_arguments(ig::Block& b, std::string_view text, std::size_t open) {
  std::size_t next = skip_blanks(text, open + 1);
  if (at(text, next) == ')') return true;
  for (;;) {
    Argument& argument = arguments_.emplace_back();
    next = skip_blanks(text, next);
    if (const char c = at(text, next); c != ',' && c != ')') {
      Expression e(b, environment_, text, next);
      argument.value = e.value();
      if (!argument.value) return false;
      name_of(b, text, next, e.position(), argument);
      next = skip_blanks(text, e.position());
    }
    if (at(text, next) == ')') return true;
    if (at(text, next) != ',' || arguments_.size() > 1000) {
      b.report(ig::diag("SIE-0169"), columns_of(next, std::max(next + 1, text.size())),
               text.substr(std::min(next, text.size())));
      return false;
    }
    ++next;
  }
}

void CallReader::name_of(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end,
                         Argument& argument) const {
  if (!is_name_start(text[begin])) return;
  const std::size_t open = skip_blanks(text, skip_name(text, begin));
  if (at(text, open) != '[' && open != skip_blanks(text, end)) return;
  Expression variable(b, environment_, text, begin);
  const auto reference = variable.reference();
  if (!reference || skip_blanks(text, variable.position()) != skip_blanks(text, end)) return;
  argument.name = reference->name;
  argument.elements = environment_.store().elements(argument.name);
  if (const Variable* const passed = environment_.store().find(argument.name)) argument.sizes = passed->sizes;
}

void CallReader::pass(ig::Block& b, const CycleFields& cycle, std::string_view text, std::size_t open,
                      std::size_t close) {
  if (!read_arguments(b, text.substr(0, close), open)) {
    b.report(ig::diag("SIE-0182"), columns_of(begin_, close), cycle.name());
    return;
  }
  if (arguments_.size() > cycle.size())
    b.report(ig::diag("SIE-0184"), columns_of(begin_, close), cycle.name(), static_cast<double>(arguments_.size()),
             static_cast<double>(cycle.size()));
  std::array<ig_word, CycleFields::most + 1> words;
  std::uint32_t count = 0;
  const std::uint16_t begin = column(begin_), end = column(environment_.written(close));
  words[count++] = {cycle.code().code(0), begin, end, ig_value{}, 0, 0};
  for (std::size_t i = 0; i < std::min(arguments_.size(), cycle.size()); ++i) {
    const std::optional<Value>& v = arguments_[i].value;
    if (!v) continue;
    if (v->is_text() && v->text.empty() && cycle.parameter(i) != "TC") continue;
    // Of texts counts whether they are there; "0" of a swivel data set is none.
    const double number = v->is_text() ? (v->text == "0" ? 0.0 : 1.0) : v->number;
    words[count++] = {cycle.field(i).id(), begin, end, {.number = number + 0.0}, 0, 0};
  }
  b.set_words(words.data(), count);
}

}  // namespace siemens
