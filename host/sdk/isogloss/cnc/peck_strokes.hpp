/// The levels of the strokes of a peck cycle (Fanuc manual, "Peck drilling cycle (G83)"). Lengths in mm.
#pragma once

#include <algorithm>
#include <cmath>

namespace ig::cnc {

/// The strokes of a peck cycle, from R to the bottom. Each level is computed from R directly, so that rounding errors
/// do not add up over a thousand strokes of 0.1, and the last stroke ends exactly at the bottom.
class PeckStrokes {
 public:
  /// The least length of a last stroke, in mm. A shorter rest comes from rounding of the program's numbers (24 / 8, 0.3
  /// / 0.1): the stroke before it then goes to the bottom.
  static constexpr double least_stroke = 1e-7;

  /// `depth` is the length of one stroke, greater than 0 whether the bottom lies above or below R.
  PeckStrokes(double r_level, double bottom, double depth) : r_level_(r_level), bottom_(bottom), depth_(depth) {}

  /// The first stroke has the length `depth`, each later one is shorter by `less`, but not shorter than `least`.
  /// `depth` and `least` are greater than 0, `less` is 0 or more.
  PeckStrokes(double r_level, double bottom, double depth, double less, double least)
      : r_level_(r_level),
        bottom_(bottom),
        depth_(depth),
        less_(less),
        least_(least),
        shrinking_(less > 0 ? std::max(0.0, std::ceil((depth - least) / less - 1e-9)) : 0) {}

  /// The number of strokes, at least 1 (also where the bottom is at R or nearer than one stroke). The number may exceed
  /// every integer, and it is not a number where R and the bottom are too far apart: compare it before conversion.
  double number() const {
    const double length = std::fabs(bottom_ - r_level_);
    const double way = length - least_stroke - length * 1e-12;
    const double strokes = less_ > 0 ? number_of_shrinking(way) : std::ceil(way / depth_);
    return strokes < 1 ? 1 : strokes;
  }
  /// The level that stroke k = 1, 2, … reaches; `count` is number().
  double level(int k, int count) const {
    if (k >= count) return bottom_;
    return r_level_ - out_of_hole() * (less_ > 0 ? depth_of(k) : depth_ * k);
  }
  /// The level that lies `distance` out of the hole from `level`; above R where the distance is longer than the hole is
  /// deep there.
  double above(double level, double distance) const { return level + out_of_hole() * distance; }

 private:
  double out_of_hole() const { return bottom_ > r_level_ ? -1 : 1; }

  /// The depth below R after k strokes.
  double depth_of(double k) const {
    const double full = std::min(k, shrinking_);
    return full * depth_ - less_ * full * (full - 1) / 2 + (k - full) * least_;
  }
  /// The fewest strokes that reach the depth `way`.
  double number_of_shrinking(double way) const {
    const double after = depth_of(shrinking_);
    if (std::isnan(way)) return way;  // R and the bottom are too far apart
    if (way > after) return shrinking_ + std::ceil((way - after) / least_);
    double low = 0, high = std::min(shrinking_, 1e9);  // a cycle with so many strokes is refused
    if (depth_of(high) < way) return high + 1;
    while (high - low > 1) {
      const double middle = std::floor((low + high) / 2);
      (depth_of(middle) < way ? low : high) = middle;
    }
    return high;
  }

  double r_level_, bottom_, depth_;
  double less_ = 0, least_ = 0;
  double shrinking_ = 0;  ///< number of strokes that are longer than least_
};

}  // namespace ig::cnc
