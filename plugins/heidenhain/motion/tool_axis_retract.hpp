/// M140: a retract along the tool axis, by a distance in mm or to the end of the travel.
#pragma once

#include <isogloss/cnc/rotary_words.hpp>
#include <isogloss/cnc/tool_direction.hpp>
#include <isogloss/cnc/travel_end.hpp>

#include "frames/scaling.hpp"
#include "motion/klartext_way.hpp"

namespace heidenhain {

/// A member of the syntax that makes a path of the words.
class ToolAxisRetract {
 public:
  ig_field to_limit() const { return to_limit_.id(); }
  ig_field distance() const { return distance_.id(); }
  bool is_programmed(const ig::Block& b) const { return b.has(to_limit_) || b.has(distance_); }

  /// Makes the retract the move of the block; `here_in_program` is the point before it, in the frame in force. False,
  /// with a diagnostic, where the block moves otherwise, or where the end of the travel is not known. In a tilted plane
  /// the first axis that reaches its end stops the retract.
  bool follow(ig::Block& b, KlartextWay& way, const ig::Vec3& here_in_program) const;

 private:
  ig::In<bool> to_limit_{"KlartextPath.RetractsToLimit",
                         ig::read,
                         {ig::Life::block, "", "M140 MB MAX: along the tool axis to the end of the travel."}};
  ig::Word distance_{"Parsing.MB", ig::take, "mm", "M140 MB: how far along the tool axis."};
  /// The way of 1 mm of the machine along the tool, in coordinates of the program: under M128 the rotary axes have
  /// turned it.
  std::optional<ig::Vec3> unit_way(ig::Block& b, const KlartextWay& way, const ig::Vec3& here_in_program) const;

  TravelEnd travel_;
  ToolCenterMode tip_control_;
  ToolKinematics kinematics_;
  RotaryPosition rotary_{ig::read};
  ScalingInForce scaling_;
};

}  // namespace heidenhain
