/// The levels of a peck cycle.
#pragma once

#include <algorithm>
#include <cmath>

namespace ig::cnc {

/// The strokes of a peck cycle, from R to the bottom. Each level is computed from R by itself, so that a thousand
/// strokes of 0.1 add up to no rounding error, and the last one ends at the bottom exactly.
class PeckStrokes {
 public:
  /// What a last stroke must at least be, in mm: below that it is rounding of the program's numbers (24 / 8, 0.3 /
  /// 0.1), and the stroke before it goes to the bottom.
  static constexpr double least_stroke = 1e-7;

  /// `depth` is the way of one stroke, greater than 0, whichever direction the bottom lies in.
  PeckStrokes(double r_level, double bottom, double depth) : r_level_(r_level), bottom_(bottom), depth_(depth) {}

  /// The first stroke is `depth`, each later one `less` shorter, down to `least`: all of them greater than 0, but for
  /// `less`, which may be 0.
  PeckStrokes(double r_level, double bottom, double depth, double less, double least)
      : r_level_(r_level),
        bottom_(bottom),
        depth_(depth),
        less_(less),
        least_(least),
        shrinking_(less > 0 ? std::max(0.0, std::ceil((depth - least) / less - 1e-9)) : 0) {}

  /// At least 1, also where the bottom is R or nearer than one stroke. It may be larger than any integer, and is no
  /// number at all where R and the bottom are too far apart for one.
  double number() const {
    const double length = std::fabs(bottom_ - r_level_);
    const double way = length - least_stroke - length * 1e-12;
    const double strokes = less_ > 0 ? number_of_shrinking(way) : std::ceil(way / depth_);
    return strokes < 1 ? 1 : strokes;
  }
  /// The level that stroke k = 1, 2, … of `count` = number() reaches.
  double level(int k, int count) const {
    if (k >= count) return bottom_;
    return r_level_ - out_of_hole() * (less_ > 0 ? depth_of(k) : depth_ * k);
  }
  /// `distance` from a level back towards R, and beyond it when the distance is longer than the hole.
  double above(double level, double distance) const { return level + out_of_hole() * distance; }

 private:
  double out_of_hole() const { return bottom_ > r_level_ ? -1 : 1; }

  /// Below R, after k strokes.
  double depth_of(double k) const {
    const double full = std::min(k, shrinking_);
    return full * depth_ - less_ * full * (full - 1) / 2 + (k - full) * least_;
  }
  /// The fewest strokes that reach so far.
  double number_of_shrinking(double way) const {
    const double after = depth_of(shrinking_);
    if (std::isnan(way)) return way;  // R and the bottom are too far apart
    if (way > after) return shrinking_ + std::ceil((way - after) / least_);
    double low = 0, high = std::min(shrinking_, 1e9);  // no cycle may take so many
    if (depth_of(high) < way) return high + 1;
    while (high - low > 1) {
      const double middle = std::floor((low + high) / 2);
      (depth_of(middle) < way ? low : high) = middle;
    }
    return high;
  }

  double r_level_, bottom_, depth_;
  double less_ = 0, least_ = 0;
  double shrinking_ = 0;  ///< strokes that are longer than the least
};

}  // namespace ig::cnc
