/// The tool's path beside the contour: under G41 and G42 each block's move is replaced by the moves of the tool's
/// centre, which touches the contour and turns its corners. Needs the next move of the contour, so it looks ahead.
/// Fanuc manual, "Details of cutter compensation".
#include <isogloss/cnc/contour_approach.hpp>
#include <isogloss/cnc/event_to_steps.hpp>
#include <isogloss/cnc/feed.hpp>
#include "contour/broken_contour.hpp"
#include "contour/contour_clearance.hpp"

namespace iso {

using namespace ig::cnc;
namespace {

enum class Approach { a, b, parameter };
enum class Interference { alarm, avoid, ignore };
enum class WithoutMove { next_move, at_once };
enum class EndOff { said, allowed };

struct RadiusCompensationPath {
  static constexpr auto spec =
      ig::syntax("RadiusCompensationPathSyntax", "The path of the tool centre beside the contour, under G41 and G42.")
          .after("RadiusCompensationSyntax", "McXyzSyntax", "McAbcSyntax", "CircularMotionSyntax", "LinearMotionSyntax",
                 "ReferenceReturnSyntax", "ReturnFromReferenceSyntax", "ReferenceCheckSyntax")
          .before("TravelCheckSyntax")
          .looks_ahead(ContourAhead::window);
  static constexpr std::array diagnostics{
      ig::diagnostic(
          IG_ERROR, "ISO-0465", "an arc cannot {0} radius compensation: program a straight move",
          "The control stops with alarm PS0034. Here an arc that would start compensation runs as programmed, and an "
          "arc that would end it runs compensated; the next straight move starts or ends compensation.",
          "G41 G02 X10. I5. D1"),
      ig::diagnostic(IG_ERROR, "ISO-0466", "the tool (radius {0} mm) does not fit into the arc (radius {1} mm)",
                     "The control stops with alarm PS0041, because the tool would cut into the contour. Here the arc "
                     "is skipped where the paths before and after it cross, as at a fillet smaller than the tool; "
                     "elsewhere a straight move replaces it.",
                     "G41 D1 (radius 5) (then) G03 X4. Y4. R4."),
      ig::diagnostic(IG_ERROR, "ISO-0467",
                     "the tool would run {0} mm against the programmed direction and cut into the contour",
                     "The corners before and after the block are so close together that the compensated path between "
                     "them runs backwards, as in a groove that is narrower than the tool. The control stops with alarm "
                     "PS0041 (interference). The path is shown as computed.",
                     "G41 D1 (radius 5) (then) X10. (then) Y8. (then) X0"),
      ig::diagnostic(
          IG_ERROR, "ISO-0468", "the compensated paths of this block and the next one do not meet",
          "At an inner corner with an arc, there is no position where the tool touches both contours. The control "
          "stops with alarm PS0033. The tool goes straight from the end of one path to the start of the other.",
          "G41 D1 (radius 5) (then) an arc that bends away under the tool"),
      ig::diagnostic(IG_WARNING, "ISO-0469",
                     "more than {0} blocks without a move in the plane follow: the tool stops square to the contour",
                     "The control reads only a limited number of blocks ahead (parameter 19625), finds no next move, "
                     "and places the tool at a right angle to the end of this one. An inner corner is then overcut, "
                     "and material remains at an outer one.",
                     "G41 ... (then) X10. (then) M08 (then) G04 P10 (then) M51 (then) Y10."),
      ig::diagnostic(IG_WARNING, "ISO-0470",
                     "{0} under radius compensation: compensation is off for this block, so cancel it first",
                     "Reference returns, G53, canned cycles and other moves made of steps go to positions as "
                     "programmed. The block before them ends square to its contour; the next straight move in the "
                     "plane starts compensation again. Program G40 first.",
                     "G41 ... (then) G28 Z0"),
      ig::diagnostic(IG_ERROR, "ISO-0471",
                     "the plane changes under radius compensation: compensation is off, so cancel it first",
                     "The control stops with alarm PS0037. Here compensation is off at once; the next straight move in "
                     "the new plane starts it again. Program G40 first.",
                     "G41 ... (then) G18"),
      ig::diagnostic(IG_ERROR, "ISO-0472",
                     "radius compensation is not executed while rotary axes turn: the block runs as programmed",
                     "The contour in the plane is known only while the rotary axes rest. Compensation in space (G41.2) "
                     "is not executed.",
                     "G43.4 H1 (then) G41 D1 X10. (then) X20. A10."),
      ig::diagnostic(
          IG_WARNING, "ISO-0473",
          "the program ends under radius compensation: cancel it with a move away from the part",
          "No move has taken the tool off the contour. Program G40 with a move away from the part before the end.",
          "G41 ... (then) M30"),
      ig::diagnostic(IG_ERROR, "ISO-0474",
                     "the compensated path of this block cannot be computed: the block runs as programmed",
                     "Its numbers are too large. Compensation is off for this block.", "G41 ... (then) X1e300"),
      ig::diagnostic(
          IG_WARNING, "ISO-0475",
          "the tool stopped at the corner before this block without looking ahead: move the stop away from the corner",
          "The control cannot look ahead across a stop (M00, M01), so the tool was square to the block before the "
          "stop. From there it goes straight to the end of this block: an inner corner is overcut, and an outer one is "
          "cut into. Program the stop where the contour goes straight on, or away from the contour.",
          "G41 ... (then) X10. (then) M00 (then) Y10."),
      ig::diagnostic(IG_ERROR, "ISO-0476",
                     "the tool cannot reach this block between its neighbours, so the block is skipped",
                     "The inner corners at the ends of the block overlap. The control stops with alarm PS0041, or "
                     "avoids the interference where parameter 19607 bit 5 is set. Here the tool changes to the next "
                     "block that it can reach, where the two paths cross.",
                     "G41 D1 (radius 5) (then) X10. (then) X13. Y3. (then) Y20."),
      ig::diagnostic(IG_ERROR, "ISO-0479", "G39 at an inner corner: the tool goes straight, without an arc",
                     "The arc leads round an outer corner. At an inner corner it would lie in the part.",
                     "G41 D1 (radius 5) (then) X10. (then) G39 (then) Y10."),
      ig::diagnostic(
          IG_WARNING, "ISO-0496", "beside this block the tool cuts {0} mm into the contour of a later block",
          "Two parts of the contour are closer to each other than the tool is wide, with other blocks between them: a "
          "neck. A control compares fewer blocks, if any, and cuts into the contour. Reported where the neck begins, "
          "for straight moves and arcs by feed at one height, within a limited number of blocks.",
          "G41 D1 (radius 5), into a pocket through an opening of 8 mm"),
      ig::diagnostic(IG_ERROR, "ISO-0497",
                     "the tool is inside the approach arc, so it goes straight to the first contour point",
                     "No line from this position touches the arc. The control stops with an alarm.",
                     "5 APPR LCT X+5 Y+5 R50 RL F300 (from a point that is 20 mm away)"),
  };

