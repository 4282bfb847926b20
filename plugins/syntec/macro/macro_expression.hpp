/// Expressions of the macro language, evaluated on their text. Binding, from the strongest: brackets and functions,
/// - and NOT, * / MOD, + -, < > <= >=, =, <>, & and AND, XOR, OR (Syntec, MACRO development manual, operators).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include <isogloss/cnc/scan.hpp>

#include "macro/macro_environment.hpp"

namespace syntec {

/// Reads one expression. What has no value is reported, and then nothing more of the expression is evaluated.
class MacroExpression {
 public:
  MacroExpression(ig::Block& b, const MacroEnvironment& environment, const MacroText& text, std::size_t position)
      : block_(b), environment_(environment), text_(text), position_(position) {}

  /// The whole expression.
  std::optional<MacroValue> value() { return binary(0); }
  /// The value of a word: sums and products without brackets, but no comparison.
  std::optional<MacroValue> word() { return binary(weakest_of_words); }
  std::optional<double> number();
  std::optional<bool> truth();
  /// #1, @[#3+7] at the position; nothing, and said, where there is none.
  std::optional<MacroStore::Variable> variable();
  /// The arguments of a function that stands as a statement: ( … ). Nothing, and said, where they have no value.
  std::optional<std::vector<MacroValue>> arguments();

  std::size_t position() const { return position_; }

 private:
  enum class Operator : std::uint8_t {
    none,
    or_,
    xor_,
    and_,
    unequal,
    equal,
    less,
    greater,
    less_or_equal,
    greater_or_equal,
    add,
    subtract,
    multiply,
    divide,
    modulo
  };
  static constexpr int weakest_of_words = 6;
  static constexpr int deepest = 200;

  std::optional<MacroValue> binary(int weakest);
  std::optional<MacroValue> unary();
  std::optional<MacroValue> primary();
  std::optional<MacroValue> literal(bool is_negative);
  std::optional<MacroValue> hexadecimal();
  std::optional<MacroValue> named();
  std::optional<MacroValue> call(std::string_view name, std::size_t begin);
  std::optional<MacroValue> of_argument(std::string_view name, std::size_t begin);
  std::optional<MacroValue> scan_text(const std::vector<MacroValue>& given, std::size_t begin);
  std::optional<MacroValue> mathematical(std::string_view name, const std::vector<MacroValue>& given, std::size_t begin,
                                         bool& is_known);
  std::optional<MacroValue> of_control(std::string_view name, const std::vector<MacroValue>& given, std::size_t begin,
                                       bool& is_known);
  std::optional<MacroValue> standard(const MacroValue& value, double unit, std::size_t begin);
  std::optional<MacroValue> whole_of(double number, std::size_t begin);

  Operator next_operator(std::size_t& behind) const;
  static int strength_of(Operator o);
  std::optional<MacroValue> apply(Operator o, const MacroValue& a, const MacroValue& c, std::size_t begin);
  std::optional<MacroValue> compare(Operator o, const MacroValue& a, const MacroValue& c, std::size_t begin);
  std::optional<MacroValue> calculate(Operator o, const MacroValue& a, const MacroValue& c, std::size_t begin);
  /// The value as a number; VACANT counts as 0, which is said.
  std::optional<double> operand(const MacroValue& value, std::size_t begin);
  std::optional<double> whole_operand(const MacroValue& value, std::string_view what, std::size_t begin);

  std::nullopt_t fail(ig::DiagnosticCode code, std::size_t begin, std::size_t end);
  std::nullopt_t fail_here() { return fail(ig::diag("SYN-0021"), position_, text_.text.size()); }
  /// The bracket from `begin` on: it has no end, or something else stands before its end.
  std::nullopt_t unclosed(std::size_t begin);
  std::string_view piece(std::size_t begin, std::size_t end) const;
  char here() const { return ig::cnc::at(text_.text, position_); }
  void skip() { position_ = ig::cnc::skip_blanks(text_.text, position_); }
  bool accept(char c);

  ig::Block& block_;
  const MacroEnvironment& environment_;
  const MacroText& text_;
  std::size_t position_;
  int depth_ = 0;
};

/// More than any program has; a run of a faulty one must not fill the memory.
inline constexpr std::size_t longest_text = 4096;

/// "#1" inside a text stands for the variable's value (STR2INT, file names). Nothing, and said, where it has none.
std::optional<std::string> with_variables(ig::Block& b, const MacroEnvironment& environment, std::string_view text,
                                          ig::Where where);
/// A number as PRINT and STR2INT write it.
std::string shown(const MacroValue& value);

}  // namespace syntec
