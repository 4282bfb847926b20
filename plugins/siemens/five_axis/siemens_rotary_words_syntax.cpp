/// A, B and C become angles of the machine before any other syntax reads them. The settable frame in force adds its
/// offset; IC is a distance from the present angle; DC, ACP and ACN give the direction of rotation. Under G153 and SUPA
/// no offset applies, and under G53 only that of the base frame; under G91 a bare word remains a distance.
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/rotary_offset.hpp>
#include <isogloss/cnc/tool_kinematics.hpp>
#include <isogloss/cnc/work_origin.hpp>

#include "five_axis/rotary_position.hpp"
#include "frames/base_frame.hpp"
#include "frames/settable_frames.hpp"
#include "modes/axis_modes.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensRotaryWords {
  static constexpr auto spec =
      ig::syntax("SiemensRotaryWordsSyntax", "A B C become angles of the machine.")
          .after("SiemensUnitSyntax", "PositioningModeSyntax")
          .before("G53p1RotaryPositionSyntax", "SiemensSwivelSyntax", "SiemensTransformationSyntax",
                  "ToolCenterPointSyntax", "SiemensReferenceSyntax", "SiemensCoordinateOffsetSyntax",
                  "SiemensMachineCoordinatesSyntax", "SiemensPositionSyntax", "McAbcSyntax");

  SettableFrames frames_{ig::read | ig::wake};
  RotaryOffsetSection offset_{"CoordinateOffset"};
  RotaryOffsetSection programmable_{"ProgrammableFrame", ig::read};
  ig::Service<ig_work_offset_1> table_{"isogloss.work-offset/1", ig::Need::optional, "Offsets of rotary axes."};
  std::array<ig::Word, 3> words_{ig::Word{"Parsing.A", ig::read | ig::write | ig::wake, "deg"},
                                 ig::Word{"Parsing.B", ig::read | ig::write | ig::wake, "deg"},
                                 ig::Word{"Parsing.C", ig::read | ig::write | ig::wake, "deg"}};
  std::array<ig::In<double>, 3> angles_{ig::In<double>{"MachineCoordinate.A"}, ig::In<double>{"MachineCoordinate.B"},
                                        ig::In<double>{"MachineCoordinate.C"}};
  ig::Codes frameless_{{"SUPA", "G53", "G153"}, ig::read | ig::write};
  ig::Signal keeps_base_{keeps_base_signal, ig::write};
  AxisModes modes_{ig::read | ig::write};
  ig::Field<bool> aligned_{"TiltTransform.IsAligned",
                           ig::read,
                           {ig::Life::modal, "", "G53.1 or G53.6 has put the tool upright on the plane."}};
  ToolCenterMode tip_control_;
  DistanceMode distance_;
  ToolKinematics machine_;
  RotaryModes rotary_;

  ig::Status restart(ig::Block& b) { return of(select(b, frames_.in_force(b).id)); }

  ig::Status build(ig::Block& b) {
    bool any = false;
    if (const auto frame = frames_.changed(b)) {
      any = select(b, frame->id);
      if (any && (tip_control_.is_on(b) || b.has(aligned_)) && offset_.acts_on(b, machine_))
        b.report(ig::diag("SIE-0300"), frame->where, b.text(frame->id));
    }
    if (!b.has(words_[0]) && !b.has(words_[1]) && !b.has(words_[2])) return of(any);
    const auto frameless = b.find(frameless_);
    const bool g91 = distance_.is_incremental(b);
    const Angles offset = frameless ? frameless_offset(*frameless) : offset_in_force(b);
    if (frameless) any |= name_supa(b);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (const auto word = b.get(words_[axis])) any |= resolve(b, axis, *word, offset[axis], g91);
    return of(any);
  }

 private:
  static ig::Status of(bool changed) { return changed ? ig::Status::changed : ig::Status::unchanged; }

  static constexpr std::size_t g53 = 1;

  /// Of the settable, the base and the programmable frame (TRANS C30).
  Angles offset_in_force(const ig::Block& b) const {
    Angles sum = offset_.get(b).value;
    const Angles more = programmable_.get(b).value;
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += more[axis];
    return sum;
  }

  Angles frameless_offset(std::size_t code) const {
    const auto base = code == g53 && table_ ? rotary_origin(table_, "BASE") : std::nullopt;
    return base.value_or(Angles{});
  }

  /// For the syntaxes that follow the rotary axes, G53 is the code of a Fanuc, which ends tool centre point control for
  /// its block and has no effect under G91. Here G53 suppresses frames, as SUPA does, but not the base frame.
  bool name_supa(ig::Block& b) const {
    ig_value code;
    bool is_renamed = false;
    for (const std::size_t i : {g53, std::size_t{2}}) {
      if (!b.get(frameless_.id(i), code)) continue;
      b.erase(frameless_.id(i));
      b.set(frameless_.id(0), code);
      if (i == g53) b.raise(keeps_base_);
      is_renamed = true;
    }
    return is_renamed;
  }

  /// Selects the frame; true where the offset changes.
  bool select(ig::Block& b, ig::Symbol id) const {
    Angles sum{};
    for (const std::string_view row : {b.text(id), std::string_view("BASE")}) {
      const auto own = table_ ? rotary_origin(table_, row) : std::nullopt;
      for (std::size_t axis = 0; own && axis < 3; ++axis) sum[axis] += (*own)[axis];
    }
    return offset_.set(b, sum);
  }

  /// Under G91 a word that is a position becomes a distance, because later syntaxes read it as one.
  bool resolve(ig::Block& b, std::size_t axis, double word, double offset, bool g91) const {
    const auto mode = modes_.get(b, 3 + axis);
    if (!mode && (g91 || offset == 0)) return false;
    double to = word + offset;
    if (mode) {
      const double present = b.get_or(angles_[axis], 0.0);
      to = rotary_.position(b, ig::Where::word(words_[axis].id()), word, *mode, present - offset) + offset;
      if (g91) to -= present;
      modes_.set(b, 3 + axis, g91 ? rotary_.ic : rotary_.ac);
    }
    b.rewrite(words_[axis].id(), to);
    return true;
  }
};

const ig::Register<SiemensRotaryWords> siemens_rotary_words_syntax;

}  // namespace
}  // namespace siemens
