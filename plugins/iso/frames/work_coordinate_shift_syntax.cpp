/// G92 and G92.1: the present position gets the coordinates that the words give, by a shift of all work coordinate
/// systems. No axis moves. Fanuc manual, "Setting a workpiece coordinate system" and "Workpiece coordinate system
/// preset".
#include <isogloss/cnc/coordinate_offset.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/rotary_offset.hpp>

#include "motion/further_axis_order.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

enum class AtReference { keep, cancel };

struct WorkCoordinateShift {
  static constexpr auto spec =
      ig::syntax("WorkCoordinateShiftSyntax",
                 "G92 sets the coordinates of the present position, G92.1 cancels the shift.")
          .after("ParameterizedFlagSyntax", "UnitModeSyntax", "IsoG68RotationSyntax", "ToolHeightOffsetSyntax",
                 "IsoLocalCoordinateOffsetSyntax", "IsoCoordinateOffsetSyntax")
          .before("CannedCycleResolveSyntax", "IncrementalResolveSyntax", "MachineCoordSelectSyntax",
                  "ProgramXyzSyntax", "McXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ISO-0365", "{0} without an axis word: no coordinate system is set"),
      ig::diagnostic(IG_WARNING, "ISO-0366", "G92.1 {0}{1}: the value is ignored, and the shift of the axis ends"),
      ig::diagnostic(IG_ERROR, "ISO-0369",
                     "{0}: the shift cannot be computed, so the coordinate systems do not change"),
      ig::diagnostic(IG_ERROR, "ISO-0370",
                     "G92 S{0}: the spindle speed limit is negative, so the previous limit stays in force"),
  };

  ig::Call g92_{{"G92"}, "X Y Z A B C S"};
  ig::Call g92_1_{{"G92.1"}, "X Y Z A B C"};
  ig::Call homes_{{"G28", "G30"}, "X Y Z A B C", ig::read | ig::wake};
  OffsetSection shift_{"WorkCoordinateShift", {ig::Life::modal, "mm", "Shift of all work coordinate systems."}};
  RotaryOffsetSection rotary_{"WorkCoordinateShift"};
  RotaryOffsetSection work_{"CoordinateOffset", ig::read}, local_{"LocalCoordinateOffset", ig::read};
  RotaryPosition angles_{ig::read};
  RotaryWords machine_axes_;
  NamesFurtherAxes names_further_;
  FurtherAxisOrder further_set_{"G92"}, further_preset_{"G92.1"};
  ig::Signal further_ends_{"FurtherAxes.~ShiftEnds", ig::write};
  ig::Out<double> limit_{"SpindleSpeed.Limit_rpm", {ig::Life::modal, "1/min", "Highest speed under G96."}};
  ig::Xyz machine_{"MachineCoordinate", ig::read};
  LastProgramXyz last_;
  /// Raised for axes that went home in the block before: their shift ends when the next block begins.
  std::array<ig::Signal, 6> homed_{ig::Signal{"WorkCoordinateShift.~HomedX", waits, ig::Life::modal},
                                   ig::Signal{"WorkCoordinateShift.~HomedY", waits, ig::Life::modal},
                                   ig::Signal{"WorkCoordinateShift.~HomedZ", waits, ig::Life::modal},
                                   ig::Signal{"WorkCoordinateShift.~HomedA", waits, ig::Life::modal},
                                   ig::Signal{"WorkCoordinateShift.~HomedB", waits, ig::Life::modal},
                                   ig::Signal{"WorkCoordinateShift.~HomedC", waits, ig::Life::modal}};

  ig::Choice<AtReference> reference_return_{"reference-return", "keep|cancel", "keep",
                                            "Whether G28 or G30 cancels the shift of the axes that it names."};

  ig::Status restart(ig::Block& b) {
    if (!shift_.has(b)) return ig::Status::unchanged;
    shift_.restore(b);
    return ig::Status::changed;
  }

  ig::Status build(ig::Block& b) {
    bool changed = end_after_home(b);
    if (const auto words = b.take(g92_1_)) {
      preset(b, *words);
      changed = true;
    }
    if (const auto words = b.take(g92_)) {
      limit_spindle(b, *words);
      set_position(b, *words);
      changed = true;
    }
    if (reference_return_ == AtReference::cancel && is_shifted(b)) changed |= remember_home(b);
    if (reference_return_ == AtReference::cancel && names_further_(b)) {
      b.raise(further_ends_);
      changed = true;
    }
    return changed ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  static constexpr ig::Access waits = ig::read | ig::write | ig::wake_while;

  bool is_shifted(const ig::Block& b) const { return shift_.get(b) != ig::Vec3{} || rotary_.get(b).value != Angles{}; }

  void set_position(ig::Block& b, const ig::Words& words) const {
    if (names_further_(b)) further_set_.give(b);
    set_angles(b, rotary_coordinates(b, machine_axes_, words, g92_));
    ig::Vec3 position = last_(b);
    const ig::PartialVec3 carried = b.get(machine_);
    const ig::Vec3 tool = carried.complete() ? carried.value : b.to_machine(position).value_or(ig::Vec3{});
    const bool any = (words.mask & 7u) != 0;
    for (std::size_t axis = 0; axis < 3; ++axis) position[axis] = words["XYZ"[axis]].value_or(position[axis]);
    if (any)
      shift_to(b, tool, position);
    else if (words.mask == 0 && !names_further_(b))
      b.report(ig::diag("ISO-0365"), ig::Where::word(g92_.code(0)), b.text(words.code));
  }

  /// Shifts so that the present angles of the axes get these values.
  void set_angles(ig::Block& b, const PartialAngles& named) const {
    const Angles machine = angles_.get(b).or_else({}), work = work_.get(b).value, local = local_.get(b).value;
    Angles shift = rotary_.get(b).value;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (named.has(axis)) shift[axis] = rounded(machine[axis] - named.value[axis] - work[axis] - local[axis]);
    rotary_.set(b, shift);
  }

  /// Shifts so that `position` is the program point of the machine point `tool`.
  void shift_to(ig::Block& b, const ig::Vec3& tool, const ig::Vec3& position) const {
    const ig::Vec3 unshifted = b.to_machine(position).value_or(tool);
    const ig::Vec3 shift = rounded(shift_.get(b) + (tool - unshifted));
    if (std::isfinite(shift.x) && std::isfinite(shift.y) && std::isfinite(shift.z))
      shift_.set(b, shift);
    else
      b.report(ig::diag("ISO-0369"), ig::Where::word(g92_.code(0)), b.text(g92_.name(0)));
  }

  void limit_spindle(ig::Block& b, const ig::Words& words) const {
    const auto s = words['S'];
    if (s && *s >= 0) b.set(limit_, *s);
    if (s && *s < 0) b.report(ig::diag("ISO-0370"), ig::Where::word(g92_.word(0, 'S')), *s);
  }

  /// Ends the shift on the axes that the block names, on all axes where it names none.
  void preset(ig::Block& b, const ig::Words& words) const {
    const bool ends_all = words.mask == 0 && !names_further_(b);
    if (ends_all || names_further_(b)) further_preset_.give(b);
    ig::Vec3 shift = shift_.get(b);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto word = words["XYZ"[axis]];
      if (word && *word != 0)
        b.report(ig::diag("ISO-0366"), ig::Where::word(g92_1_.row(0)[axis]), std::string_view("XYZ").substr(axis, 1),
                 *word);
      if (word || ends_all) shift[axis] = 0;
    }
    if ((words.mask & 7u) != 0 || ends_all) shift_.set(b, shift);
    Angles turned = rotary_.get(b).value;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto word = words[rotary_names[axis]];
      if (word && *word != 0)
        b.report(ig::diag("ISO-0366"), ig::Where::word(g92_1_.row(0)[axis + 3]), rotary_names.substr(axis, 1), *word);
      if (word || ends_all) turned[axis] = 0;
    }
    rotary_.set(b, turned);
  }

  bool remember_home(ig::Block& b) const {
    const auto home = b.find(homes_);
    if (!home) return false;
    ig_value words[6];
    const std::uint32_t named = b.get_many(homes_.row(*home), 6, words);
    for (std::size_t axis = 0; axis < homed_.size(); ++axis)
      if ((named >> axis & 1u) != 0) b.raise(homed_[axis]);
    return named != 0;
  }

  bool end_after_home(ig::Block& b) const {
    const ig::Vec3 shift = shift_.get(b);
    ig::Vec3 left = shift;
    Angles turned = rotary_.get(b).value;
    bool any = false;
    for (std::size_t axis = 0; axis < homed_.size(); ++axis) {
      if (!b.is_raised(homed_[axis])) continue;
      b.erase(homed_[axis]);
      (axis < 3 ? left[axis] : turned[axis - 3]) = 0;
      any = true;
    }
    if (left != shift) shift_.set(b, left);
    rotary_.set(b, turned);
    return any;
  }
};

const ig::Register<WorkCoordinateShift> work_coordinate_shift_syntax;

}  // namespace
}  // namespace iso
