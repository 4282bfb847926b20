/// The transformation from program to machine coordinates, entry by entry.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>

namespace isogloss {

/// One entry of the transformation from program to machine coordinates. Row vectors, translation in elements 12..14.
struct Frame {
  enum class Kind : std::uint8_t { identity, translation, general };
  Kind kind = Kind::identity;
  double matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  bool is_moving = false;  ///< in the block that set it last

  /// Row vectors: 16 numbers, row by row.
  void assign(const double* m);
  bool is_same(const double* m) const { return std::equal(std::begin(matrix), std::end(matrix), m); }
  static Frame from(const double* m) {
    Frame frame;
    frame.assign(m);
    return frame;
  }
  void map(const double (&in)[3], double (&out)[3]) const {
    if (kind == Kind::general) {
      for (int i = 0; i < 3; ++i)
        out[i] = in[0] * matrix[i] + in[1] * matrix[4 + i] + in[2] * matrix[8 + i] + matrix[12 + i];
    } else {
      for (int i = 0; i < 3; ++i) out[i] = in[i] + matrix[12 + i];
    }
  }
  /// This entry, and then the next one.
  void append(const Frame& next);
  friend Frame operator*(const Frame& first, const Frame& then);
  std::optional<Frame> inverse() const;
};

}  // namespace isogloss
