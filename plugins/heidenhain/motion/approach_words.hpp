/// APPR and DEP: the shape of the way to a contour or away from it. Lengths are in the unit of the program as written,
/// and in mm in the block; angles in degrees.
#pragma once

#include <isogloss/cnc/contour_approach.hpp>

#include "language/klartext_values.hpp"
#include "language/program_unit.hpp"
#include "motion/contour_side.hpp"
#include "motion/klartext_departure.hpp"
#include "motion/path_function.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// The words of one block.
struct ApproachShape {
  std::optional<ContourApproach::Shape> shape{};
  std::optional<double> length{}, radius{}, angle{};
  bool is_beside = false;  ///< the block holds RL or RR
  bool is_at_named_point() const { return shape == ContourApproach::Shape::line_and_arc; }
  bool is_complete() const;
};

/// A member of the syntax that reads path blocks.
class ApproachWords {
 public:
  /// Reads LT, LN, CT, LCT, in polar coordinates PLT and so on, and LEN, CCA and R with a value; returns the position
  /// after the word, `position` where none of them is there. A word without a value, one that the shape does not use
  /// and one that stands twice are reported.
  std::size_t scan(ig::Block& b, const Values& values, std::string_view text, std::size_t position,
                   PathFunction function, ApproachShape& found) const;

  /// Sets the way of APPR to the contour, or that of DEP away from it. Where there is none, because a word or the side
  /// of the contour is missing, the tool goes straight to its point, which is reported at `where`.
  void set(ig::Block& b, const ContourSide& side, PathFunction function, const ApproachShape& found,
           ig::Where where) const;

 private:
  /// False where the block has no way: a side is in force already, or the block has neither RL nor RR.
  bool approach(ig::Block& b, const ContourSide& side, const ApproachShape& found) const;
  bool depart(ig::Block& b, const ContourSide& side, const ApproachShape& found) const;
  ContourApproach::Way way_of(const ig::Block& b, const ApproachShape& found) const;

  ContourApproach approach_{ig::write};
  KlartextDeparture departure_{ig::write};
  ig::In<ig::Symbol> motion_in_force_{"MotionState.Term"};
  ig::In<ig::Symbol> feed_term_{"Feedrate.Term"};
  ig::In<double> feed_in_force_{"Feedrate.FeedrateValue"};
  ig::Name g00_{"G00"}, g94_{"G94"};
  ProgramUnit unit_;
};

}  // namespace heidenhain
