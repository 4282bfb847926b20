// The origin of the program: CYCL DEF 247 selects a preset of the table, CYCL DEF 7 shifts the datum from there. Both
// act where they are defined; an axis that cycle 7 does not name keeps its shift.
#include <charconv>

#include <isogloss/cnc/coordinate_offset.hpp>
#include <isogloss/cnc/rotary_offset.hpp>
#include <isogloss/cnc/work_origin.hpp>

#include "frames/basic_rotation.hpp"
#include "frames/datum_shift.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

enum class Order { programmed, shift_first };

struct HeidenhainCoordinateOffset {
  static constexpr auto spec =
      ig::syntax("HeidenhainCoordinateOffsetSyntax", "CYCL DEF 247 presets and CYCL DEF 7 datum shifts.")
          .after("KlartextCycleSyntax", "UnitModeSyntax", "ToolHeightOffsetSyntax")
          .before("KlartextMotionSyntax", "KlartextDrillingCycleSyntax", "ProgramXyzSyntax", "McXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "HEI-0174",
                     "preset {0} is not in the table, so it is assumed at machine zero: add it to the table"),
      ig::diagnostic(IG_ERROR, "HEI-0350",
                     "{0} has a basic rotation, which is not executed: add KlartextBasicRotationSyntax to the dialect"),
  };

  ig::Word number_{"Parsing.DATUM_PRESET", ig::wake, ""};
  DatumWords words_;
  ig::Out<ig::Symbol> id_{"CoordinateOffset.CoordinateId"};
  ig::Transform rotation_{"WorkOffsetFrame", ig::read};
  OffsetSection local_{"LocalCoordinateOffset"};
  ig::Transform local_frame_{"LocalCoordinateOffset"};
  BasicRotations rotations_;
  OffsetSection offset_{"CoordinateOffset"};
  RotaryOffsetSection rotary_{"CoordinateOffset"};
  TurnedShift turned_{"DatumShift"};
  ig::In<ig::Symbol> tilt_{"TiltTransform.Term"};
  ig::In<double> angle_{"TiltTransform.R"};
  ig::InWhile<bool> while_rotated_{"DatumShift.IsRotated"}, while_mirrored_{"DatumShift.IsMirrored"},
      while_scaled_{"DatumShift.IsScaled"};
  PlaneInForce plane_;
  ig::Choice<Order> order_{"order", "programmed|shift-first", "programmed",
                           "In which system a shift after a rotation, a mirror image or a scaling lies: the one "
                           "that these have made, or that of the preset."};
  ig::Service<ig_work_offset_1> table_{"isogloss.work-offset/1", ig::Need::required, "The presets."};
  ig::Name g68_{"G68"};

  ig::Status restart(ig::Block& b) {
    const std::string_view id = b.text(b.get_or(id_, ig::Symbol{}));
    const auto origin = id.empty() ? std::nullopt : linear_origin(table_, id);
    if (!id.empty()) turn(b, id);
    offset_.set(b, origin.value_or(ig::Vec3{}));
    local_.restore(b);
    turn_shift(b);
    check_rotation(b, id, ig::Where::block());
    return ig::Status::changed;
  }

  ig::Status build(ig::Block& b) {
    const bool selects = b.has(number_);
    if (selects) select(b);
    const bool shifts = words_.stand_in(b);
    if (shifts) shift(b);
    const bool follows = turned_.is_here(b);
    if (follows) follow(b);
    return shifts || selects || follows ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  void select(ig::Block& b) const {
    const auto where = ig::Where::word(number_.id());
    const double number = b.take(number_).value_or(0);
    std::array<char, 40> name{};
    constexpr std::string_view prefix = "DATUM_PRESET_";
    prefix.copy(name.data(), prefix.size());
    const bool is_number = number >= 0 && number < 1e9 && number == std::floor(number);
    char* const end = std::to_chars(name.data() + prefix.size(), name.data() + name.size(),
                                    is_number ? static_cast<std::int64_t>(number) : -1)
                          .ptr;
    const std::string_view id(name.data(), static_cast<std::size_t>(end - name.data()));
    const auto origin = linear_origin(table_, id);
    const ig::Symbol preset = b.symbol(id);
    if (!origin && !b.is(id_, preset)) b.report(ig::diag("HEI-0174"), where, number);
    turn(b, id);
    b.set(id_, preset);
    offset_.set(b, origin.value_or(ig::Vec3{}));
    lay(b, {});  // a preset cancels the shift
    words_.end_rotary(b);
    turned_.end(b);
    check_rotation(b, id, where);
  }

  void check_rotation(ig::Block& b, std::string_view id, ig::Where where) const {
    const ig::Vec3 angles = rotations_.angles_of(id);
    if (angles != ig::Vec3{} && rotation(b) != BasicRotations::matrix(angles))
      b.report(ig::diag("HEI-0350"), where, id);
  }

  Mat4 rotation(const ig::Block& b) const {
    Mat4 m;
    return b.get(rotation_, m) ? m : identity_frame;
  }

  /// Shows the shift along the axes of the preset, and executes it along those of the machine.
  void lay(ig::Block& b, const ig::Vec3& shift) const {
    local_.set(b, shift);
    turn_shift(b);
  }
  void turn_shift(ig::Block& b) const {
    if (const Mat4 m = rotation(b); m != identity_frame) b.set_translation(local_frame_, mapped(m, local_.get(b)));
  }

  /// KlartextRotaryStepSyntax adds the preset's angles to the words of the rotary axes.
  void turn(ig::Block& b, std::string_view id) const { rotary_.set(b, rotary_origin(table_, id).value_or(Angles{})); }

  void shift(ig::Block& b) const {
    const ig::Vec3 old = turned_.is_here(b) ? turned_.get(b) : local_.get(b);
    const ig::Vec3 now = words_.take(b, old);
    if (order_ == Order::programmed && old == ig::Vec3{}) turned_.begin(b, b.is(tilt_, g68_));
    if (now == ig::Vec3{}) turned_.end(b);
    if (turned_.is_here(b))
      turned_.set(b, now);
    else
      lay(b, now);
  }

  /// Cycles 8, 10 and 11 that precede the shift also act on the shift.
  void follow(ig::Block& b) const {
    const Mat4 rotation = turn_about(plane_(b).tool, b.get_or(angle_, 0.0));
    const ig::Vec3 to = turned_.around(b, b.is(tilt_, g68_) ? &rotation : nullptr);
    if (!turned_.is_here(b)) turned_.end(b);
    if (to != local_.get(b)) lay(b, to);
  }
};

const ig::Register<HeidenhainCoordinateOffset> heidenhain_coordinate_offset_syntax;

}  // namespace
}  // namespace heidenhain
