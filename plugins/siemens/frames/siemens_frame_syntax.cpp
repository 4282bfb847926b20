/// TRANS, ROT, SCALE, MIRROR and their additive forms: the programmable frame. TRANS, ROT, SCALE and MIRROR replace the
/// whole frame, including what the others of them have set; ATRANS, AROT, ASCALE and AMIRROR act within the frame in
/// force.
#include <isogloss/cnc/rotary_offset.hpp>
#include <isogloss/cnc/tilt_transform.hpp>
#include <isogloss/cnc/tool_kinematics.hpp>
#include <isogloss/sdk.hpp>

#include "frames/assigned_frame.hpp"
#include "frames/frame_shape.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensFrame {
  static constexpr auto spec =
      ig::syntax("SiemensFrameSyntax",
                 "TRANS, ROT, SCALE, MIRROR, ATRANS, AROT, ASCALE, AMIRROR: the programmable frame.")
          .after("SiemensUnitSyntax", "PlaneSelectSyntax")
          .before("SiemensSwivelSyntax", "SiemensToolOffsetSyntax", "SiemensPositionSyntax", "ProgramXyzSyntax",
                  "McXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(
          IG_ERROR, "SIE-0241",
          "{0}: the scale {1} is not greater than 0, so the frame does not change; use MIRROR to reverse an axis"),
      ig::diagnostic(IG_ERROR, "SIE-0242",
                     "{0} would make the frame too large or too small, so it does not change: check scales and shifts"),
      ig::diagnostic(IG_ERROR, "SIE-0243",
                     "{0} is the second frame instruction of this block: give it a block of its own"),
      ig::diagnostic(IG_WARNING, "SIE-0244", "RPL= is ignored beside axes: program the axes or RPL=, not both"),
      ig::diagnostic(IG_ERROR, "SIE-0245",
                     "G41 or G42 under unequal scales: the tool is not beside the contour; scale all axes alike"),
  };

  ig::Call trans_{{"TRANS", "ATRANS"}, "X Y Z A[deg] B[deg] C[deg]"};
  ig::Call rot_{{"ROT", "AROT"}, "X[deg] Y[deg] Z[deg] A[deg] B[deg] C[deg]"};
  ig::Call scale_{{"SCALE", "ASCALE"}, "X[] Y[] Z[] A[] B[] C[]"};
  ig::Call mirror_{{"MIRROR", "AMIRROR"}, "X[] Y[] Z[] A[] B[] C[]"};
  ig::Word rpl_{"Parsing.RPL", ig::take, "deg", "Turn about the normal of the plane."};
  AssignedFrame assigned_{ig::read | ig::wake};
  ig::In<ig::Symbol> unit_{"Unit.Term"};
  ig::Out<ig::Symbol> term_{"ProgrammableFrame.Term", {ig::Life::modal, "", "The instruction that was last."}};
  ig::Signal uneven_{"ProgrammableFrame.~Uneven", ig::read | ig::write, ig::Life::modal};
  ig::InWhile<ig::Symbol> left_{"RadiusCompensation.Term", "G41"}, right_{"RadiusCompensation.Term", "G42"};
  ig::Signal compensation_said_{"ProgrammableFrame.~CompensationSaid", ig::read | ig::write | ig::wake_while,
                                ig::Life::modal};
  ig::Transform frame_{"ProgrammableFrame", ig::read | ig::write};
  /// Tells `isogloss explain` that the frame of this block acts within the one before it.
  ig::Signal adds_{"ProgrammableFrame.~Adds", ig::read | ig::write};
  RotaryOffsetSection rotary_{"ProgrammableFrame"};
  ToolCenterMode tip_control_;
  ig::Field<bool> aligned_{"TiltTransform.IsAligned",
                           ig::read,
                           {ig::Life::modal, "", "G53.1 or G53.6 has put the tool upright on the plane."}};
  ToolKinematics machine_;
  PlaneInForce plane_;
  ig::Name g41_{"G41"}, g42_{"G42"}, g700_{"G700"};

  ig::Status build(ig::Block& b) {
    bool any = false;
    std::uint32_t seen = 0;
    if (const auto frame = assigned_.get(b)) {  // first, since what SAVE gives back stood before this block
      assign(b, *frame);
      any = true;
    }
    for (const ig::Call* call : {&trans_, &rot_, &scale_, &mirror_})
      if (const auto words = b.take(*call)) {
        if (++seen > 1) b.report(ig::diag("SIE-0243"), ig::Where::word(call->code(words->row)), b.text(words->code));
        change(b, *call, *words);
        any = true;
      }
    return report_uneven_compensation(b) || any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  /// Reports such a frame once each time that G41 or G42 becomes active in it.
  bool report_uneven_compensation(ig::Block& b) const {
    const bool is_wrong =
        b.is_raised(uneven_) && (b.is(left_, g41_) || b.is(right_, g42_)) && !keeps_circles(present(b), plane_(b));
    if (is_wrong == b.is_raised(compensation_said_)) return false;
    if (is_wrong) {
      b.report(ig::diag("SIE-0245"), ig::Where::block());
      b.raise(compensation_said_);
    } else {
      b.erase(compensation_said_);
    }
    return true;
  }

  void change(ig::Block& b, const ig::Call& call, const ig::Words& words) const {
    const auto where = ig::Where::word(call.code(words.row));
    if (&call != &trans_ && (words['A'] || words['B'] || words['C']))
      b.report(ig::diag("SIE-0261"), where, b.text(words.code),
               std::string_view("rotary axes are only shifted, by TRANS"));
    Mat4 m = identity_frame;
    if (&call == &trans_) m = at_origin(m, {words['X'].value_or(0), words['Y'].value_or(0), words['Z'].value_or(0)});
    if (&call == &rot_) m = rotation(b, words, where);
    if (&call == &scale_ || &call == &mirror_) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto word = words["XYZ"[axis]];
        if (!word) continue;
        if (&call == &scale_ && !(*word > 0)) {
          b.report(ig::diag("SIE-0241"), where, b.text(words.code), *word);
          return;
        }
        m[5 * axis] = &call == &scale_ ? *word : -1;
      }
    }
    const bool is_additive = words.row == 1;
    if (is_additive) m = product(m, present(b));
    Angles shift = is_additive ? rotary_.get(b).or_else({}) : Angles{};
    for (std::size_t axis = 0; &call == &trans_ && axis < 3; ++axis)
      shift[axis] += words[rotary_names[axis]].value_or(0);
    if (is_additive) b.raise(adds_);
    put(b, words.code, where, m, shift);
  }

  /// $P_PFRAME=CTRANS(X,10):CROT(Z,30) replaces the whole frame.
  void assign(ig::Block& b, const FrameValue& frame) const {
    const double mm = b.is(unit_, g700_) ? mm_per_inch : 1;
    const ig::Vec3 coarse{frame.shift[0], frame.shift[1], frame.shift[2]};
    put(b, b.symbol("$P_PFRAME"), ig::Where::block(),
        at_origin(frame.shape.matrix(), mm * (coarse + frame.shape[ShapePart::fine])),
        {frame.shift[3], frame.shift[4], frame.shift[5]});
  }

  /// `rotary` is the part of the frame that SiemensRotaryWordsSyntax adds to A, B and C.
  void put(ig::Block& b, ig::Symbol name, ig::Where where, const Mat4& m, const Angles& rotary) const {
    bool is_fit = is_sound(m);
    for (const double degrees : rotary) is_fit &= std::fabs(degrees) < 1e9;
    if (!is_fit) {
      b.report(ig::diag("SIE-0242"), where, b.text(name));
      return;
    }
    const bool is_shifted = rotary_.set(b, rotary);
    if (is_shifted && (tip_control_.is_on(b) || b.has(aligned_)) && rotary_.acts_on(b, machine_))
      b.report(ig::diag("SIE-0300"), where, b.text(name));
    b.set_transform(frame_, m);
    b.set(term_, name);
    if (keeps_circles(m, xy_plane) && keeps_circles(m, zx_plane))
      b.erase(uneven_);
    else
      b.raise(uneven_);
  }

  Mat4 present(const ig::Block& b) const {
    Mat4 m;
    return b.get(frame_, m) ? m : identity_frame;
  }

  /// The rotation about Z, then about the new Y, then about the new X. With row vectors, X is applied first.
  Mat4 rotation(ig::Block& b, const ig::Words& words, ig::Where where) const {
    const auto rpl = b.take(rpl_);
    const bool has_axes = words['X'] || words['Y'] || words['Z'];
    if (rpl && has_axes) b.report(ig::diag("SIE-0244"), where);
    if (rpl && !has_axes) return turn_about(plane_(b).tool, *rpl);
    return roll_pitch_yaw({words['X'].value_or(0), words['Y'].value_or(0), words['Z'].value_or(0)}, {0, 1, 2},
                          TurnedAxes::fixed);
  }

  /// True for a finite matrix that has an inverse.
  static bool is_sound(const Mat4& m) {
    constexpr double least = 1e-9, most = 1e9;
    for (const double element : m)
      if (!(std::fabs(element) < 1e12)) return false;
    for (std::size_t row = 0; row < 3; ++row)
      if (!(length(axis_of(m, row)) > least && length(axis_of(m, row)) < most)) return false;
    return true;
  }
};

const ig::Register<SiemensFrame> siemens_frame_syntax;

}  // namespace
}  // namespace siemens
