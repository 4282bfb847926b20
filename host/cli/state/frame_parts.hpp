/// A frame taken apart into what programs write: a shift, three rotations, scales and mirrored axes.
#pragma once

#include <array>
#include <optional>

namespace isogloss::cli {

struct FrameParts {
  std::array<double, 3> shift{};     ///< mm
  std::array<double, 3> turn_deg{};  ///< about Z, then the turned Y, then the turned X; in the order X Y Z
  std::array<double, 3> scale{1, 1, 1};
  std::array<bool, 3> is_mirrored{};  ///< one axis at most: two mirrored axes are a rotation

  /// Of a matrix with row vectors; scales and the mirror act first, then the rotations, then the shift. Nothing where
  /// the axes of the frame are not square to each other.
  static std::optional<FrameParts> of(const std::array<double, 16>& matrix);
};

}  // namespace isogloss::cli
