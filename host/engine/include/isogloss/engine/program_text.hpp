/// How a control writes what the host wants to have written: templates that a dialect gives as data.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace isogloss {

class Chain;

/// A block with places for values: "RAPID[ X{X}]". {NAME} or {NAME:format} stands for a value; what stands in brackets
/// is left out when a value in it is missing.
class BlockTemplate {
 public:
  explicit BlockTemplate(std::string_view text);
  /// Appends the value of this name to `out`; false: there is none.
  using Values = std::function<bool(std::string_view name, std::string_view format, std::string& out)>;
  /// False when a value outside brackets is missing: `out` is then as before.
  bool fill(const Values& values, std::string& out) const;

 private:
  struct Piece {
    enum class Kind : unsigned char { text, value, open, close } kind;
    std::string text;
    std::string format{};
  };
  std::vector<Piece> pieces_;
};

/// The rows of the dependency that answers for "isogloss.program-text/1", in their order.
struct ProgramText {
  struct Row {
    std::string name;
    std::string when;  ///< conditions on fields, separated by blanks; empty: always
    BlockTemplate block;
  };
  std::vector<Row> rows;

  static ProgramText of(Chain& chain);
  /// The row of this name; null: the control has no block for it.
  const Row* find(std::string_view name) const;
};

/// A number for a block: never an exponent, "-0" or a value without a decimal point, unless `is_plain`. At most 6
/// decimals, or the shortest text that reads back to the same double.
std::string block_number(double value, bool exact, bool is_plain = false);

}  // namespace isogloss
