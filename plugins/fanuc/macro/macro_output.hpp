/// The text that DPRNT writes to the output device of the control.
#pragma once

#include <charconv>
#include <string>
#include <utility>

#include <isogloss/cnc/scan.hpp>

#include "macro/macro_environment.hpp"

namespace fanuc {

using namespace ig::cnc;

/// #1[43]: four digits before the point and three after it. 0: the format is wrong.
inline std::size_t put_variable(ig::Block& b, const MacroEnvironment& environment, std::string_view text,
                                std::size_t position, std::string& line) {
  const Outcome o = evaluate_operand(text, position, environment.rules(), environment.reader(b));
  if (!o.ok()) {
    environment.report(b, o, text);
    return 0;
  }
  const std::size_t open = ig::cnc::skip_blanks(text, o.end);
  if (ig::cnc::at(text, open) != '[' || !is_digit(ig::cnc::at(text, open + 1)) ||
      !is_digit(ig::cnc::at(text, open + 2)) || ig::cnc::at(text, open + 3) != ']')
    return 0;
  if (o.value.is_null()) return open + 4;
  std::array<char, 400> digits{};
  const auto printed = std::to_chars(digits.data(), digits.data() + digits.size(), o.value.number,
                                     std::chars_format::fixed, text[open + 2] - '0');
  line.append(digits.data(), printed.ptr);
  return open + 4;
}

/// Which of POPEN, PCLOS, BPRNT and SETVN have been reported: each once in a run.
class SaidOutput {
 public:
  void clear() { said_ = 0; }
  /// True the first time. Two letters tell the words apart, whether shortened or not.
  bool is_first(std::string_view word) {
    const char first = to_upper(ig::cnc::at(word, 0)), second = to_upper(ig::cnc::at(word, 1));
    const unsigned kind = first == 'B' ? 0 : first == 'S' ? 1 : second == 'O' ? 2 : 3;
    return (std::exchange(said_, said_ | 1u << kind) >> kind & 1u) == 0;
  }

 private:
  unsigned said_ = 0;
};

/// Reports the text that DPRNT writes and, once in a run, each of the other words.
inline void put_out(ig::Block& b, const MacroEnvironment& environment, SaidOutput& said, std::string_view text,
                    std::size_t position, std::size_t behind) {
  using ig::cnc::piece;
  const auto whole = ig::Where::columns(position, std::max(text.size(), position + 1));
  const std::string_view word = piece(text, position, behind);
  const std::size_t bracket = ig::cnc::skip_blanks(text, behind);
  if (!equals_ignoring_case(word, "DPRNT")) {
    if (said.is_first(word)) b.report(ig::diag("FAN-0141"), whole, text.substr(position));
    return;
  }
  if (ig::cnc::at(text, bracket) != '[' || skip_bracketed(text, bracket) < text.size() || text.back() != ']') {
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
