// G and M codes. A code that some syntax of the chain declares is a field of its own, found in a table by letter and
// number, so that later syntaxes test one bit. A code that no syntax declares stays as a leftover under its canonical
// name: two digits for one-digit codes (G5 is G05), G54.1 unchanged.
#include <isogloss/flow.hpp>

#include <span>
#include <string>
#include <vector>

#include <isogloss/cnc/machine_codes.hpp>
#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

#include "reading/split_numbers.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

constexpr std::size_t no_code = static_cast<std::size_t>(-1);
constexpr std::uint64_t largest_code = 99999;

/// A code as an integer: its number times ten plus the one decimal that codes have (G54.1 is 541, G5 is 50).
struct Code {
  std::size_t index = no_code;
  std::size_t end = 0;  ///< position after the text that was read, whether it is a code or not
};

/// With `joins`, "G5. 1" is G5.1.
Code read_code(std::string_view text, std::size_t position, bool joins = false) {
  const std::size_t digits_end = skip_digits(text, position);
  Code code{no_code, digits_end};
  std::uint64_t number = 0;
  for (std::size_t i = position; i < digits_end && number <= largest_code; ++i)
    number = number * 10 + static_cast<std::uint64_t>(text[i] - '0');
  std::uint64_t decimal = 0;
  if (at(text, digits_end) == '.') {
    const std::size_t next = joins ? skip_blanks(text, digits_end + 1) : digits_end + 1;
    const std::size_t decimals = is_digit(at(text, next)) ? next : digits_end + 1;
    code.end = skip_digits(text, decimals);
    if (code.end > decimals) decimal = static_cast<std::uint64_t>(text[decimals] - '0');
    if (code.end > decimals + 1) return code;  // G54.10 is not G54.1
  }
  if (number <= largest_code) code.index = number * 10 + decimal;
  return code;
}

