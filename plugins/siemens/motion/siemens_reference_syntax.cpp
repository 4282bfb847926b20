/// G74: to the reference point. G75: to a fixed point of the machine. Both go by rapid with the named axes only,
/// whatever code of group 1 is in force, and do not change it; no frame and no tool length applies.
#include <cmath>

#include <isogloss/cnc/axis_names.hpp>
#include <isogloss/cnc/machine_target.hpp>
#include <isogloss/cnc/motion_event.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/sdk.hpp>

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensReference {
  static constexpr auto spec = ig::syntax("SiemensReferenceSyntax", "G74 reference point, G75 fixed point.")
                                   .after("SiemensToolOffsetSyntax", "SiemensCoordinateOffsetSyntax")
                                   .before("SiemensMachineCoordinatesSyntax", "SiemensPositionSyntax",
                                           "ProgramXyzSyntax", "McXyzSyntax", "McAbcSyntax", "LinearMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "SIE-0275",
                     "the machine does not define position {0} of axis {1}: machine zero is assumed"),
      ig::diagnostic(IG_ERROR, "SIE-0276", "{0} names no axis, so nothing moves: name each axis that should move"),
      ig::diagnostic(IG_ERROR, "SIE-0277", "FP={0} is not a fixed point, so nothing moves: program FP=1 to FP=4"),
  };

  ig::Call codes_{{"G74", "G75"}, "X Y Z A[] B[] C[]"};
  std::array<ig::Word, 6> of_machine_{ig::Word{"Parsing.X1", ig::take, ""}, ig::Word{"Parsing.Y1", ig::take, ""},
                                      ig::Word{"Parsing.Z1", ig::take, ""}, ig::Word{"Parsing.A1", ig::take, ""},
                                      ig::Word{"Parsing.B1", ig::take, ""}, ig::Word{"Parsing.C1", ig::take, ""}};
  ig::Word fp_{"Parsing.FP", ig::take, "", "Which fixed point."};
  std::array<ig::Word, 3> turns_{ig::Word{"Parsing.A", ig::write, "deg"}, ig::Word{"Parsing.B", ig::write, "deg"},
                                 ig::Word{"Parsing.C", ig::write, "deg"}};
  ig::Xyz program_{"ProgramXyz", ig::write};
  ig::Xyz machine_{"MachineCoordinate", ig::read | ig::write};
  BlockMotion move_;
  LastProgramXyz last_;
  ig::Service<ig_machine_axis_1> axes_{"isogloss.machine-axis/1", ig::Need::optional, "Reference positions."};
  AxisNames names_;

  ig::Status build(ig::Block& b) {
    const auto words = b.take(codes_);
    if (!words) return ig::Status::unchanged;
    const auto where = ig::Where::word(codes_.code(words->row));
    std::uint32_t named = 0;
    for (std::size_t axis = 0; axis < axis_names.size(); ++axis) {
      const bool by_machine_name = b.take(of_machine_[axis]).has_value();
      if ((*words)[axis_names[axis]] || by_machine_name) named |= 1u << axis;
    }
    const double fixed_point = b.take(fp_).value_or(1);
    if (named == 0) {
      b.report(ig::diag("SIE-0276"), where, b.text(words->code));
      return ig::Status::changed;
    }
    if (!(fixed_point >= 1 && fixed_point <= 4) || fixed_point != std::floor(fixed_point)) {
      b.report(ig::diag("SIE-0277"), where, fixed_point);
      return ig::Status::changed;
    }
    go(b, named, words->row == 1 ? static_cast<std::uint32_t>(fixed_point) : 0, where);
    return ig::Status::changed;
  }

 private:
  static constexpr std::string_view axis_names = "XYZABC";

  /// The fixed point 1 to 4, or 0: the reference point. A machine that defines no fixed point has it at the reference
  /// position of the same number.
  std::optional<double> position(std::size_t axis, std::uint32_t fixed_point) const {
    double out = 0;
    if (fixed_point > 0)
      if (const auto own = names_.position(static_cast<std::uint32_t>(axis), IG_AXIS_FIXED_POINT_1 + fixed_point - 1))
        return own;
    const std::uint32_t which = std::max(fixed_point, 1u);
    if (!axes_ || axes_->reference(axes_->self, axis_names[axis], which, &out) == 0) return std::nullopt;
    return out;
  }

  void go(ig::Block& b, std::uint32_t named, std::uint32_t fixed_point, ig::Where where) const {
    ig::Vec3 to = machine_position(b, machine_, last_);
    for (std::size_t axis = 0; axis < axis_names.size(); ++axis) {
      if ((named >> axis & 1u) == 0) continue;
      const auto known = position(axis, fixed_point);
      if (!known)
        b.report(ig::diag("SIE-0275"), where, static_cast<double>(std::max(fixed_point, 1u)),
                 axis_names.substr(axis, 1));
      if (axis < 3)
        to[axis] = known.value_or(0);
      else
        b.set(turns_[axis - 3], known.value_or(0));
    }
    move_.rapid(b);
    if ((named & 7u) == 0) return;  // McAbcSyntax turns the rotary axes
    if (!set_machine_target(b, machine_, program_, to)) b.report(ig::diag("SIE-0212"), ig::Where::block());
  }
};

const ig::Register<SiemensReference> siemens_reference_syntax;

}  // namespace
}  // namespace siemens