  ig::Signal path_{"RadiusCompensation.~Path", ig::read | ig::wake};
  ig::Signal corner_path_{"CornerBreak.~Path", ig::read | ig::wake};
  ig::In<bool> is_rapid_{"MotionEvent.IsRapid"};
  ig::In<ig::Symbol> term_{"RadiusCompensation.Term"};
  ig::Out<ig::Symbol> phase_{"RadiusCompensation.Phase",
                             {ig::Life::block, "", "StartUp, Offset or Cancel: what the move of the block is."}};
  ig::Out<ig::Symbol> corner_{"RadiusCompensation.Corner",
                              {ig::Life::block, "", "How the tool comes to the next move of the contour."}};
  // Of the blocks of a run none carries it: logic has gone on before it is written.
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

  ig::Status restart(ig::Block&) {
    tool_ = {};
    contour_.forget();
    return ig::Status::unchanged;
  }

  ig::Status build(ig::Block& b) {
    const ContourMotion now = motion_(b);
    const BrokenContour::Piece piece = contour_.take(b, now);
    programmed_ = now.to;
    manner_.reset();
    inserted_.reset();
    next_start_.reset();
    const double offset = ahead_.offset_in_force(b);
    find_tool(b, now);
    if (!tool_.is_off && offset == 0) return ig::Status::unchanged;
    if (tool_.is_off && !(tool_.plane == now.plane)) {
      b.report(ig::diag("ISO-0471"), ig::Where::block());
      b.alarm();
      tool_ = {};
    }
    const bool may_end = end_off_ == EndOff::allowed && offset == 0;
    if (tool_.is_off && b.has(program_end_) && !may_end) b.report(ig::diag("ISO-0473"), ig::Where::block());
    switch (now.kind) {
      case ContourMotion::Kind::by_steps: return suspend(b, now);
      case ContourMotion::Kind::rest: return rest_or_step(b, now, offset);
      case ContourMotion::Kind::move: break;
    }
    if (piece.corner) {
      inserted_ = piece.corner->move;
      next_start_ = piece.corner->move.end;
    }
    const ig::Status status = follow(b, piece.motion, offset);
    if (!manner_) return status;
    contour_.say(b, piece);
    inserted_.reset();
    if (piece.corner) go_round_corner(b, *piece.corner, offset);
    return status;
  }

