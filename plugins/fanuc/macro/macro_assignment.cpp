/// #1=…, and the assignments that stop the program with a text: #3000, #3006.
#include "macro/macro_execution.hpp"

namespace fanuc {

using namespace ig::cnc;

void MacroExecution::assign(ig::Block& b, std::string_view text, std::size_t position) {
  const Outcome target = evaluate_reference(text, position, environment_.rules(), environment_.reader(b));
  if (!target.ok()) return environment_.report(b, target, text);
  const auto number = static_cast<std::uint32_t>(target.value.number);
  const std::size_t equals = skip_blanks(text, target.end);
  if (at(text, equals) != '=') {
    b.report(ig::diag("FAN-0124"), columns(text, position));
    return;
  }
  const Outcome o = evaluate_at(b, text, equals + 1);
  if (!o.ok()) return;
  MacroValue value = o.value;
  if (value.kind == Kind::truth) {
    if (!environment_.rules().truth_is_number) {
      const std::size_t begin = skip_blanks(text, equals + 1);
      b.report(ig::diag("FAN-0115"), ig::Where::columns(begin, o.end), piece(text, begin, o.end));
      return;
    }
    value.kind = Kind::number;
  }
  if (number == 3000 || number == 3006) return message(b, text, position, number, value, o.end);
  if (!ends(b, text, o.end)) return;
  using Written = MacroEnvironment::Written;
  const auto where = ig::Where::columns(position, target.end);
  const auto name = [&] { return MacroEnvironment::name_of(piece(text, position, target.end), number); };
  switch (environment_.write(b, number, value)) {
    case Written::done: break;
    case Written::no_variable: b.report(ig::diag("FAN-0109"), where, name()); return;
    case Written::read_only: b.report(ig::diag("FAN-0121"), where, name()); return;
    default: b.report(ig::diag("FAN-0122"), where, name()); return;
  }
  b.set(variable_, static_cast<std::int64_t>(number));
  if (!value.is_null()) b.set(value_, value.number);
}

void MacroExecution::message(ig::Block& b, std::string_view text, std::size_t position, std::uint32_t number,
                             const MacroValue& value, std::size_t end) {
  std::size_t open = skip_blanks(text, end);
  std::string_view words;
  if (at(text, open) == '(') {
    const std::size_t close = text.find(')', open);
    words = trim(piece(text, open + 1, close == std::string_view::npos ? text.size() : close));
    open = close == std::string_view::npos ? text.size() : close + 1;
  }
  if (!ends(b, text, open)) return;
  if (words.empty()) words = "(no text)";
  if (number == 3006) {
    b.report(ig::diag("FAN-0140"), columns(text, position), words);
    b.set(stop_, message_stop_);
    return;
  }
  const bool is_own = value.number >= 0 && value.number <= 200;
  b.report(ig::diag("FAN-0139"), columns(text, position), is_own ? 3000 + value.number : value.number, words);
  b.alarm();
}

}  // namespace fanuc
