/// A frame as a value of the language: what FRAME variables hold and CTRANS(X,10):CROT(Z,30) gives. Lengths are in the
/// unit of the program, angles in degrees.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "frames/settable_shape.hpp"

namespace siemens {

enum class FrameLink : std::uint8_t { shift, fine, rotation, scale, mirror };

/// The link that CTRANS, CFINE, CROT, CSCALE or CMIRROR writes.
std::optional<FrameLink> frame_link(std::string_view name);
/// The link whose component TR, FI, RT, SC or MI is.
std::optional<FrameLink> frame_component_link(std::string_view component);

struct FrameValue {
  std::array<double, 6> shift{};  ///< coarse, of X Y Z A B C
  SettableShape shape;

  /// Sets a value of an axis (0 to 5: X Y Z A B C); false where the axis has no such value, or the value is out of its
  /// range. A rotary axis has one shift: CFINE adds to it.
  bool set(FrameLink link, std::size_t axis, double value);
  /// Of an axis, as set() sets it.
  double get(FrameLink link, std::size_t axis) const;
  /// CTRANS(X,10):CROT(Z,30), without what changes nothing.
  std::string text() const;
  /// Reads such links with numbers only; nothing for another form.
  static std::optional<FrameValue> read(std::string_view links);
  /// The frame of a matrix, with the shifts of A B C; nothing where its axes are not square to each other.
  static std::optional<FrameValue> of(const ig::cnc::Mat4& m, const std::array<double, 3>& rotary);
  bool is_within_range() const;
};

/// The frame of FIRST:SECOND; nothing where no frame of this form can express it: SECOND is rotated, and FIRST has
/// different scales or a mirror.
std::optional<FrameValue> chained(const FrameValue& first, const FrameValue& second);

}  // namespace siemens
