// Words and codes whose value is computed: X#1, Z-[#2+1.], G#5, M[#6+10]. The values have full precision and are read
// as if written with a decimal point; an empty variable removes the word. Evaluated while the block is read, so that
// later syntaxes see plain words.
#include <algorithm>
#include <string>

#include <isogloss/cnc/further_axes.hpp>
#include <isogloss/cnc/scan.hpp>

#include <isogloss/cnc/code_fields.hpp>
#include "macro/macro_environment.hpp"

namespace fanuc {

using namespace ig::cnc;

namespace {

struct FanucMacroWord {
  static constexpr auto spec =
      ig::syntax("FanucMacroWordSyntax", "Words and codes whose value is a variable or an expression.")
          .after("FlagSyntax", "WordSyntax", "FanucMacroStatementSyntax")
          .before("ParameterizedFlagSyntax")
          .scans("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz,")
          .scans_ahead();
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "FAN-0151", "'{0}' is not used: {1} needs a number, not a variable"),
      ig::diagnostic(IG_ERROR, "FAN-0152", "{0}{1} is not a code: a code is 0 to 9999, whole or with one decimal"),
      ig::diagnostic(IG_WARNING, "FAN-0153",
                     "'{0}' is a calculation without brackets: write it in [ ]; it is computed here"),
      ig::diagnostic(IG_WARNING, "FAN-0154", "'{0}' repeats an address of this block: the last word counts"),
      ig::diagnostic(IG_NOTE, "FAN-0155",
                     "{0} is empty, so the block has no such word: check where the variable is assigned"),
  };

  ig::Fields addresses_{"addresses", "Parsing.?", ig::write, "The addresses that words may have."};
  /// With a comma before them, C and R are chamfer and rounding of a corner.
  ig::Field<double> chamfer_{"Parsing.CornerBreak.C", ig::write, {ig::Life::standard, "mm", ""}};
  ig::Field<double> rounding_{"Parsing.CornerBreak.R", ig::write, {ig::Life::standard, "mm", ""}};
  FurtherAxisWords further_{ig::write, ig::read};
  AxisNames axes_;
  CodeFields codes_;
  ig::Field<double> passed_m_{"PassedCode.M", ig::write, {ig::Life::block, "", "The M code found last."}};
  ig::Config number_format_{"isogloss.number-format/1", ig::Need::optional, "The increments that ROUND rounds to."};
  ig::Codes units_{{"G20", "G21"}, ig::read};
  ig::In<ig::Symbol> system_{"Unit.System"};
  ig::Name inch_{"Inch"};
  MacroEnvironment environment_;

  struct Address {
    ig_field field = IG_NO_FIELD;
    std::string_view unit;
  };
  std::array<Address, 26> words_{};
  double mm_ = number_format_.number("LengthIncrement_mm").value_or(0.001);
  double in_ = number_format_.number("LengthIncrement_inch").value_or(0.0001);
  double deg_ = number_format_.number("AngleIncrement_deg").value_or(0.001);

