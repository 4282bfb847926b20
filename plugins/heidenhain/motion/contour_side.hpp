/// RL, RR and R0 of a path block: the side of the contour, with the radius of the tool in the spindle.
#pragma once

#include "language/block_words.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// A member of the syntax that reads path blocks. Positions are byte offsets into the text of the block.
class ContourSide {
 public:
  /// True where RL or RR stands at `position`.
  static bool begins(std::string_view text, std::size_t position);
  /// True where R0 stands at `position`, and not the radius R0.5.
  static bool ends(std::string_view text, std::size_t position);
  /// Reads R0, RL, RR, or R alone, a prompt that was not answered; `is_beside` becomes true for RL and RR. Returns the
  /// position after the word, `position` where it is none of them. R+ and R- are reported.
  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position, bool& is_beside) const;

  /// TOOL CALL between `begin` and `end` puts another tool, of which this is the row, under RL or RR: its radius counts
  /// from here on, which is reported. So is another DR for the same tool.
  void change_tool(ig::Block& b, std::int64_t row, bool is_other_delta, std::size_t begin, std::size_t end) const;

  bool is_in_force(const ig::Block& b) const { return b.is(term_, g41_) || b.is(term_, g42_); }

  void end(ig::Block& b, std::size_t begin, std::size_t end) const {
    if (is_in_force(b)) put_code(b, codes_.id(0), begin, end);
  }

 private:
  enum Side : std::size_t { left = 1, right = 2 };  // the order of codes_

  /// Changes nothing where the side and the tool are in force already.
  void set(ig::Block& b, Side side, std::size_t begin, std::size_t end) const;

  ig::Codes codes_{{"G40", "G41", "G42"}, ig::write};
  ig::Field<double> offset_word_{"Parsing.D", ig::write, {ig::Life::word, "", ""}};
  ig::In<ig::Symbol> term_{"RadiusCompensation.Term"};
  ig::In<std::int64_t> offset_in_force_{"RadiusCompensation.OffsetId"};
  ig::In<std::int64_t> tool_{"ToolHeightCompensation.OffsetId"};
  ig::Name g41_{"G41"}, g42_{"G42"};
};

}  // namespace heidenhain
