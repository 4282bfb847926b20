/// The steps of a block that moves by several: a canned cycle, a return to the reference point, a compensated corner.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "explain/facts.hpp"

namespace isogloss::cli {

struct Stroke {
  std::string does;  ///< "rapid", "feed", "arc", "dwell 0.5 s", "spindle CW"
  std::optional<std::array<double, 3>> program, machine;
  std::optional<double> feed_mm_min;
  std::string to;      ///< the axes that move, "X60 Y30", with the rotary axes that turn: "B30 C90"
  bool turns = false;  ///< rotary axes turn
  std::string reason;  ///< "Z is CannedCycle.Params.R (line 6)"; empty: nothing of the cycle has this value
};

std::vector<Stroke> strokes_of(const Facts& facts);

}  // namespace isogloss::cli