 private:
  enum Phase : std::size_t { starting, offsetting, cancelling };

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

  ig::Status follow(ig::Block& b, const ContourMotion& now, double offset) {
    if (offset == 0) return cancel(b, now);
    return tool_.is_off ? go_on(b, now, offset) : start(b, now, offset);
  }

  /// A chamfer or a rounding is a move of the contour like others. Behind the move that cancels nothing is beside it.
  void go_round_corner(ig::Block& b, const ContourMotion& corner, double offset) {
    if (tool_.is_off) {
      go_on(b, corner, offset != 0 ? offset : tool_.offset);
      return;
    }
    const ToolSteps::Manner manner{false, manner_->feed_mmds, 0};
    if (corner.move.is_arc)
      steps_.arc(b, corner.to, at(corner, corner.move.center, corner.to[corner.plane.tool]), corner.move.is_ccw,
                 manner);
    else
      steps_.line(b, corner.to, manner);
    tool_.at = corner.to;
    finish(b);
    tool_ = {};
  }

  /// What comes after the move at hand.
  ContourAhead::Next following(ig::Block& b, const ContourMotion& now, double offset) const {
    ContourAhead::Next next;
    if (inserted_) {
      next.kind = ContourAhead::Next::Kind::move;
      next.offset = offset;
      next.move = *inserted_;
      return next;
    }
    next = ahead_.next(b, now.plane, rests_allowed_);
    if (next_start_ && next.kind == ContourAhead::Next::Kind::move)
      next.move = between_corners(next.move, *next_start_, next.move.end);
    return next;
  }
  std::size_t following(ig::Block& b, const ContourMotion& now, double offset, ContourAhead::Moves& moves,
                        ContourAhead::Walls* walls = nullptr) const {
    const auto most = static_cast<std::size_t>(static_cast<std::int64_t>(compared_));
    const std::size_t count =
        std::min(most, ahead_.moves(b, now.plane, offset, rests_allowed_, next_start_, moves, walls));
    if (!inserted_) return count;
    const std::size_t kept = std::min(count, moves.size() - 1);
    const auto put_first = [kept](auto& list, const auto& first) {
      std::copy_backward(list.begin(), list.begin() + kept, list.begin() + kept + 1);
      list[0] = first;
    };
    put_first(moves, *inserted_);
    if (walls != nullptr) put_first(walls->are, true);
    return kept + 1;
  }
  /// In the frame of this block. A block alone (a case) finds the vector in the block before it.
  void find_tool(ig::Block& b, const ContourMotion& now) {
    if (!tool_.is_off) {
      const ig::PartialVec3 carried = b.get(vector_);
      if (!carried.complete() || carried.value == ig::Vec3{}) return;
      stand_at(now, now.from + carried.value, ahead_.offset_in_force(b));
    } else if (b.frame_changed()) {
      const auto here = [&](const ig::Vec3& machine) { return rounded(b.to_program(machine).value_or(machine)); };
      tool_.at = here(tool_.machine);
      tool_.corner_center = ContourMotionOf::in_plane(now.plane, here(tool_.center_machine));
      for (std::size_t i = 0; i < tool_.corner.count; ++i)
        tool_.corner.steps[i].to = ContourMotionOf::in_plane(now.plane, here(tool_.steps_machine[i]));
    }
  }

