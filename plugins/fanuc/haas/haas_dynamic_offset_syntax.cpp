/// G254 of a Haas: the work offset follows a table that has turned, so that programs for 3+2 axes fit wherever the part
/// is clamped. It is a shift on the way to machine coordinates; the program's axes keep the machine's directions.
#include <isogloss/cnc/coordinate_offset.hpp>
#include <isogloss/cnc/rotary_offset.hpp>
#include <isogloss/cnc/tool_kinematics.hpp>
#include <isogloss/sdk.hpp>

namespace fanuc {

using namespace ig::cnc;

namespace {

struct HaasDynamicOffset {
  static constexpr auto spec =
      ig::syntax("HaasDynamicOffsetSyntax", "G254 and G255 of a Haas: the work offset follows the table.")
          .after("IsoLocalCoordinateOffsetSyntax", "IsoCoordinateOffsetSyntax", "WorkCoordinateShiftSyntax",
                 "RotaryOffsetSyntax")
          .before("PivotTransformationSyntax", "CannedCycleResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax",
                  "HaasCodeSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "FAN-0209",
                     "rotary axes have turned under G254: the work offset does not follow; program G255 before they "
                     "turn"),
  };

  ig::Codes codes_{"G254", "G255"};
  ig::Signal on_{"DynamicWorkOffset.~On", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  OffsetSection shift_{"DynamicWorkOffset",
                       {ig::Life::modal, "mm", "From the work offset to the place where the table has carried it."}};
  std::array<ig::In<double>, 3> work_{ig::In<double>{"CoordinateOffset.Offset_X"},
                                      ig::In<double>{"CoordinateOffset.Offset_Y"},
                                      ig::In<double>{"CoordinateOffset.Offset_Z"}};
  RotaryOffsets rotary_offsets_{ig::read};
  RotaryPosition rotary_{ig::read};
  ToolKinematics machine_;

  Angles angles_{};  ///< of the machine, at G254
  bool is_turn_reported_ = false;

  ig::Status build(ig::Block& b) {
    const auto code = b.take(codes_);
    if (code == 1) return end(b);
    if (code == 0) begin(b);
    if (!b.is_raised(on_)) return ig::Status::unchanged;
    const Angles now = rotary_.get(b).or_else({});
    if (!is_turn_reported_ && now != angles_) {
      is_turn_reported_ = true;
      b.report(ig::diag("FAN-0209"), ig::Where::block());
    }
    const ig::Vec3 to = shift(b);
    if (to == shift_.get(b) && code != 0) return ig::Status::unchanged;
    shift_.set(b, to);
    return ig::Status::changed;
  }

  ig::Status restart(ig::Block&) {
    angles_ = {};
    is_turn_reported_ = false;
    return ig::Status::unchanged;
  }

 private:
  ig::Status end(ig::Block& b) const {
    if (!b.is_raised(on_)) return ig::Status::changed;
    b.erase(on_);
    shift_.set(b, {});
    return ig::Status::changed;
  }

  void begin(ig::Block& b) {
    if (!b.is_raised(on_)) b.raise(on_);
    angles_ = rotary_.get(b).or_else({});
    is_turn_reported_ = false;
    if (!turns(b)) return;
    const auto where = ig::Where::word(codes_.id(0));
    if (!machine_)
      report(b, where, "the rotary axes of the machine are not known, so positions do not follow them");
    else if (!is_table())
      report(b, where, "the machine turns the tool too, not only the workpiece");
  }

  static void report(ig::Block& b, ig::Where where, std::string_view why) {
    b.report(ig::diag("FAN-0201"), where, std::string_view("G254"), why);
  }

  /// True when the table has left the angle at which the work offset was measured.
  bool turns(const ig::Block& b) const {
    const Angles zero = rotary_offsets_.get(b);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (std::fabs(std::remainder(angles_[axis] - zero[axis], 360)) > 1e-9) return true;
    return false;
  }
  bool is_table() const {
    for (std::size_t i = 0; i < machine_.count(); ++i)
      if (!machine_.is_table(i)) return false;
    return true;
  }

  ig::Vec3 shift(const ig::Block& b) const {
    if (!machine_ || !is_table() || !turns(b)) return {};
    const auto turned = machine_.pivot(angles_), zero = machine_.pivot(rotary_offsets_.get(b));
    if (!turned || !zero) return {};
    const ig::Vec3 work{b.get_or(work_[0], 0.0), b.get_or(work_[1], 0.0), b.get_or(work_[2], 0.0)};
    return rounded(mapped(*turned, mapped(inverse(*zero), work)) - work);
  }
};

const ig::Register<HaasDynamicOffset> haas_dynamic_offset_syntax;

}  // namespace
}  // namespace fanuc
