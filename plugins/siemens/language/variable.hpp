/// Values of the language, variables and their elements, and what a call passes. Lengths and angles are numbers as the
/// program writes them.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace siemens {

/// An AXIS is kept as a text, a FRAME as the text of its links: CTRANS(X,10):CROT(Z,30).
enum class Type : std::uint8_t { real, integer, boolean, text, frame };

struct Value {
  double number = 0;
  Type type = Type::real;
  std::string text;

  static Value real(double n) { return {n, Type::real, {}}; }
  static Value integer(double n) { return {n, Type::integer, {}}; }
  static Value truth(bool yes) { return {yes ? 1.0 : 0.0, Type::boolean, {}}; }
  static Value string(std::string t) { return {0, Type::text, std::move(t)}; }
  static Value frame(std::string links) { return {0, Type::frame, std::move(links)}; }
  /// A text or a frame.
  bool is_text() const { return type == Type::text || type == Type::frame; }
};

/// How an assignment has ended.
enum class Stored : std::uint8_t { yes, wrong_type, out_of_range, too_long, outside_array, too_many, unknown };

/// What a definition tells of a variable.
struct Declared {
  enum class Detail : std::uint8_t { none, character, axis };

  Type type = Type::real;
  Detail detail = Detail::none;
  std::uint32_t length = 0;  ///< of a STRING, in characters; 0: not limited
  bool cuts = false;         ///< a text that is too long is cut, and not refused
  double lowest = -std::numeric_limits<double>::infinity(), highest = std::numeric_limits<double>::infinity();

  /// The value of a variable that has got none: 0 or, outside the limits, the nearest of them; an empty text.
  Value initial() const;
  /// Converts the value: INT rounds, BOOL is 0 or 1, CHAR takes one character. Changes `value` only for Stored::yes.
  Stored fit(Value& value) const;
  /// "0 to 5", "from 0" or "up to 5"
  std::string range() const;
};

struct Variable {
  Value value;  ///< for an array: the value of elements that were never set
  bool is_array = false;
  std::vector<std::string> elements{};                 ///< [1] and so on: elements with a variable of their own
  std::vector<std::uint32_t> sizes{};                  ///< of an array, by dimension; empty: not known
  std::pair<std::uint64_t, std::size_t> defined_at{};  ///< offset of its block, column
  Declared declared{};

  /// The number of the element with these indices, "[0,3]", where the last index runs fastest; nothing where they are
  /// out of range. Where the sizes are not known there is one index of any size.
  std::optional<std::size_t> number_of(std::string_view indices) const;
  /// The indices of the element with that number.
  std::string indices_of(std::size_t number) const;
  std::size_t size() const;
  /// "A[2,3]", as in its definition.
  std::string shown_as(std::string_view name) const;
};

/// What a call passes: values, and the names of the caller's variables that VAR parameters change.
struct Argument {
  std::optional<Value> value;
  std::string name;
  std::vector<std::pair<std::string, Value>> elements{};  ///< of an array, where `name` is one
  std::vector<std::uint32_t> sizes{};
};

}  // namespace siemens
