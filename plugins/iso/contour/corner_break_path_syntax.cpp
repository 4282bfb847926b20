/// Chamfers and roundings between two moves: the first move ends before the corner, a straight line or an arc leads to
/// the second move, which begins after the corner. The next move must be known, so the syntax looks ahead. Under cutter
/// radius compensation RadiusCompensationPathSyntax does the same. Fanuc manual, "Optional chamfering and corner
/// rounding".
#include <isogloss/cnc/event_to_steps.hpp>

#include "contour/broken_contour.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct CornerBreakPath {
  static constexpr auto spec = ig::syntax("CornerBreakPathSyntax", "The path round a corner with ,C or ,R.")
                                   .after("CornerBreakSizeSyntax", "RadiusCompensationPathSyntax", "McXyzSyntax",
                                          "McAbcSyntax", "CircularMotionSyntax", "LinearMotionSyntax")
                                   .before("TravelCheckSyntax")
                                   .looks_ahead(ContourAhead::window);

  ig::Signal path_{"CornerBreak.~Path", ig::read | ig::wake};
  ig::In<ig::Symbol> compensated_{"RadiusCompensation.Phase", ig::read, {ig::Life::block, "", ""}};
  ig::Xyz machine_{"MachineCoordinate", ig::read | ig::write};
  ig::Out<ig::Symbol> compound_{"CompoundMotion.Term"};
  ig::In<ig::Symbol> motion_code_{"MotionState.Term"};
  RotaryPosition rotary_{ig::read};
  ContourMotionOf motion_;
  BrokenContour contour_;
  EventToSteps event_;
  ToolSteps steps_;

  std::optional<ig::Vec3> tool_;  ///< after the corner, until the next move

  ig::Status restart(ig::Block&) {
    contour_.forget();
    tool_.reset();
    return ig::Status::unchanged;
  }

  ig::Status build(ig::Block& b) {
    if (b.has(compensated_)) {
      contour_.forget();
      tool_.reset();
      return ig::Status::unchanged;
    }
    const ContourMotion now = motion_(b);
    const BrokenContour::Piece piece = contour_.take(b, now);
    contour_.report(b, piece);
    if (now.kind == ContourMotion::Kind::rest && !now.has_event && tool_) {
      if (const auto machine = b.to_machine(*tool_)) b.amend(machine_, *machine);
      return ig::Status::changed;
    }
    tool_.reset();
    if (!piece.corner && !piece.begins_behind_corner) return ig::Status::unchanged;
    make(b, piece);
    return ig::Status::changed;
  }

 private:
  void make(ig::Block& b, const BrokenContour::Piece& piece) {
    const ToolSteps::Manner manner = event_.take(b);
    if (length(piece.motion.to - piece.motion.from) > same_point_mm || !piece.corner) step(b, piece.motion, manner);
    const auto corner_feed = piece.corner_feed_mmds ? piece.corner_feed_mmds : manner.feed_mmds;
    if (piece.corner) step(b, *piece.corner, {false, corner_feed, 0});
    if (piece.corner)
      b.set(compound_, contour_.term(b));
    else if (const auto code = b.get(motion_code_))
      b.set(compound_, *code);
    const std::uint32_t turned = rotary_.fresh(b);
    PartialAngles rotary = rotary_.get(b);
    rotary.mask &= turned;
    steps_.finish(b, rotary);
    if (!piece.corner) return;
    tool_ = piece.corner->to;
    if (const auto machine = b.to_machine(*tool_)) b.set(machine_, *machine);
  }

  void step(ig::Block& b, const ContourMotion& m, const ToolSteps::Manner& manner) const {
    if (!m.move.is_arc) {
      steps_.line(b, m.to, manner);
      return;
    }
    ig::Vec3 center = m.from;
    center[m.plane.first] = rounded(m.move.center.u);
    center[m.plane.second] = rounded(m.move.center.v);
    steps_.arc(b, m.to, center, m.move.is_ccw, manner);
  }
};

const ig::Register<CornerBreakPath> corner_break_path_syntax;

}  // namespace
}  // namespace iso
