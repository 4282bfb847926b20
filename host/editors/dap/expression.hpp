/// The language of conditions: "Z < -10", "spindle off", "feed > 500 and tool == 3", "#101 * 2", "depth > 0".
///
///   expression  or-chain of comparisons: or and not == != < <= > >= + - * / ( ); also ||, &&, !, =, <>
///   names       X Y Z: program coordinates, mm; machine.X … machine.C, and A B C: machine coordinates, mm and degrees;
///               feed: mm/min; speed: 1/min; tool; spindle: CW, CCW or STOP; coolant; motion: rapid, feed, arc, …;
///               line, file, program, depth, pass, block: where the run is
///   fields      any field of the block document by its path, "Feedrate.Unit" ("isogloss state" lists them)
///   variables   #101, #<name>, R5, Q2, QS1, V12; any other one as var("DEPTH")
///   states      "spindle on", "spindle off", "coolant off": a name and a word
///   functions   abs(x), min(a, b), max(a, b), has(x): it has a value
///
/// A name without a value gives no value, and so does what is counted from it; a comparison with it is false. Texts
/// are compared without their case.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "dap/strokes.hpp"

namespace isogloss::dap {

struct Value {
  enum class Kind : std::uint8_t { none, truth, number, text };
  Kind kind = Kind::none;
  double number = 0;  ///< of a truth: 1 or 0
  std::string text{};

  static Value of(double number) { return {Kind::number, number, {}}; }
  static Value truth(bool value) { return {Kind::truth, value ? 1.0 : 0.0, {}}; }
  static Value of(std::string text) { return {Kind::text, 0, std::move(text)}; }
  bool is_true() const { return kind == Kind::text ? !text.empty() : number != 0; }
};
/// As a user reads it: "true", "12.5", "CW"; of no value "no value".
std::string shown(const Value& value);

/// What an expression looks at.
struct Scene {
  const Document* document = nullptr;
  const SymbolTable* symbols = nullptr;
  const Stroke* stroke = nullptr;  ///< its end stands for the position; null: the end of the block
  std::string_view file, program;
  std::uint32_t line = 0, depth = 0, pass = 1;
  std::uint64_t block = 0;
};

/// The variables of the program.
class VariableSource {
 public:
  virtual Value value_of(std::string_view name) const = 0;

 protected:
  ~VariableSource() = default;
};

class Expression {
 public:
  /// Or a sentence that says what is wrong. The layout outlives the expression.
  static std::variant<Expression, std::string> parse(std::string_view text, const Layout& layout);
  Value evaluate(const Scene& scene, const VariableSource& variables) const;
  const std::string& text() const { return text_; }

  /// One operation; its operands are places in the list.
  struct Node {
    enum class Op : std::uint8_t {
      constant,
      name,
      field,
      variable,
      either,
      both,
      negated,
      equal,
      unequal,
      less,
      not_greater,
      greater,
      not_less,
      sum,
      difference,
      product,
      quotient,
      minus,
      absolute,
      smaller,
      larger,
      has,
      is_on,
      is_off
    };
    Op op = Op::constant;
    std::uint32_t first = 0, second = 0;
    Value value{};
    ig_field field = IG_NO_FIELD;
    std::string name{};
  };

 private:
  Value at(std::uint32_t index, const Scene& scene, const VariableSource& variables) const;
  std::vector<Node> nodes_;
  std::string text_;
};

}  // namespace isogloss::dap
