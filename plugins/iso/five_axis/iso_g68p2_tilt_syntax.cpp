/// G68.2, G68.3, G68.4 and G69: a tilted plane. From here on the program describes points in a system of its own, whose
/// XY plane lies anywhere in the workpiece; Z stands upright on it. Fanuc manual, "Tilted working plane command".
///
/// The plane is one entry of the frame, before the tool length and the offsets, so that arcs, cycles and everything
/// else lie in it without knowing of it. Nothing moves here, neither the tool nor the rotary axes.
#include "five_axis/tilted_plane.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct IsoG68p2Tilt {
  static constexpr auto spec =
      ig::syntax("IsoG68p2TiltSyntax", "G68.2/G68.3/G68.4/G69 tilted plane.")
          .after("ParameterizedFlagSyntax", "UnitModeSyntax", "IsoG68RotationSyntax")
          .before("ToolHeightOffsetSyntax", "IsoLocalCoordinateOffsetSyntax", "IsoCoordinateOffsetSyntax",
                  "CannedCycleResolveSyntax", "IncrementalResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0421",
                     "{0} P{1}: P must be a whole number from 0 to 4, so the plane does not change",
                     "P decides how the words define the plane: Euler angles, roll-pitch-yaw, three points, two "
                     "vectors, or projection angles. Positions from here on are unreliable.",
                     "G68.2 P7 X0 Y0 Z0 I0 J30. K0"),
      ig::diagnostic(
          IG_WARNING, "ISO-0422", "{0} while {1} is in force: the new plane replaces the old one, so program G69 first",
          "Controls require G69 before another plane is defined; some stop with an alarm. The new plane starts from "
          "the workpiece coordinates, as if G69 had been programmed. G68.4 starts from the plane in force.",
          "G68.2 X0 Y0 Z0 J30. (then) G68.2 X50. Y0 Z0 J30."),
      ig::diagnostic(IG_ERROR, "ISO-0423", "{0}: the words are too large to compute the plane, which does not change",
                     "Look for a typing error. Positions from here on are unreliable.",
                     "G68.2 X1 Y1 I45. J45. (then) G68.4 X1 Y1 Z1, each X Y Z with 308 zeros after it"),
      ig::diagnostic(
          IG_WARNING, "ISO-0424", "{0} in a tilted work plane: end the plane with G69 first",
          "Controls forbid reference returns and other coordinate systems inside a tilted work plane. For machine "
          "coordinates they differ: some stop with an alarm, some go to unwanted positions. Here the plane stays, with "
          "its origin in workpiece coordinates, and the code acts as it does without a plane.",
          "G55 (while G68.2 is in force)"),
      ig::diagnostic(IG_ERROR, "ISO-0425", "{0} P{1} is incomplete because {2} is missing: the plane does not change",
                     "Three points need the blocks Q1, Q2 and Q3, and two vectors need Q1 and Q2, before anything "
                     "moves. Positions from here on are unreliable.",
                     "G68.2 P2 Q1 X0 Y0 Z0 (then) G00 X10."),
      ig::diagnostic(IG_WARNING, "ISO-0426", "{0} P{1} Q{2} is programmed twice: the last one is used",
                     "Two blocks define the same part of the plane. Look for a wrong Q.",
                     "G68.2 P2 Q1 X0 Y0 Z0 (then) G68.2 P2 Q1 X10. Y0 Z0"),
      ig::diagnostic(
          IG_WARNING, "ISO-0427",
          "G68.4 without a tilted work plane: the new plane starts from the workpiece coordinates",
          "G68.4 defines a plane relative to the one in force. Without one, some controls stop with an alarm.",
          "G68.4 X0 Y0 Z0 J30."),
      ig::diagnostic(IG_ERROR, "ISO-0428",
                     "G68.3 has only some of X, Y and Z, so the plane does not change: program all or none",
                     "X, Y and Z are the origin of the plane; without them the origin is the position of the tool tip. "
                     "Positions from here on are unreliable.",
                     "G68.3 X0 Y0"),
      ig::diagnostic(IG_ERROR, "ISO-0429", "{0} P{1} Q{2}: this Q is not valid with P{1}, so the plane does not change",
                     "With P1, Q is the order of the rotations (123, 132, 213, 231, 312, 321); with P2, Q is 0 to 3; "
                     "with P3, Q is 1 or 2. Positions from here on are unreliable.",
                     "G68.2 P1 Q122 X0 Y0 Z0 I10. J20. K30."),
      ig::diagnostic(IG_ERROR, "ISO-0431", "{0} P{1}: its {2} do not define a plane, so the plane does not change",
                     "The three points are on a line, two of them are the same, a vector has length zero, or the "
                     "angles project both axes to one direction. Positions from here on are unreliable.",
                     "G68.2 P3 Q1 X0 Y0 Z0 I0 J0 K0 (then) G68.2 P3 Q2 K1."),
      ig::diagnostic(IG_ERROR, "ISO-0432",
                     "{0} P3: the vectors are at {1} degrees, not at 90 degrees, so the plane does not change",
                     "The first vector lies in the plane, and the second is perpendicular to the plane. Deviations up "
                     "to 5 degrees are corrected by turning the first vector. Positions from here on are unreliable.",
                     "G68.2 P3 Q1 X0 Y0 Z0 I1. J0 K0 (then) G68.2 P3 Q2 I1. J0 K1."),
      ig::diagnostic(IG_WARNING, "ISO-0433",
                     "G68.3: the machine's kinematics are not known, so the tool is assumed to lie along Z",
                     "The direction of the tool follows from the rotary axes and from the kinematics of the machine "
                     "(--machine FILE).",
                     "G68.3 (on a machine without MachineKinematics)"),
      ig::diagnostic(IG_WARNING, "ISO-0434",
                     "{0} while {1} is active: its levels now refer to the new plane, so program G80 first",
                     "The R level, the bottom and the initial level keep their numbers, which now mean other places. "
                     "Controls require G80 first; some stop with an alarm.",
                     "G81 X10. Y10. Z-5. R2. F100 (then) G68.2 X0 Y0 Z0 J30."),
  };

  TiltedPlane plane_;

  ig::Status build(ig::Block& b) { return plane_.build(b); }
};

const ig::Register<IsoG68p2Tilt> iso_g68p2_tilt_syntax;

}  // namespace
}  // namespace iso
