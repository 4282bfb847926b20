/// The chamfer or rounding that ,C and ,R put at the end of a block's move: its kind and size, as a state that
/// CornerBreakPathSyntax and the radius compensation make the path from.
#include "corner_diagnostics.hpp"
#include "plane_util.hpp"
#include "scale_and_mirror.hpp"

namespace iso {
namespace {

struct CornerBreakSize {
  static constexpr auto spec =
      ig::syntax("CornerBreakSizeSyntax", "The size of a chamfer ,C or a rounding ,R of a corner.")
          .after("UnitModeSyntax", "PlaneSelectSyntax", "ProgrammableMirrorSyntax", "CircularMotionSyntax",
                 "LinearMotionSyntax")
          .before("CornerBreakPathSyntax", "RadiusCompensationPathSyntax", "UnconsumedCheckSyntax");

  ig::Word chamfer_{"Parsing.CornerBreak.C", ig::wake, "mm",
                    "Chamfer at the end of the move: from the corner to its two ends."};
  ig::Word rounding_{"Parsing.CornerBreak.R", ig::wake, "mm", "Radius of the arc at the end of the move."};
  ig::Out<ig::Symbol> term_{"CornerBreak.Term", {ig::Life::block, "", "What stands at the end of the move: ,C or ,R."}};
  ig::Out<double> size_{"CornerBreak.Size_mm",
                        {ig::Life::block, "mm", "From the corner to both ends of the chamfer, or the radius."}};
  /// From the block of the corner up to the next move.
  ig::Signal open_{"CornerBreak.~Open", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  ig::Signal path_{"CornerBreak.~Path", ig::write};
  ig::In<ig::Symbol> form_{"MotionEvent.Form"};
  ig::In<ig::Symbol> compound_{"CompoundMotion.Term"};
  ScaleAndMirror scale_and_mirror_;
  PlaneInForce plane_;
  ig::Name c_{",C"}, r_{",R"};

  ig::Status build(ig::Block& b) const {
    const bool was_open = b.is_raised(open_);
    const auto chamfer = b.take(chamfer_), rounding = b.take(rounding_);
    const bool opens = (chamfer || rounding) && describe(b, chamfer, rounding);
    if (was_open || opens) b.raise(path_);
    if (opens && !was_open) b.raise(open_);
    if (was_open && !opens && b.has_any(form_, compound_)) b.erase(open_);
    return was_open || chamfer || rounding ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  bool describe(ig::Block& b, std::optional<double> chamfer, std::optional<double> rounding) const {
    const ig::Name& name = chamfer ? c_ : r_;
    const auto where = ig::Where::word(chamfer ? chamfer_.id() : rounding_.id());
    if (chamfer && rounding) {
      refuse(b, where, b.text(name), "the block has ,C and ,R");
      return false;
    }
    const double size = chamfer ? *chamfer : *rounding;
    if (size == 0) return false;
    if (!(size > 0)) {
      refuse(b, where, b.text(name), "it is less than 0");
      return false;
    }
    const PlaneAxes plane = plane_(b);
    const double factor = std::fabs(scale_and_mirror_.axis(b, plane.first).factor);
    if (std::fabs(factor - std::fabs(scale_and_mirror_.axis(b, plane.second).factor)) > 1e-12) {
      refuse(b, where, b.text(name), "the axes of the plane are scaled differently");
      return false;
    }
    b.set(term_, name);
    b.set(size_, factor * size);
    return true;
  }

  static void refuse(ig::Block& b, ig::Where where, std::string_view name, std::string_view why) {
    b.report(corner_diag("ISO-0480"), where, name, why);
    b.alarm();
  }
};

const ig::Register<CornerBreakSize> registered;

}  // namespace
}  // namespace iso
