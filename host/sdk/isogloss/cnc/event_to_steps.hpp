/// Takes the single move of a block away so that a syntax can write it as steps: one block never holds both.
#pragma once

#include "isogloss/cnc/tool_steps.hpp"

namespace ig::cnc {

/// A member of each syntax that replaces a move.
class EventToSteps {
 public:
  /// Erases the section MotionEvent and returns what the steps have to keep of it: rapid or feed (mm/s), additional
  /// circles.
  ToolSteps::Manner take(Block& b) const {
    const ToolSteps::Manner manner{b.get_or(is_rapid_, false), b.get(feedrate_), b.get_or(circles_, std::int64_t{0})};
    b.erase(form_);
    b.erase(is_rapid_);
    b.erase(feedrate_);
    for (std::size_t axis = 0; axis < 3; ++axis) b.erase(center_.id(axis));
    b.erase(is_ccw_);
    b.erase(circles_);
    return manner;
  }

 private:
  Out<Symbol> form_{"MotionEvent.Form"};
  Out<bool> is_rapid_{"MotionEvent.IsRapid"};
  Out<double> feedrate_{"MotionEvent.Feedrate_mmds"};
  Xyz center_{"MotionEvent.ArcCenter", read | write};
  Out<bool> is_ccw_{"MotionEvent.IsCcw"};
  Out<std::int64_t> circles_{"MotionEvent.AdditionalCircleNum"};
};

}  // namespace ig::cnc
