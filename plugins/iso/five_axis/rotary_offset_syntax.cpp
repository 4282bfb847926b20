/// Work offsets of rotary axes: adds up what G54, EXT, G52 and G92 put between the angle of the program and the angle
/// of the machine, and adds the sum in place to the words of positions, so that all later syntaxes read machine angles.
/// Distances (G91) and machine positions (G53) get no offset.
#include <isogloss/cnc/rotary_offset.hpp>
#include <isogloss/cnc/tool_kinematics.hpp>
#include <isogloss/sdk.hpp>

#include "motion/words_of_axes.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct RotaryOffset {
  static constexpr auto spec =
      ig::syntax("RotaryOffsetSyntax", "Work offsets of rotary axes: turns A B C into machine angles.")
          .after("PositioningModeSyntax", "G53p1RotaryPositionSyntax", "ToolCenterPointSyntax",
                 "IsoLocalCoordinateOffsetSyntax", "IsoCoordinateOffsetSyntax", "WorkCoordinateShiftSyntax")
          .before("PivotTransformationSyntax", "IncrementalResolveSyntax", "MachineCoordSelectSyntax", "McAbcSyntax",
                  "ReturnFromReferenceSyntax", "ReferenceReturnSyntax", "ReferenceCheckSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ISO-0405",
                     "the rotary offset changes here, but A, B and C of this block still use the previous one"),
  };

  static constexpr ig::Access heard = ig::read | ig::wake;
  std::array<RotaryOffsetSection, 3> sections_{RotaryOffsetSection{"CoordinateOffset", heard},
                                               RotaryOffsetSection{"LocalCoordinateOffset", heard},
                                               RotaryOffsetSection{"WorkCoordinateShift", heard}};
  RotaryOffsets sum_{ig::read | ig::write | ig::wake_while};
  ig::Fields words_{"words",
                    "Parsing.A Parsing.B Parsing.C Parsing.G27.A Parsing.G27.B Parsing.G27.C Parsing.G28.A "
                    "Parsing.G28.B Parsing.G28.C Parsing.G29.A Parsing.G29.B Parsing.G29.C Parsing.G30.A "
                    "Parsing.G30.B Parsing.G30.C",
                    ig::read | ig::write, "Positions of rotary axes. Their last letter is the axis."};
  std::array<ig_field, 3> block_words_{ig::Word("Parsing.A", ig::read, "deg").id(),
                                       ig::Word("Parsing.B", ig::read, "deg").id(),
                                       ig::Word("Parsing.C", ig::read, "deg").id()};
  ig::Codes machine_select_{{"G53"}, ig::read};
  ig::Field<bool> aligned_{"TiltTransform.IsAligned",
                           ig::read,
                           {ig::Life::modal, "", "G53.1 or G53.6 has put the tool upright on the plane."}};
  ToolCenterMode tip_control_;
  DistanceMode distance_;
  RotaryAxes axes_;

  WordsOfAxes axis_words_{words_, rotary_names};

  ig::Status restart(ig::Block& b) { return of(sum_up(b)); }

  ig::Status build(ig::Block& b) {
    const Angles before = sum_.get(b);
    const bool is_new = sum_up(b);
    if (distance_.is_incremental(b) || b.find(machine_select_)) return of(is_new);
    const bool has_turned = is_new && (tip_control_.is_on(b) || b.has(aligned_));
    if (has_turned && names_angles(b)) b.report(ig::diag("ISO-0405"), ig::Where::block());
    const bool resolved = resolve(b, has_turned ? before : sum_.get(b));
    return of(is_new || resolved);
  }

 private:
  static ig::Status of(bool changed) { return changed ? ig::Status::changed : ig::Status::unchanged; }

  bool sum_up(ig::Block& b) const {
    Angles sum{};
    for (const RotaryOffsetSection& section : sections_) {
      const Angles offset = section.get(b).value;
      for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += offset[axis];
    }
    const Angles old = sum_.get(b);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (sum[axis] != old[axis]) sum_.set(b, axis, sum[axis]);
    return sum != old;
  }

  bool names_angles(const ig::Block& b) const {
    ig_value unused[3];
    return b.get_many(block_words_.data(), 3, unused) != 0;
  }

  bool resolve(ig::Block& b, const Angles& offset) const {
    if (offset == Angles{}) return false;
    return axis_words_.rewrite(b, [&](std::size_t axis, double angle) {
      return offset[axis] == 0 ? std::nullopt
                               : std::optional(RotaryOffsets::to_machine(angle, offset[axis], axes_.rollover(axis)));
    });
  }
};

const ig::Register<RotaryOffset> rotary_offset_syntax;

}  // namespace
}  // namespace iso
