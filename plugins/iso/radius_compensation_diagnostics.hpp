/// Diagnostics of cutter radius compensation: the part of the plugin's table that follows tool_center_diagnostics.hpp.
#pragma once

#include "subprogram_diagnostics.hpp"

namespace iso {

inline constexpr std::array radius_compensation_diagnostics{
    ig::diagnostic(IG_WARNING, "ISO-0461", "{0} without D, and none was programmed before: radius 0 is used",
                   "D names the row of the tool table. The tool runs on the contour, not beside it.", "G41 X10. Y10."),
    ig::diagnostic(IG_WARNING, "ISO-0462", "the tool table has no offset {0}: radius 0 is used",
                   "Add a row to the ToolOffsetTable, or give --tools FILE. The tool runs on the contour.", "G41 D77"),
    ig::diagnostic(IG_ERROR, "ISO-0463", "D{0} is no offset number; the radius of before stays in force",
                   "An offset number is a whole number, zero or greater. D0 is radius 0: compensation ends.",
                   "G41 D1.5"),
    ig::diagnostic(IG_NOTE, "ISO-0464", "the radius of D{0} is 0: the tool runs on the programmed path",
                   "Either the program holds the path of the tool's centre and D its wear, or the tool table was not "
                   "given: --tools FILE. Said once a run.",
                   "G41 D1 X10."),
    ig::diagnostic(IG_ERROR, "ISO-0465", "an arc cannot {0} radius compensation: program a straight move",
                   "The control stops with alarm PS0034. Here an arc that would start it runs as programmed, and one "
                   "that would end it runs compensated; the next straight move does it.",
                   "G41 G02 X10. I5. D1"),
    ig::diagnostic(
        IG_ERROR, "ISO-0466", "the tool (radius {0}) does not fit into the arc (radius {1})",
        "The control stops with alarm PS0041, since the tool would cut into the contour. Here the arc is left "
        "out where the paths before and behind it cross, as at a fillet smaller than the tool; elsewhere a "
        "straight move is shown in its place.",
        "G41 D1 (radius 5) (then) G03 X4. Y4. R4."),
    ig::diagnostic(IG_ERROR, "ISO-0467", "the tool would run against the programmed direction by {0} mm: it cuts in",
                   "The corners before and behind the block are so near to each other that the compensated path turns "
                   "round between them: a groove that is narrower than the tool. The control stops with alarm PS0041 "
                   "(interference). The path is shown as computed.",
                   "G41 D1 (radius 5) (then) X10. (then) Y8. (then) X0"),
    ig::diagnostic(IG_ERROR, "ISO-0468", "the compensated paths of this block and the next do not meet",
                   "At an inner corner with an arc there is no place where the tool touches both. The control stops "
                   "with alarm PS0033. The tool goes straight from the end of the one to the start of the other.",
                   "G41 D1 (radius 5) (then) an arc that bends away under the tool"),
    ig::diagnostic(
        IG_WARNING, "ISO-0469",
        "more than {0} blocks without a move in the plane follow: the tool stops square to the contour",
        "The control reads only some blocks ahead (parameter 19625), finds no next move, and puts the tool at a right "
        "angle to the end of this one. An inner corner is overcut then, an outer one is left with material.",
        "G41 ... (then) X10. (then) M08 (then) G04 P10 (then) M51 (then) Y10."),
    ig::diagnostic(IG_WARNING, "ISO-0470", "{0} under radius compensation: it is off for this block",
                   "Reference returns, G53, canned cycles and other moves by steps go to positions as programmed. The "
                   "block before them ends square to its contour; the next straight move in the plane starts "
                   "compensation again. Program G40 first.",
                   "G41 ... (then) G28 Z0"),
    ig::diagnostic(IG_ERROR, "ISO-0471", "the plane changes under radius compensation",
                   "The control stops with alarm PS0037. Here compensation is off at once; the next straight move in "
                   "the new plane starts it again.",
                   "G41 ... (then) G18"),
    ig::diagnostic(
        IG_ERROR, "ISO-0472", "radius compensation while the rotary axes turn: the block runs as programmed",
        "The contour in the plane is known for resting rotary axes only. Compensation in space (G41.2) is not "
        "executed.",
        "G43.4 H1 (then) G41 D1 X10. (then) X20. A10."),
    ig::diagnostic(IG_WARNING, "ISO-0473", "the program ends under radius compensation: no move took the tool off it",
                   "Program G40 with a move away from the part before the end.", "G41 ... (then) M30"),
    ig::diagnostic(IG_ERROR, "ISO-0474", "the compensated path of this block has no position",
                   "Its numbers are too great to compute with. The block runs as programmed, and compensation is off.",
                   "G41 ... (then) X1e300"),
    ig::diagnostic(IG_WARNING, "ISO-0475", "the tool did not turn the corner before this block: it stopped there",
                   "Across a stop (M00, M01) the control cannot look ahead, so it had the tool square to the block "
                   "before. From there it goes straight to the end of this one, and an inner corner is overcut, an "
                   "outer one cut into. Put the stop where the contour goes straight on, or outside of it.",
                   "G41 ... (then) X10. (then) M00 (then) Y10."),
    ig::diagnostic(
        IG_ERROR, "ISO-0476", "the tool cannot reach this block between its neighbours: it is left out",
        "The inner corners at its ends overlap. The control stops with alarm PS0041, or avoids the "
        "interference where parameter 19607 bit 5 says so. Here the tool goes over to the next block that it "
        "reaches, where the two paths cross.",
        "G41 D1 (radius 5) (then) X10. (then) X13. Y3. (then) Y20."),
    ig::diagnostic(IG_ERROR, "ISO-0477", "the radius of D{0} is no radius: 0 is used",
                   "Geometry and wear of the tool table together are 1 000 000 m or more. Look for a typing error, or "
                   "for the computation that wrote the table.",
                   "G41 D1 (with D=2000000000 in the tool table)"),
    ig::diagnostic(
        IG_WARNING, "ISO-0496", "beside this block the tool cuts {0} mm into the contour of one that follows",
        "Two parts of the contour lie nearer to each other than the tool is wide, and there are blocks between "
        "them: a neck. A control compares fewer blocks, if any, and cuts. Said where the neck begins, of "
        "straight moves and arcs by feed at one height, some blocks ahead.",
        "G41 D1 (radius 5), into a pocket through an opening of 8 mm"),
    ig::diagnostic(IG_ERROR, "ISO-0497", "the tool stands inside the arc by which it would come to the contour",
                   "No line touches the arc from there. The tool goes straight to the first point; the control stops.",
                   "5 APPR LCT X+5 Y+5 R50 RL F300 (from a point that is 20 mm away)"),
};

inline constexpr std::size_t radius_end = subprogram_end + radius_compensation_diagnostics.size();

consteval std::uint32_t radius_diag(std::string_view code) {
  return index_of(radius_compensation_diagnostics, code, subprogram_end);
}

}  // namespace iso
