/// Expressions of custom macro B: read and computed in one pass over the text. Knows no block; variables come from a
/// function of the caller. Recursion is bounded by the nesting of brackets.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string_view>

#include <isogloss/cnc/units.hpp>
#include <isogloss/number.hpp>

namespace fanuc {

using namespace ig::cnc;

/// null: a variable that nobody set. truth: the answer of a comparison, 1 or 0.
enum class Kind : std::uint8_t { number, null, truth };

struct MacroValue {
  double number = 0;
  Kind kind = Kind::number;

  bool is_null() const { return kind == Kind::null; }
  static MacroValue null() { return {0, Kind::null}; }
  static MacroValue truth(bool yes) { return {yes ? 1.0 : 0.0, Kind::truth}; }
};

enum class Fault : std::uint8_t {
  none,
  no_operand,        ///< a value should stand here
  not_closed,        ///< this bracket has no partner
  too_deep,          ///< more brackets than are read
  number_too_large,  ///< digits that no number holds
  unknown_function,
  named_variable,  ///< #<name>, #_NAME
  double_hash,     ///< ##1
  no_variable,     ///< a variable number that is negative, not whole, null or too large
  unknown_variable,
  not_known_here,  ///< a variable of the control whose value this run does not know
  division_by_zero,
  out_of_domain,  ///< the function has no value there
  overflow,
  no_bits,          ///< AND, OR, XOR, BIN or BCD of what is no whole number of 32 bits
  truth_as_number,  ///< a comparison inside a calculation
  no_comparison     ///< a condition that compares nothing
};

/// What controls differ in.
struct ExpressionRules {
  bool arcs_are_signed = false;  ///< ATAN and ASIN answer from -180 to 180, not from 0 to 360
  bool truth_is_number = false;  ///< a comparison is 1 or 0 anywhere, and any number is a condition
  bool whole_modulus = true;     ///< MOD rounds its operands to whole numbers
  std::uint32_t deepest = 64;    ///< brackets inside each other that are read
  double increment = 0;          ///< ROUND rounds to this; 0: to whole numbers
};

struct Outcome {
  MacroValue value;
  Fault fault = Fault::none;
  std::uint32_t depth = 0;      ///< brackets inside each other
  std::size_t end = 0;          ///< past what was read
  std::size_t fault_begin = 0;  ///< columns of the fault
  std::size_t fault_end = 0;
  std::uint32_t variable = 0;  ///< the one that could not be read

