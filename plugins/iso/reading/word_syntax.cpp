// Words: an address and a number, X12.5. The scanner reads all words that follow each other and gives them to the host
// in one call. Text that is not plainly a word is reported: an expression becomes a leftover for evaluation; a typing
// error is a diagnostic that shows the text, and the word is not set.
#include <string>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

#include "reading/split_numbers.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

/// Characters after a number that do not end a word.
constexpr std::array<bool, 256> odd_after_number = [] {
  std::array<bool, 256> odd{};
  for (const char c : {'.', ',', '=', 'E', 'e', 'O', 'o'}) odd[static_cast<unsigned char>(c)] = true;
  return odd;
}();

constexpr bool is_number_part(char c) { return is_digit(c) || c == '.' || c == '+' || c == '-'; }
constexpr bool is_sign_or_blank(char c) { return c == '+' || c == '-' || is_blank(c); }
constexpr bool is_digit_or_o(char c) { return is_digit(c) || c == '.' || c == 'O' || c == 'o'; }

/// 1E5, 1e-3: an exponent follows its number without a blank and has no point. X1 E2.5 is two words.
std::size_t skip_exponent(std::string_view text, std::size_t position) {
  if (to_upper(at(text, position)) != 'E') return position;
  const char sign = at(text, position + 1);
  const std::size_t digits = position + (sign == '+' || sign == '-' ? 2 : 1);
  const std::size_t end = skip_digits(text, digits);
  return end == digits || at(text, end) == '.' ? position : end;
}

