/// Cycles 220 and 221: points on a circle or in rows, at which the last defined cycle runs at once. Lengths are in mm
/// in the block, angles in degrees.
#pragma once

#include "cycles/cycle_text.hpp"
#include "cycles/hole_pattern.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// A member of the syntax that executes cycles where they are defined.
class PatternCycle {
 public:
  /// Reads the parameters that `definition` finds in the text, and calls the cycle. Where one is missing, that is
  /// reported at `where`, and nothing is called.
  void define(ig::Block& b, const CycleText& definition, std::string_view text, const CycleNumber& number,
              ig::Where where) const;

 private:
  HolePattern pattern_{ig::write};
  CycleDefinition definition_{ig::write};
  ig::Field<std::int64_t> in_force_{
      "CycleDefinition.Number", ig::read, {ig::Life::modal, "", "The cycle that CYCL CALL runs."}};
  ig::Out<bool> call_{"KlartextCycle.IsCalled",
                      {ig::Life::block, "", "The block calls the cycle: CYCL CALL, M99 or M89."}};
};

}  // namespace heidenhain