  void stand_at(const ContourMotion& now, const ig::Vec3& at, double offset) {
    tool_ = {};
    tool_.is_off = true;
    tool_.plane = now.plane;
    tool_.at = at;
    tool_.offset = offset;
  }

  Corner corner_to(const ContourMotion& now, const ContourAhead::Next& next, double offset) const {
    // A rapid makes no arc.
    return iso::corner(now.move, next.move, offset, next.is_rapid ? OuterCorner::lines : OuterCorner{outer_corner_});
  }

  // ---- the phases

  ig::Status start(ig::Block& b, const ContourMotion& now, double offset) {
    if (now.move.is_arc) {
      b.report(ig::diag("ISO-0465"), ig::Where::block(), std::string_view("start"));
      b.alarm();
      return ig::Status::unchanged;
    }
    const ContourAhead::Next next = following(b, now, offset);
    Corner corner = square_corner(now.move, offset);
    if (next.kind == ContourAhead::Next::Kind::move && next.offset * offset > 0) {
      const Corner round = corner_to(now, next, offset);
      const bool is_outer =
          round.kind == CornerKind::obtuse || round.kind == CornerKind::acute || round.kind == CornerKind::round;
      if (is_type_b_ && is_outer)
        corner = round;
      else
        corner.leave = next.move.offset_start(offset);
    }
    say_too_far(b, next);
    stand_at(now, now.from, offset);
    const auto way = approach_.get(b);
    const ig::Status status = way && next.kind == ContourAhead::Next::Kind::move
                                  ? approach(b, now, *way, next.move.direction_at_start(), corner, offset)
                                  : move(b, now, starting, corner, offset);
    tool_.is_blind = next.kind == ContourAhead::Next::Kind::none;
    return status;
  }

  /// To where the way to the contour begins, there along the third axis, then on the way.
  ig::Status approach(ig::Block& b, const ContourMotion& now, const ContourApproach::Way& way, const Point2& along,
                      const Corner& corner, double offset) {
    const Point2 side = (offset > 0 ? 1.0 : -1.0) * left_of(along);
    const auto path =
        ContourApproach::path(way, ContourMotionOf::in_plane(now.plane, now.from), corner.leave, along, side);
    if (!path || !is_sound(corner)) {
      b.report(ig::diag("ISO-0497"), ig::Where::block());
      b.alarm();
      return move(b, now, starting, corner, offset);
    }
    const ToolSteps::Manner manner = take_event(b);
    const double height = now.to[now.plane.tool];
    const ig::Vec3 to = at(now, corner.leave, height);
    const ToolSteps::Manner first{way.is_rapid, way.feed_mmds ? way.feed_mmds : manner.feed_mmds, 0};
    const double before = now.from[now.plane.tool];
    steps_.line(b, at(now, path->begin, before), first);
    if (height != before) steps_.line(b, at(now, path->begin, height), first);
    if (path->center && !is_same(path->begin, corner.leave))
      steps_.arc(b, to, at(now, *path->center, height), path->is_ccw, manner);
    else
      steps_.line(b, to, manner);
    return arrive(b, now, starting, corner, offset, to);
  }

  /// On an arc off the contour, then straight on, then along the third axis.
  ig::Status depart(ig::Block& b, const ContourMotion& now, const ContourDeparture::Arc& arc) {
    const ToolSteps::Manner manner = take_event(b);
    turn_corner(b, now, manner);
    const double height = tool_.at[now.plane.tool];
    const Point2 center = ContourMotionOf::in_plane(now.plane, arc.center);
    const Point2 end = ContourMotionOf::in_plane(now.plane, arc.end);
    steps_.arc(b, at(now, end, height), at(now, center, height), arc.is_ccw, manner);
    tool_.at = at(now, end, height);
    if (!is_same(end, now.move.end)) steps_.line(b, at(now, now.move.end, height), manner);
    if (now.to[now.plane.tool] != height) steps_.line(b, now.to, manner);
    tool_.at = now.to;
    b.set(phase_, phases_[cancelling]);
    finish(b);
    tool_ = {};
    return ig::Status::changed;
  }

