/// Expressions of custom macro B: read and computed in one pass over the text. Knows no block; variables come from
/// the caller. Recursion is bounded by the nesting of brackets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include <isogloss/cnc/units.hpp>

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

/// What an expression reads; the caller's.
class VariableSource {
 public:
  /// A variable and Fault::none, or why there is none.
  virtual Fault read(std::uint32_t number, MacroValue& out) const = 0;
  /// A parameter of the control. Axis 0: one that is for the whole control.
  virtual Fault parameter(std::uint32_t, std::uint32_t, MacroValue&) const { return Fault::not_known_here; }

 protected:
  ~VariableSource() = default;
};

/// The expression that begins at `position`; it ends before the first character that cannot continue it.
Outcome evaluate(std::string_view text, std::size_t position, const ExpressionRules& rules,
                 const VariableSource& variables);

/// One operand without a sign: #1, [#1+2], SIN[30], 12.5.
Outcome evaluate_operand(std::string_view text, std::size_t position, const ExpressionRules& rules,
                         const VariableSource& variables);

/// The number of the variable that is named at `position`.
Outcome evaluate_reference(std::string_view text, std::size_t position, const ExpressionRules& rules,
                           const VariableSource& variables);

}  // namespace fanuc
