/// The move of a block, taken to be made in steps: one block never moves twice.
#pragma once

#include "tool_steps.hpp"

namespace iso {

/// A member of each syntax that replaces a move.
class EventToSteps {
 public:
  ToolSteps::Manner take(ig::Block& b) const {
    const ToolSteps::Manner manner{b.get_or(is_rapid_, false), b.get(feedrate_), b.get_or(circles_, std::int64_t{0})};
    b.erase(form_);
    b.erase(is_rapid_);
    b.erase(feedrate_);
    for (std::size_t axis = 0; axis < 3; ++axis) b.host()->erase(b.raw(), center_.id(axis));
    b.erase(is_ccw_);
    b.erase(circles_);
    return manner;
  }

 private:
  ig::Out<ig::Symbol> form_{"MotionEvent.Form"};
  ig::Out<bool> is_rapid_{"MotionEvent.IsRapid"};
  ig::Out<double> feedrate_{"MotionEvent.Feedrate_mmds"};
  ig::Xyz center_{"MotionEvent.ArcCenter", ig::read | ig::write};
  ig::Out<bool> is_ccw_{"MotionEvent.IsCcw"};
  ig::Out<std::int64_t> circles_{"MotionEvent.AdditionalCircleNum"};
};

}  // namespace iso
