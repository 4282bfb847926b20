/// Words and codes of files in MACRO format: X10., X#1, X(#1+2.), X30. / 2, G#5, M#4, X1=50. Evaluated while the block
/// is read, so that later syntaxes see plain words. An integer counts input units, as a number without a point does; a
/// VACANT value removes the word.
#include <cmath>

#include <isogloss/cnc/code_fields.hpp>
#include <isogloss/cnc/further_axes.hpp>
#include <isogloss/cnc/scan.hpp>

#include "macro/macro_codes.hpp"
#include "macro/macro_expression.hpp"
#include "macro/macro_shared.hpp"

namespace syntec {

using namespace ig::cnc;

namespace {

struct SyntecMacroWord {
  static constexpr auto spec =
      ig::syntax("SyntecMacroWordSyntax", "Reads the words and codes of programs in MACRO format.")
          .after("SyntecMacroStatementSyntax", "HeadIndexSyntax", "MachineCodeSyntax")
          .before("FlagSyntax", "WordSyntax", "ParameterizedFlagSyntax")
          .scans("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz,")
          .scans_ahead();
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SYN-0060", "{0}{1} is not a code: a code is 0 to 9999, whole or with one decimal"),
      ig::diagnostic(IG_ERROR, "SYN-0061",
                     "'{0}' is not executed: the machine has no such axis, and no macro is called"),
      ig::diagnostic(IG_ERROR, "SYN-0062", "'{0}' is not executed: {1} needs a number, not an expression"),
      ig::diagnostic(IG_ERROR, "SYN-0063", "'{0}' has no value: write its number, or remove the address"),
      ig::diagnostic(IG_WARNING, "SYN-0059", "'{0}' repeats an address of this block: the last word counts"),
  };

  ig::Fields addresses_{"addresses", "Parsing.?", ig::write, "The addresses that words may have."};
  ig::Field<double> chamfer_{"Parsing.CornerBreak.C", ig::write, {ig::Life::standard, "mm", ""}};
  ig::Field<double> rounding_{"Parsing.CornerBreak.R", ig::write, {ig::Life::standard, "mm", ""}};
  ig::Signal without_point_{"Parsing.~WithoutPoint", ig::write};
  ig::Signal feed_without_point_{"Parsing.~FeedWithoutPoint", ig::write};
  ig::Signal words_{"Parsing.~MacroWords", ig::read | ig::write};
  ig::Signal named_{"Parsing.~MacroNamedWord", ig::read | ig::write | ig::wake};
  ig::Signal call_{"Parsing.~SyntecMacroCall", ig::read | ig::write};
  ig::Signal code_call_{"Parsing.~BuilderMacro", ig::read | ig::write};
  ig::Signal end_modal_{"Parsing.~SyntecModalEnd", ig::write};
  ig::Signal iso_modal_{"MacroCall.~Modal", ig::read, ig::Life::modal};
  ig::Signal program_{"Parsing.~MacroProgramName", ig::write};
  ig::Config macros_{"isogloss.code-call/1", ig::Need::optional, "The codes that call a macro."};
  FurtherAxisWords further_{ig::write, ig::read};
  AxisNames axes_;
  CodeFields codes_;
  FormatField format_{ig::read};
  SharedScan scan_;
  MacroEnvironment environment_;

  struct Address {
    ig_field field = IG_NO_FIELD;
    std::string_view unit;
  };
  std::array<Address, 26> words_of_{};

  SyntecMacroWord() {
    for (std::size_t i = 0; i < addresses_.size(); ++i)
      if (const unsigned letter = letter_index(addresses_.path(i).back()); letter < 26)
        words_of_[letter] = {addresses_.id(i), addresses_.unit(i)};
  }

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (!format_.is_macro(b) || !b.is_in_turn()) return position;
    if (environment_.flow.is_indexing()) return words_end(text, position);
    // Behind a byte that begins no block, such as NUL, nobody has looked at the words.
    if (!b.is_raised(words_) || scan_->words.size() <= position) {
      scan_->begin_words(text.substr(0, words_end(text, position)));
      b.raise(words_);
    }
    const std::string_view words = scan_->words;
    environment_.enter(b);
    if (text[position] == ',') return corner(b, words, position);
    const std::size_t name = skip_name_of(words, position, is_name_part);
    const std::size_t letters = skip_name_of(words, position, is_letter);
    const std::size_t equals = skip_blanks(words, name);
    if (name - position > 1 && at(words, equals) == '=') return named(b, words, position, name, equals + 1);
    if (letters - position > 1) {
      b.report(ig::diag("SYN-0050"), ig::Where::columns(position, name), piece(words, position, name));
      return name;
    }
    return word(b, words, position, to_upper(text[position]), position + 1);
  }

