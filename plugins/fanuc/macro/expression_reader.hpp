/// One expression of custom macro B, read and computed in one pass over the text by recursive descent.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "macro/expression.hpp"
#include "macro/expression_letters.hpp"

namespace fanuc {

using namespace ig::cnc;

namespace detail {

class ExpressionReader {
 public:
  ExpressionReader(std::string_view text, std::size_t position, const ExpressionRules& rules,
                   const VariableSource& variables)
      : text_(text), position_(position), rules_(rules), variables_(variables) {}

  Outcome expression();
  Outcome operand();
  /// #12, #[#3+1]: the number of the variable.
  Outcome reference();

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
  bool accept(std::string_view name);

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
  Relation relation();

  static bool holds(Relation relation, const MacroValue& a, const MacroValue& b);

  bool comparison(MacroValue& out);

  bool sum(MacroValue& out);

  bool product(MacroValue& out);

  /// AND, OR, XOR: of two comparisons, or bit by bit of whole numbers.
  template <class Operation>
  bool bits(MacroValue& out, std::size_t begin, Operation operation, bool (ExpressionReader::*next)(MacroValue&));

  bool signed_operand(MacroValue& out);

  bool primary(MacroValue& out);

  bool number(MacroValue& out);

  bool open() {
    if (++depth_ > rules_.deepest) return fail(Fault::too_deep, position_, position_ + 1);
    if (depth_ > deepest_) deepest_ = depth_;
    ++position_;
    return true;
  }
  bool close(std::size_t opened);

  bool bracket(MacroValue& out);

  /// The digits of #101, as far as they can be a number of a variable. False where something else stands next.
  bool plain_number(std::uint32_t& out);
  static constexpr std::size_t longest_variable = 6;

  bool variable_number(MacroValue& out);

  bool variable(MacroValue& out);

  bool function(MacroValue& out);

  /// PRM[number], PRM[number, bit], and either with /[axis]: the axis counts from 1.
  bool parameter(const MacroValue& number, const MacroValue* bit, MacroValue& out, std::size_t begin);

  /// ATAN[a]/[b]
  bool is_second_bracket_next() const;

  std::string_view text_;
  std::size_t position_;
  const ExpressionRules& rules_;
  const VariableSource& variables_;
  Fault fault_ = Fault::none;
  std::size_t end_ = position_;
  std::size_t fault_begin_ = 0, fault_end_ = 0;
  std::uint32_t unread_ = 0;
  std::uint32_t depth_ = 0, deepest_ = 0;
};

}  // namespace detail
}  // namespace fanuc
