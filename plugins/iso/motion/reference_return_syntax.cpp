/// G28 and G30: a rapid to the intermediate point that the words name, then to a reference position of the machine,
/// both with the named axes only. `G91 G28 Z0` goes straight up; `G90 G28 Z0` goes to program Z0 first, as on the
/// control. Fanuc manual, "Reference position".
#include "motion/reference_position.hpp"
#include "tool/untravelled_length.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

enum class WithoutAxes { nothing, all };
enum class ToolLength { keep, cancel };

struct ReferenceReturn {
  static constexpr auto spec =
      ig::syntax("ReferenceReturnSyntax", "G28 and G30 return to a reference position.")
          .after("IncrementalResolveSyntax", "McXyzSyntax", "LinearMotionSyntax", "PivotTransformationSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0380",
                     "G30 P{0}: there is no such reference position, so nothing moves: P must be 2, 3 or 4"),
  };

  ig::Call g28_{{"G28"}, "X Y Z A B C"};
  ig::Call g30_{{"G30"}, "X Y Z A B C P[]"};
  ReferenceMove move_;
  LastProgramXyz last_;
  ReferencePositions reference_;
  ig::Choice<WithoutAxes> without_axes_{"without-axes", "nothing|all", "nothing",
                                        "Which axes a G28 or G30 without an axis word returns."};

  ig::Choice<ToolLength> tool_length_{"tool-length", "keep|cancel", "keep",
                                      "Whether G28 ends G43 and G44 when the axes have arrived."};
  ig::Out<ig::Symbol> compensation_{"ToolHeightCompensation.Term"};
  ig::Field<double> offset_{"ToolHeightCompensation.Offset_mm", ig::read | ig::write};
  ig::Field<double> untravelled_ = untravelled_length(ig::read | ig::write);
  ig::Transform frame_{"ToolHeightCompensation", ig::read | ig::write};
  std::array<FurtherAxisOrder, 4> further_{FurtherAxisOrder{"R1"}, FurtherAxisOrder{"R2"}, FurtherAxisOrder{"R3"},
                                           FurtherAxisOrder{"R4"}};
  FurtherAxisOrder drop_further_{"Nothing"};
  ig::Name g43_{"G43"}, g44_{"G44"}, g49_{"G49"};
  TurnedFrame turned_frame_;

  ig::Status build(ig::Block& b) {
    bool any = false;
    if (const auto words = b.take(g28_)) {
      any = true;
      if (go(b, *words, g28_, 1) && tool_length_ == ToolLength::cancel) end_compensation(b);
    }
    if (const auto words = b.take(g30_)) {
      const double which = (*words)['P'].value_or(2);
      if (which == 2 || which == 3 || which == 4)
        go(b, *words, g30_, static_cast<std::uint32_t>(which));
      else
        refuse(b, which);
      any = true;
    }
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  void refuse(ig::Block& b, double which) const {
    b.report(ig::diag("ISO-0380"), ig::Where::word(g30_.code(0)), which);
    drop_further_.give(b);
  }

  /// True when the axes have reached the reference position.
  bool go(ig::Block& b, const ig::Words& words, const ig::Call& call, std::uint32_t which) const {
    const ig_field code = call.code(0);
    const ig::Vec3 from = last_(b);
    const bool returns_all =
        without_axes_ == WithoutAxes::all && !ReferenceMove::names_axes(words) && !move_.names_further(b);
    if (returns_all || move_.names_further(b)) further_[which - 1].give(b);
    const auto axes = returns_all ? NamedAxes{{7, from}, move_.rotary.all(b)} : move_.named(b, words, call);
    if (!axes) return false;
    const ig::Vec3 intermediate = axes->linear.or_else(from);
    const auto over = b.to_machine(intermediate);
    if (!over) {
      not_invertible(b);
      return false;
    }
    ig::Vec3 reference = *over;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (axes->linear.has(axis)) reference[axis] = reference_(b, axis, which, code);
    const PartialAngles turned_over = move_.rotary.approach(b, axes->rotary);
    PartialAngles turned_home = turned_over;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (turned_over.has(axis))
        turned_home.value[axis] =
            move_.rotary.to_machine(axis, turned_over.value[axis], reference_(b, axis + 3, which, code));
    turned_frame_.turn(b, turned_home);
    const auto end = b.to_program(reference);
    if (!end) {
      not_invertible(b);
      return false;
    }

    move_.begin(b, words.code);
    move_.pass(b, intermediate, *over, turned_over);
    move_.arrive(b, rounded(*end), reference, turned_home);
    return true;
  }

  /// The machine does not move; the program point changes by the tool length.
  void end_compensation(ig::Block& b) const {
    if (!b.is(compensation_, g43_) && !b.is(compensation_, g44_)) return;
    const ig::PartialVec3 machine = b.get(move_.machine);
    b.set(compensation_, g49_);
    if (b.has(untravelled_)) {
      const double left = b.get_or(untravelled_, 0.0) - b.get_or(offset_, 0.0);
      if (left != 0)
        b.set(untravelled_, left);
      else
        b.erase(untravelled_);
    }
    b.set(offset_, 0.0);
    b.set_translation(frame_, {});
    if (const auto here = b.to_program(machine.value)) b.set(move_.program, rounded(*here));
  }
};

const ig::Register<ReferenceReturn> reference_return_syntax;

}  // namespace
}  // namespace iso
