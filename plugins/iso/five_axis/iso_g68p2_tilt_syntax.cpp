/// G68.2, G68.3, G68.4 and G69: a tilted plane. From here on the program describes points in a system of its own, whose
/// XY plane lies anywhere in the workpiece; Z stands upright on it. Fanuc manual, "Tilted working plane command".
///
/// The plane is one entry of the frame, before the tool length and the offsets, so that arcs, cycles and everything
/// else lie in it without knowing of it. Nothing moves here, neither the tool nor the rotary axes.
#include <string>
#include <string_view>

#include <isogloss/cnc/units.hpp>
#include <isogloss/sdk.hpp>

#include <isogloss/cnc/cycle_codes.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/tilt_transform.hpp>
#include <isogloss/cnc/whole_number.hpp>

namespace iso {

using namespace ig::cnc;
namespace {

enum class OffsetChange { warning, allowed };
enum class Unnamed { zero, tool };
enum class Q0 { shift, origin };

constexpr double widest_from_square = 5;  // degrees, of the vectors of P3

/// By its fields: who declares an entry of the frame decides where it stands among the entries.
class Offset {
 public:
  explicit Offset(const std::string& section)
      : x_(section + ".Offset_X"), y_(section + ".Offset_Y"), z_(section + ".Offset_Z") {}
  ig::Vec3 get(const ig::Block& b) const { return {b.get_or(x_, 0.0), b.get_or(y_, 0.0), b.get_or(z_, 0.0)}; }

 private:
  ig::In<double> x_, y_, z_;
};

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

  ig::Status build(ig::Block& b) {
    const auto row = b.find(tilt_);
    const bool ends = b.take(g69_).has_value();
    const bool ends_last = ends && (!row || ordinal(b, g69_.id(0)) > ordinal(b, tilt_.code(*row)));
    if (row && ends)
      b.report(ig::diag("ISO-0201"), ig::Where::word(tilt_.code(*row)),
               b.text(ends_last ? g69_name_ : tilt_.name(*row)));
    const bool is_rotated_anew = ends && b.find(rotation_) && ordinal(b, rotation_.code(0)) > ordinal(b, g69_.id(0));
    if (is_rotated_anew)
      forget_tilt(b);
    else if (ends)
      cancel(b);
    const bool gives_up = b.has(open_p_) && (ends || moves(b));
    if (gives_up) give_up(b);
    if (row && ends_last)
      drop(b, *row);
    else if (row)
      define(b, *row);
    if (!row && !ends && is_tilted(b.get_or(term_before_, ig::Symbol{}))) warn_of_changes(b);
    return row || ends || gives_up ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  enum Row : std::size_t { anew, by_tool, inside };  // the order of tilt_

  static std::int64_t ordinal(const ig::Block& b, ig_field code) {
    ig_value v;
    return b.get(code, v) ? v.integer : 0;
  }
  bool is_tilted(ig::Symbol term) const {
    return term == tilt_.name(anew) || term == tilt_.name(by_tool) || term == tilt_.name(inside);
  }

  // ---- Words. One that the way of definition has no use for is left, to be reported.

  std::optional<double> take_word(ig::Block& b, std::size_t row, char letter) const {
    ig_value v;
    if (!b.take(tilt_.word(row, letter), v)) return std::nullopt;
    return v.number;
  }
  ig::PartialVec3 take_words(ig::Block& b, std::size_t row, std::string_view letters) const {
    ig::PartialVec3 out;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto word = take_word(b, row, letters[i]);
      if (!word) continue;
      out.mask |= 1u << i;
      out.value[i] = *word;
    }
    return out;
  }
  void drop(ig::Block& b, std::size_t row) const {
    take_code(b, row);
    ig_value unused[32];
    b.take_many(tilt_.row(row), static_cast<std::uint32_t>(tilt_.letters().size()), unused);
  }
  void take_code(ig::Block& b, std::size_t row) const {
    const ig_field code = tilt_.code(row);
    std::uint32_t found = 0;
    b.take_code(&code, 1, &found);
  }
  ig::Where at(std::size_t row, char letter = 0) const {
    return ig::Where::word(letter != 0 ? tilt_.word(row, letter) : tilt_.code(row));
  }

  /// The control would stop.
  template <class... Args>
  static void alarm(ig::Block& b, ig::DiagnosticCode diagnostic, ig::Where where, const Args&... args) {
    b.report(diagnostic, where, args...);
    b.alarm();
  }

  // ---- The ways to define a plane

