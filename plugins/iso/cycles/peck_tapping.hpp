/// The cuts of peck tapping: how deep each goes, and where the tap is withdrawn to after it.
#pragma once

#include <isogloss/cnc/canned_cycle.hpp>

namespace iso {

using namespace ig::cnc;

/// No hole has more cuts.
inline constexpr int most_pecks = 10'000;

struct PeckTapping {
  double r_level = 0;  ///< from where the depths count
  double bottom = 0;
  double step = 0;     ///< of each cut, without sign
  double retract = 0;  ///< after each cut but the last, without sign
  int count = 1;
  bool is_cut_short = false;  ///< more cuts would be needed than are allowed: the last one does the rest

  PeckTapping() = default;
  /// One cut.
  PeckTapping(double r, double to) : r_level(r), bottom(to) {}
  /// Cuts of `q`, of which the sign says nothing; 0: one cut. A rest that is only rounding is none.
  PeckTapping(double r, double to, double q, double withdraw, int most)
      : r_level(r), bottom(to), step(std::fabs(q)), retract(withdraw) {
    const double cuts = step > 0 ? strokes().number() : 1;
    is_cut_short = !(cuts <= most);
    count = is_cut_short ? most : static_cast<int>(cuts);
  }

  double depth(int k) const { return strokes().level(k, count); }
  /// Above it by the retract.
  double clearance(int k) const { return strokes().above(depth(k), retract); }

 private:
  PeckStrokes strokes() const { return {r_level, bottom, step}; }
};

}  // namespace iso