  ig::Status go_on(ig::Block& b, const ContourMotion& now, double offset) {
    if (tool_.left_out > 0) return leave_out(b, now, offset);
    const Point2 from = ContourMotionOf::in_plane(now.plane, tool_.at);
    if (tool_.is_blind && !is_same(from, now.move.offset_start(offset)))
      b.report(ig::diag("ISO-0475"), ig::Where::block());
    const ContourAhead::Next next = following(b, now, offset);
    const Corner corner = end_of(b, now, offset, next);
    say_too_far(b, next);
    if (may_be_narrow(now, next, corner)) say_neck(b, now, offset, corner);
    const ig::Status status = move(b, now, offsetting, corner, offset);
    tool_.is_blind = next.kind == ContourAhead::Next::Kind::none;
    return status;
  }

  Corner end_of(ig::Block& b, const ContourMotion& now, double offset, const ContourAhead::Next& next) {
    if (next.kind != ContourAhead::Next::Kind::move || !now.move.fits(offset)) return square_corner(now.move, offset);
    if (next.offset == 0) {
      if (next.direction.length() > 0) return directed_end(now.move, offset, next.direction);
      const bool goes_at_once = without_move_ == WithoutMove::at_once && next.cancels_at_rest;
      if (!is_type_b_ || next.move.is_arc || goes_at_once) return square_corner(now.move, offset);
      const Corner round = corner_to(now, next, offset);
      return round.kind == CornerKind::inner ? square_corner(now.move, offset) : round;
    }
    if (next.offset * offset < 0) return change_of_side(now.move, offset, next.move, next.offset);
    const Corner corner = corner_to(now, next, offset);
    if (interference_ != Interference::ignore)
      if (const auto around = go_around(b, now, offset, next, corner)) return *around;
    if (!next.move.fits(offset)) return square_corner(now.move, offset);
    if (corner.kind == CornerKind::no_solution) {
      b.report(ig::diag("ISO-0468"), ig::Where::block());
      b.alarm();
    }
    return corner;
  }

  /// Where the tool cannot reach the next moves, since the corners at their ends overlap, it goes over from this move
  /// to the first one after them that it reaches.
  std::optional<Corner> go_around(ig::Block& b, const ContourMotion& now, double offset, const ContourAhead::Next& next,
                                  const Corner& corner) {
    const bool is_narrow = corner.kind == CornerKind::inner || corner.kind == CornerKind::no_solution;
    if (!is_narrow && next.move.fits(offset)) return std::nullopt;
    ContourAhead::Moves moves;
    const std::size_t count = following(b, now, offset, moves);
    const Point2 from = tool_.corner.count == 0 ? ContourMotionOf::in_plane(now.plane, tool_.at) : tool_.corner.last();
    std::optional<Corner> trial;
    if (corner.kind != CornerKind::no_solution) trial = corner;
    for (std::size_t n = 0; n < count; ++n) {
      if (n > 0) trial = iso::meet(now.move, moves[n], offset, from);
      if (!trial || !moves[n].fits(offset)) continue;
      const Point2 end = n + 1 < count ? iso::corner(moves[n], moves[n + 1], offset, OuterCorner::lines).leave
                                       : moves[n].offset_end(offset);
      if (moves[n].way(trial->last(), end, offset) < -same_point_mm) continue;
      if (n == 0) return std::nullopt;
      tool_.left_out = n;
      return trial;
    }
    return std::nullopt;
  }

  // ---- necks: two parts of the contour that are no neighbours lie nearer to each other than the tool is wide

  /// A contour of short lines that turns little by little is not looked at: nothing there can face this move.
  bool may_be_narrow(const ContourMotion& now, const ContourAhead::Next& next, const Corner& corner) const {
    if (interference_ == Interference::ignore || tool_.left_out > 0) return false;
    if (next.kind != ContourAhead::Next::Kind::move || next.offset == 0 || next.is_rapid) return false;
    if (corner.kind == CornerKind::no_solution) return false;
    return now.move.is_arc || next.move.is_arc ||
           dot(now.move.direction_at_end(), next.move.direction_at_start()) < least_turn_;
  }

