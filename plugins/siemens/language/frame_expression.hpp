/// The value of a frame in a program: CTRANS(X,10):CROT(Z,R1), $P_UIFR[2]:CTRANS(X,5), or a FRAME variable.
#pragma once

#include "frames/frame_value.hpp"
#include "language/siemens_expression.hpp"

namespace siemens {

using namespace ig::cnc;

class FrameExpression {
 public:
  FrameExpression(ig::Block& b, const Environment& environment, std::string_view text, std::size_t position)
      : b_(b), environment_(environment), text_(text), at_(position) {}

  /// The frame; nothing where an element has another form, or no frame of our form can express the links. Faults of
  /// numbers in the links are reported, the others are left to the caller.
  std::optional<FrameValue> value();
  std::size_t position() const { return at_; }

  /// True at CTRANS( and the other links.
  static bool begins(std::string_view text, std::size_t position);

 private:
  std::optional<FrameValue> element();
  /// The values in the bracket at the present position.
  std::optional<FrameValue> link(FrameLink kind);
  /// X, or the axis that an AXIS variable names: 0 to 5; npos for other names.
  std::size_t axis();

  ig::Block& b_;
  const Environment& environment_;
  std::string_view text_;
  std::size_t at_;
};

}  // namespace siemens