struct FlagSyntax {
  static constexpr auto spec = ig::syntax("FlagSyntax", "Reads G and M codes.")
                                   .after("HeadIndexSyntax")
                                   .before("WordSyntax")
                                   .scans("GMgm")
                                   .scans_ahead();
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0102", "'{0}' has no number and is not executed: write the number of the code"),
      ig::diagnostic(IG_WARNING, "ISO-0547",
                     "{0} is already in this block, so the second one changes nothing: remove it"),
  };

  ig::Fields codes{"codes", "Parsing.Flags.* Parsing.*", ig::write, "The codes that syntaxes of this chain know.",
                   IG_CODE};
  ig::Choice<Expressions> expressions{
      "expressions", "leave|pass", "leave",
      "A code whose number is an expression: left unread, or passed on to the following scanners."};
  ig::Choice<SplitNumbers> split_numbers{"split-numbers", "error|join", "error", split_numbers_meaning};
  ig::TextOption passed_codes{"passed-codes", "", "Codes that are passed on to the following scanners: G65 G66."};
  ig::Flow flow;
  ig::Signal parameters{"ProgrammableDataInput.~Parameters", ig::write, ig::Life::modal};
  ig::Signal unknown_code{"Source.~UnknownCode", ig::write};
  ig::Config code_calls{"isogloss.code-call/1", ig::Need::optional,
                        "Codes that call a program on this control are passed on, too."};
  MachineCodes machine_codes;  // codes with a row are for MachineCodeSyntax
  std::array<std::vector<ig_field>, 2> table;

  FlagSyntax() {
    for (std::size_t i = 0; i < codes.size(); ++i) {
      std::string_view name = codes.path(i);
      for (const std::string_view prefix : {"Parsing.Flags.", "Parsing."})
        if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
      enter(name, is_for_another_syntax(name) ? passed_on : codes.id(i));
    }
    std::string_view rest = passed_codes.text();
    while (!(rest = trim(rest)).empty()) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      enter(rest.substr(0, end), passed_on);
      rest.remove_prefix(end);
    }
  }

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    std::array<ig_word, 16> words;
    std::uint32_t count = 0;
    std::size_t end = position;
    std::size_t next = position;
    do {
      const std::size_t number = skip_blanks(text, next + 1);
      if (!is_digit(at(text, number))) {
        const std::size_t odd = no_number(b, text, next, number);
        if (odd == next) break;
        end = odd;
      } else {
        const Code code = read_code(text, number, split_numbers == SplitNumbers::join);
        const ig_field field = field_of(text[next], code.index);
        if (code.index == data_input || code.index == data_end) note_parameters(b, text, next, code);
        if (is_odd_after(text, code.end)) {
          end = odd_number(b, text, next, code.end);
        } else if (field >= passed_on) {
          if (field == passed_on || !unknown(b, text, next, number, code.end)) break;
          end = code.end;
        } else {
          end = code.end;
          if (count == words.size()) {
            b.set_words(words.data(), count);
            count = 0;
          }
          if (stands_already({words.data(), count}, field) || (position > 0 && stands_before(b, field)))
            b.report(ig::diag("ISO-0547"), ig::Where::columns(next, end), trim(piece(text, next, end)));
          words[count++] = {field, column(next), column(end), ig_value{}, 0, 0};
        }
      }
      next = skip_blanks(text, end);
    } while (next < text.size() && is_flag_letter(text[next]));
    if (count > 0) b.set_words(words.data(), count);
    return end;
  }

 private:
  /// A field id that no chain uses: the code is for another scanner.
  static constexpr ig_field passed_on = IG_NO_FIELD - 1;

  static constexpr std::size_t data_input = 100, data_end = 110;  // G10, G11

  /// While a file is indexed no block is executed, so the text alone must tell which N are numbers of parameters.
  void note_parameters(ig::Block& b, std::string_view text, std::size_t begin, const Code& code) const {
    if (!flow.is_indexing() || row_of(text[begin]) != 0) return;
    if (code.index == data_end) return b.erase(parameters);
    const std::size_t word = skip_blanks(text, code.end);
    if (to_upper(at(text, word)) != 'L') return;
    const ig::Decimal number = ig::read_decimal(text, skip_blanks(text, word + 1));
    if (number.ok && (number.value == 50 || number.value == 52)) b.raise(parameters);
  }

  static bool stands_already(std::span<const ig_word> words, ig_field field) {
    return std::any_of(words.begin(), words.end(), [&](const ig_word& w) { return w.field == field; });
  }
  static bool stands_before(const ig::Block& b, ig_field field) {
    ig_value unused;
    return b.get(field, unused);
  }

  void enter(std::string_view name, ig_field field) {
    if (name.empty() || !is_flag_letter(name.front())) return;
    const Code code = read_code(name, 1);
    if (code.index == no_code || code.end != name.size() || code.end < 2) return;
    std::vector<ig_field>& row = table[row_of(name.front())];
    if (row.size() <= code.index) row.resize(code.index + 1, IG_NO_FIELD);
    row[code.index] = field;
  }

  static constexpr bool is_flag_letter(char c) { return c == 'G' || c == 'M' || c == 'g' || c == 'm'; }
  static constexpr std::size_t row_of(char letter) { return to_upper(letter) == 'G' ? 0 : 1; }
  static constexpr bool is_odd_after(std::string_view text, std::size_t end) {
    const char c = at(text, end);
    return c == '.' || c == '=' || ((c == 'O' || c == 'o') && (is_digit(at(text, end + 1)) || end + 1 == text.size()));
  }

  ig_field field_of(char letter, std::size_t index) const {
    const std::vector<ig_field>& row = table[row_of(letter)];
    return index < row.size() ? row[index] : IG_NO_FIELD;
  }

  /// The canonical name of a code that no syntax declares: leading zeros go, one-digit codes get one (G5 is G05, G054
  /// is G54). False: the code is for another scanner.
  bool unknown(ig::Block& b, std::string_view text, std::size_t begin, std::size_t number, std::size_t end) const {
    std::string_view digits = piece(text, number, end);
    while (digits.size() > 1 && digits.front() == '0' && is_digit(digits[1])) digits.remove_prefix(1);
    if (digits.ends_with('.')) digits.remove_suffix(1);
    if (digits.ends_with(".0")) digits.remove_suffix(2);
    std::array<char, 24> name;
    std::size_t size = 0;
    name[size++] = to_upper(text[begin]);
    if (skip_digits(digits, 0) < 2) name[size++] = '0';
    for (const char c : digits.substr(0, name.size() - size)) name[size++] = c;
    if (calls_program({name.data(), size})) return false;
    leave(b, IG_LEFT_UNKNOWN, {name.data(), size}, begin, end);
    if (name[0] == 'G') b.raise(unknown_code);
    return true;
  }

  bool is_for_another_syntax(std::string_view code) const {
    return code_calls.number(code).has_value() || machine_codes.find(code) != nullptr;
  }

  /// A table is searched only once for each code, because a loop may ask for the same code a million times.
  bool calls_program(std::string_view code) const {
    std::size_t hash = 0;
    for (const char c : code) hash = hash * 31 + static_cast<unsigned char>(c);
    Asked& asked = asked_[hash % asked_.size()];
    if (asked.code != code)
      asked = {std::string(code), is_for_another_syntax(code) || machine_codes.family(code) != nullptr};
    return asked.calls;
  }

  /// Reports a letter without a number; returns `begin` where it is not a code at all, so that another scanner may read
  /// it.
  std::size_t no_number(ig::Block& b, std::string_view text, std::size_t begin, std::size_t number) const {
    const char c = at(text, number);
    if (to_upper(c) == 'O' && (is_digit(at(text, number + 1)) || at(text, number + 1) == 'O'))
      return refuse(b, ig::diag("ISO-0101"), text, begin, skip_while(text, number, is_digit_or_o));
    if (const std::size_t end = skip_expression(text, number); end != number)
      return expressions == Expressions::pass ? begin : expression(b, text, begin, end);
    if (c == '=') return expression(b, text, begin, skip_to_blank(text, number + 1));
    if (skip_name_of(text, begin, is_letter) - begin > 2) return begin;
    return refuse(b, ig::diag("ISO-0102"), text, begin, skip_while(text, begin + 1, [](char u) { return u == '_'; }));
  }

  /// Reports G1.2.3, G0O and M3=3, which is not M03.
  static std::size_t odd_number(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end) {
    if (text[end] == '=') return expression(b, text, begin, skip_to_blank(text, end + 1));
    if (text[end] == '.')
      return refuse(b, ig::diag("ISO-0103"), text, begin,
                    skip_while(text, end, [](char c) { return is_digit(c) || c == '.'; }));
    return refuse(b, ig::diag("ISO-0101"), text, begin, skip_while(text, end, is_digit_or_o));
  }

  static std::size_t skip_to_blank(std::string_view text, std::size_t position) {
    return skip_while(text, skip_blanks(text, position), [](char c) { return !is_blank(c) && c != '\r'; });
  }
  static constexpr bool is_digit_or_o(char c) { return is_digit(c) || c == 'O' || c == 'o' || c == '.'; }

  static std::size_t expression(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end) {
    const char name = to_upper(text[begin]);
    leave(b, IG_LEFT_EXPRESSION, {&name, 1}, begin, end);
    return end;
  }

  static std::size_t refuse(ig::Block& b, ig::DiagnosticCode diagnostic, std::string_view text, std::size_t begin,
                            std::size_t end) {
    b.report(diagnostic, ig::Where::columns(begin, end), piece(text, begin, end));
    return end;
  }

  struct Asked {
    std::string code;
    bool calls = false;
  };
  mutable std::array<Asked, 16> asked_{};
};

const ig::Register<FlagSyntax> flag_syntax;

}  // namespace
}  // namespace iso