  /// The two moves behind this one are neighbours, which their corners look after; the last one leads away.
  void say_neck(ig::Block& b, const ContourMotion& now, double offset, const Corner& corner) {
    const double height = now.to[now.plane.tool];
    if (b.get_or(is_rapid_, false) || std::fabs(now.from[now.plane.tool] - height) > same_point_mm) return;
    if (!now.move.fits(offset)) return;
    ContourAhead::Moves moves;
    ContourAhead::Walls walls{height, {}};
    const std::size_t count = following(b, now, offset, moves, &walls);
    const Point2 from = tool_.corner.count == 0 ? ContourMotionOf::in_plane(now.plane, tool_.at) : tool_.corner.last();
    if (now.move.way(from, corner.leave, offset) < same_point_mm) return;
    const ContourMove path{from, corner.leave, now.move.is_arc, now.move.center, now.move.is_ccw};
    double deepest = least_cut_mm_;
    for (std::size_t n = 2; n + leads_away_ < count; ++n)
      if (walls.are[n] && moves[n].fits(offset)) deepest = std::fmax(deepest, std::fabs(offset) - gap(path, moves[n]));
    if (deepest > least_cut_mm_) b.report(ig::diag("ISO-0496"), ig::Where::block(), deepest);
  }
  static constexpr double least_turn_ = 0.996;   ///< 5 degrees
  static constexpr double least_cut_mm_ = 0.01;  ///< coordinates are rounded
  static constexpr std::size_t leads_away_ = 1;

  ig::Status leave_out(ig::Block& b, const ContourMotion& now, double offset) {
    --tool_.left_out;
    if (interference_ == Interference::alarm) {
      if (now.move.fits(offset))
        b.report(ig::diag("ISO-0476"), ig::Where::block());
      else
        b.report(ig::diag("ISO-0466"), ig::Where::block(), std::fabs(offset),
                 (now.move.end - now.move.center).length());
      b.alarm();
    }
    const ToolSteps::Manner manner = take_event(b);
    tool_.at[now.plane.tool] = now.to[now.plane.tool];
    steps_.line(b, tool_.at, manner);
    b.set(phase_, phases_[offsetting]);
    finish(b);
    return ig::Status::changed;
  }

  ig::Status cancel(ig::Block& b, const ContourMotion& now) {
    if (now.move.is_arc) {
      b.report(ig::diag("ISO-0465"), ig::Where::block(), std::string_view("end"));
      b.alarm();
      return go_on(b, now, tool_.offset);
    }
    if (const auto arc = departure_.get(b)) return depart(b, now, *arc);
    Corner corner;
    corner.leave = now.move.end;
    const ig::Status status = move(b, now, cancelling, corner, 0);
    tool_ = {};
    return status;
  }

  /// The block before has ended square to the contour, since this one is a barrier.
  ig::Status suspend(ig::Block& b, const ContourMotion& now) {
    if (now.turns) {
      b.report(ig::diag("ISO-0472"), ig::Where::block());
      b.alarm();
    } else if (tool_.is_off) {
      b.report(ig::diag("ISO-0470"), ig::Where::block(),
               b.has(compound_) ? b.text(b.get_or(compound_, ig::Symbol{})) : std::string_view("G53"));
    }
    tool_ = {};
    return ig::Status::unchanged;
  }

  /// A block without a move in the plane may move the tool all the same: G39, and start and end of type C.
  ig::Status rest_or_step(ig::Block& b, const ContourMotion& now, double offset) {
    const bool may_step = without_move_ == WithoutMove::at_once && !now.has_event;
    if (!tool_.is_off) return may_step ? start_at_rest(b, now, offset) : ig::Status::unchanged;
    if (b.has(corner_arc_)) return turn_on_arc(b, now, offset);
    if (may_step && offset == 0) return cancel_at_rest(b, now);
    return rest(b, now);
  }

  /// By the motion code in force.
  ToolSteps::Manner manner_of_step(ig::Block& b, double length) const {
    const bool is_rapid = b.is(motion_code_, rapid_code_) || !b.has(motion_code_);
    const double mmds = is_rapid ? 0 : feed_.mmds(b, [&] { return length; });
    return {is_rapid, mmds > 0 ? std::optional(mmds) : std::nullopt, 0};
  }

  /// Square to the next move.
  ig::Status start_at_rest(ig::Block& b, const ContourMotion& now, double offset) {
    const ContourAhead::Next next = ahead_.next(b, now.plane, rests_allowed_);
    if (next.kind != ContourAhead::Next::Kind::move || next.offset * offset <= 0) return ig::Status::unchanged;
    stand_at(now, now.from, offset);
    step_to(b, now, next.move.offset_start(offset), starting);
    return ig::Status::changed;
  }