struct WordSyntax {
  static constexpr auto spec = ig::syntax("WordSyntax", "Reads words: an address and its number.")
                                   .after("FlagSyntax", "HeadIndexSyntax", "MacroStatementSyntax")
                                   .scans("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+-.,");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0104", "'{0}' has no number: write its value, or remove the address"),
      ig::diagnostic(IG_ERROR, "ISO-0105", "'{0}' has two signs, so the word is not executed: remove one of them"),
      ig::diagnostic(IG_ERROR, "ISO-0106", "'{0}' is written with an exponent: write the number out"),
      ig::diagnostic(IG_ERROR, "ISO-0107", "'{0}' has a decimal comma: write a decimal point"),
      ig::diagnostic(IG_ERROR, "ISO-0109",
                     "'{0}' is a number without an address and is not executed: look for a lost letter"),
      ig::diagnostic(IG_ERROR, "ISO-0110",
                     "'{0}' is not a word of this dialect and is not executed: check the dialect or the spelling"),
      ig::diagnostic(IG_ERROR, "ISO-0116",
                     "'{0}' cannot be read as a number, so the word is not executed: check its digits"),
  };

  ig::Fields addresses{"addresses", "Parsing.?", ig::write, "The addresses that words may have."};
  ig::Choice<Expressions> expressions{
      "expressions", "leave|pass", "leave",
      "A word whose value is an expression: left unread, or passed on to the following scanners."};
  ig::Choice<SplitNumbers> split_numbers{"split-numbers", "error|join", "error", split_numbers_meaning};
  enum class SecondT { counts, next };
  ig::Choice<SecondT> second_t{"second-t", "counts|next", "counts",
                               "A second T in a block: replaces the first, or preselects the next tool."};
  ig::Field<double> next_tool{"Parsing.NextTool", ig::write};
  ig::Signal without_point{"Parsing.~WithoutPoint", ig::write};
  ig::Signal fine_digits{"Parsing.~FineDigits", ig::write};
  ig::Signal cuts_digits{"Parsing.~CutsDigits", ig::read, ig::Life::modal};

  struct Address {
    ig_field field = IG_NO_FIELD;
    bool counts_increments = false;
    bool may_lack_point = false;  // P: seconds or milliseconds on some controls
  };
  std::array<Address, 26> table{};
  std::array<bool, 256> begins_word{};

  WordSyntax() {
    for (std::size_t i = 0; i < addresses.size(); ++i) {
      const unsigned letter = letter_index(addresses.path(i).back());
      const std::string_view unit = addresses.unit(i);
      if (letter >= 26) continue;
      const bool counts = unit == "mm" || unit == "deg" || unit == "s";
      table[letter] = {addresses.id(i), counts, counts || letter == letter_index('P')};
    }
    for (std::size_t c = 0; c < begins_word.size(); ++c) begins_word[c] = is_address(static_cast<char>(c));
  }

  /// Words that follow each other and are set by one call of the host.
  struct Run {
    std::array<ig_word, 27> words;  // each letter, and the next tool
    std::uint32_t count = 0;
    std::uint32_t letters = 0;
    bool has_next_tool = false;
    bool without_point = false;
    std::ptrdiff_t most_decimals = 0;
  };

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    const char first = text[position];
    if (first == ',') return corner(b, text, position);
    if (!is_letter(first)) {
      const std::size_t joined = split_numbers == SplitNumbers::join ? join_number(b, text, position) : position;
      return joined > position ? joined : number_without_address(b, text, position);
    }
    Run run;
    std::size_t next = position;
    std::size_t end = position;
    do {
      const std::size_t behind = word(b, text, next, run);
      if (behind == next) break;  // for another scanner
      end = behind;
      next = skip_blanks(text, end);
    } while (next < text.size() && begins_word[static_cast<unsigned char>(text[next])]);
    set(b, run, position > 0);
    return end;
  }

 private:
  /// Codes, sequence numbers and program numbers belong to earlier scanners.
  bool is_address(char c) const {
    const unsigned letter = letter_index(c);
    return letter < 26 && table[letter].field != IG_NO_FIELD && c != 'G' && c != 'g' && c != 'M' && c != 'm' &&
           c != 'N' && c != 'n' && c != 'O' && c != 'o';
  }

  std::size_t word(ig::Block& b, std::string_view text, std::size_t begin, Run& run) const {
    const unsigned letter = letter_index(text[begin]);
    const Address address = table[letter];
    const std::size_t number = skip_blanks(text, begin + 1);
    const ig::Decimal d = ig::read_decimal(text, number);
    if (!d.ok) return no_number(b, text, begin, number);
    if (odd_after_number[static_cast<unsigned char>(at(text, d.end))]) {
      const std::size_t end = odd_number(b, text, begin, d.end);
      if (end != begin) return end;
    }
    if (address.field == IG_NO_FIELD) {
      const char name = to_upper(text[begin]);
      leave(b, IG_LEFT_WORD, {&name, 1}, begin, d.end);
      return d.end;
    }
    std::uint32_t place = run.count;
    ig_field field = address.field;
    if ((run.letters >> letter & 1u) != 0) [[unlikely]] {
      if (is_next_tool(letter, run)) {
        field = next_tool.id();
        run.has_next_tool = true;
        ++run.count;
      } else {
        place = 0;
        while (run.words[place].field != field) ++place;
        twice(b, field, begin, d.end);
      }
    } else {
      ++run.count;
    }
    run.letters |= 1u << letter;
    const bool bare = !d.has_point && address.may_lack_point && d.value != 0;
    run.without_point |= bare && address.counts_increments;
    run.most_decimals = std::max(run.most_decimals, d.decimals);
    run.words[place] = {.field = field,
                        .begin = column(begin),
                        .end = column(d.end),
                        .value = {.number = d.value + 0.0},  // -0 becomes 0
                        .flags = bare ? static_cast<std::uint32_t>(IG_WORD_WITHOUT_POINT) : 0u,
                        .reserved = 0};
    return d.end;
  }

  bool is_next_tool(unsigned letter, const Run& run) const {
    return second_t == SecondT::next && letter == letter_index('T') && !run.has_next_tool;
  }

  void set(ig::Block& b, Run& run, bool has_more_before) const {
    if (run.count == 0) return;
    for (std::uint32_t i = 0; has_more_before && i < run.count; ++i) {
      ig_word& w = run.words[i];
      if (!b.has(w.field)) continue;
      if (w.field == table[letter_index('T')].field && is_next_tool(letter_index('T'), run)) {
        w.field = next_tool.id();
        run.has_next_tool = true;
      } else {
        twice(b, w.field, w.begin, w.end);
      }
    }
    b.set_words(run.words.data(), run.count);
    if (run.without_point) b.raise(without_point);
    if (run.most_decimals > 3 && b.is_raised(cuts_digits)) b.raise(fine_digits);
  }

  void twice(ig::Block& b, ig_field field, std::size_t begin, std::size_t end) const {
    for (unsigned letter = 0; letter < 26; ++letter)
      if (table[letter].field == field) {
        const char name = static_cast<char>('A' + letter);
        b.report(ig::diag("ISO-0108"), ig::Where::columns(begin, end), std::string_view(&name, 1));
      }
  }

  /// Reads an address at `begin` that has no number at `number`: an expression, a name or a typing error.
  std::size_t no_number(ig::Block& b, std::string_view text, std::size_t begin, std::size_t number) const {
    const char c = at(text, number);
    if (c == '=') return assignment(b, text, begin, number);
    const bool is_signed = c == '+' || c == '-';
    const std::size_t body = is_signed ? skip_while(text, number, is_sign_or_blank) : number;
    if (begins_expression(text, body)) {
      if (expressions == Expressions::pass) return begin;
      return expression(b, text, begin, skip_expression(text, number));
    }
    if (to_upper(c) == 'O' && is_digit(at(text, number + 1)))
      return refuse(b, ig::diag("ISO-0101"), text, begin, skip_while(text, number, is_digit_or_o));
    const std::size_t name = skip_while(text, begin, is_letter);
    if (name - begin > 2) return refuse(b, ig::diag("ISO-0110"), text, begin, skip_statement(text, name));
    if (is_number_part(c)) {
      const bool two_signs = is_signed && piece(text, number + 1, body).find_first_of("+-") != std::string_view::npos;
      return refuse(b, two_signs ? ig::diag("ISO-0105") : ig::diag("ISO-0116"), text, begin,
                    skip_while(text, body, is_number_part));
    }
    return refuse(b, ig::diag("ISO-0104"), text, begin, skip_while(text, begin + 1, [](char u) { return u == '_'; }));
  }

  /// True at #1, [#1+2.], SIN[30.]
  static bool begins_expression(std::string_view text, std::size_t position) {
    const char c = at(text, position);
    return c == '#' || c == '[' || (is_letter(c) && at(text, skip_while(text, position, is_letter)) == '[');
  }

  /// Reports a number that ends at `end` before a character that does not end a word. Returns `begin` where another
  /// scanner may read it.
  std::size_t odd_number(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end) const {
    const char c = text[end];
    const char after = at(text, end + 1);
    if (c == '.')
      return refuse(b, ig::diag("ISO-0103"), text, begin,
                    skip_while(text, end, [](char d) { return is_digit(d) || d == '.'; }));
    if (c == ',')
      return is_digit(after) ? refuse(b, ig::diag("ISO-0107"), text, begin, skip_digits(text, end + 1)) : begin;
    if (c == '=') return assignment(b, text, begin, end);
    if (const std::size_t exponent = skip_exponent(text, end); exponent != end)
      return refuse(b, ig::diag("ISO-0106"), text, begin, exponent);
    if (to_upper(c) == 'O' && !is_letter(after))
      return refuse(b, ig::diag("ISO-0101"), text, begin, skip_while(text, end, is_digit_or_o));
    return begin;
  }

  /// X=#1, X1=10, R5=R2+1: the value reaches to the next blank outside brackets.
  std::size_t assignment(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals) const {
    std::size_t end = skip_blanks(text, equals + 1);
    while (end < text.size() && std::string_view(" \t;\r\n").find(text[end]) == std::string_view::npos)
      end = text[end] == '[' || text[end] == '(' ? skip_bracketed(text, end) : end + 1;
    return expression(b, text, begin, end, equals - begin);
  }

  std::size_t expression(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end,
                         std::size_t name_size = 1) const {
    std::array<char, 16> name{};
    const std::size_t size = std::min(name_size, name.size());
    for (std::size_t i = 0; i < size; ++i) name[i] = to_upper(text[begin + i]);
    const std::string_view word = trim({name.data(), size});
    leave(b, IG_LEFT_EXPRESSION, word, begin, end,
          word.size() == 1 ? table[letter_index(text[begin])].field : IG_NO_FIELD);
    return end;
  }

  /// Skips CYCLE81(…) with its arguments, or TRANS X10, up to a comment: words after a name are not the block's own.
  static std::size_t skip_statement(std::string_view text, std::size_t position) {
    std::size_t end =
        skip_while(text, position, [](char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '.'; });
    if (at(text, end) == '(') end = skip_bracketed(text, end);
    end = skip_while(text, end, [](char c) { return c != '(' && c != ';' && c != '\r' && c != '\n'; });
    while (is_blank(text[end - 1])) --end;
    return end;
  }

  static std::size_t refuse(ig::Block& b, ig::DiagnosticCode diagnostic, std::string_view text, std::size_t begin,
                            std::size_t end) {
    b.report(diagnostic, ig::Where::columns(begin, end), piece(text, begin, end));
    return end;
  }

  /// G01 X5. ,C2. or ,R2.: a chamfer or a corner radius, which is neither a C word nor an R word.
  std::size_t corner(ig::Block& b, std::string_view text, std::size_t position) const {
    const std::size_t letter = skip_blanks(text, position + 1);
    if (!is_letter(at(text, letter))) return position;
    const std::size_t number = skip_blanks(text, letter + 1);
    const char c = to_upper(text[letter]);
    if (expressions == Expressions::pass && (c == 'C' || c == 'R') &&
        begins_expression(text, skip_while(text, number, is_sign_or_blank)))
      return position;
    const std::size_t end = skip_expression(text, number);
    const char name[2] = {',', c};
    leave(b, IG_LEFT_WORD, {name, 2}, position, end);
    return end;
  }

  /// X1. 5 and X1 .5: the text here continues the number of the word before it. Without a point at the blank it does
  /// not: in X10 20 an address is missing.
  std::size_t join_number(ig::Block& b, std::string_view text, std::size_t position) const {
    std::size_t before = position;
    while (before > 0 && is_blank(text[before - 1])) --before;
    std::size_t number = before;
    while (number > 0 && is_number_part(text[number - 1])) --number;
    std::size_t begin = number;
    while (begin > 0 && is_blank(text[begin - 1])) --begin;
    if (before == position || number == before || begin == 0 || !is_address(text[begin - 1])) return position;
    if ((text[before - 1] == '.') == (text[position] == '.')) return position;
    --begin;
    const std::size_t end = skip_while(text, position, is_number_part);
    const std::string whole = std::string(piece(text, number, before)).append(piece(text, position, end));
    const ig::Decimal d = ig::read_decimal(whole, 0);
    const ig_field field = table[letter_index(text[begin])].field;
    ig_word word{};
    if (!d.ok || d.end != whole.size() || !b.has(field) || !b.word(field, word) || word.begin != column(begin))
      return position;
    word.value.number = d.value + 0.0;
    word.end = column(end);
    word.flags = 0;
    b.set_word(word);
    return end;
  }

  static std::size_t number_without_address(ig::Block& b, std::string_view text, std::size_t position) {
    const std::size_t end = skip_while(text, position, is_number_part);
    const std::string_view number = piece(text, position, end);
    if (number.find_first_of("0123456789") == std::string_view::npos) {
      leave(b, IG_LEFT_TEXT, number, position, end);
      return end;
    }
    return refuse(b, ig::diag("ISO-0109"), text, position, end);
  }
};

const ig::Register<WordSyntax> word_syntax;

}  // namespace
}  // namespace iso
