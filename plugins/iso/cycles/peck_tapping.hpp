/// The cuts of peck tapping: how deep each one goes, and how far the tap is retracted after it. Lengths in mm.
#pragma once

#include <isogloss/cnc/canned_cycle.hpp>

namespace iso {

using namespace ig::cnc;

/// The largest number of cuts of one hole.
inline constexpr int most_pecks = 10'000;

struct PeckTapping {
  double r_level = 0;  ///< the level from which depths are measured
  double bottom = 0;
  double step = 0;     ///< of each cut, without sign
  double retract = 0;  ///< after each cut but the last, without sign
  int count = 1;
  bool is_cut_short = false;  ///< more cuts would be needed than are allowed: the last one cuts the rest

  PeckTapping() = default;
  /// One cut.
  PeckTapping(double r, double to) : r_level(r), bottom(to) {}
  /// Cuts of `q`, whose sign has no meaning; 0: one cut. A rest that is only rounding gets no cut of its own.
  PeckTapping(double r, double to, double q, double withdraw, int most)
      : r_level(r), bottom(to), step(std::fabs(q)), retract(withdraw) {
    const double cuts = step > 0 ? strokes().number() : 1;
    is_cut_short = !(cuts <= most);
    count = is_cut_short ? most : static_cast<int>(cuts);
  }

  double depth(int k) const { return strokes().level(k, count); }
  /// The level above cut k by the retract.
  double clearance(int k) const { return strokes().above(depth(k), retract); }

 private:
  PeckStrokes strokes() const { return {r_level, bottom, step}; }
};

}  // namespace iso
