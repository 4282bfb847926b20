#include "isogloss/engine/frame.hpp"

#include <cmath>
#include <cstring>

namespace isogloss {

void Frame::assign(const double* m) {
  std::memcpy(matrix, m, sizeof matrix);
  const bool rotates = m[0] != 1 || m[1] != 0 || m[2] != 0 || m[3] != 0 || m[4] != 0 || m[5] != 1 || m[6] != 0 ||
                       m[7] != 0 || m[8] != 0 || m[9] != 0 || m[10] != 1 || m[11] != 0 || m[15] != 1;
  kind = rotates ? Kind::general : (m[12] == 0 && m[13] == 0 && m[14] == 0) ? Kind::identity : Kind::translation;
  is_moving = false;
}

void Frame::append(const Frame& next) {
  if (next.kind == Kind::identity) return;
  if (kind == Kind::identity) {
    *this = next;
  } else if (kind == Kind::translation && next.kind == Kind::general) {
    const double way[3] = {matrix[12], matrix[13], matrix[14]};
    std::memcpy(matrix, next.matrix, 12 * sizeof(double));
    for (int column = 0; column < 4; ++column)
      matrix[12 + column] = way[0] * matrix[column] + way[1] * matrix[4 + column] + way[2] * matrix[8 + column] +
                            next.matrix[12 + column];
    kind = Kind::general;
  } else if (kind == Kind::translation) {
    for (int column = 12; column < 15; ++column) matrix[column] += next.matrix[column];
  } else if (next.kind == Kind::translation) {
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 3; ++column)
        matrix[row * 4 + column] += matrix[row * 4 + 3] * next.matrix[12 + column];
  } else {
    *this = *this * next;
  }
}

Frame operator*(const Frame& first, const Frame& then) {
  if (first.kind != Frame::Kind::general || then.kind != Frame::Kind::general) {
    Frame out = first;
    out.append(then);
    return out;
  }
  Frame out;
  out.kind = Frame::Kind::general;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) {
      double sum = 0;
      for (int k = 0; k < 4; ++k) sum += first.matrix[row * 4 + k] * then.matrix[k * 4 + column];
      out.matrix[row * 4 + column] = sum;
    }
  return out;
}

std::optional<Frame> Frame::inverse() const {
  Frame out = *this;
  if (kind != Kind::general) {
    for (int i = 12; i < 15; ++i) out.matrix[i] = -matrix[i];
    return out;
  }
  const double* m = matrix;
  const double c00 = m[5] * m[10] - m[6] * m[9];
  const double c01 = m[6] * m[8] - m[4] * m[10];
  const double c02 = m[4] * m[9] - m[5] * m[8];
  const double determinant = m[0] * c00 + m[1] * c01 + m[2] * c02;
  if (!(std::abs(determinant) > 1e-12)) return std::nullopt;
  const double d = 1 / determinant;
  double* o = out.matrix;
  o[0] = c00 * d;
  o[1] = (m[2] * m[9] - m[1] * m[10]) * d;
  o[2] = (m[1] * m[6] - m[2] * m[5]) * d;
  o[4] = c01 * d;
  o[5] = (m[0] * m[10] - m[2] * m[8]) * d;
  o[6] = (m[2] * m[4] - m[0] * m[6]) * d;
  o[8] = c02 * d;
  o[9] = (m[1] * m[8] - m[0] * m[9]) * d;
  o[10] = (m[0] * m[5] - m[1] * m[4]) * d;
  for (int i = 0; i < 3; ++i) o[12 + i] = -(m[12] * o[i] + m[13] * o[4 + i] + m[14] * o[8 + i]);
  return out;
}

}  // namespace isogloss