  /// X1= is an argument of a macro, or of nothing.
  ig::Status build(ig::Block& b) const {
    if (!b.is_raised(named_) || b.is_raised(call_) || b.is_raised(code_call_)) return ig::Status::unchanged;
    for (const auto& [name, value] : scan_->arguments.named)
      b.report(ig::diag("SYN-0061"), ig::Where::block(), name + "=" + shown(value));
    return ig::Status::changed;
  }

 private:
  struct Read {
    MacroValue value{};
    std::size_t end = 0;
    bool is_known = false;
  };

  /// The value at the position, and where it ends. What has no value is reported.
  Read read(ig::Block& b, std::string_view words, std::size_t position, std::size_t begin) const {
    const MacroText text{words, 0};
    const std::size_t first = skip_blanks(words, position);
    if (first >= words.size()) {
      b.report(ig::diag("SYN-0063"), ig::Where::columns(begin, first), trim(piece(words, begin, words.size())));
      return {.end = words.size()};
    }
    if (const ig::Decimal d = ig::read_decimal(words, first); d.ok && !goes_on(words, d.end)) {
      if (d.has_point || is_of_32_bits(d.value))
        return {d.has_point ? MacroValue::real(d.value + 0.0) : MacroValue::whole(d.value + 0.0), d.end, true};
      b.report(ig::diag("SYN-0033"), ig::Where::columns(begin, d.end), trim(piece(words, begin, d.end)));
      return {.end = d.end};
    }
    if (!begins_value(words, first)) {
      b.report(ig::diag("SYN-0063"), ig::Where::columns(begin, first), trim(piece(words, begin, first)));
      return {.end = first};
    }
    MacroExpression e(b, environment_, text, first);
    auto value = e.word();
    // What is left of a value that could not be read is no word of its own.
    if (!value) return {.end = std::max(rest_of_value(words, first), e.position())};
    return {std::move(*value), e.position(), true};
  }

  static bool begins_value(std::string_view words, std::size_t position) {
    const char c = at(words, position);
    if (is_letter(c)) return at(words, name_end(words, position)) == '(';
    return is_digit(c) || std::string_view("#@(\"+-.").find(c) != std::string_view::npos;
  }

  static bool goes_on(std::string_view words, std::size_t end) {
    const std::size_t next = skip_blanks(words, end);
    const char c = at(words, next);
    return c == '*' || c == '/' || c == '+' || c == '-' || is_word(words, next, "MOD");
  }

  static std::size_t rest_of_value(std::string_view words, std::size_t position) {
    std::size_t depth = 0;
    for (; position < words.size(); ++position) {
      const char c = words[position];
      if (c == '(' || c == '[') ++depth;
      if ((c == ')' || c == ']') && depth > 0 && --depth == 0) return position + 1;
      if (depth == 0 && is_blank(c)) break;
    }
    return position;
  }

  std::size_t word(ig::Block& b, std::string_view words, std::size_t begin, char letter, std::size_t position) {
    const std::size_t first = skip_blanks(words, position);
    if ((letter == 'G' || letter == 'M') && is_digit(at(words, first)))
      if (const ig::Decimal d = ig::read_decimal(words, first); d.ok && !goes_on(words, d.end)) {
        code(b, macro_code_name(letter, piece(words, first, d.end)), d.value, d.decimals, begin, d.end);
        return d.end;
      }
    const Read r = read(b, words, position, begin);
    if (!r.is_known && letter == 'P') scan_->has_refused_p = true;
    if (!r.is_known || r.value.is_vacant()) return r.end;
    const auto where = ig::Where::columns(begin, r.end);
    if (letter == 'N' || letter == 'O') {
      b.report(ig::diag("SYN-0062"), where, piece(words, begin, r.end), std::string_view(&letter, 1));
    } else if (r.value.is_text()) {
      if (letter == 'P') {
        scan_->program = r.value.text;
        b.raise(program_);
      } else {
        b.report(ig::diag("SYN-0062"), where, piece(words, begin, r.end), std::string_view(&letter, 1));
      }
    } else if (letter == 'G' || letter == 'M') {
      computed_code(b, letter, r.value.number, begin, r.end);
    } else {
      scan_->arguments.letters[letter_index(letter)] = r.value;
      set(b, words_of_[letter_index(letter)], std::string_view(&letter, 1), r.value, begin, r.end,
          piece(words, begin, r.end));
    }
    return r.end;
  }

