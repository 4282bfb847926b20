// Cycles 7 and 10 in a tilted plane: they shift and rotate the plane's own coordinates. One frame inside that of the
// plane holds both.
#include "frames/datum_shift.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextPlaneFrame {
  static constexpr auto spec =
      ig::syntax("KlartextPlaneFrameSyntax", "CYCL DEF 7 and CYCL DEF 10 in a tilted plane.")
          .after("KlartextFrameCycleSyntax", "PlaneSelectSyntax")
          .before("IsoG68RotationSyntax", "IsoG68p2TiltSyntax", "HeidenhainCoordinateOffsetSyntax",
                  "KlartextPoleSyntax", "ProgramXyzSyntax", "McXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "HEI-0191",
                     "{0} comes while a datum shift or rotation of the previous plane is active: both stay active"),
  };

  DatumWords words_;
  TurnedShift shift_{"PlaneFrame"};
  ig::Word turn_{"Parsing.PLANE_ROTATION", ig::take | ig::wake, "deg", "Rotation in the plane (cycle 10)."};
  ig::Field<double> preset_{"Parsing.DATUM_PRESET", ig::read | ig::wake, {ig::Life::word, "", ""}};
  ig::Call planes_{{"G68.2"}, "", ig::read | ig::wake};
  ig::Codes end_{{"G69"}, ig::read | ig::wake};
  ig::Out<double> angle_{"PlaneFrame.R", {ig::Life::modal, "deg", "Rotation in the plane."}};
  ig::Transform frame_{"PlaneFrame", ig::read | ig::write};
  ig::In<ig::Symbol> tilt_{"TiltTransform.Term"};
  ig::Signal acts_{"PlaneFrame.~Acts", ig::write | ig::wake_while, ig::Life::modal};
  PlaneInForce plane_;
  ig::Name g68_2_{"G68.2"};

  ig::Status build(ig::Block& b) {
    const bool is_tilted = b.is(tilt_, g68_2_);
    if (acts(b) && b.has(preset_)) return end(b);
    const bool is_new = b.find(planes_).has_value();
    bool any = is_tilted && (is_new || b.find(end_)) && leave(b, is_new ? "a new plane" : "the end of the plane");
    if (const auto angle = b.take(turn_)) {
      if (*angle == 0)
        b.erase(angle_);
      else
        b.set(angle_, *angle);
      any = true;
    }
    const bool shifts = words_.stand_in(b) && (is_tilted ? begins(b) || shift_.was_set(b) : is_shifted(b));
    if (shifts && is_tilted) shift(b);
    if (shifts && !is_tilted) shift_.end(b);  // HeidenhainCoordinateOffsetSyntax takes the words
    if (!shifts && !any && !acts(b)) return ig::Status::unchanged;
    lay(b);
    return ig::Status::changed;
  }

 private:
  bool acts(const ig::Block& b) const { return b.has(angle_) || is_shifted(b); }
  bool is_shifted(const ig::Block& b) const { return shift_.get(b) != ig::Vec3{}; }

  /// Ends a shift of zeros; true when there was one. Reports, with `how`, a shift or rotation that has an effect.
  bool leave(ig::Block& b, std::string_view how) const {
    if (acts(b)) {
      b.report(ig::diag("HEI-0191"), ig::Where::block(), how);
      return false;
    }
    const bool was_set = shift_.was_set(b);
    if (was_set) shift_.end(b);
    return was_set;
  }

  /// Zeros alone end the shift from before the plane; they are not for this syntax.
  bool begins(const ig::Block& b) const {
    for (const ig::Xyz* named : {&absolute_, &steps_}) {
      const ig::PartialVec3 v = b.get(*named);
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (v.has(axis) && v.value[axis] != 0) return true;
    }
    return false;
  }

  void shift(ig::Block& b) const {
    const bool is_first = !is_shifted(b);
    const ig::Vec3 now = words_.take(b, shift_.get(b));
    if (is_first) shift_.begin(b, b.has(angle_));
    shift_.set(b, now);
    if (now == ig::Vec3{}) shift_.forget(b);
  }

  void lay(ig::Block& b) const {
    const double angle = b.get_or(angle_, 0.0);
    const Mat4 turn = turn_about(plane_(b).tool, angle);
    const Mat4 frame = at_origin(turn, shift_.around(b, angle != 0 ? &turn : nullptr));
    Mat4 old;
    if (!b.get(frame_, old) || old != frame) b.set_transform(frame_, frame);
    if (acts(b))
      b.raise(acts_);
    else
      b.erase(acts_);
  }

  ig::Status end(ig::Block& b) const {
    shift_.end(b);
    b.erase(angle_);
    lay(b);
    return ig::Status::changed;
  }

  ig::Xyz absolute_{"Parsing.DATUM", ig::read}, steps_{"Parsing.IDATUM", ig::read};
};

const ig::Register<KlartextPlaneFrame> klartext_plane_frame_syntax;

}  // namespace
}  // namespace heidenhain