  void define(ig::Block& b, std::size_t row) const {
    take_code(b, row);
    const auto cycle = b.get(cycle_);
    if (cycle && *cycle != g80_ && !b.find(cycle_end_))
      b.report(ig::diag("ISO-0434"), at(row), b.text(tilt_.name(row)), b.text(*cycle));
    for (const auto& term : geometry_)
      if (const auto code = b.get(term))
        b.report(ig::diag("ISO-0383"), at(row), b.text(tilt_.name(row)), b.text(*code));
    const auto p_word = row == by_tool ? std::nullopt : take_word(b, row, 'P');
    const auto p = whole_number(p_word.value_or(0));
    if (!p || *p > 4) {
      alarm(b, ig::diag("ISO-0421"), at(row, 'P'), b.text(tilt_.name(row)), *p_word);
      drop(b, row);
      return;
    }
    if (b.has(open_p_) && (b.get(open_p_) != p || !b.is(open_term_, tilt_.name(row)))) give_up(b);
    if (row == by_tool)
      by_tool_axis(b);
    else if (*p == 2 || *p == 3)
      by_parts(b, row, *p);
    else
      by_angles(b, row, *p);
  }

  void by_angles(ig::Block& b, std::size_t row, std::int64_t p) const {
    double order = 123;
    if (p == 1) order = take_word(b, row, 'Q').value_or(order);
    const auto axes = axes_of(order);
    if (!axes) {
      no_such_q(b, row, p, order);
      return;
    }
    const ig::Vec3 angles = take_words(b, row, "IJK").or_else({});
    const ig::Vec3 at_point = origin_words(b, row);
    const auto turned = p == 0   ? euler_zxz(angles)
                        : p == 1 ? roll_pitch_yaw(angles, *axes, turns_)
                                 : from_projections(angles);
    if (!turned) {
      alarm(b, ig::diag("ISO-0431"), at(row), b.text(tilt_.name(row)), static_cast<double>(p),
            std::string_view("angles"));
      return;
    }
    if (!put_in_force(b, row, at_origin(*turned, at_point))) return;
    write(b, row, at_point, p);
    for (std::size_t i = 0; i < 3; ++i) b.set(angles_[i], angles[i]);
    if (p == 1) b.set(q_, static_cast<std::int64_t>(order));
  }

  /// 231 is Y, Z, X.
  static std::optional<std::array<std::size_t, 3>> axes_of(double order) {
    constexpr std::array orders{123, 132, 213, 231, 312, 321};
    for (const int known : orders) {
      if (order != known) continue;
      const auto digit = [known](int by) { return static_cast<std::size_t>(known / by % 10 - 1); };
      return std::array{digit(100), digit(10), digit(1)};
    }
    return std::nullopt;
  }

  ig::Vec3 origin_words(ig::Block& b, std::size_t row) const {
    const ig::PartialVec3 named = take_words(b, row, "XYZ");
    if (unnamed_ == Unnamed::zero || named.complete()) return named.or_else({});
    const ig::Vec3 here = last_(b);
    return named.or_else(row == inside ? here : rounded(mapped(frame_.get(b), here)));
  }

  /// Three points (P2) or two vectors (P3), a block for each.
  void by_parts(ig::Block& b, std::size_t row, std::int64_t p) const {
    const auto q_word = take_word(b, row, 'Q');
    const auto q = whole_number(q_word.value_or(0));
    if (!q || *q > (p == 2 ? 3 : 2) || (p == 3 && *q == 0)) {
      no_such_q(b, row, p, q_word.value_or(0));
      return;
    }
    const auto part = static_cast<std::size_t>(*q);
    const ig::Xyz& known = p == 2 ? points_[part] : vectors_[part - 1];
    if (b.get(known).complete())
      b.report(ig::diag("ISO-0426"), at(row), b.text(tilt_.name(row)), static_cast<double>(p), static_cast<double>(*q));
    b.set(open_p_, p);
    b.set(open_term_, tilt_.name(row));
    if (p == 3 && part == 1) b.set(points_[1], origin_words(b, row));
    b.set(known, take_words(b, row, p == 2 ? "XYZ" : "IJK").or_else({}));
    if (p == 2 && part == 0)
      if (const auto turn = take_word(b, row, 'R')) b.set(open_turn_, *turn);
    if (missing(b).empty()) finish(b, row, p);
  }

