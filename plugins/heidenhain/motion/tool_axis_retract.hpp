/// M140: a retract along the tool axis, by a distance in mm or to the end of the travel.
#pragma once

#include "motion/klartext_way.hpp"

namespace heidenhain {

/// A member of the syntax that makes a path of the words.
class ToolAxisRetract {
 public:
  bool is_programmed(const ig::Block& b) const { return b.has(to_limit_) || b.has(distance_); }

  /// Makes the retract the move of the block; `here_in_program` is the point before it, in the frame in force. False,
  /// with a diagnostic, where the block moves otherwise, or where the end of the travel is not known: the axis of the
  /// travel is Z of the machine.
  bool follow(ig::Block& b, KlartextWay& way, const ig::Vec3& here_in_program) const;

 private:
  ig::In<bool> to_limit_{"KlartextPath.RetractsToLimit",
                         ig::read,
                         {ig::Life::block, "", "M140 MB MAX: along the tool axis to the end of the travel."}};
  ig::Word distance_{"Parsing.MB", ig::take, "mm", "M140 MB: how far along the tool axis."};
  ig::Service<ig_machine_axis_1> machine_{"isogloss.machine-axis/1", ig::Need::optional, "The travel of Z, for M140."};
};

}  // namespace heidenhain
