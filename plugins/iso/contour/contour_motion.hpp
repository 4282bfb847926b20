/// The motion of an executed block in the plane, as a move of the contour for cutter radius compensation.
#pragma once

#include <isogloss/cnc/contour_move.hpp>
#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/program_xyz.hpp>

namespace iso {

using namespace ig::cnc;

struct ContourMotion {
  enum class Kind {
    rest,     ///< no move in the plane
    move,     ///< a straight line or an arc
    by_steps  ///< a cycle, a reference return, G53: the positions do not belong to a contour
  };
  Kind kind = Kind::rest;
  PlaneAxes plane;
  ig::Vec3 from, to;  ///< as programmed
  bool has_event = false;
  bool turns = false;  ///< the tip is led along its path while rotary axes turn
  ContourMove move{};
};

/// A member of each syntax that needs the motion of a block.
class ContourMotionOf {
 public:
  ContourMotion operator()(ig::Block& b) const {
    ContourMotion out;
    out.plane = plane_(b);
    out.from = last_(b);
    out.to = b.get(program_).or_else(out.from);
    out.has_event = b.has(form_);
    out.turns = out.has_event && b.is(form_, led_);
    out.move.start = in_plane(out.plane, out.from);
    out.move.end = in_plane(out.plane, out.to);
    if (b.has(compound_) || out.turns || (b.find(machine_select_) && out.has_event)) {
      out.kind = ContourMotion::Kind::by_steps;
    } else if (out.has_event) {
      read_arc(b, out);
      if (out.move.is_arc || !is_same(out.move.start, out.move.end)) out.kind = ContourMotion::Kind::move;
    }
    return out;
  }

  static Point2 in_plane(const PlaneAxes& plane, const ig::Vec3& p) { return {p[plane.first], p[plane.second]}; }

 private:
  /// An arc with radius 0 at one of its ends is not an arc here.
  void read_arc(const ig::Block& b, ContourMotion& out) const {
    if (!b.is(form_, arc_)) return;
    out.move.center = in_plane(out.plane, b.get(center_).or_else(out.from));
    out.move.is_ccw = b.get_or(is_ccw_, false);
    out.move.slack_mm = slack_mm_;
    out.move.is_arc = !is_same(out.move.center, out.move.start) && !is_same(out.move.center, out.move.end);
  }

  ig::Xyz program_{"ProgramXyz", ig::read};
  ig::In<ig::Symbol> compound_{"CompoundMotion.Term"};
  ig::In<ig::Symbol> form_{"MotionEvent.Form"};
  ig::Xyz center_{"MotionEvent.ArcCenter", ig::read};
  ig::In<bool> is_ccw_{"MotionEvent.IsCcw"};
  ig::Codes machine_select_{{"G53"}, ig::read};
  ig::Name arc_{"McArc"}, led_{"ClLinear"};
  PlaneInForce plane_;
  LastProgramXyz last_;
  ig::Config config_{"isogloss.motion/1", ig::Need::optional, "ArcRadiusTolerance_mm"};
  double slack_mm_ = std::fmax(same_point_mm, config_.number("ArcRadiusTolerance_mm").value_or(0));
};

}  // namespace iso