  /// What is still to come, "" when nothing is.
  std::string_view missing(const ig::Block& b) const {
    if (b.get_or(open_p_, std::int64_t{0}) == 2) {
      if (!b.get(points_[1]).complete()) return "Q1";
      if (!b.get(points_[2]).complete()) return "Q2";
      return b.get(points_[3]).complete() ? "" : "Q3";
    }
    if (!b.get(vectors_[0]).complete()) return "Q1";
    return b.get(vectors_[1]).complete() ? "" : "Q2";
  }

  void finish(ig::Block& b, std::size_t row, std::int64_t p) const {
    const double turn = b.get_or(open_turn_, 0.0);
    const bool is_turned = b.has(open_turn_);
    const bool is_square = p == 2 || are_square(b, row);
    const auto plane = p == 2 ? through_points(b, turn) : along_vectors(b);
    forget_parts(b);
    if (!is_square) return;
    if (!plane) {
      alarm(b, ig::diag("ISO-0431"), at(row), b.text(tilt_.name(row)), static_cast<double>(p),
            std::string_view(p == 2 ? "points" : "vectors"));
      return;
    }
    if (!put_in_force(b, row, *plane)) return;
    write(b, row, origin(*plane), p);
    if (is_turned) b.set(turn_, turn);
  }

  std::optional<Mat4> through_points(const ig::Block& b, double turn) const {
    const ig::Vec3 first = b.get(points_[1]).value, shift = b.get(points_[0]).or_else({});
    const auto plane = from_x_and_side(b.get(points_[2]).value - first, b.get(points_[3]).value - first);
    if (!plane) return std::nullopt;
    const bool is_origin = q0_ == Q0::origin && b.get(points_[0]).complete();
    if (is_origin) return at_origin(product(turn_about(2, turn), *plane), shift);
    return product(at_origin(turn_about(2, turn), shift), at_origin(*plane, first));
  }

  std::optional<Mat4> along_vectors(const ig::Block& b) const {
    const auto plane = from_z_and_x(b.get(vectors_[1]).value, b.get(vectors_[0]).value);
    return plane ? std::optional(at_origin(*plane, b.get(points_[1]).or_else({}))) : std::nullopt;
  }
  /// True also where an angle cannot be said.
  bool are_square(ig::Block& b, std::size_t row) const {
    const auto x = unit(b.get(vectors_[0]).value), z = unit(b.get(vectors_[1]).value);
    if (!x || !z) return true;
    const double angle = std::acos(std::clamp(scalar_product(*x, *z), -1.0, 1.0)) * degrees_per_radian;
    constexpr double rounding = 1e-9;
    if (std::fabs(angle - 90) <= widest_from_square + rounding) return true;
    alarm(b, ig::diag("ISO-0432"), at(row), b.text(tilt_.name(row)), angle);
    return false;
  }

  /// G68.3: Z along the tool, X square to it and to the vertical axis. The tool stands upright from the start.
  void by_tool_axis(ig::Block& b) const {
    const ig::PartialVec3 named = take_words(b, by_tool, "XYZ");
    const auto turn = take_word(b, by_tool, 'R');
    if (named.mask != 0 && !named.complete()) {
      alarm(b, ig::diag("ISO-0428"), at(by_tool));
      return;
    }
    const double angles[3] = {b.get_or(rotary_[0], 0.0), b.get_or(rotary_[1], 0.0), b.get_or(rotary_[2], 0.0)};
    const ig::Vec3 tool = tool_axis(b, angles);
    const auto up = static_cast<std::size_t>(vertical_ - 1);
    ig::Vec3 vertical, beside;
    vertical[up] = beside[(up + 1) % 3] = 1;
    const ig::Vec3 x = vector_product(vertical, tool);
    constexpr double parallel = 1e-9;
    const auto plane = from_z_and_x(tool, std::sqrt(scalar_product(x, x)) > parallel ? x : beside);
    if (!plane) return;  // a tool axis has a direction
    const ig::Vec3 at_point = named.complete() ? named.value : tip(b, tool, angles);
    if (!put_in_force(b, by_tool, at_origin(product(turn_about(2, turn.value_or(0)), *plane), at_point))) return;
    write(b, by_tool, at_point, 0);
    if (turn) b.set(turn_, *turn);
    b.set(is_aligned_, true);
    b.set(orientation_, tool);
  }

  ig::Vec3 tool_axis(ig::Block& b, const double (&angles)[3]) const {
    double t[3];
    if (kinematics_ && kinematics_->tool_axis(kinematics_->self, angles, t) != 0) return {t[0], t[1], t[2]};
    const ig::PartialVec3 orientation = b.get(orientation_);
    if (orientation.complete() && unit(orientation.value)) return orientation.value;
    b.report(ig::diag("ISO-0433"), at(by_tool));
    return {0, 0, 1};
  }

