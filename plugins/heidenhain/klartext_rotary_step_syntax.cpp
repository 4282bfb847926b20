// IA, IB and IC become angles before the frame follows the rotary axes: under M128, and in a plane that PLANE has
// turned to, an increment moves the frame as a position does.
#include "rotary_offset_util.hpp"

namespace heidenhain {
namespace {

struct KlartextRotaryStep {
  static constexpr auto spec =
      ig::syntax("KlartextRotaryStepSyntax", "IA, IB and IC become positions of the rotary axes.")
          .after("KlartextPathSyntax")
          .before("G53p1RotaryPositionSyntax", "ToolCenterPointSyntax", "PivotTransformationSyntax",
                  "KlartextMotionSyntax", "McAbcSyntax");

  std::array<ig_field, 3> steps_{step("Parsing.IA"), step("Parsing.IB"), step("Parsing.IC")};
  std::array<ig_field, 3> words_{position("Parsing.A"), position("Parsing.B"), position("Parsing.C")};
  std::array<ig::In<double>, 3> angles_{ig::In<double>{"MachineCoordinate.A"}, ig::In<double>{"MachineCoordinate.B"},
                                        ig::In<double>{"MachineCoordinate.C"}};
  iso::RotaryOffsets offsets_{ig::read};

  ig::Status build(ig::Block& b) const {
    ig_value steps[3];
    const std::uint32_t named = b.host()->take_many(b.raw(), steps_.data(), 3, steps);
    const iso::Angles offset = offsets_.any(b) ? offsets_.get(b) : iso::Angles{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      if ((named >> axis & 1u) != 0)
        b.host()->set(b.raw(), words_[axis],
                      {.number = b.get_or(angles_[axis], 0.0) - offset[axis] + steps[axis].number});
    return ig::Status::changed;
  }

 private:
  static ig_field step(const char* path) {
    return ig::Field<double>(path, ig::take | ig::wake, {ig::Life::word, "deg", ""}).id();
  }
  static ig_field position(const char* path) {
    return ig::Field<double>(path, ig::write, {ig::Life::standard, "deg", ""}).id();
  }
};

const ig::Register<KlartextRotaryStep> klartext_rotary_step_syntax;

}  // namespace
}  // namespace heidenhain
