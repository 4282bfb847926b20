/// The tool's path beside the contour: under G41 and G42 each block's move is replaced by the moves of the tool's
/// centre, which touches the contour and turns its corners. Needs the next move of the contour, so it looks ahead.
/// Fanuc manual, "Details of cutter compensation".
#include "contour/compensated_path.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

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
                     "no move in the plane follows within the blocks read ahead ({0} may be without a move): the tool "
                     "stops square to the contour",
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

  CompensatedPath path_;

  ig::Status restart(ig::Block&) { return path_.restart(); }
  ig::Status build(ig::Block& b) { return path_.build(b); }
};

const ig::Register<RadiusCompensationPath> radius_compensation_path_syntax;

}  // namespace
}  // namespace iso
