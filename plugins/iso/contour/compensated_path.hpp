/// The path of the tool's centre beside the contour: the state and the fields with which RadiusCompensationPathSyntax
/// replaces each move, from the move that starts compensation to the move that cancels it.
#pragma once

#include <isogloss/cnc/contour_approach.hpp>
#include <isogloss/cnc/event_to_steps.hpp>
#include <isogloss/cnc/feed.hpp>
#include <isogloss/cnc/radius_compensation.hpp>

#include "contour/broken_contour.hpp"
#include "contour/contour_ahead.hpp"
#include "contour/contour_motion.hpp"

namespace iso {

using namespace ig::cnc;

/// The one member of the syntax.
class CompensatedPath {
 public:
  ig::Status restart() {
    tool_ = {};
    contour_.forget();
    return ig::Status::unchanged;
  }

  ig::Status build(ig::Block& b);

 private:
  enum class Approach { a, b, parameter };
  enum class Interference { alarm, avoid, ignore };
  enum class WithoutMove { next_move, at_once };
  enum class EndOff { said, allowed };
  enum class FeedOnArcs { center, contour, contour_inside };
  enum Phase : std::size_t { starting, offsetting, cancelling };

  ig::Signal path_{"RadiusCompensation.~Path", ig::read | ig::wake};
  ig::Signal corner_path_{"CornerBreak.~Path", ig::read | ig::wake};
  ig::In<bool> is_rapid_{"MotionEvent.IsRapid"};
  ig::In<ig::Symbol> term_{"RadiusCompensation.Term"};
  ig::Out<ig::Symbol> phase_{"RadiusCompensation.Phase",
                             {ig::Life::block, "", "StartUp, Offset or Cancel: what the move of the block is."}};
  ig::Out<ig::Symbol> corner_{"RadiusCompensation.Corner",
                              {ig::Life::block, "", "How the tool comes to the next move of the contour."}};
  // Never carried between blocks of a run; it is modal only so that cases can set it.
  ig::Xyz vector_{"RadiusCompensation.Vector",
                  ig::read | ig::write,
                  {ig::Life::modal, "mm", "From the programmed point to the tool's centre, program coordinates."}};
  ig::Xyz machine_{"MachineCoordinate", ig::read | ig::write};
  ig::Out<ig::Symbol> compound_{"CompoundMotion.Term"};
  ig::In<ig::Symbol> program_end_{"ProgramEnd.Term"};
  ig::In<ig::Symbol> corner_arc_{"RadiusCompensation.CornerArc"};
  ig::Xyz corner_direction_{"RadiusCompensation.CornerDirection", ig::read, {ig::Life::block, "mm", ""}};
  ig::In<ig::Symbol> motion_code_{"MotionState.Term"};
  ig::Name rapid_code_{"G00"};
  FeedInForce feed_{ig::read};
  RotaryPosition rotary_{ig::read};
  ContourMotionOf motion_;
  ContourAhead ahead_;
  BrokenContour contour_;
  EventToSteps event_;
  ContourApproach approach_{ig::read};
  ContourDeparture departure_{ig::read};
  ToolSteps steps_;
  std::array<ig::Name, 3> phases_{ig::Name{"StartUp"}, ig::Name{"Offset"}, ig::Name{"Cancel"}};
  std::array<ig::Name, 8> corners_{ig::Name{"Tangent"},  ig::Name{"Inner"},     ig::Name{"Obtuse"},
                                   ig::Name{"Acute"},    ig::Name{"Round"},     ig::Name{"Square"},
                                   ig::Name{"Crossing"}, ig::Name{"NoSolution"}};

