/// Reads the parts of an assignment to a Q parameter and of an FN function.
#pragma once

#include "language/klartext_values.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// Reads one statement, which begins at `begin` and ends with `text`. Whatever is missing is reported, and the caller
/// does not execute the statement. Positions are byte offsets into the text of the block.
struct ParameterReader {
  ig::Block& block;
  const Values& values;
  std::string_view text;
  std::size_t begin;

  /// A Q parameter and the position after its equals sign.
  struct Target {
    QNumber q;
    std::string_view name;
    std::size_t begin, after;
  };

  std::optional<Target> target(std::size_t position) const;
  /// A number or a Q parameter at `position`, which moves past it.
  std::optional<double> value(std::size_t& position) const;
  /// False, with a diagnostic, where the statement has more text.
  bool ends(std::size_t position) const;

  /// Reports that `what` is missing.
  void missing(std::string_view what) const { block.report(ig::diag("HEI-0119"), whole(), what); }
  /// Reports a string parameter: the statement is not executed.
  void refuse_text() const {
    block.report(ig::diag("HEI-0116"), whole(), rest_of_line(text, begin),
                 std::string_view("a number is expected, and a string parameter holds a text"));
  }
  ig::Where whole() const { return ig::Where::columns(begin, std::max(begin + 1, text.size())); }
};

/// True where QS, a string parameter, begins.
constexpr bool is_string_parameter(std::string_view text, std::size_t position) {
  return to_upper(at(text, position)) == 'Q' && to_upper(at(text, position + 1)) == 'S';
}

}  // namespace heidenhain
