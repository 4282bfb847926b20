/// G68 and G69: the programmed coordinates are rotated in their plane about a centre, before every offset. Fanuc
/// manual, "Coordinate system rotation".
///
/// Until an axis of the plane is programmed under G90, the control rotates increments about the position of the tool.
/// That equals a rotation that takes the centre to the tool and keeps the tool's program point; the frame is this
/// rotation until then, where the dialect keeps the programmed numbers (unnamed-axis="programmed").
#include <algorithm>

#include <isogloss/cnc/cycle_codes.hpp>
#include <isogloss/cnc/modal_group.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/scale_and_mirror.hpp>
#include <isogloss/cnc/tilt_transform.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

enum class UnnamedAxis { rotated, programmed };
enum class IncrementalAngle { never, under_g91, parameter };

struct IsoG68Rotation {
  static constexpr auto spec =
      ig::syntax("IsoG68RotationSyntax", "G68/G69 coordinate rotation in the plane.")
          .after("ParameterizedFlagSyntax", "UnitModeSyntax", "PlaneSelectSyntax", "PositioningModeSyntax")
          .before("ToolHeightOffsetSyntax", "IsoLocalCoordinateOffsetSyntax", "IsoCoordinateOffsetSyntax",
                  "CannedCycleResolveSyntax", "IncrementalResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0263",
                     "{0} is not executed as a rotation in space: the coordinates are not rotated, so use G68.2"),
      ig::diagnostic(IG_ERROR, "ISO-0360",
                     "G68 without R, and the control's default angle is not known: the rotation does not change"),
      ig::diagnostic(IG_WARNING, "ISO-0361",
                     "G68 without R: the control's default of {0} degrees is assumed, so program R"),
      ig::diagnostic(IG_WARNING, "ISO-0362",
                     "R{0}: the rotation angle must be from -360 to 360 degrees, so whole turns are dropped"),
      ig::diagnostic(IG_ERROR, "ISO-0363",
                     "G68: the centre is too far away to compute the rotation, which does not change"),
      ig::diagnostic(IG_WARNING, "ISO-0364",
                     "{0} while the coordinates are rotated: cancel the rotation with G69 first"),
      ig::diagnostic(IG_ERROR, "ISO-0430", "G68 is not executed in a tilted work plane: the plane does not change"),
  };

  ig::Call g68_{{"G68"}, "X Y Z I J K R[deg]"};
  ig::Codes g69_{"G69"};
  ig::Out<ig::Symbol> term_{"TiltTransform.Term", {ig::Life::modal, "", "The code in force."}};
  ig::Xyz center_{"TiltTransform", ig::read | ig::write, {ig::Life::modal, "mm", "Centre, unrotated coordinates."}};
  ig::Out<double> angle_{"TiltTransform.R", {ig::Life::modal, "deg", "Angle in force."}};
  TiltFrame frame_{ig::read | ig::write};
  /// Raised while the frame still rotates about the tool: no axis of the plane was programmed under G90 since G68.
  ig::Signal about_tool_{"TiltTransform.~AboutTool", ig::read | ig::write | ig::wake_while, ig::Life::modal};

  ig::Xyz words_{"Parsing", ig::read | ig::write};
  CycleCalls positions_{"X Y Z", ig::read | ig::write, {"G28"}};
  ig::Codes machine_select_{{"G53"}, ig::read};
  ig::Codes changes_{{"G54", "G55", "G56", "G57", "G58", "G59"}, ig::read | ig::wake};
  ig::Call changes_with_words_{{"G27", "G28", "G29", "G30", "G52", "G54.1", "G92", "G92.1"}, "", ig::read | ig::wake};
  ig::Codes planes_{{"G17", "G18", "G19"}, ig::read | ig::wake};
  ig::Previous<ig::Symbol> plane_before_{"PlaneSelect.Term"};

  PlaneInForce plane_;
  DistanceMode distance_;
  LastProgramXyz last_;
  ScaleAndMirror scale_and_mirror_;
  ig::In<ig::Symbol> polar_{"PolarCoordinate.Term"};
  ig::Config config_{"isogloss.coordinate-system/1", ig::Need::optional, "RotationAngle_deg, RotationIsIncremental."};
  ig::Name g68_name_{"G68"}, g69_name_{"G69"}, g17_{"G17"};
  std::array<ig::Name, 3> planes_in_space_{ig::Name{"G68.2"}, ig::Name{"G68.3"}, ig::Name{"G68.4"}};

  ig::Choice<UnnamedAxis> unnamed_axis_{
      "unnamed-axis", "rotated|programmed", "rotated",
      "The coordinate of a plane axis that the first absolute block after G68 does not name: the tool position in the "
      "rotated system, or the last programmed number."};
  ig::Choice<IncrementalAngle> incremental_angle_{"incremental-angle", "never|g91|parameter", "never",
                                                  "Whether R is added to the angle in force under G91."};
  bool adds_under_g91_ =
      incremental_angle_ == IncrementalAngle::under_g91 ||
      (incremental_angle_ == IncrementalAngle::parameter && config_.number("RotationIsIncremental").value_or(0) != 0);

  ig::Status build(ig::Block& b) {
    const bool was_rotated = b.is(term_, g68_name_);
    const bool turns = b.find(g68_).has_value(), ends = b.take(g69_).has_value();
    const bool ends_last = ends && (!turns || ordinal(b, g69_.id(0)) > ordinal(b, g68_.code(0)));
    if (turns && ends)
      b.report(ig::diag("ISO-0201"), ig::Where::word(g68_.code(0)), b.text(ends_last ? g69_name_ : g68_name_));
    if (ends && !ends_last && is_tilted(b)) cancel(b);
    if (turns) rotate(b);
    if (ends_last) cancel(b);
    const bool settled = b.is_raised(about_tool_) && settle(b);
    if (was_rotated && b.is(term_, g68_name_)) warn_of_changes(b);
    return turns || ends || settled ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  enum Letter : std::size_t { X, Y, Z, I, J, K, R };  // the order of g68_

  static std::int64_t ordinal(const ig::Block& b, ig_field code) {
    ig_value v;
    return b.get(code, v) ? v.integer : 0;
  }
  std::optional<double> take_word(ig::Block& b, std::size_t letter) const {
    ig_value v;
    if (!b.take(g68_.row(0)[letter], v)) return std::nullopt;
    return v.number;
  }

  /// A word of the centre, after scaling and mirror image.
  std::optional<double> center_word(ig::Block& b, std::size_t axis) const {
    const auto word = take_word(b, axis);
    return word ? std::optional(scale_and_mirror_.axis(b, axis).position(*word)) : std::nullopt;
  }

  bool is_tilted(const ig::Block& b) const {
    return std::ranges::any_of(planes_in_space_, [&](const ig::Name& code) { return b.is(term_, code); });
  }

  void cancel(ig::Block& b) const {
    b.set(term_, g69_name_);
    for (std::size_t axis = 0; axis < 3; ++axis) b.erase(center_.id(axis));
    b.erase(angle_);
    b.erase(about_tool_);
    frame_.set(b, identity_frame);
  }

  /// Words that no rotation in the plane has are not taken, so that they are reported.
  void rotate(ig::Block& b) const {
    const auto where = ig::Where::word(g68_.code(0));
    b.take_code(g68_.codes(), 1);
    ig_value unused[3];
    const bool is_in_space = b.take_many(g68_.row(0) + I, 3, unused) != 0;  // about an axis in space
    if (is_in_space || is_tilted(b)) {
      b.take_many(g68_.row(0), 3, unused);
      take_word(b, R);
      if (is_in_space)
        b.report(ig::diag("ISO-0263"), where, b.text(g68_.name(0)));
      else
        b.report(ig::diag("ISO-0430"), where);
      return;
    }
    const PlaneAxes plane = plane_(b);
    const Mat4 before = frame_.get(b);
    const ig::Vec3 programmed = last_(b);
    const ig::Vec3 tool = mapped(before, programmed);  // without a rotation
    ig::Vec3 center;
    for (const std::size_t axis : {plane.first, plane.second})
      center[axis] = center_word(b, axis).value_or(rounded(tool[axis]));
    auto angle = angle_of(b, where);
    if (!angle) return;
    if (scale_and_mirror_.swaps_sense(b, plane)) angle = -*angle;
    const Mat4 about_center = rotation_in(plane, *angle, center, center);
    if (!is_finite(about_center)) {
      b.report(ig::diag("ISO-0363"), where);
      return;
    }
    b.set(term_, g68_name_);
    b.erase(center_.id(plane.tool));
    for (const std::size_t axis : {plane.first, plane.second}) b.set(center_.id(axis), center[axis]);
    b.set(angle_, *angle);
    if (unnamed_axis_ == UnnamedAxis::programmed) {
      b.raise(about_tool_);
      frame_.set(b, rotation_in(plane, *angle, programmed, tool));
    } else {
      frame_.set(b, about_center);
    }
  }

  std::optional<double> angle_of(ig::Block& b, ig::Where where) const {
    if (const auto r = take_word(b, R)) {
      if (std::fabs(*r) > 360) b.report(ig::diag("ISO-0362"), ig::Where::word(g68_.row(0)[R]), *r);
      const bool adds = adds_under_g91_ && distance_.is_incremental(b);
      const double angle = adds ? *r + b.get_or(angle_, 0.0) : *r;
      return std::fabs(angle) > 360 ? std::fmod(angle, 360.0) : angle;
    }
    const auto parameter = config_.number("RotationAngle_deg");
    if (parameter)
      b.report(ig::diag("ISO-0361"), where, *parameter);
    else
      b.report(ig::diag("ISO-0360"), where);
    return parameter;
  }

  /// The first block that names an axis of the plane under G90: from here on the frame rotates about the centre. An
  /// axis that the block does not name gets its last programmed number, which scaling and mirror image have still to
  /// change. G28 moves the named axes only, and G16 makes both positions from one word.
  bool settle(ig::Block& b) const {
    if (distance_.is_incremental(b) || b.find(machine_select_)) return false;
    const PlaneAxes plane = rotated_plane(b);
    const auto call = b.find(positions_);
    const ig_field* const words = call ? positions_.row(*call) : words_.ids();
    ig_value v[3];
    const std::uint32_t named = b.get_many(words, 3, v);
    const auto is_named = [&](std::size_t axis) { return (named >> axis & 1u) != 0; };
    if (!is_named(plane.first) && !is_named(plane.second)) return false;
    const ig::Vec3 programmed = scale_and_mirror_.programmed(b, last_(b));
    const ig::Vec3 center = b.get(center_).or_else({});
    const bool fills = !(call && *call == 0) && !b.has(polar_);
    for (const std::size_t axis : {plane.first, plane.second})
      if (!is_named(axis) && fills) b.set(words[axis], programmed[axis]);
    frame_.set(b, rotation_in(plane, b.get_or(angle_, 0.0), center, center));
    b.erase(about_tool_);
    return true;
  }

  /// The plane in which G68 was programmed, told by the words of its centre.
  PlaneAxes rotated_plane(const ig::Block& b) const {
    const ig::PartialVec3 center = b.get(center_);
    return !center.has(0) ? yz_plane : !center.has(1) ? zx_plane : xy_plane;
  }

  void warn_of_changes(ig::Block& b) const {
    if (const auto set = b.find(changes_))
      b.report(ig::diag("ISO-0364"), ig::Where::word(changes_.id(*set)), b.text(changes_.name(*set)));
    if (const auto code = b.find(changes_with_words_))
      b.report(ig::diag("ISO-0364"), ig::Where::word(changes_with_words_.code(*code)),
               b.text(changes_with_words_.name(*code)));
    const auto plane = b.find(planes_);
    if (plane && !b.find(g68_) && planes_.name(*plane) != b.get_or(plane_before_, static_cast<ig::Symbol>(g17_)))
      b.report(ig::diag("ISO-0364"), ig::Where::word(planes_.id(*plane)), b.text(planes_.name(*plane)));
  }
};

const ig::Register<IsoG68Rotation> iso_g68_rotation_syntax;

}  // namespace
}  // namespace iso