  ig::Status cancel_at_rest(ig::Block& b, const ContourMotion& now) {
    step_to(b, now, now.move.end, cancelling);
    tool_ = {};
    return ig::Status::changed;
  }

  void step_to(ig::Block& b, const ContourMotion& now, const Point2& to, Phase phase) {
    turn_corner(b, now, manner_of_step(b, 0));
    const ig::Vec3 end = at(now, to, now.to[now.plane.tool]);
    steps_.line(b, end, manner_of_step(b, iso::length(end - tool_.at)));
    tool_.at = end;
    b.set(phase_, phases_[phase]);
    finish(b);
  }

  /// G39: about the corner, until the tool stands square to the next move, or to the direction of the program.
  ig::Status turn_on_arc(ig::Block& b, const ContourMotion& now, double offset) {
    const Point2 middle = now.move.end, from = ContourMotionOf::in_plane(now.plane, tool_.at);
    Point2 to = from;
    const ig::PartialVec3 named = b.get(corner_direction_);
    if (named.mask != 0) {
      const Point2 way = ContourMotionOf::in_plane(now.plane, named.or_else({}));
      to = middle + (offset / way.length()) * left_of(way);
    } else if (const auto next = ahead_.next(b, now.plane, rests_allowed_);
               next.kind == ContourAhead::Next::Kind::move && next.offset * offset > 0) {
      to = next.move.offset_start(offset);
    } else {
      b.report(ig::diag("ISO-0478"), ig::Where::block(), std::string_view("no move on this side follows"));
      b.alarm();
      return rest(b, now);
    }
    const bool is_inner = cross(from - middle, to - middle) * offset > 0;
    if (is_inner) {
      b.report(ig::diag("ISO-0479"), ig::Where::block());
      b.alarm();
    }
    const double height = tool_.at[now.plane.tool];
    const ig::Vec3 end = at(now, to, height);
    const ToolSteps::Manner manner = manner_of_step(b, (to - from).length());
    if (!is_same(from, to) && !is_inner)
      steps_.arc(b, end, at(now, middle, height), offset < 0, {false, manner.feed_mmds, 0});
    else if (!is_same(from, to))
      steps_.line(b, end, manner);
    tool_.at = end;
    b.set(phase_, phases_[offsetting]);
    b.set(corner_, corners_[static_cast<std::size_t>(CornerKind::round)]);
    if (is_same(from, to))
      keep_position(b);
    else
      finish(b);
    return ig::Status::changed;
  }

  /// No move in the plane: the tool keeps its distance. What moves across the plane goes with it.
  ig::Status rest(ig::Block& b, const ContourMotion& now) {
    if (now.has_event) {
      ig::Vec3 to = tool_.at;
      to[now.plane.tool] = now.to[now.plane.tool];
      const ToolSteps::Manner manner = take_event(b);
      steps_.line(b, to, manner);
      tool_.at = to;
      finish(b);
      return ig::Status::changed;
    }
    keep_position(b);
    return ig::Status::changed;
  }

  void say_too_far(ig::Block& b, const ContourAhead::Next& next) const {
    if (next.kind == ContourAhead::Next::Kind::too_far)
      b.report(ig::diag("ISO-0469"), ig::Where::block(), static_cast<double>(rests_allowed_));
  }

  // ---- the path

  /// The rest of the corner before, then the move up to where it is left for the next.
  ig::Status move(ig::Block& b, const ContourMotion& now, Phase phase, const Corner& corner, double offset) {
    if (!is_sound(corner)) {
      b.report(ig::diag("ISO-0474"), ig::Where::block());
      tool_ = {};
      return ig::Status::unchanged;
    }
    const ToolSteps::Manner manner = take_event(b);
    turn_corner(b, now, manner);
    const Point2 from = ContourMotionOf::in_plane(now.plane, tool_.at);
    const double height = now.to[now.plane.tool];
    const ig::Vec3 to = at(now, corner.leave, height);
    if (goes_along_arc(b, now, phase, from, corner.leave, offset))
      steps_.arc(b, to, at(now, now.move.center, tool_.at[now.plane.tool]), now.move.is_ccw, manner);
    else
      steps_.line(b, to, manner);
    return arrive(b, now, phase, corner, offset, to);
  }