  ig::Choice<Approach> start_up_{"start-up", "a|b|parameter", "a",
                                 "Start and end of compensation: type A or B, or as the control's parameters say."};
  ig::Config parameters_{"isogloss.motion/1", ig::Need::optional, "RadiusCompensationStartUp: 0 type A, 1 type B."};
  bool is_type_b_ = start_up_ == Approach::b || (start_up_ == Approach::parameter &&
                                                 parameters_.number("RadiusCompensationStartUp").value_or(0) != 0);
  ig::Choice<OuterCorner> outer_corner_{"outer-corner", "lines|arc", "lines",
                                        "How the tool moves round an outer corner."};
  ig::In<double> corner_limit_{
      "RadiusCompensation.CornerLimit_deg",
      ig::read,
      {ig::Life::modal, "deg", "Outer corners that bend by at most this are passed where the offsets cross."}};
  ig::Choice<FeedOnArcs> feed_on_arcs_{"feed-on-arcs", "center|contour|contour-inside", "center",
                                       "Where F holds on an arc: at the tool centre, or at the contour."};
  ig::In<ig::Symbol> feed_at_{"RadiusCompensation.FeedOnArcs",
                              ig::read,
                              {ig::Life::modal, "", "Center, Contour or ContourInside: where F holds on an arc."}};
  std::array<ig::Name, 3> feeds_at_{ig::Name{"Center"}, ig::Name{"Contour"}, ig::Name{"ContourInside"}};
  ig::Choice<Interference> interference_{"interference", "alarm|avoid|ignore", "alarm",
                                         "What happens to a move that the tool cannot reach between its neighbours: "
                                         "skipped with an alarm, skipped, or made as computed."};
  ig::Choice<WithoutMove> without_move_{
      "without-move", "next-move|at-once", "next-move",
      "When a block without a move starts or cancels compensation: with the next move, or at once (type C)."};
  ig::Choice<EndOff> end_off_{
      "end-off", "said|allowed", "said",
      "A program that ends with compensation cancelled while the tool is still beside the contour."};
  ig::IntegerOption compared_{
      "moves-compared", "8", {1, 8}, "How many moves ahead a block is compared with for interference."};
  ig::IntegerOption rests_allowed_{
      "blocks-without-move",
      "2",
      {0, 10},
      "How many blocks without a move in the plane the look-ahead passes to find the next move."};

  /// Where the tool's centre is, and the corner that it has begun to turn.
  struct Tool {
    bool is_off = false;  ///< off the contour
    PlaneAxes plane;
    ig::Vec3 at;       ///< program coordinates, as the corner
    ig::Vec3 machine;  ///< the same in machine coordinates, should the frame change
    double offset = 0;
    Point2 corner_center{};
    Corner corner;             ///< its steps belong to the next move in the plane
    bool is_blind = false;     ///< it has not seen the next move
    std::size_t left_out = 0;  ///< moves that follow and that it cannot reach
    std::array<ig::Vec3, 3> steps_machine{};
    ig::Vec3 center_machine{};
  };
  Tool tool_;

  // Of the block that is built.
  ig::Vec3 programmed_;
  std::optional<ToolSteps::Manner> manner_;  ///< of its move, once that is taken
  std::optional<ContourMove> inserted_;      ///< what breaks the corner at the end of its move, still to come
  std::optional<Point2> next_start_;         ///< where the next block begins behind that

  // ---- compensated_path.cpp: the moves of the contour

  ig::Status follow(ig::Block& b, const ContourMotion& now, double offset);
  ig::Status go_on(ig::Block& b, const ContourMotion& now, double offset);
  /// In the frame of this block. A block alone (a case) finds the vector in the block before it.
  void find_tool(ig::Block& b, const ContourMotion& now);
  void stand_at(const ContourMotion& now, const ig::Vec3& at, double offset);
  /// What comes after the move at hand.
  ContourAhead::Next following(ig::Block& b, const ContourMotion& now, double offset) const;
  Corner corner_to(ig::Block& b, const ContourMotion& now, const ContourAhead::Next& next, double offset) const;
  /// The first or the last point of the contour, about which the tool goes from behind the contour or to there.
  Corner about_first_or_last(ig::Block& b, const ContourMove& before, const ContourMove& after, double offset) const;
  Corner end_of(ig::Block& b, const ContourMotion& now, double offset, const ContourAhead::Next& next);
  /// A chamfer or a rounding is a move of the contour like others. After the move that cancels compensation, the tool
  /// centre is on it.
  void go_round_corner(ig::Block& b, const ContourMotion& corner, double offset);
  /// An arc that is narrower than the tool; both radii as they are in the machine.
  void report_narrow_arc(ig::Block& b, const ContourMotion& now, double offset) const;
  void report_too_far(ig::Block& b, const ContourAhead::Next& next) const;
  FeedOnArcs feed_on_arcs(const ig::Block& b) const;
  /// The feed of the tool centre on an arc of the contour.
  ToolSteps::Manner on_arc(const ig::Block& b, const ContourMotion& now, const ToolSteps::Manner& manner,
                           double offset) const;

