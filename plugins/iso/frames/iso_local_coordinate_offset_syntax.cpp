/// G52: a local coordinate system inside every work coordinate system. The words are the local origin itself, under G91
/// too: an axis that is named gets a new offset, the other axes keep theirs. G92 ends it on the axes that it names.
#include <isogloss/cnc/coordinate_offset.hpp>
#include <isogloss/cnc/rotary_offset.hpp>

#include "motion/further_axis_order.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

enum class CancelledBy { program_end, never, parameter };

struct IsoLocalCoordinateOffset {
  static constexpr auto spec =
      ig::syntax("IsoLocalCoordinateOffsetSyntax", "G52 local coordinate system.")
          .after("UnitModeSyntax", "ToolHeightOffsetSyntax")
          .before("IsoCoordinateOffsetSyntax", "CannedCycleResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax");

  ig::Call g52_{{"G52"}, "X Y Z A B C"};
  ig::Codes program_end_{{"M02", "M30"}, ig::read | ig::wake};
  ig::Call presets_{{"G92", "G92.1"}, "X Y Z A B C", ig::read | ig::wake};
  OffsetSection local_{"LocalCoordinateOffset"};
  RotaryOffsetSection rotary_{"LocalCoordinateOffset"};
  RotaryWords machine_axes_;
  NamesFurtherAxes names_further_;
  FurtherAxisOrder further_{"G52"};
  ig::Signal further_ends_{"FurtherAxes.~LocalEnds", ig::write};
  ig::Config config_{"isogloss.coordinate-system/1", ig::Need::optional, "ResetCancelsLocalCoordinate."};
  ig::Choice<CancelledBy> cancelled_by_{"cancelled-by", "program-end|never|parameter", "program-end",
                                        "Whether the end of the program cancels the local system; parameter: the "
                                        "control's parameter for a reset decides."};
  bool ends_with_program_ =
      cancelled_by_ == CancelledBy::program_end ||
      (cancelled_by_ == CancelledBy::parameter && config_.number("ResetCancelsLocalCoordinate").value_or(0) != 0);

  ig::Status restart(ig::Block& b) {
    local_.restore(b);
    return ig::Status::changed;
  }

  ig::Status build(ig::Block& b) {
    if (const auto words = b.take(g52_)) {
      const ig::Vec3 old = local_.get(b);
      local_.set(b, {(*words)['X'].value_or(old.x), (*words)['Y'].value_or(old.y), (*words)['Z'].value_or(old.z)});
      rotary_.set(b, rotary_coordinates(b, machine_axes_, *words, g52_).or_else(rotary_.get(b).value));
      if (names_further_(b)) further_.give(b);
      return ig::Status::changed;
    }
    const bool ends = ends_with_program_ && b.find(program_end_);
    if (ends) b.raise(further_ends_);
    return end_axes(b) || ends ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  bool end_axes(ig::Block& b) const {
    const ig::Vec3 old = local_.get(b);
    Angles turned = rotary_.get(b).value;
    if (old == ig::Vec3{} && turned == Angles{}) return false;
    const std::uint32_t ended = ended_axes(b);
    ig::Vec3 left = old;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if ((ended >> axis & 1u) != 0) left[axis] = 0;
      if ((ended >> (axis + 3) & 1u) != 0) turned[axis] = 0;
    }
    if (left != old) local_.set(b, left);
    return rotary_.set(b, turned) || left != old;
  }

  /// A bit for each of X Y Z A B C. G92 and G92.1 end the local system on the axes that they name, G92.1 without words
  /// on all.
  std::uint32_t ended_axes(const ig::Block& b) const {
    constexpr std::uint32_t all = 63;
    if (ends_with_program_ && b.find(program_end_)) return all;
    const auto preset = b.find(presets_);
    if (!preset) return 0;
    ig_value words[6];
    const std::uint32_t named = b.get_many(presets_.row(*preset), 6, words);
    return named == 0 && *preset == 1 && !names_further_(b) ? all : named;
  }
};

const ig::Register<IsoLocalCoordinateOffset> iso_local_coordinate_offset_syntax;

}  // namespace
}  // namespace iso
