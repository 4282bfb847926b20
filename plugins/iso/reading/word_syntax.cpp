// Words: an address and a number, X12.5. The scanner reads all words that follow each other and gives them to the host
// in one call. Text that is not plainly a word (irregular_word.hpp) is an expression for evaluation or a typing error.
#include <isogloss/cnc/further_axes.hpp>

#include "reading/irregular_word.hpp"
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

struct WordSyntax {
  static constexpr auto spec = ig::syntax("WordSyntax", "Reads words: an address and its number.")
                                   .after("FlagSyntax", "HeadIndexSyntax", "MacroStatementSyntax")
                                   .scans("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+-.,")
                                   .scans_ahead();
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
  ig::Signal feed_without_point{"Parsing.~FeedWithoutPoint", ig::write};
  ig::Signal fine_digits{"Parsing.~FineDigits", ig::write};
  ig::Signal cuts_digits{"Parsing.~CutsDigits", ig::read, ig::Life::modal};

  std::array<ig::Field<double>, most_further_axes> further{of_further(1), of_further(2), of_further(3),
                                                           of_further(4), of_further(5), of_further(6)};
  AxisNames axes;

  WordAddresses table{addresses};

  /// Words that follow each other and are set by one call of the host.
  struct Run {
    std::array<ig_word, 27> words;  // each letter, and the next tool
    std::uint32_t count = 0;
    std::uint32_t letters = 0;
    bool has_next_tool = false;
    std::uint8_t without_point = 0;  // WordAddresses::Counts
    std::ptrdiff_t most_decimals = 0;
  };

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    const char first = text[position];
    if (first == ',') return read_corner(b, text, position, expressions);
    if (!is_letter(first)) {
      const std::size_t joined =
          split_numbers == SplitNumbers::join ? join_split_word(b, text, position, table) : position;
      return joined > position ? joined : read_without_address(b, text, position);
    }
    Run run;
    std::size_t next = position;
    std::size_t end = position;
    do {
      const std::size_t behind = word(b, text, next, run);
      if (behind == next) break;  // for another scanner
      end = behind;
      next = skip_blanks(text, end);
    } while (next < text.size() && table.begins_word(text[next]));
    if (run.count == 0) return end == position ? set_named_axis(b, text, position) : end;
    set(b, run, position > 0);
    return end;
  }

 private:
  std::size_t word(ig::Block& b, std::string_view text, std::size_t begin, Run& run) const {
    const unsigned letter = letter_index(text[begin]);
    const WordAddresses::Address address = table[letter];
    const std::size_t number = is_blank(at(text, begin + 1)) ? skip_blanks(text, begin + 2) : begin + 1;
    const ig::Decimal d = ig::read_decimal(text, number);
    if (!d.ok) {
      if (is_named_axis(text, begin)) return begin;
      return read_without_number(b, text, begin, number, address.field, expressions);
    }
    if (odd_after_number[static_cast<unsigned char>(at(text, d.end))]) {
      if (is_named_axis(text, begin)) return begin;
      const std::size_t end = read_odd_end(b, text, begin, d.end, address.field);
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
    if (bare) run.without_point |= address.without_point;
    run.most_decimals = std::max(run.most_decimals, d.decimals);
    run.words[place] = {.field = field,
                        .begin = column(begin),
                        .end = column(d.end),
                        .value = {.number = d.value + 0.0},  // -0 becomes 0
                        .flags = bare ? static_cast<std::uint32_t>(IG_WORD_WITHOUT_POINT) : 0u,
                        .reserved = 0};
    return d.end;
  }

  /// C2=90.: a word of an axis by a name of several characters that the machine's table gives it.
  struct NamedAxis {
    std::uint32_t axis;
    std::size_t name_end;
    ig::Decimal number;
  };
  [[gnu::cold, gnu::noinline]] bool is_named_axis(std::string_view text, std::size_t begin) const {
    if (named_axis(text, begin)) return true;
    const std::size_t end = skip_while(text, begin, is_part_of_name);
    return expressions == Expressions::pass && at(text, end) == '=' && axes.find(piece(text, begin, end)) &&
           begins_expression(text,
                             skip_while(text, end + 1, [](char c) { return is_blank(c) || c == '+' || c == '-'; }));
  }
  static bool is_part_of_name(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

  std::optional<NamedAxis> named_axis(std::string_view text, std::size_t begin) const {
    const std::size_t end = skip_while(text, begin, is_part_of_name);
    if (end - begin < 2 || at(text, end) != '=') return std::nullopt;
    const auto axis = axes.find(piece(text, begin, end));
    const ig::Decimal d = ig::read_decimal(text, skip_blanks(text, end + 1));
    if (!axis || !d.ok || odd_after_number[static_cast<unsigned char>(at(text, d.end))]) return std::nullopt;
    return field_of(*axis) == IG_NO_FIELD ? std::nullopt : std::optional(NamedAxis{*axis, end, d});
  }
  ig_field field_of(std::uint32_t axis) const {
    return is_further_axis(axis) ? further[axis - first_further_axis].id()
                                 : table[letter_index(axis_letters[axis])].field;
  }

  /// It begins no run of words, so that a second word of the axis is seen.
  [[gnu::cold, gnu::noinline]] std::size_t set_named_axis(ig::Block& b, std::string_view text,
                                                          std::size_t begin) const {
    const auto word = named_axis(text, begin);
    if (!word) return begin;
    const auto& [axis, name_end, d] = *word;
    const ig_field field = field_of(axis);
    const bool bare = !d.has_point && d.value != 0;
    if (b.has(field)) b.report(ig::diag("ISO-0108"), ig::Where::columns(begin, d.end), piece(text, begin, name_end));
    b.set_word({.field = field,
                .begin = column(begin),
                .end = column(d.end),
                .value = {.number = d.value + 0.0},
                .flags = bare ? static_cast<std::uint32_t>(IG_WORD_WITHOUT_POINT) : 0u,
                .reserved = 0});
    if (bare) b.raise(without_point);
    if (d.decimals > 3 && b.is_raised(cuts_digits)) b.raise(fine_digits);
    return d.end;
  }

  static ig::Field<double> of_further(int number) {
    return ig::Field<double>("Parsing.FurtherAxis" + std::to_string(number), ig::write, {ig::Life::word, "", ""});
  }

  bool is_next_tool(unsigned letter, const Run& run) const {
    return second_t == SecondT::next && letter == letter_index('T') && !run.has_next_tool;
  }

  void set(ig::Block& b, Run& run, bool has_more_before) const {
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
    if ((run.without_point & WordAddresses::counts_increments) != 0) b.raise(without_point);
    if ((run.without_point & WordAddresses::counts_feed) != 0) b.raise(feed_without_point);
    if (run.most_decimals > 3 && b.is_raised(cuts_digits)) b.raise(fine_digits);
  }

  void twice(ig::Block& b, ig_field field, std::size_t begin, std::size_t end) const {
    if (const auto letter = table.letter_of(field))
      b.report(ig::diag("ISO-0108"), ig::Where::columns(begin, end), std::string_view(&*letter, 1));
  }
};

const ig::Register<WordSyntax> word_syntax;

}  // namespace
}  // namespace iso