  /// Where the tip stands in the workpiece, which has turned with the rotary axes.
  ig::Vec3 tip(ig::Block& b, const ig::Vec3& tool, const double (&angles)[3]) const {
    const ig::PartialVec3 machine = b.get(machine_);
    Mat4 pivot;
    if (!machine.complete()) return rounded(mapped(frame_.get(b), last_(b)));
    if (!kinematics_ || kinematics_->pivot(kinematics_->self, angles, pivot.data()) == 0) pivot = identity_frame;
    ig::Vec3 point = mapped(inverse(pivot), machine.value) - b.get_or(length_, 0.0) * tool;
    for (const Offset& offset : offsets_) point = point - offset.get(b);
    return rounded(point);
  }

  void no_such_q(ig::Block& b, std::size_t row, std::int64_t p, double q) const {
    alarm(b, ig::diag("ISO-0429"), at(row, 'Q'), b.text(tilt_.name(row)), static_cast<double>(p), q);
    drop(b, row);
  }

  // ---- Into force, and out of it

  bool put_in_force(ig::Block& b, std::size_t row, const Mat4& plane) const {
    const ig::Symbol before = b.get_or(term_, ig::Symbol{});
    const bool replaces = is_tilted(before) || before == g68_;
    const Mat4 m = row == inside ? product(plane, frame_.get(b)) : plane;
    if (!is_finite(m)) {
      alarm(b, ig::diag("ISO-0423"), at(row), b.text(tilt_.name(row)));
      return false;
    }
    if (row == inside && !replaces) b.report(ig::diag("ISO-0427"), at(row));
    if (row != inside && replaces) b.report(ig::diag("ISO-0422"), at(row), b.text(tilt_.name(row)), b.text(before));
    forget_plane(b);
    frame_.set(b, m);
    return true;
  }

  void write(ig::Block& b, std::size_t row, const ig::Vec3& at_point, std::int64_t p) const {
    b.set(term_, tilt_.name(row));
    b.set(origin_, at_point);
    if (p != 0) b.set(p_, p);
  }

  void cancel(ig::Block& b) const {
    forget_plane(b);
    b.set(term_, g69_name_);
    frame_.set(b, identity_frame);
  }

  void forget_plane(ig::Block& b) const {
    forget_tilt(b);
    for (std::size_t axis = 0; axis < 3; ++axis) b.erase(origin_.id(axis));
    b.erase(turn_);
    b.erase(about_tool_);
  }
  /// What a rotation in the plane (G68) has not.
  void forget_tilt(ig::Block& b) const {
    if (b.get_or(is_aligned_, false))
      for (std::size_t axis = 0; axis < 3; ++axis) b.erase(orientation_.id(axis));
    for (const auto& angle : angles_) b.erase(angle);
    b.erase(p_);
    b.erase(q_);
    b.erase(is_aligned_);
  }

  // ---- Unfinished definitions, and what has no place inside a plane

  bool moves(const ig::Block& b) const {
    ig_value unused[3];
    return b.find(movers_) || b.find(program_end_) || b.get_many(words_.ids(), 3, unused) != 0 ||
           b.get_many(rotary_words_.data(), 3, unused) != 0;
  }

  void give_up(ig::Block& b) const {
    alarm(b, ig::diag("ISO-0425"), ig::Where::block(), b.text(b.get_or(open_term_, ig::Symbol{})),
          static_cast<double>(b.get_or(open_p_, std::int64_t{0})), missing(b));
    forget_parts(b);
  }

  void forget_parts(ig::Block& b) const {
    b.erase(open_p_);
    b.erase(open_term_);
    b.erase(open_turn_);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const ig::Xyz& point : points_) b.erase(point.id(axis));
      for (const ig::Xyz& vector : vectors_) b.erase(vector.id(axis));
    }
  }

  void warn_of_changes(ig::Block& b) const {
    if (offset_change_ == OffsetChange::allowed) return;
    if (const auto set = b.find(changes_))
      b.report(ig::diag("ISO-0424"), ig::Where::word(changes_.id(*set)), b.text(changes_.name(*set)));
    if (const auto code = b.find(changes_with_words_))
      b.report(ig::diag("ISO-0424"), ig::Where::word(changes_with_words_.code(*code)),
               b.text(changes_with_words_.name(*code)));
  }
};

const ig::Register<IsoG68p2Tilt> iso_g68p2_tilt_syntax;

}  // namespace
}  // namespace iso
