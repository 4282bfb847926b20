/// G51.1 and G50.1: an axis is mirrored at a position. The words of the block are rewritten in place; where one of the
/// two axes of the plane is mirrored, CircularMotionSyntax reverses the sense of arcs. Fanuc manual, "Programmable
/// mirror image".
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/scale_and_mirror.hpp>

#include "reading/geometry_words.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

enum class OtherCodes { warning, allowed };

struct ProgrammableMirror {
  static constexpr auto spec =
      ig::syntax("ProgrammableMirrorSyntax", "G51.1/G50.1 programmable mirror image.")
          .after("UnitModeSyntax", "PlaneSelectSyntax", "PositioningModeSyntax")
          .before("CannedCycleResolveSyntax", "IncrementalResolveSyntax", "ProgramXyzSyntax", "CircularMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ISO-0388", "G51.1 without an axis word: nothing is mirrored"),
  };

  ig::Call on_{{"G51.1"}, "X Y Z"};
  ig::Call off_{{"G50.1"}, "X Y Z"};
  ig::InWhile<ig::Symbol> term_{"MirrorImage.Term", nullptr, ig::write};
  ig::Xyz mirror_{"MirrorImage", ig::read | ig::write};
  GeometryWords words_;
  PlaneInForce plane_;
  DistanceMode distance_;
  ig::Choice<OtherCodes> other_codes_{
      "other-codes", "warning|allowed", "warning",
      "Codes whose words are not mirrored (G53, G28, …) under a mirror image: with or without a warning."};

  ig::Status build(ig::Block& b) {
    bool changed = false;
    if (const auto words = b.take(off_)) {
      end(b, *words);
      changed = true;
    }
    if (const auto words = b.take(on_)) {
      begin(b, *words);
      changed = true;
    }
    if (b.has(term_)) changed |= mirror(b);
    return changed ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  /// Ends the mirror image of the named axes; without words, of all axes.
  void end(ig::Block& b, const ig::Words& words) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (words.mask == 0 || words["XYZ"[axis]]) b.erase(mirror_.id(axis));
    if (b.get(mirror_).mask == 0) b.erase(term_);
  }

  void begin(ig::Block& b, const ig::Words& words) const {
    if (words.mask == 0) {
      b.report(ig::diag("ISO-0388"), ig::Where::word(on_.code(0)));
      return;
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (const auto at = words["XYZ"[axis]]) b.set(mirror_.id(axis), *at);
    b.set(term_, words.code);
  }

  bool mirror(ig::Block& b) const {
    if (other_codes_ == OtherCodes::warning) words_.report_untouched(b, b.get(term_).value_or(on_.name(0)));
    const auto here = words_.find(b);
    if (!here) return false;
    const ig::PartialVec3 at = b.get(mirror_);
    const bool incremental = distance_.is_incremental(b);
    bool any = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool is_drilling_axis = here->is_cycle && axis == plane_(b).tool;
      if (!at.has(axis) || is_drilling_axis) continue;
      if (const auto value = GeometryWords::get(b, here->axes[axis])) {
        GeometryWords::rewrite(b, here->axes[axis], (incremental ? 0 : 2 * at.value[axis]) - *value);
        any = true;
      }
      const ig_field center = words_.centers()[axis];
      if (const auto value = GeometryWords::get(b, center); value && !here->is_cycle) {
        GeometryWords::rewrite(b, center, 0 - *value);
        any = true;
      }
    }
    return any;
  }
};

const ig::Register<ProgrammableMirror> programmable_mirror_syntax;

}  // namespace
}  // namespace iso