  bool ok() const { return fault == Fault::none; }
};

namespace detail {

constexpr bool is_space(char c) { return c == ' ' || c == '\t'; }
constexpr bool is_number_start(char c) { return (c >= '0' && c <= '9') || c == '.'; }
constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
constexpr bool is_name(char c) { return upper(c) >= 'A' && upper(c) <= 'Z'; }

enum class Function : std::uint8_t {
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  sqrt,
  abs,
  bin,
  bcd,
  round,
  fix,
  fup,
  ln,
  exp,
  pow,
  adp,
  prm,
  none
};

struct FunctionName {
  std::string_view name;
  Function function;
};
inline constexpr std::array functions{
    FunctionName{"SIN", Function::sin},   FunctionName{"COS", Function::cos},     FunctionName{"TAN", Function::tan},
    FunctionName{"ASIN", Function::asin}, FunctionName{"ACOS", Function::acos},   FunctionName{"ATAN", Function::atan},
    FunctionName{"ATN", Function::atan},  FunctionName{"SQRT", Function::sqrt},   FunctionName{"SQR", Function::sqrt},
    FunctionName{"ABS", Function::abs},   FunctionName{"BIN", Function::bin},     FunctionName{"BCD", Function::bcd},
    FunctionName{"RND", Function::round}, FunctionName{"ROUND", Function::round}, FunctionName{"FIX", Function::fix},
    FunctionName{"FUP", Function::fup},   FunctionName{"LN", Function::ln},       FunctionName{"EXP", Function::exp},
    FunctionName{"POW", Function::pow},   FunctionName{"ADP", Function::adp},     FunctionName{"PRM", Function::prm}};

constexpr bool equals(std::string_view text, std::string_view capitals) {
  if (text.size() != capitals.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (upper(text[i]) != capitals[i]) return false;
  return true;
}

/// By its name, or by its first two letters.
constexpr Function function_of(std::string_view name) {
  for (const FunctionName& f : functions)
    if (equals(name, f.name) || (name.size() == 2 && equals(name, f.name.substr(0, 2)))) return f.function;
  return Function::none;
}

/// Exact where the answer is: multiples of 30 degrees.
inline double sine(double degrees) {
  const double turn = std::remainder(degrees, 360.0);  // -180 to 180
  const double a = std::abs(turn);
  const double sign = turn < 0 ? -1 : 1;
  if (a == 0 || a == 180) return 0;
  if (a == 30 || a == 150) return sign * 0.5;
  if (a == 90) return sign;
  return std::sin(turn * radians_per_degree);
}
inline double cosine(double degrees) {
  const double a = std::abs(std::remainder(degrees, 360.0));
  if (a == 0) return 1;
  if (a == 60) return 0.5;
  if (a == 90) return 0;
  if (a == 120) return -0.5;
  if (a == 180) return -1;
  return std::cos(a * radians_per_degree);
}
inline double tangent(double degrees) {
  const double turn = std::remainder(degrees, 180.0);  // -90 to 90
  if (turn == 0) return 0;
  if (std::abs(turn) == 45) return turn < 0 ? -1 : 1;
  return std::tan(turn * radians_per_degree);
}
inline double in_degrees(double radians) { return radians * degrees_per_radian; }

/// Half away from zero.
inline double round_to(double value, double increment) {
  if (increment == 0) return std::round(value);
  const double per_unit = std::round(1 / increment);
  return std::round(value * per_unit) / per_unit;
}

inline bool to_bits(double value, std::int32_t& out) {
  const double whole = std::round(value);
  if (!(std::abs(whole) <= 2147483647.0)) return false;
  out = static_cast<std::int32_t>(whole);
  return true;
}

template <class Variables>
class ExpressionReader {
 public:
  ExpressionReader(std::string_view text, std::size_t position, const ExpressionRules& rules,
                   const Variables& variables)
      : text_(text), position_(position), rules_(rules), variables_(variables) {}

  Outcome expression() {
    MacroValue value;
    comparison(value);
    return outcome(value);
  }
  Outcome operand() {
    MacroValue value;
    primary(value);
    return outcome(value);
  }
  /// #12, #[#3+1]: the number of the variable.
  Outcome reference() {
    MacroValue number;
    skip_spaces();
    const std::size_t begin = position_;
    if (peek() != '#') {
      fail(Fault::no_operand, begin, begin + 1);
    } else {
      variable_number(number);
    }
    return outcome(number);
  }

 private:
  char peek() const { return position_ < text_.size() ? text_[position_] : '\0'; }
  void skip_spaces() {
    while (position_ < text_.size() && is_space(text_[position_])) ++position_;
  }

  Outcome outcome(MacroValue value) const {
    return {value, fault_, deepest_, end_, fault_begin_, std::min(fault_end_, text_.size()), unread_};
  }

  bool fail(Fault fault, std::size_t begin, std::size_t end) {
    fault_ = fault;
    fault_begin_ = begin;
    fault_end_ = end;
    return false;
  }

  /// True, and behind it, when the letters of an operator stand next.
  bool accept(std::string_view name) {
    if (text_.size() - position_ < name.size() || !equals(text_.substr(position_, name.size()), name)) return false;
    position_ += name.size();
    return true;
  }

  bool finish(double result, MacroValue& out, std::size_t begin) {
    if (!std::isfinite(result)) return fail(Fault::overflow, begin, end_);
    out = {result + 0.0, Kind::number};  // -0 becomes 0
    return true;
  }

  bool as_number(const MacroValue& value, std::size_t begin) {
    if (value.kind != Kind::truth || rules_.truth_is_number) return true;
    return fail(Fault::truth_as_number, begin, end_);
  }

  enum class Relation : std::uint8_t { none, eq, ne, gt, ge, lt, le };
  Relation relation() {
    skip_spaces();
    switch (upper(peek())) {
      case 'E': return accept("EQ") ? Relation::eq : Relation::none;
      case 'N': return accept("NE") ? Relation::ne : Relation::none;
      case 'G': return accept("GT") ? Relation::gt : accept("GE") ? Relation::ge : Relation::none;
      case 'L': return accept("LT") ? Relation::lt : accept("LE") ? Relation::le : Relation::none;
      default: return Relation::none;
    }
  }

  static bool holds(Relation relation, const MacroValue& a, const MacroValue& b) {
    const bool same = a.is_null() == b.is_null() && a.number == b.number;
    switch (relation) {
      case Relation::eq: return same;
      case Relation::ne: return !same;
      case Relation::gt: return a.number > b.number;
      case Relation::ge: return a.number >= b.number;
      case Relation::lt: return a.number < b.number;
      default: return a.number <= b.number;
    }
  }

  bool comparison(MacroValue& out) {
    const std::size_t begin = position_;
    if (!sum(out)) return false;
    for (;;) {
      const Relation which = relation();
      if (which == Relation::none) return true;
      if (!as_number(out, begin)) return false;
      skip_spaces();
      const std::size_t right_begin = position_;
      MacroValue right;
      if (!sum(right) || !as_number(right, right_begin)) return false;
      out = MacroValue::truth(holds(which, out, right));
    }
  }

  bool sum(MacroValue& out) {
    const std::size_t begin = position_;
    if (!product(out)) return false;
    for (;;) {
      skip_spaces();
      const char c = upper(peek());
      const std::size_t at = position_;
      if (c == '+' || c == '-') {
        ++position_;
        skip_spaces();
        const std::size_t right_begin = position_;
        MacroValue right;
        if (!product(right) || !as_number(out, begin) || !as_number(right, right_begin)) return false;
        if (!finish(c == '+' ? out.number + right.number : out.number - right.number, out, begin)) return false;
      } else if (c == 'O' && accept("OR")) {
        if (!bits(
                out, begin, [](std::uint32_t a, std::uint32_t b) { return a | b; }, &ExpressionReader::product))
          return false;
      } else if (c == 'X' && accept("XOR")) {
        if (!bits(
                out, begin, [](std::uint32_t a, std::uint32_t b) { return a ^ b; }, &ExpressionReader::product))
          return false;
      } else {
        position_ = at;
        return true;
      }
    }
  }

  bool product(MacroValue& out) {
    const std::size_t begin = position_;
    if (!signed_operand(out)) return false;
    for (;;) {
      skip_spaces();
      const char c = upper(peek());
      if (c == '*' || c == '/') {
        ++position_;
        skip_spaces();
        const std::size_t right_begin = position_;
        MacroValue right;
        if (!signed_operand(right) || !as_number(out, begin) || !as_number(right, right_begin)) return false;
        if (c == '/' && right.number == 0) return fail(Fault::division_by_zero, right_begin, end_);
        if (!finish(c == '*' ? out.number * right.number : out.number / right.number, out, begin)) return false;
      } else if (c == 'M' && accept("MOD")) {
        skip_spaces();
        const std::size_t right_begin = position_;
        MacroValue right;
        if (!signed_operand(right) || !as_number(out, begin) || !as_number(right, right_begin)) return false;
        const double a = rules_.whole_modulus ? std::round(out.number) : out.number;
        const double b = rules_.whole_modulus ? std::round(right.number) : right.number;
        if (b == 0) return fail(Fault::division_by_zero, right_begin, end_);
        if (!finish(std::fmod(a, b), out, begin)) return false;
      } else if (c == 'A' && accept("AND")) {
        if (!bits(
                out, begin, [](std::uint32_t a, std::uint32_t b) { return a & b; }, &ExpressionReader::signed_operand))
          return false;
      } else {
        return true;
      }
    }
  }

  /// AND, OR, XOR: of two comparisons, or bit by bit of whole numbers.
  template <class Operation>
  bool bits(MacroValue& out, std::size_t begin, Operation operation, bool (ExpressionReader::*next)(MacroValue&)) {
    const std::size_t left_end = position_;
    skip_spaces();
    const std::size_t right_begin = position_;
    MacroValue right;
    if (!(this->*next)(right)) return false;
    if (out.kind == Kind::truth && right.kind == Kind::truth) {
      out.number = operation(static_cast<std::uint32_t>(out.number), static_cast<std::uint32_t>(right.number));
      return true;
    }
    if (!as_number(out, begin) || !as_number(right, right_begin)) return false;
    std::int32_t a = 0, b = 0;
    if (!to_bits(out.number, a)) return fail(Fault::no_bits, begin, left_end);
    if (!to_bits(right.number, b)) return fail(Fault::no_bits, right_begin, end_);
    const auto result =
        static_cast<std::int32_t>(operation(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)));
    out = {static_cast<double>(result), Kind::number};
    return true;
  }

  bool signed_operand(MacroValue& out) {
    bool negative = false, is_signed = false;
    std::size_t begin = position_;
    for (skip_spaces();; ++position_, skip_spaces()) {
      const char c = peek();
      if (c != '+' && c != '-') break;
      if (!is_signed) begin = position_;
      is_signed = true;
      negative ^= c == '-';
    }
    if (!primary(out)) return false;
    if (!is_signed) return true;
    if (!as_number(out, begin)) return false;
    out = {(negative ? -out.number : out.number) + 0.0, Kind::number};
    return true;
  }

  bool primary(MacroValue& out) {
    skip_spaces();
    const std::size_t begin = position_;
    const char c = peek();
    if (c == '#') return variable(out);
    if (c == '[') return bracket(out);
    if (is_number_start(c)) return number(out);
    if (is_name(c)) return function(out);
    return fail(Fault::no_operand, begin, begin + 1);
  }

  bool number(MacroValue& out) {
    const std::size_t begin = position_;
    const ig::Decimal d = ig::read_decimal(text_, begin);
    if (!d.ok) {
      return d.end == begin ? fail(Fault::no_operand, begin, begin + 1) : fail(Fault::number_too_large, begin, d.end);
    }
    position_ = end_ = d.end;
    out = {d.value, Kind::number};
    return true;
  }

  bool open() {
    if (++depth_ > rules_.deepest) return fail(Fault::too_deep, position_, position_ + 1);
    if (depth_ > deepest_) deepest_ = depth_;
    ++position_;
    return true;
  }
  bool close(std::size_t opened) {
    skip_spaces();
    if (peek() != ']') {
      // What stands there instead says more than the bracket, unless the text ends.
      if (position_ < text_.size() && peek() != '\r' && peek() != '\n')
        return fail(Fault::no_operand, position_, position_ + 1);
      return fail(Fault::not_closed, opened, opened + 1);
    }
    --depth_;
    end_ = ++position_;
    return true;
  }

  bool bracket(MacroValue& out) {
    const std::size_t opened = position_;
    return open() && comparison(out) && close(opened);
  }

  bool variable_number(MacroValue& out) {
    const std::size_t hash = position_++;
    skip_spaces();
    const char c = peek();
    if (c == '[') {
      if (!bracket(out) || !as_number(out, hash)) return false;
      if (out.is_null()) return fail(Fault::no_variable, hash, end_);
      const double whole = std::round(out.number);
      // Calculated numbers carry the noise of their last digits.
      if (std::abs(out.number - whole) > 1e-6) return fail(Fault::no_variable, hash, end_);
      out.number = whole;
    } else if (c == '#') {
      return fail(Fault::double_hash, hash, position_ + 1);
    } else if (c == '<' || c == '_') {
      return fail(Fault::named_variable, hash, position_ + 1);
    } else if (c == '-' || c == '+') {
      return fail(Fault::no_variable, hash, position_ + 1);
    } else if (!is_number_start(c)) {
      return fail(Fault::no_operand, position_, position_ + 1);
    } else if (!number(out)) {
      return false;
    }
    if (!(out.number >= 0 && out.number <= 999'999) || out.number != std::floor(out.number))
      return fail(Fault::no_variable, hash, end_);
    return true;
  }

  bool variable(MacroValue& out) {
    const std::size_t begin = position_;
    MacroValue number;
    if (!variable_number(number)) return false;
    const Fault fault = variables_(static_cast<std::uint32_t>(number.number), out);
    if (fault == Fault::none) return true;
    unread_ = static_cast<std::uint32_t>(number.number);
    return fail(fault, begin, end_);
  }

  bool function(MacroValue& out) {
    const std::size_t begin = position_;
    std::size_t name_end = begin;
    while (name_end < text_.size() && is_name(text_[name_end])) ++name_end;
    const Function which = function_of(text_.substr(begin, name_end - begin));
    if (which == Function::none) return fail(Fault::unknown_function, begin, name_end);
    position_ = name_end;
    skip_spaces();
    const std::size_t opened = position_;
    if (peek() != '[') return fail(Fault::no_operand, opened, opened + 1);
    MacroValue first, second;
    if (!open() || !comparison(first) || !as_number(first, opened)) return false;
    skip_spaces();
    bool has_second = false;
    if (peek() == ',' && (which == Function::atan || which == Function::pow || which == Function::prm)) {
      ++position_;
      has_second = true;
      const std::size_t second_begin = position_;
      if (!comparison(second) || !as_number(second, second_begin)) return false;
    }
    if (!close(opened)) return false;
    if (which == Function::pow && !has_second) return fail(Fault::no_operand, end_ - 1, end_);
    if (which == Function::prm) return parameter(first, has_second ? &second : nullptr, out, begin);
    if (which == Function::atan && !has_second && is_second_bracket_next()) {
      skip_spaces();
      ++position_;
      skip_spaces();
      const std::size_t second_begin = position_;
      if (!bracket(second) || !as_number(second, second_begin)) return false;
      has_second = true;
    }
    if (has_second && which == Function::atan) return arc_tangent(first.number, second.number, out, begin);
    return apply(which, first.number, second.number, out, begin);
  }

  /// PRM[number], PRM[number, bit], and either with /[axis]: the axis counts from 1.
  bool parameter(const MacroValue& number, const MacroValue* bit, MacroValue& out, std::size_t begin) {
    MacroValue axis;
    const bool has_axis = is_second_bracket_next();
    if (has_axis) {
      skip_spaces();
      ++position_;
      skip_spaces();
      const std::size_t axis_begin = position_;
      if (!bracket(axis) || !as_number(axis, axis_begin)) return false;
    }
    const auto whole = [](double x, double least, double most) {
      return x >= least && x <= most && x == std::floor(x);
    };
    if (!whole(number.number, 1, 99'999) || (bit != nullptr && !whole(bit->number, 0, 7)) ||
        (has_axis && !whole(axis.number, 1, 32)))
      return fail(Fault::out_of_domain, begin, end_);
    if constexpr (requires { variables_.parameter(0U, 0U, out); }) {
      const Fault fault = variables_.parameter(static_cast<std::uint32_t>(number.number),
                                               has_axis ? static_cast<std::uint32_t>(axis.number) : 0, out);
      if (fault != Fault::none) return fail(fault, begin, end_);
      if (bit != nullptr)
        out.number = (static_cast<std::uint32_t>(out.number) >> static_cast<std::uint32_t>(bit->number)) & 1U;
      return true;
    } else {
      return fail(Fault::not_known_here, begin, end_);
    }
  }

  /// ATAN[a]/[b]
  bool is_second_bracket_next() const {
    std::size_t i = position_;
    while (i < text_.size() && is_space(text_[i])) ++i;
    if (i >= text_.size() || text_[i] != '/') return false;
    for (++i; i < text_.size() && is_space(text_[i]);) ++i;
    return i < text_.size() && text_[i] == '[';
  }

  bool arc_tangent(double y, double x, MacroValue& out, std::size_t begin) {
    if (x == 0 && y == 0) return fail(Fault::out_of_domain, begin, end_);
    const double angle = in_degrees(std::atan2(y, x));
    return finish(angle < 0 && !rules_.arcs_are_signed ? angle + 360 : angle, out, begin);
  }

  bool apply(Function which, double x, double y, MacroValue& out, std::size_t begin) {
    const auto no_value = [&] { return fail(Fault::out_of_domain, begin, end_); };
    switch (which) {
      case Function::sin: return finish(sine(x), out, begin);
      case Function::cos: return finish(cosine(x), out, begin);
      case Function::tan:
        if (std::abs(std::remainder(x, 180.0)) == 90) return no_value();
        return finish(tangent(x), out, begin);
      case Function::asin: {
        if (!(std::abs(x) <= 1)) return no_value();
        const double angle = in_degrees(std::asin(x));
        return finish(angle < 0 && !rules_.arcs_are_signed ? angle + 360 : angle, out, begin);
      }
      case Function::acos: return std::abs(x) <= 1 ? finish(in_degrees(std::acos(x)), out, begin) : no_value();
      case Function::atan: return finish(in_degrees(std::atan(x)), out, begin);
      case Function::sqrt: return x >= 0 ? finish(std::sqrt(x), out, begin) : no_value();
      case Function::abs: return finish(std::abs(x), out, begin);
      case Function::bin: return binary_from_decades(x, out, begin);
      case Function::bcd: return decades_from_binary(x, out, begin);
      case Function::round: return finish(round_to(x, rules_.increment), out, begin);
      case Function::fix: return finish(std::trunc(x), out, begin);
      case Function::fup: return finish(x < 0 ? std::floor(x) : std::ceil(x), out, begin);
      case Function::ln: return x > 0 ? finish(std::log(x), out, begin) : no_value();
      case Function::exp: return finish(std::exp(x), out, begin);
      case Function::pow: {
        const double power = std::pow(x, y);
        return std::isnan(power) || (x == 0 && y < 0) ? no_value() : finish(power, out, begin);
      }
      case Function::adp: return finish(x, out, begin);
      default: return no_value();
    }
  }

  /// BIN: four bits are one decimal digit.
  bool binary_from_decades(double x, MacroValue& out, std::size_t begin) {
    const double whole = std::round(x);
    if (!(whole >= 0 && whole <= 4294967295.0)) return fail(Fault::no_bits, begin, end_);
    double value = 0, place = 1;
    for (auto rest = static_cast<std::uint32_t>(whole); rest != 0; rest >>= 4, place *= 10) {
      if ((rest & 15u) > 9) return fail(Fault::no_bits, begin, end_);
      value += place * (rest & 15u);
    }
    return finish(value, out, begin);
  }
  /// BCD: each decimal digit becomes four bits.
  bool decades_from_binary(double x, MacroValue& out, std::size_t begin) {
    const double whole = std::round(x);
    if (!(whole >= 0 && whole <= 99'999'999)) return fail(Fault::no_bits, begin, end_);
    std::uint32_t value = 0, shift = 0;
    for (auto rest = static_cast<std::uint32_t>(whole); rest != 0; rest /= 10, shift += 4) value |= rest % 10 << shift;
    return finish(value, out, begin);
  }

  std::string_view text_;
  std::size_t position_;
  const ExpressionRules& rules_;
  const Variables& variables_;
  Fault fault_ = Fault::none;
  std::size_t end_ = position_;
  std::size_t fault_begin_ = 0, fault_end_ = 0;
  std::uint32_t unread_ = 0;
  std::uint32_t depth_ = 0, deepest_ = 0;
};

}  // namespace detail

/// The expression that begins at `position`; it ends before the first character that cannot continue it.
/// `variables(number, value)` gives a variable and answers Fault::none, or says why there is none;
/// `variables.parameter( number, axis, value)`, where it has that, a parameter of the control. Axis 0: one that is for
/// the whole control.
template <class Variables>
Outcome evaluate(std::string_view text, std::size_t position, const ExpressionRules& rules,
                 const Variables& variables) {
  return detail::ExpressionReader<Variables>(text, position, rules, variables).expression();
}

/// One operand without a sign: #1, [#1+2], SIN[30], 12.5.
template <class Variables>
Outcome evaluate_operand(std::string_view text, std::size_t position, const ExpressionRules& rules,
                         const Variables& variables) {
  return detail::ExpressionReader<Variables>(text, position, rules, variables).operand();
}

/// The number of the variable that is named at `position`.
template <class Variables>
Outcome evaluate_reference(std::string_view text, std::size_t position, const ExpressionRules& rules,
                           const Variables& variables) {
  return detail::ExpressionReader<Variables>(text, position, rules, variables).reference();
}

}  // namespace fanuc
