/// Texts in string parameters: QS10 = QS1 || "_" || TOCHAR( DAT+Q5 DECIMALS2 ), and the functions that make a number of
/// a text. Positions are byte offsets into the text of the block.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "language/klartext_values.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// Reads from `position` on, which moves. What is wrong is reported, and there is no result.
class StringFormula {
 public:
  StringFormula(ig::Block& b, const Values& values, std::string_view text, std::size_t position)
      : b_(b), values_(values), text_(text), position_(position) {}

  /// Texts joined by ||.
  std::optional<std::string> text();
  /// TONUMB, STRLEN, INSTR or STRCOMP with its brackets.
  std::optional<double> number();
  static bool is_number_function(std::string_view text, std::size_t position);

  std::size_t position() const { return position_; }

 private:
  std::optional<std::string> operand();
  std::optional<std::string> quoted();
  std::optional<std::string> to_char();
  std::optional<std::string> substring();
  std::optional<std::string> of_system(std::size_t begin);

  /// Moves behind the word; false, and reported, where it is not there.
  bool expects(std::string_view word, std::string_view shown);
  /// SRC_QS1, SEA_QS2
  std::optional<std::string> parameter(std::string_view word);
  /// BEG2, LEN4, DECIMALS3; `otherwise` where the word is not there.
  std::optional<double> value(std::string_view word, std::optional<double> otherwise);
  std::optional<double> result_of(std::size_t function);
  std::nullopt_t missing(std::string_view what);
  bool skips(std::string_view word);

  ig::Block& b_;
  const Values& values_;
  std::string_view text_;
  std::size_t position_;
};

}  // namespace heidenhain