  std::size_t named(ig::Block& b, std::string_view words, std::size_t begin, std::size_t name_end,
                    std::size_t position) {
    const Read r = read(b, words, position, begin);
    if (!r.is_known || r.value.is_vacant()) return r.end;
    const std::string name = in_capitals(piece(words, begin, name_end));
    const auto axis = axes_.find(name);
    if (r.value.is_text()) {
      b.report(ig::diag("SYN-0062"), ig::Where::columns(begin, r.end), piece(words, begin, r.end),
               std::string_view(name));
      return r.end;
    }
    if (axis) {
      const Address address = is_further_axis(*axis)
                                  ? Address{further_.word(*axis).id(), axes_.is_rotary(*axis) ? "deg" : "mm"}
                                  : words_of_[letter_index(axis_letters[*axis])];
      set(b, address, name, r.value, begin, r.end, piece(words, begin, r.end));
    } else if (is_letter(name[0]) && skip_digits(name, 1) == name.size()) {
      scan_->arguments.set(name, r.value);
      b.raise(named_);
    } else {
      b.report(ig::diag("SYN-0061"), ig::Where::columns(begin, r.end), piece(words, begin, r.end));
    }
    return r.end;
  }

  /// ,C10. is read by the syntax of corners; here are only the values that have to be computed.
  std::size_t corner(ig::Block& b, std::string_view words, std::size_t position) {
    const std::size_t letter = skip_blanks(words, position + 1), value = skip_blanks(words, letter + 1);
    const char name = to_upper(at(words, letter));
    const ig::Decimal d = value < words.size() ? ig::read_decimal(words, value) : ig::Decimal{.end = value};
    if ((name != 'C' && name != 'R') || (d.ok && !goes_on(words, d.end)) || !begins_value(words, value))
      return position;
    const Read r = read(b, words, value, position);
    if (r.is_known && r.value.is_number())
      set(b, {(name == 'C' ? chamfer_ : rounding_).id(), "mm"}, std::string_view(&name, 1), r.value, position, r.end,
          piece(words, position, r.end));
    return r.end;
  }

  void set(ig::Block& b, const Address& address, std::string_view name, const MacroValue& value, std::size_t begin,
           std::size_t end, std::string_view written) const {
    if (address.field == IG_NO_FIELD) return leave(b, IG_LEFT_WORD, name, begin, end);
    if (b.has(address.field) && b.is_fresh(address.field))
      b.report(ig::diag("SYN-0059"), ig::Where::columns(begin, end), written);
    const bool is_length = address.unit == "mm" || address.unit == "deg" || address.unit == "s";
    const bool is_feed = address.unit == "mm/min";
    const bool is_bare = value.is_whole() && value.number != 0 && (is_length || is_feed || name == "P");
    // Counts and identifying numbers are whole: an error in the last digits of a calculation is rounded off.
    const bool is_count = address.unit.empty() && name.size() == 1 && std::string_view("DHLT").find(name[0]) < 4;
    b.set_word({.field = address.field,
                .begin = column(begin),
                .end = column(end),
                .value = {.number = (is_count ? std::round(value.number) : value.number) + 0.0},
                .flags = is_bare ? static_cast<std::uint32_t>(IG_WORD_WITHOUT_POINT) : 0u,
                .reserved = 0});
    if (is_bare && is_length) b.raise(without_point_);
    if (is_bare && is_feed) b.raise(feed_without_point_);
  }

  void computed_code(ig::Block& b, char letter, double number, std::size_t begin, std::size_t end) {
    const auto index = CodeFields::index_of(number);
    if (!index) {
      b.report(ig::diag("SYN-0060"), ig::Where::columns(begin, end), std::string_view(&letter, 1), number);
      return;
    }
    code(b, std::string(CodeName(letter, *index).text()), number, *index % 10 == 0 ? 0 : 1, begin, end);
  }

  void code(ig::Block& b, const std::string& name, double number, std::ptrdiff_t decimals, std::size_t begin,
            std::size_t end) {
    if (name[0] == 'M') scan_->arguments.letters[letter_index('M')] = MacroValue::of_number(number);
    if (name == "G65" || name == "G66" || name == "G66.1") {
      scan_->calls.push_back({name, {}, begin, end});
      return b.raise(call_);
    }
    // A G66 of a file in ISO format is FanucModalMacroSyntax's.
    if (name == "G67" && !(environment_.store().level().modal.empty() && b.is_raised(iso_modal_)))
      return b.raise(end_modal_);
    if (macros_.number(name) && calls_macro(name, environment_.store().level().caller)) {
      const bool is_of_robot = name[0] == 'G' && number < 200 && decimals > 1;
      scan_->calls.push_back({name, is_of_robot ? std::string() : macro_code_file(name), begin, end});
      return b.raise(code_call_);
    }
    const auto index = CodeFields::index_of(number);
    if (decimals > 1 || !index)
      leave(b, IG_LEFT_UNKNOWN, name, begin, end);
    else
      codes_.set(b, name[0], *index, begin, end);
  }
};

const ig::Register<SyntecMacroWord> syntec_macro_word_syntax;

}  // namespace
}  // namespace syntec