  FanucMacroWord() {
    for (std::size_t i = 0; i < addresses_.size(); ++i)
      if (const unsigned letter = letter_index(addresses_.path(i).back()); letter < 26)
        words_[letter] = {addresses_.id(i), addresses_.unit(i)};
  }

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    bool negative = false;
    const bool is_corner = text[position] == ',';
    const std::size_t letter = is_corner ? ig::cnc::skip_blanks(text, position + 1) : position;
    const char name = to_upper(ig::cnc::at(text, letter));
    if (is_corner && name != 'C' && name != 'R') return position;
    const std::optional<Name> axis = is_corner ? std::nullopt : name_at(text, position);
    const std::size_t value = skip_signs(text, axis ? axis->end : letter + 1, negative);
    const char c = ig::cnc::at(text, value);
    const bool is_function =
        ig::cnc::is_letter(c) && ig::cnc::at(text, skip_name_of(text, value, ig::cnc::is_letter)) == '[';
    if ((c != '#' && c != '[' && !is_function) || !b.is_in_turn()) return position;
    if (environment_.flow.is_indexing()) return skip_expression(text, value);
    environment_.enter(b);
    return word(b, text, position, value, negative, axis ? &axis->address : nullptr);
  }

 private:
  struct Name {
    Address address;
    std::size_t end;  ///< behind =
  };
  /// C2=#1: an axis by a name of several characters that the machine's table gives it.
  std::optional<Name> name_at(std::string_view text, std::size_t begin) const {
    const auto is_part = [](char c) { return ig::cnc::is_letter(c) || is_digit(c) || c == '_'; };
    const std::size_t end = skip_name_of(text, begin, is_part);
    if (end - begin < 2 || ig::cnc::at(text, end) != '=') return std::nullopt;
    const auto axis = axes_.find(ig::cnc::piece(text, begin, end));
    if (!axis) return std::nullopt;
    if (!is_further_axis(*axis)) return Name{words_[letter_index(axis_letters[*axis])], end + 1};
    return Name{{further_.word(*axis).id(), axes_.is_rotary(*axis) ? "deg" : "mm"}, end + 1};
  }

  static std::size_t skip_signs(std::string_view text, std::size_t position, bool& negative) {
    for (;; ++position) {
      const char c = ig::cnc::at(text, position);
      if (c == '-') negative = !negative;
      if (c != '+' && c != '-' && !is_blank(c)) return position;
    }
  }

  std::size_t word(ig::Block& b, std::string_view text, std::size_t begin, std::size_t value, bool negative,
                   const Address* axis) {
    const bool is_corner = text[begin] == ',';
    const char letter = to_upper(text[is_corner ? ig::cnc::skip_blanks(text, begin + 1) : begin]);
    ExpressionRules rules = environment_.rules();
    rules.increment = increment_of(b, is_corner ? 'R' : letter, axis);
    const auto variables = environment_.reader(b);
    const bool is_variable = text[value] == '#' && is_digit(ig::cnc::at(text, value + 1));
    if (!is_variable) text = without_comments(text, begin, value);
    Outcome o = evaluate_operand(text, value, rules, variables);
    const std::size_t whole = skip_expression(text, value);
    if (!o.ok()) {
      environment_.report(b, o, text);
      return std::max({whole, o.end, o.fault_end, begin + 1});
    }
    if (whole > o.end) {
      b.report(ig::diag("FAN-0153"), ig::Where::columns(begin, whole), ig::cnc::piece(text, begin, whole));
      o = evaluate(text.substr(0, whole), value, rules, variables);
      if (!o.ok()) {
        environment_.report(b, o, text);
        return whole;
      }
    }
    if (environment_.has_deep_brackets(o)) environment_.warn_of_depth(b, o, begin, o.end);
    if (o.value.kind == Kind::truth && !rules.truth_is_number) {
      b.report(ig::diag("FAN-0115"), ig::Where::columns(value, o.end), ig::cnc::piece(text, value, o.end));
    } else if (axis == nullptr && (letter == 'N' || letter == 'O')) {
      b.report(ig::diag("FAN-0151"), ig::Where::columns(begin, o.end), ig::cnc::piece(text, begin, o.end),
               std::string_view(&letter, 1));
    } else if (!o.value.is_null()) {
      const double number = negative ? -o.value.number : o.value.number;
      if (is_corner)
        set_corner(b, letter, number, begin, o.end);
      else if (axis == nullptr && (letter == 'G' || letter == 'M'))
        set_code(b, letter, number, begin, o.end);
      else
        set_word(b, letter, axis, number, begin, o.end, ig::cnc::piece(text, begin, o.end));
    } else if (letter == 'F' && !is_corner) {
      b.report(ig::diag("FAN-0155"), ig::Where::columns(begin, o.end), ig::cnc::piece(text, begin, o.end));
    }
    return o.end;
  }

  /// The text up to the end of the brackets that begin at `value`, with blanks in place of the comments between them,
  /// so that columns stay the same. Text before the word is not copied, because a line may hold thousands of words. The
  /// text itself where there are no such comments.
  std::string_view without_comments(std::string_view text, std::size_t begin, std::size_t value) {
    constexpr std::size_t longest_name = 64;  // up to the first bracket: signs, #, a function's name
    std::size_t depth = 0, copied = begin;
    for (std::size_t i = value; i < text.size(); ++i) {
      if (text[i] == '(' && depth > 0) {
        const std::size_t close = skip_bracketed(text, i);
        if (blanked_.size() < text.size()) blanked_.resize(text.size());
        text.copy(blanked_.data() + copied, i - copied, copied);
        std::fill(blanked_.data() + i, blanked_.data() + close, ' ');
        copied = close;
        i = close - 1;
        continue;
      }
      if (depth == 0 && i - value > longest_name) return text;
      if (text[i] == '[') ++depth;
      if (text[i] != ']' || depth == 0 || --depth > 0) continue;
      if (copied == begin) return text;
      text.copy(blanked_.data() + copied, i + 1 - copied, copied);
      return std::string_view(blanked_).substr(0, i + 1);
    }
    if (copied == begin) return text;
    text.copy(blanked_.data() + copied, text.size() - copied, copied);
    return std::string_view(blanked_).substr(0, text.size());
  }

  /// The increment to which ROUND rounds in this word; 0: whole numbers.
  double increment_of(const ig::Block& b, char letter, const Address* axis) const {
    const Address& address = axis != nullptr ? *axis : words_[letter_index(letter)];
    if (address.unit == "deg") return deg_;
    if (address.unit == "mm") {
      const auto code = b.find(units_);
      return (code ? *code == 0 : b.is(system_, inch_)) ? in_ : mm_;
    }
    return letter == 'F' ? 0.001 : 0;
  }

  void set_word(ig::Block& b, char letter, const Address* axis, double number, std::size_t begin, std::size_t end,
                std::string_view written) {
    const Address& address = axis != nullptr ? *axis : words_[letter_index(letter)];
    const auto where = ig::Where::columns(begin, end);
    if (address.field == IG_NO_FIELD) {
      leave(b, IG_LEFT_WORD, {&letter, 1}, begin, end);
      return;
    }
    ig_value before;
    if (b.get(address.field, before)) b.report(ig::diag("FAN-0154"), where, written);
    // Counts and identifying numbers are whole: an error in the last digits of a calculation is rounded off.
    const bool is_whole = address.unit.empty() && std::string_view("DHLPT").find(letter) != std::string_view::npos;
    const ig_word word{.field = address.field,
                       .begin = column(begin),
                       .end = column(end),
                       .value = {.number = (is_whole ? std::round(number) : number) + 0.0},
                       .flags = 0,
                       .reserved = 0};
    b.set_word(word);
  }

  void set_corner(ig::Block& b, char letter, double number, std::size_t begin, std::size_t end) const {
    const ig_word word{.field = (letter == 'C' ? chamfer_ : rounding_).id(),
                       .begin = column(begin),
                       .end = column(end),
                       .value = {.number = number + 0.0},
                       .flags = 0,
                       .reserved = 0};
    b.set_word(word);
  }

  void set_code(ig::Block& b, char letter, double number, std::size_t begin, std::size_t end) {
    if (letter == 'M') b.set(passed_m_, number);
    if (const auto index = CodeFields::index_of(number))
      codes_.set(b, letter, *index, begin, end);
    else
      b.report(ig::diag("FAN-0152"), ig::Where::columns(begin, end), std::string_view(&letter, 1), number);
  }

  std::string blanked_;
};

const ig::Register<FanucMacroWord> fanuc_macro_word_syntax;

}  // namespace
}  // namespace fanuc