  /// Where the tool stands before the corner is turned.
  ig::Status arrive(ig::Block& b, const ContourMotion& now, Phase phase, const Corner& corner, double offset,
                    const ig::Vec3& to) {
    tool_.at = to;
    tool_.offset = offset;
    tool_.corner_center = now.move.end;
    tool_.corner = corner;
    keep_corner(b, now, to[now.plane.tool]);
    b.set(phase_, phases_[phase]);
    if (phase != cancelling) b.set(corner_, corners_[static_cast<std::size_t>(corner.kind)]);
    finish(b);
    return ig::Status::changed;
  }

  void keep_corner(ig::Block& b, const ContourMotion& now, double height) {
    tool_.center_machine = b.to_machine(now.to).value_or(now.to);
    for (std::size_t i = 0; i < tool_.corner.count; ++i) {
      const ig::Vec3 step = at(now, tool_.corner.steps[i].to, height);
      tool_.steps_machine[i] = b.to_machine(step).value_or(step);
    }
  }

  void turn_corner(ig::Block& b, const ContourMotion& now, const ToolSteps::Manner& manner) {
    const double height = tool_.at[now.plane.tool];
    for (std::size_t i = 0; i < tool_.corner.count; ++i) {
      const Corner::Step& step = tool_.corner.steps[i];
      const ig::Vec3 to = at(now, step.to, height);
      if (step.is_arc)
        steps_.arc(b, to, at(now, tool_.corner_center, height), step.is_ccw, {manner.is_rapid, manner.feed_mmds, 0});
      else
        steps_.line(b, to, manner);
      tool_.at = to;
    }
    tool_.corner.count = 0;
  }

  /// Says when the move cannot be made; a straight one stands in for an arc then.
  bool goes_along_arc(ig::Block& b, const ContourMotion& now, Phase phase, const Point2& from, const Point2& to,
                      double offset) const {
    if (phase != offsetting) return false;
    if (!now.move.fits(offset)) {
      b.report(ig::diag("ISO-0466"), ig::Where::block(), std::fabs(offset), (now.move.end - now.move.center).length());
      b.alarm();
      return false;
    }
    const double way = now.move.way(from, to, offset);
    if (way < -same_point_mm) {
      if (interference_ != Interference::ignore) {
        b.report(ig::diag("ISO-0467"), ig::Where::block(), -way);
        b.alarm();
      }
      return false;
    }
    return now.move.is_arc && way > same_point_mm;
  }

  static bool is_sound(const Corner& corner) {
    const auto is_position = [](const Point2& p) { return std::fabs(p.u) < 1e9 && std::fabs(p.v) < 1e9; };
    bool is_sound = is_position(corner.leave);
    for (std::size_t i = 0; i < corner.count; ++i) is_sound = is_sound && is_position(corner.steps[i].to);
    return is_sound;
  }

  static ig::Vec3 at(const ContourMotion& now, const Point2& p, double height) {
    ig::Vec3 out;
    out[now.plane.first] = rounded(p.u);
    out[now.plane.second] = rounded(p.v);
    out[now.plane.tool] = height;
    return out;
  }

  /// Of the move of the block, for all its steps.
  ToolSteps::Manner take_event(ig::Block& b) {
    if (!manner_) manner_ = event_.take(b);
    return *manner_;
  }

  void finish(ig::Block& b) {
    b.set(compound_, b.get_or(term_, ig::Symbol{}));
    const std::uint32_t turned = rotary_.fresh(b);
    PartialAngles rotary = rotary_.get(b);
    rotary.mask &= turned;
    steps_.finish(b, rotary);
    keep_position(b);
  }

  void keep_position(ig::Block& b) {
    const auto machine = b.to_machine(tool_.at);
    if (machine) {
      tool_.machine = *machine;
      if (b.has(compound_))
        b.set(machine_, *machine);
      else
        b.amend(machine_, *machine);
    }
    const ig::Vec3 vector = tool_.at - programmed_;
    b.set(vector_, rounded(vector));
  }
};

const ig::Register<RadiusCompensationPath> radius_compensation_path_syntax;

}  // namespace
}  // namespace iso
