/// CYCLE800: a swivelled plane, and the rotary axes that set the tool square to it. The call becomes the words that
/// IsoG68p2TiltSyntax (the plane) and G53p1RotaryPositionSyntax (the axes) execute.
#include <algorithm>

#include <isogloss/cnc/rotary_offset.hpp>
#include <isogloss/cnc/tilt_transform.hpp>
#include <isogloss/cnc/tool_kinematics.hpp>
#include <isogloss/cnc/whole_number.hpp>
#include <isogloss/sdk.hpp>

#include "cycles/cycle_signatures.hpp"
#include "five_axis/swivel_retract.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensSwivel {
  static constexpr auto spec = ig::syntax("SiemensSwivelSyntax", "CYCLE800 swivelled plane.")
                                   .after("SiemensUnitSyntax", "SiemensFrameSyntax", "SiemensRotaryWordsSyntax")
                                   .before("IsoG68p2TiltSyntax", "G53p1RotaryPositionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(
          IG_ERROR, "SIE-0251",
          "CYCLE800: mode {0} gives no order of axes, so the previous plane is cancelled: use 57, for example"),
      ig::diagnostic(IG_ERROR, "SIE-0252", "CYCLE800: mode {0} ({1}) is not executed: positions are not swivelled"),
      ig::diagnostic(IG_WARNING, "SIE-0253",
                     "CYCLE800: the retract before swivelling (_FR) is not executed: check that the tool is clear"),
      ig::diagnostic(IG_WARNING, "SIE-0254",
                     "CYCLE800: status {0} asks to track the tool tip or to align the tool, which is not executed"),
  };

  CycleFields call_{swivel_signature, ig::take | ig::wake};
  enum class OldFrame { deleted, kept };
  ig::Choice<OldFrame> old_frame_{"programmable-frame", "deleted|kept", "deleted",
                                  "What happens to TRANS, ROT, SCALE and MIRROR when a plane begins or ends."};
  ig::Transform programmable_{"ProgrammableFrame", ig::read | ig::write};
  ig::Field<ig::Symbol> programmable_term_{"ProgrammableFrame.Term", ig::write, {ig::Life::modal, "", ""}};
  ig::Signal uneven_{"ProgrammableFrame.~Uneven", ig::write, ig::Life::modal};
  ig::Call plane_{{"G68.2", "G68.4"}, "X Y Z I[deg] J[deg] K[deg] P[] Q[]", ig::write};
  ig::Call align_{{"G53.1"}, "P[]", ig::write};
  ig::Codes cancel_{{"G69"}, ig::write};
  ig::Field<ig::Symbol> term_{"TiltTransform.Term", ig::read | ig::write, {ig::Life::modal, "", "The code in force."}};
  std::array<ig::In<double>, 3> angles_{ig::In<double>{"MachineCoordinate.A"}, ig::In<double>{"MachineCoordinate.B"},
                                        ig::In<double>{"MachineCoordinate.C"}};
  RotaryOffsetSection rotary_offset_{"CoordinateOffset", ig::read}, programmable_offset_{"ProgrammableFrame"};
  ig::In<ig::Symbol> frame_in_force_{"CoordinateOffset.CoordinateId"};
  ToolKinematics machine_;
  SwivelRetract retract_;
  ig::Name g68_2_{"G68.2"}, g68_4_{"G68.4"};
  ig::Signal way_said_{"SiemensSwivel.~WaySaid", ig::read | ig::write, ig::Life::modal};

  ig::Status build(ig::Block& b) {
    Values v;
    if (!call_.take(b, v)) return ig::Status::unchanged;
    if (v == Values{} || v[tc].value_or(1) == 0)
      cancel(b);
    else
      swivel(b, v, ig::Where::word(call_.code().code(0)));
    return ig::Status::changed;
  }

 private:
  enum Parameter : std::size_t { fr, tc, st, mode, x0, y0, z0, angle_a, angle_b, angle_c, x1, y1, z1, dir, fr_i };
  using Values = CycleFields::Values;

  bool is_tilted(const ig::Block& b) const { return b.is(term_, g68_2_) || b.is(term_, g68_4_); }

  void cancel(ig::Block& b) const {
    end_programmable_frame(b);
    if (is_tilted(b)) b.raise(cancel_.id(0));
  }

  void end_programmable_frame(ig::Block& b) const {
    ig::cnc::Mat4 m;
    if (old_frame_ == OldFrame::kept) return;
    programmable_offset_.set(b, {});
    if (!b.get(programmable_, m)) return;
    m = identity_frame;
    b.set_transform(programmable_, m);
    b.erase(programmable_term_);
    b.erase(uneven_);
  }

  void swivel(ig::Block& b, const Values& v, ig::Where where) const {
    const auto whole_mode = whole_number(v[mode].value_or(57));
    const auto status = whole_number(v[st].value_or(0));
    if (!whole_mode || *whole_mode > 255 || !status) {
      b.report(ig::diag("SIE-0251"), where, v[mode].value_or(57));
      cancel(b);
      return;
    }
    retract(b, v, where);
    const std::int64_t way = *whole_mode / 64;
    std::array<std::size_t, 3> axes{static_cast<std::size_t>(*whole_mode % 4),
                                    static_cast<std::size_t>(*whole_mode / 4 % 4),
                                    static_cast<std::size_t>(*whole_mode / 16 % 4)};
    std::array<double, 3> turns{v[angle_a].value_or(0), v[angle_b].value_or(0), v[angle_c].value_or(0)};
    if (way == solid_angle) {  // A about Z, then B about the new Y
      axes = {3, 2, 1};
      turns[2] = 0;
    } else if (way != axis_by_axis) {
      b.report(ig::diag("SIE-0252"), where, static_cast<double>(*whole_mode),
               std::string_view(way == 2 ? "projection angles" : "angles of the rotary axes"));
      cancel(b);
      return;
    }
    if (axes[0] * axes[1] * axes[2] != 6 || axes[0] + axes[1] + axes[2] != 6) {
      b.report(ig::diag("SIE-0251"), where, static_cast<double>(*whole_mode));
      cancel(b);
      return;
    }
    if (*status / 10 % 10000 != 0) b.report(ig::diag("SIE-0254"), where, static_cast<double>(*status));
    ig::Vec3 angles;
    ig::cnc::Mat4 m = identity_frame;
    double order = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      angles[axes[i] - 1] = turns[i];
      m = product(turn_about(axes[i] - 1, turns[i]), m);
      order = order * 10 + static_cast<double>(axes[i]);
    }
    const ig::Vec3 origin = ig::Vec3{v[x0].value_or(0), v[y0].value_or(0), v[z0].value_or(0)} +
                            mapped(m, {v[x1].value_or(0), v[y1].value_or(0), v[z1].value_or(0)});
    const bool is_additive = *status % 10 == 1 && is_tilted(b);
    if (*status % 10 != 1) end_programmable_frame(b);
    const std::size_t row = is_additive ? 1 : 0;
    // A new plane replaces the previous one, which is not a fault here.
    if (!is_additive && is_tilted(b)) b.erase(term_);
    b.set_call(plane_, row);
    constexpr std::string_view names = "XYZIJK";
    const double values[] = {origin.x, origin.y, origin.z, angles.x, angles.y, angles.z};
    for (std::size_t i = 0; i < names.size(); ++i) b.set_word(plane_, row, names[i], values[i]);
    b.set_word(plane_, row, 'P', 1);
    b.set_word(plane_, row, 'Q', order);
    const double direction = v[dir].value_or(1);
    const bool is_level = !is_additive && turns[0] == 0 && turns[1] == 0 && turns[2] == 0;
    if (direction == 0 || (is_level && !machine_ && is_at_zero(b))) return;
    report_offset(b, where);
    align(b);
    b.set_word(align_, 0, 'P', direction > 0 ? 1 : 2);
  }

  /// SiemensSwivelRetractSyntax executes it. Reported once where the machine does not tell where to.
  void retract(ig::Block& b, const Values& v, ig::Where where) const {
    const double way = v[fr].value_or(0);
    if (way == 0 || retract_.prepare(b, way, v[fr_i].value_or(0)) || b.is_raised(way_said_)) return;
    b.report(ig::diag("SIE-0253"), where);
    b.raise(way_said_);
  }

  void report_offset(ig::Block& b, ig::Where where) const {
    if (programmable_offset_.acts_on(b, machine_)) b.report(ig::diag("SIE-0300"), where, std::string_view("TRANS"));
    if (rotary_offset_.acts_on(b, machine_))
      b.report(ig::diag("SIE-0300"), where, b.text(b.get_or(frame_in_force_, ig::Symbol{})));
  }

  /// Has the place of CYCLE800 in the block, so that diagnostics point there.
  void align(ig::Block& b) const {
    ig_word word{};
    b.word(call_.code().code(0), word);
    word.field = align_.code(0);
    word.value = ig::present;
    b.set_word(word);
  }

  /// True when no code has turned the rotary axes.
  bool is_at_zero(const ig::Block& b) const {
    return std::all_of(angles_.begin(), angles_.end(), [&](const auto& angle) { return b.get_or(angle, 0.0) == 0; });
  }

  static constexpr std::int64_t axis_by_axis = 0, solid_angle = 1;
};

const ig::Register<SiemensSwivel> siemens_swivel_syntax;

}  // namespace
}  // namespace siemens
