/// G53, G153 and SUPA: for this block no frame acts on the axis words, under G53 only the base frame; the tool length
/// does, unless D0 has cancelled it. Group 1 decides how the block moves. Distances start at the present positions of
/// the axes.
#include <isogloss/cnc/machine_target.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/sdk.hpp>

#include "frames/base_frame.hpp"
#include "modes/axis_modes.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensMachineCoordinates {
  static constexpr auto spec = ig::syntax("SiemensMachineCoordinatesSyntax", "G53/G153/SUPA: a block without frames.")
                                   .after("PositioningModeSyntax", "SiemensToolOffsetSyntax",
                                          "SiemensCoordinateOffsetSyntax", "PivotTransformationSyntax")
                                   .before("SiemensPositionSyntax", "ProgramXyzSyntax", "McXyzSyntax");

  ig::Codes codes_{"G53", "G153", "SUPA"};
  ig::Signal keeps_base_{keeps_base_signal, ig::read};
  ig::Xyz words_{"Parsing", ig::take};
  AxisModes modes_{ig::read};
  ig::Xyz program_{"ProgramXyz", ig::write};
  ig::Xyz machine_{"MachineCoordinate", ig::read | ig::write};
  ig::Transform tool_{"ToolHeightCompensation", ig::read}, pivot_{"PivotTransform", ig::read};
  DistanceMode distance_;
  LastProgramXyz last_;
  BaseFrame base_;
  ig::Name ac_{"AC"}, ic_{"IC"};

  ig::Status build(ig::Block& b) {
    const auto code = b.take(codes_);
    if (!code) return ig::Status::unchanged;
    const ig::PartialVec3 named = b.take(words_);
    if (named.mask == 0) return ig::Status::changed;
    const bool keeps_base = *code == 0 || b.is_raised(keeps_base_);
    const Mat4 base = keeps_base ? base_.get() : identity_frame;
    const bool is_plain = base == identity_frame;
    ig::Vec3 to = machine_position(b, machine_, last_);
    if (!is_plain) to = unmapped(base, to);
    const ig::Vec3 length = is_plain ? tool_length(b) : unmapped(at_origin(base, {}), tool_length(b));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!named.has(axis)) continue;
      const auto mode = modes_.get(b, axis);
      const bool is_increment = mode ? *mode == ic_ : distance_.is_incremental(b);
      to[axis] = named.value[axis] + (is_increment ? to[axis] : length[axis]);
    }
    if (!is_plain) to = rounded(mapped(base, to));
    if (!set_machine_target(b, machine_, program_, to)) b.report(ig::diag("SIE-0212"), ig::Where::block());
    return ig::Status::changed;
  }

 private:
  /// The tool length in machine coordinates. The frame holds it in coordinates of the workpiece, which a table may have
  /// swivelled.
  ig::Vec3 tool_length(const ig::Block& b) const {
    double m[16];
    if (!b.get(tool_, m)) return {};
    const ig::Vec3 v{m[12], m[13], m[14]};
    if (!b.get(pivot_, m)) return v;
    return rounded(ig::Vec3{v.x * m[0] + v.y * m[4] + v.z * m[8], v.x * m[1] + v.y * m[5] + v.z * m[9],
                            v.x * m[2] + v.y * m[6] + v.z * m[10]});
  }
};

const ig::Register<SiemensMachineCoordinates> siemens_machine_coordinates_syntax;

}  // namespace
}  // namespace siemens
