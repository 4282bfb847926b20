/// TRAORI: X Y Z are positions of the tool's tip in the workpiece, wherever the rotary axes have turned it. The call
/// becomes a code that ToolCenterPointSyntax executes: G43.4, whose blocks give angles, or G43.5 where the block gives
/// a direction (A3= B3= C3=). TRAFOOF ends it.
#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/rotary_offset.hpp>
#include <isogloss/cnc/tool_kinematics.hpp>
#include <isogloss/sdk.hpp>

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensTransformation {
  static constexpr auto spec =
      ig::syntax("SiemensTransformationSyntax", "TRAORI and TRAFOOF: tool centre point control.")
          .after("ParameterizedFlagSyntax", "SiemensUnitSyntax", "PositioningModeSyntax", "SiemensFrameSyntax",
                 "SiemensRotaryWordsSyntax", "G53p1RotaryPositionSyntax")
          .before("SiemensToolOffsetSyntax", "ToolCenterPointSyntax", "SiemensPositionSyntax");

  ig::Codes on_{"TRAORI"}, off_{"TRAFOOF"};
  ig::Codes planes_{{"G17", "G18", "G19"}, ig::read};
  ig::Codes arcs_{{"G02", "G03", "CIP"}, ig::read};
  ig::Codes straights_{{"G00", "G01"}, ig::read};
  ig::Transform programmable_{"ProgrammableFrame", ig::read};
  ig::In<ig::Symbol> motion_{"MotionState.Term"};
  ig::InWhile<ig::Symbol> by_angles_{"ToolHeightCompensation.Term", "G43.4", ig::write};
  ig::InWhile<ig::Symbol> by_direction_{"ToolHeightCompensation.Term", "G43.5"};
  ig::Call tip_{{"G43.4", "G43.5"}, "H[]", ig::write};
  ig::Word h_{"Parsing.H", ig::take, ""};
  std::array<ig::Word, 3> vector_{ig::Word{"Parsing.A3", ig::take, ""}, ig::Word{"Parsing.B3", ig::take, ""},
                                  ig::Word{"Parsing.C3", ig::take, ""}};
  std::array<ig::Word, 3> direction_{ig::Word{"Parsing.I", ig::write}, ig::Word{"Parsing.J", ig::write},
                                     ig::Word{"Parsing.K", ig::write}};
  std::array<ig::Word, 3> rotary_{ig::Word{"Parsing.A", ig::read, "deg"}, ig::Word{"Parsing.B", ig::read, "deg"},
                                  ig::Word{"Parsing.C", ig::read, "deg"}};
  RotaryOffsetSection rotary_offset_{"CoordinateOffset", ig::read}, programmable_offset_{"ProgrammableFrame", ig::read};
  ig::In<ig::Symbol> frame_in_force_{"CoordinateOffset.CoordinateId"};
  ig::Out<std::int64_t> offset_id_{"ToolHeightCompensation.OffsetId"};
  ig::Field<std::int64_t> edge_{
      "ToolHeightCompensation.Edge", ig::read, {ig::Life::modal, "", "D: the cutting edge in force; 0: none."}};
  ig::In<double> offset_{"ToolHeightCompensation.Offset_mm"};
  ig::Transform frame_{"ToolHeightCompensation"};
  ig::Xyz orientation_{"ToolOrientation", ig::read | ig::write};
  ig::Field<bool> aligned_{"TiltTransform.IsAligned",
                           ig::read,
                           {ig::Life::modal, "", "G53.1 or G53.6 has put the tool upright on the plane."}};
  PlaneInForce plane_;
  ToolKinematics machine_;
  ToolCenterMode mode_;
  ig::Signal refused_{"SiemensTransformation.~Refused", ig::read | ig::write, ig::Life::modal};
  ig::Name g43_5_{"G43.5"}, g02_{"G02"}, g03_{"G03"};

  ig::Status build(ig::Block& b) {
    const bool was_on = mode_.is_on(b);
    if (b.take(off_)) {
      if (was_on) end(b);
      return ig::Status::changed;
    }
    const auto on = b.take(on_);
    if (on && !machine_) {
      if (!b.is_raised(refused_)) b.report(ig::diag("SIE-0183"), ig::Where::word(on_.id(*on)), b.text(on_.name(*on)));
      b.raise(refused_);
      return ig::Status::changed;
    }
    if (!on && !was_on) return ig::Status::unchanged;
    if (on) report_offset(b, ig::Where::word(on_.id(*on)));
    if (was_on)
      if (const auto h = b.take(h_)) b.report(ig::diag("SIE-0126"), ig::Where::word(h_.id()), std::string_view("H"));
    if (!b.has(offset_id_)) b.set(offset_id_, std::int64_t{0});
    const bool has_angles = b.has(rotary_[0]) || b.has(rotary_[1]) || b.has(rotary_[2]);
    const bool has_vector = b.has(vector_[0]) || b.has(vector_[1]) || b.has(vector_[2]);
    const bool by_vector = has_vector && take_vector(b);
    const bool is_by_vector = b.is(by_direction_, g43_5_);
    // I J K of an arc are its centre, not a direction: the angles of the tool do not change.
    const bool ends_vector = is_by_vector && (has_angles || is_arc(b));
    if (on || (by_vector ? !is_by_vector : ends_vector)) b.set_call(tip_, by_vector ? 1 : 0);
    return ig::Status::changed;
  }

 private:
  bool is_arc(const ig::Block& b) const {
    const ig::Symbol in_force = b.get_or(motion_, ig::Symbol{});
    return b.find(arcs_) || (!b.find(straights_) && (in_force == g02_ || in_force == g03_));
  }

  void report_offset(ig::Block& b, ig::Where where) const {
    if (programmable_offset_.acts_on(b, machine_)) b.report(ig::diag("SIE-0300"), where, std::string_view("TRANS"));
    if (rotary_offset_.acts_on(b, machine_))
      b.report(ig::diag("SIE-0300"), where, b.text(b.get_or(frame_in_force_, ig::Symbol{})));
  }

  /// False where the block is an arc, whose I J K are its centre. ROT and MIRROR rotate the direction as they do X Y Z.
  bool take_vector(ig::Block& b) const {
    std::array<double, 3> v{};
    for (std::size_t i = 0; i < 3; ++i) v[i] = b.take(vector_[i]).value_or(0);
    if (is_arc(b)) {
      b.report(ig::diag("SIE-0262"), ig::Where::block(),
               std::string_view("A3= B3= C3= in an arc: the tool keeps its direction"));
      return false;
    }
    ig::cnc::Mat4 m;
    if (!b.get(programmable_, m)) m = identity_frame;
    std::array<double, 3> turned{};
    for (std::size_t row = 0; row < 3; ++row)
      if (const auto axis = unit({m[4 * row], m[4 * row + 1], m[4 * row + 2]}))
        for (std::size_t i = 0; i < 3; ++i) turned[i] += v[row] * (*axis)[i];
    for (std::size_t i = 0; i < 3; ++i) b.set(direction_[i], turned[i]);
    return true;
  }

  /// The length lies along the axis of the plane again, or along the tool that CYCLE800 has set square to the plane.
  void end(ig::Block& b) const {
    const ig::PartialVec3 orientation = b.get(orientation_);
    const bool stays = b.has(aligned_) && orientation.complete();
    ig::Vec3 axis;
    axis[plane_(b).tool] = 1;
    if (stays) axis = orientation.value;
    if (!stays)
      for (std::size_t i = 0; i < 3; ++i) b.erase(orientation_.id(i));
    b.set(by_angles_, b.symbol("D" + std::to_string(b.get_or(edge_, std::int64_t{0}))));
    b.set_translation(frame_, b.get_or(offset_, 0.0) * axis);
  }
};

const ig::Register<SiemensTransformation> siemens_transformation_syntax;

}  // namespace
}  // namespace siemens
