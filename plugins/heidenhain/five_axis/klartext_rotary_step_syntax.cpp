// A, B, C and IA, IB, IC become angles of the machine before the frame follows the rotary axes. The preset and the
// datum shift in force add their offsets between program and machine. Under M128, and in a plane to which PLANE has
// turned the axes, an increment moves the frame as a position does.
#include <isogloss/cnc/tool_kinematics.hpp>
#include <isogloss/sdk.hpp>

#include "frames/rotary_datum.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextRotaryStep {
  static constexpr auto spec =
      ig::syntax("KlartextRotaryStepSyntax", "A B C and IA IB IC become angles of the machine.")
          .after("KlartextPathSyntax")
          .before("G53p1RotaryPositionSyntax", "ToolCenterPointSyntax", "PivotTransformationSyntax",
                  "KlartextMotionSyntax", "McAbcSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0200",
                     "{0} shifts rotary axes, but planes and tool centre point control use machine angles here: check "
                     "the machine parameters"),
  };

  std::array<ig_field, 3> steps_{step("Parsing.IA"), step("Parsing.IB"), step("Parsing.IC")};
  std::array<ig::Word, 3> words_{ig::Word{"Parsing.A", ig::read | ig::write | ig::wake, "deg"},
                                 ig::Word{"Parsing.B", ig::read | ig::write | ig::wake, "deg"},
                                 ig::Word{"Parsing.C", ig::read | ig::write | ig::wake, "deg"}};
  std::array<ig::In<double>, 3> angles_{ig::In<double>{"MachineCoordinate.A"}, ig::In<double>{"MachineCoordinate.B"},
                                        ig::In<double>{"MachineCoordinate.C"}};
  RotaryDatum offset_{ig::read};
  ig::In<ig::Symbol> preset_{"CoordinateOffset.CoordinateId"};
  RotaryIncrements increments_{ig::write};
  ig::Codes of_machine_{{"G53"}, ig::read};
  ig::Call plane_{{"G68.2"}, "", ig::read | ig::wake};
  ig::Call tip_{{"G43.4"}, "", ig::read | ig::wake};
  ig::Signal is_plane_{"Parsing.~KlartextPlane", ig::read};
  ToolKinematics machine_;

  ig::Status build(ig::Block& b) const {
    const Angles offset = offset_.get(b);
    if (offset != Angles{}) shift(b, offset);
    ig_value steps[3];
    const std::uint32_t named = b.take_many(steps_.data(), 3, steps);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((named >> axis & 1u) != 0) {
        b.set(words_[axis].id(), b.get_or(angles_[axis], 0.0) + steps[axis].number);
        increments_.raise(b, axis);
      }
    return ig::Status::changed;
  }

 private:
  /// PLANE has found machine angles already, and M91 programs them.
  void shift(ig::Block& b, const Angles& offset) const {
    const bool is_plane = b.is_raised(is_plane_);
    if (b.find(plane_) || b.find(tip_) || (is_plane && has_words(b))) report(b, offset);
    if (is_plane || b.find(of_machine_)) return;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (const auto word = b.get(words_[axis]); word && offset[axis] != 0)
        b.rewrite(words_[axis].id(), *word + offset[axis]);
  }
  bool has_words(const ig::Block& b) const { return b.has(words_[0]) || b.has(words_[1]) || b.has(words_[2]); }

  void report(ig::Block& b, const Angles& offset) const {
    bool counts = false;
    for (std::size_t axis = 0; axis < 3; ++axis) counts = counts || (machine_.has(axis) && offset[axis] != 0);
    const bool is_shift = offset_.shift(b) != Angles{};
    const std::string_view cause = is_shift ? "the datum shift" : b.text(b.get_or(preset_, ig::Symbol{}));
    if (counts) b.report(ig::diag("HEI-0200"), ig::Where::block(), cause);
  }

  static ig_field step(const char* path) {
    return ig::Field<double>(path, ig::take | ig::wake, {ig::Life::word, "deg", ""}).id();
  }
};

const ig::Register<KlartextRotaryStep> klartext_rotary_step_syntax;

}  // namespace
}  // namespace heidenhain