  /// The rest of the corner before, then the move up to where it is left for the next.
  ig::Status move(ig::Block& b, const ContourMotion& now, Phase phase, const Corner& corner, double offset);
  /// Where the tool stands before the corner is turned.
  ig::Status arrive(ig::Block& b, const ContourMotion& now, Phase phase, const Corner& corner, double offset,
                    const ig::Vec3& to);
  void keep_corner(ig::Block& b, const ContourMotion& now, double height);
  void turn_corner(ig::Block& b, const ContourMotion& now, const ToolSteps::Manner& manner);
  /// Reports when the move cannot be made; a straight one replaces an arc then.
  bool goes_along_arc(ig::Block& b, const ContourMotion& now, Phase phase, const Point2& from, const Point2& to,
                      double offset) const;
  static bool is_sound(const Corner& corner);
  /// Of the move of the block, for all its steps.
  ToolSteps::Manner take_event(ig::Block& b);
  void finish(ig::Block& b);
  void keep_position(ig::Block& b);

  static ig::Vec3 at(const ContourMotion& now, const Point2& p, double height) {
    ig::Vec3 out;
    out[now.plane.first] = rounded(p.u);
    out[now.plane.second] = rounded(p.v);
    out[now.plane.tool] = height;
    return out;
  }

  // ---- compensated_path_ends.cpp: start and end

  ig::Status start(ig::Block& b, const ContourMotion& now, double offset);
  /// To where the way to the contour begins, there along the third axis, then on the way.
  ig::Status approach(ig::Block& b, const ContourMotion& now, const ContourApproach::Way& way, const Point2& along,
                      const Corner& corner, double offset);
  ig::Status cancel(ig::Block& b, const ContourMotion& now);
  /// On an arc off the contour, then straight on, then along the third axis.
  ig::Status depart(ig::Block& b, const ContourMotion& now, const ContourDeparture::Arc& arc);
  /// The block before has ended square to the contour, since this one is a barrier.
  ig::Status suspend(ig::Block& b, const ContourMotion& now);

  // ---- compensated_path_at_rest.cpp: blocks without a move in the plane

  /// A block without a move in the plane may move the tool all the same: G39, and start and end of type C.
  ig::Status rest_or_step(ig::Block& b, const ContourMotion& now, double offset);
  /// By the motion code in force.
  ToolSteps::Manner manner_of_step(ig::Block& b, double length) const;
  /// Square to the next move.
  ig::Status start_at_rest(ig::Block& b, const ContourMotion& now, double offset);
  ig::Status cancel_at_rest(ig::Block& b, const ContourMotion& now);
  void step_to(ig::Block& b, const ContourMotion& now, const Point2& to, Phase phase);
  /// G39: about the corner, until the tool stands square to the next move, or to the direction of the program.
  ig::Status turn_on_arc(ig::Block& b, const ContourMotion& now, double offset);
  /// No move in the plane: the tool keeps its distance. What moves across the plane goes with it.
  ig::Status rest(ig::Block& b, const ContourMotion& now);

  // ---- compensated_path_narrow.cpp: places that are narrower than the tool

  /// The moves that follow on this side, into `moves`, as far as the control compares them.
  std::size_t following(ig::Block& b, const ContourMotion& now, double offset, ContourAhead::Moves& moves,
                        ContourAhead::Walls* walls = nullptr) const;
  /// Where the tool cannot reach the next moves, since the corners at their ends overlap, it goes over from this move
  /// to the first one after them that it reaches.
  std::optional<Corner> go_around(ig::Block& b, const ContourMotion& now, double offset, const ContourAhead::Next& next,
                                  const Corner& corner);
  ig::Status leave_out(ig::Block& b, const ContourMotion& now, double offset);
  /// False on a contour of short lines that turns little by little: nothing there can face this move.
  bool may_be_narrow(const ContourMotion& now, const ContourAhead::Next& next, const Corner& corner) const;
  /// A neck: two parts of the contour that are no neighbours are nearer to each other than the tool is wide. The two
  /// moves behind this one are neighbours, which their corners look after; the last one leads away.
  void report_neck(ig::Block& b, const ContourMotion& now, double offset, const Corner& corner);
};

}  // namespace iso
