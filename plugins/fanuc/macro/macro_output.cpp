/// DPRNT, BPRNT, POPEN and PCLOS.
#include "macro/macro_output.hpp"

#include <array>
#include <charconv>
#include <string>

#include <isogloss/cnc/scan.hpp>

namespace fanuc {

using namespace ig::cnc;

namespace {

/// #1[43]: four digits before the point and three after it. 0: the format is wrong.
std::size_t put_variable(ig::Block& b, const MacroEnvironment& environment, std::string_view text, std::size_t position,
                         std::string& line) {
  const Outcome o = evaluate_operand(text, position, environment.rules(), environment.reader(b));
  if (!o.ok()) {
    environment.report(b, o, text);
    return 0;
  }
  const std::size_t open = skip_blanks(text, o.end);
  if (at(text, open) != '[' || !is_digit(at(text, open + 1)) || !is_digit(at(text, open + 2)) ||
      at(text, open + 3) != ']')
    return 0;
  if (o.value.is_null()) return open + 4;
  std::array<char, 400> digits{};
  const auto printed = std::to_chars(digits.data(), digits.data() + digits.size(), o.value.number,
                                     std::chars_format::fixed, text[open + 2] - '0');
  line.append(digits.data(), printed.ptr);
  return open + 4;
}

}  // namespace

void put_out(ig::Block& b, const MacroEnvironment& environment, ReportedOutput& said, std::string_view text,
             std::size_t position, std::size_t behind) {
  const auto whole = ig::Where::columns(position, std::max(text.size(), position + 1));
  const std::string_view word = piece(text, position, behind);
  const std::size_t bracket = skip_blanks(text, behind);
  if (!equals_ignoring_case(word, "DPRNT")) {
    if (said.is_first(word)) b.report(ig::diag("FAN-0141"), whole, text.substr(position));
    return;
  }
  if (at(text, bracket) != '[' || skip_bracketed(text, bracket) < text.size() || text.back() != ']') {
    b.report(ig::diag("FAN-0142"), whole, word, text.substr(bracket));
    return;
  }
  std::string line;
  for (std::size_t i = bracket + 1; i + 1 < text.size();) {
    if (text[i] != '#') {
      line += text[i] == '*' ? ' ' : text[i];
      ++i;
      continue;
    }
    const std::size_t next = put_variable(b, environment, text, i, line);
    if (next == 0) {
      b.report(ig::diag("FAN-0142"), ig::Where::columns(i, text.size()), word, text.substr(i));
      return;
    }
    i = next;
  }
  b.report(ig::diag("FAN-0141"), whole, std::string_view(line));
}

}  // namespace fanuc
