/// A tilted work plane as the words of G68.2, G68.3 and G68.4 define it, one block or several; and G69.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <isogloss/cnc/cycle_codes.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/tilt_transform.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

/// The one member of the syntax.
class TiltedPlane {
 public:
  ig::Status build(ig::Block& b);

 private:
  enum class OffsetChange { warning, allowed };
  enum class Unnamed { zero, tool };
  enum class Q0 { shift, origin };
  enum Row : std::size_t { anew, by_tool, inside };  // the order of tilt_

  /// By its fields: who declares an entry of the frame decides where it stands among the entries.
  class Offset {
   public:
    explicit Offset(const std::string& section)
        : x_(section + ".Offset_X"), y_(section + ".Offset_Y"), z_(section + ".Offset_Z") {}
    ig::Vec3 get(const ig::Block& b) const { return {b.get_or(x_, 0.0), b.get_or(y_, 0.0), b.get_or(z_, 0.0)}; }

   private:
    ig::In<double> x_, y_, z_;
  };

  ig::Call tilt_{{"G68.2", "G68.3", "G68.4"}, "X Y Z I[deg] J[deg] K[deg] R[deg] P[] Q[]"};
  ig::Codes g69_{"G69"};
  ig::Call rotation_{{"G68"}, "", ig::read};
  ig::Out<ig::Symbol> term_{"TiltTransform.Term", {ig::Life::modal, "", "The code in force."}};
  ig::Previous<ig::Symbol> term_before_{"TiltTransform.Term"};
  ig::Xyz origin_{"TiltTransform", ig::read | ig::write, {ig::Life::modal, "mm", "Origin of the plane, or centre."}};
  std::array<ig::Out<double>, 3> angles_{
      ig::Out<double>{"TiltTransform.I", {ig::Life::modal, "deg", "First angle of the plane."}},
      ig::Out<double>{"TiltTransform.J", {ig::Life::modal, "deg", "Second angle of the plane."}},
      ig::Out<double>{"TiltTransform.K", {ig::Life::modal, "deg", "Third angle of the plane."}}};
  ig::Out<double> turn_{"TiltTransform.R", {ig::Life::modal, "deg", "Angle in force."}};
  ig::Out<std::int64_t> p_{"TiltTransform.P", {ig::Life::modal, "", "P of the definition; absent: 0."}};
  ig::Out<std::int64_t> q_{"TiltTransform.Q", {ig::Life::modal, "", "Order of the turns under P1."}};
  ig::Out<bool> is_aligned_{"TiltTransform.IsAligned",
                            {ig::Life::modal, "", "G53.1 or G53.6 has put the tool upright on the plane."}};
  TiltFrame frame_{ig::read | ig::write};
  ig::Signal about_tool_{"TiltTransform.~AboutTool", ig::read | ig::write, ig::Life::modal};
  ig::Xyz orientation_{"ToolOrientation", ig::read | ig::write};

  /// A plane of which blocks are still to come.
  ig::Field<std::int64_t> open_p_{"TiltDefinition.P",
                                  ig::read | ig::write | ig::wake_while,
                                  {ig::Life::modal, "", "P of a plane whose definition is not finished."}};
  ig::Out<ig::Symbol> open_term_{"TiltDefinition.Term", {ig::Life::modal, "", "Its code."}};
  std::array<ig::Xyz, 4> points_{
      ig::Xyz{"TiltDefinition.Q0", ig::read | ig::write, {ig::Life::modal, "mm", "Shift of the origin."}},
      ig::Xyz{"TiltDefinition.Q1", ig::read | ig::write, {ig::Life::modal, "mm", "First point, or origin."}},
      ig::Xyz{"TiltDefinition.Q2", ig::read | ig::write, {ig::Life::modal, "mm", "Second point."}},
      ig::Xyz{"TiltDefinition.Q3", ig::read | ig::write, {ig::Life::modal, "mm", "Third point."}}};
  std::array<ig::Xyz, 2> vectors_{
      ig::Xyz{"TiltDefinition.XAxis", ig::read | ig::write, {ig::Life::modal, "", "Direction of X."}},
      ig::Xyz{"TiltDefinition.ZAxis", ig::read | ig::write, {ig::Life::modal, "", "Direction of Z."}}};
  ig::Out<double> open_turn_{"TiltDefinition.R", {ig::Life::modal, "deg", "Turn in the plane."}};

  /// What must not stand between the blocks of one plane: whatever moves, and the end of the program.
  ig::Xyz words_{"Parsing", ig::read};
  std::array<ig_field, 3> rotary_words_{ig::Word("Parsing.A", ig::read).id(), ig::Word("Parsing.B", ig::read).id(),
                                        ig::Word("Parsing.C", ig::read).id()};
  CycleCalls movers_{"", ig::read, {"G27", "G28", "G29", "G30", "G53.1", "G53.6"}};
  ig::Codes program_end_{{"M02", "M30"}, ig::read};

  ig::Codes changes_{{"G53", "G54", "G55", "G56", "G57", "G58", "G59"}, ig::read | ig::wake};
  ig::Call changes_with_words_{{"G27", "G28", "G29", "G30", "G52", "G54.1", "G92", "G92.1"}, "", ig::read | ig::wake};

