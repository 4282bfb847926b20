/// Functions with their arguments: SIN[30], ATAN[1]/[2], POW[2,3], PRM[1234,0]/[1].
#include "macro/expression_functions.hpp"
#include "macro/expression_reader.hpp"

namespace fanuc {

using namespace ig::cnc;

namespace detail {

bool ExpressionReader::function(MacroValue& out) {
  const std::size_t begin = position_;
  std::size_t name_end = begin;
  while (name_end < text_.size() && is_name(text_[name_end])) ++name_end;
  const MacroFunction which = macro_function(text_.substr(begin, name_end - begin));
  if (which == MacroFunction::none) return fail(Fault::unknown_function, begin, name_end);
  position_ = name_end;
  skip_spaces();
  const std::size_t opened = position_;
  if (peek() != '[') return fail(Fault::no_operand, opened, opened + 1);
  MacroValue first, second;
  if (!open() || !comparison(first) || !as_number(first, opened)) return false;
  skip_spaces();
  bool has_second = false;
  if (peek() == ',' && (which == MacroFunction::atan || which == MacroFunction::pow || which == MacroFunction::prm)) {
    ++position_;
    has_second = true;
    const std::size_t second_begin = position_;
    if (!comparison(second) || !as_number(second, second_begin)) return false;
  }
  if (!close(opened)) return false;
  if (which == MacroFunction::pow && !has_second) return fail(Fault::no_operand, end_ - 1, end_);
  if (which == MacroFunction::prm) return parameter(first, has_second ? &second : nullptr, out, begin);
  if (which == MacroFunction::atan && !has_second && is_second_bracket_next()) {
    skip_spaces();
    ++position_;
    skip_spaces();
    const std::size_t second_begin = position_;
    if (!bracket(second) || !as_number(second, second_begin)) return false;
    has_second = true;
  }
  double value = 0;
  const Fault fault = has_second && which == MacroFunction::atan
                          ? arc_tangent(first.number, second.number, rules_, value)
                          : function_value(which, first.number, second.number, rules_, value);
  return fault == Fault::none ? finish(value, out, begin) : fail(fault, begin, end_);
}

bool ExpressionReader::parameter(const MacroValue& number, const MacroValue* bit, MacroValue& out, std::size_t begin) {
  MacroValue axis;
  const bool has_axis = is_second_bracket_next();
  if (has_axis) {
    skip_spaces();
    ++position_;
    skip_spaces();
    const std::size_t axis_begin = position_;
    if (!bracket(axis) || !as_number(axis, axis_begin)) return false;
  }
  const auto whole = [](double x, double least, double most) { return x >= least && x <= most && x == std::floor(x); };
  if (!whole(number.number, 1, 99'999) || (bit != nullptr && !whole(bit->number, 0, 7)) ||
      (has_axis && !whole(axis.number, 1, 32)))
    return fail(Fault::out_of_domain, begin, end_);
  const Fault fault = variables_.parameter(static_cast<std::uint32_t>(number.number),
                                           has_axis ? static_cast<std::uint32_t>(axis.number) : 0, out);
  if (fault != Fault::none) return fail(fault, begin, end_);
  if (bit != nullptr)
    out.number = (static_cast<std::uint32_t>(out.number) >> static_cast<std::uint32_t>(bit->number)) & 1U;
  return true;
}

bool ExpressionReader::is_second_bracket_next() const {
  std::size_t i = position_;
  while (i < text_.size() && is_space(text_[i])) ++i;
  if (i >= text_.size() || text_[i] != '/') return false;
  for (++i; i < text_.size() && is_space(text_[i]);) ++i;
  return i < text_.size() && text_[i] == '[';
}

}  // namespace detail
}  // namespace fanuc