  std::array<ig::In<ig::Symbol>, 3> geometry_{ig::In<ig::Symbol>{"PolarCoordinate.Term"},
                                              ig::In<ig::Symbol>{"Scaling.Term"},
                                              ig::In<ig::Symbol>{"MirrorImage.Term"}};
  ig::Xyz machine_{"MachineCoordinate", ig::read};
  std::array<ig::In<double>, 3> rotary_{ig::In<double>{"MachineCoordinate.A"}, ig::In<double>{"MachineCoordinate.B"},
                                        ig::In<double>{"MachineCoordinate.C"}};
  ig::In<double> length_{"ToolHeightCompensation.Offset_mm"};
  std::array<Offset, 3> offsets_{Offset{"LocalCoordinateOffset"}, Offset{"CoordinateOffset"},
                                 Offset{"WorkCoordinateShift"}};
  ig::In<ig::Symbol> cycle_{"CannedCycle.Term"};
  ig::Codes cycle_end_{{"G80"}, ig::read};
  LastProgramXyz last_;
  ig::Service<ig_machine_kinematics_1> kinematics_{"isogloss.machine-kinematics/1", ig::Need::optional,
                                                   "Direction of the tool, for G68.3."};
  ig::Name g68_{"G68"}, g69_name_{"G69"}, g80_{"G80"};

  ig::Choice<TurnedAxes> turns_{"roll-pitch-yaw", "fixed|turned", "fixed",
                                "P1: the rotations are about the workpiece axes, or about axes that rotate along."};
  ig::Choice<Q0> q0_{
      "q0", "shift|origin", "shift",
      "P2 Q0: X Y Z are the distance from the first point to the origin, in the plane, or the origin itself."};
  ig::Choice<Unnamed> unnamed_{"unnamed-origin", "zero|tool", "zero",
                               "An axis of the origin that G68.2 or G68.4 does not name: 0, or the tool position."};
  ig::Choice<OffsetChange> offset_change_{"offset-change", "warning|allowed", "warning",
                                          "Another work offset, or a move in machine coordinates, while a plane is "
                                          "tilted."};
  ig::IntegerOption vertical_{"vertical-axis",
                              "3",
                              {1, 3},
                              "G68.3: X of the plane is perpendicular to the tool and to this axis (1 X, 2 Y, 3 Z)."};

  static std::int64_t ordinal(const ig::Block& b, ig_field code) {
    ig_value v;
    return b.get(code, v) ? v.integer : 0;
  }
  bool is_tilted(ig::Symbol term) const {
    return term == tilt_.name(anew) || term == tilt_.name(by_tool) || term == tilt_.name(inside);
  }

  // ---- Words. One that the way of definition has no use for is left, to be reported.

  std::optional<double> take_word(ig::Block& b, std::size_t row, char letter) const;
  ig::PartialVec3 take_words(ig::Block& b, std::size_t row, std::string_view letters) const;
  void drop(ig::Block& b, std::size_t row) const;
  void take_code(ig::Block& b, std::size_t row) const;
  ig::Where at(std::size_t row, char letter = 0) const {
    return ig::Where::word(letter != 0 ? tilt_.word(row, letter) : tilt_.code(row));
  }

  /// The control would stop.
  template <class... Args>
  static void alarm(ig::Block& b, ig::DiagnosticCode diagnostic, ig::Where where, const Args&... args) {
    b.report(diagnostic, where, args...);
    b.alarm();
  }

  // ---- tilted_plane.cpp: by angles; into force, and out of it

  void define(ig::Block& b, std::size_t row) const;
  void by_angles(ig::Block& b, std::size_t row, std::int64_t p) const;
  /// 231 is Y, Z, X.
  static std::optional<std::array<std::size_t, 3>> axes_of(double order);
  ig::Vec3 origin_words(ig::Block& b, std::size_t row) const;
  void no_such_q(ig::Block& b, std::size_t row, std::int64_t p, double q) const;

  bool put_in_force(ig::Block& b, std::size_t row, const Mat4& plane) const;
  void write(ig::Block& b, std::size_t row, const ig::Vec3& at_point, std::int64_t p) const;
  void cancel(ig::Block& b) const;
  void forget_plane(ig::Block& b) const;
  /// What a rotation in the plane (G68) has not.
  void forget_tilt(ig::Block& b) const;
  /// Codes that have no place inside a plane.
  void warn_of_changes(ig::Block& b) const;

  // ---- tilted_plane_parts.cpp: points and vectors

  /// Three points (P2) or two vectors (P3), a block for each.
  void by_parts(ig::Block& b, std::size_t row, std::int64_t p) const;
  /// What is still to come, "" when nothing is.
  std::string_view missing(const ig::Block& b) const;
  void finish(ig::Block& b, std::size_t row, std::int64_t p) const;
  std::optional<Mat4> through_points(const ig::Block& b, double turn) const;
  std::optional<Mat4> along_vectors(const ig::Block& b) const;
  /// True also where there is no angle, of a vector of length zero.
  bool are_square(ig::Block& b, std::size_t row) const;
  bool moves(const ig::Block& b) const;
  void give_up(ig::Block& b) const;
  void forget_parts(ig::Block& b) const;

  // ---- tilted_plane_tool_axis.cpp: G68.3

  /// Z along the tool, X square to it and to the vertical axis. The tool stands upright from the start.
  void by_tool_axis(ig::Block& b) const;
  ig::Vec3 tool_axis(ig::Block& b, const double (&angles)[3]) const;
  /// Where the tip stands in the workpiece, which has turned with the rotary axes.
  ig::Vec3 tip(ig::Block& b, const ig::Vec3& tool, const double (&angles)[3]) const;
};

}  // namespace iso
