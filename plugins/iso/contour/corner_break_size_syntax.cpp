/// The kind and the size of the chamfer or rounding that ,C and ,R put at the end of a block's move.
/// CornerBreakPathSyntax and cutter radius compensation make the path from this state.
#include <isogloss/cnc/corner_break_state.hpp>
#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/scale_and_mirror.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct CornerBreakSize {
  static constexpr auto spec =
      ig::syntax("CornerBreakSizeSyntax", "The size of a chamfer ,C or a rounding ,R of a corner.")
          .after("UnitModeSyntax", "PlaneSelectSyntax", "ProgrammableMirrorSyntax", "CircularMotionSyntax",
                 "LinearMotionSyntax")
          .before("CornerBreakPathSyntax", "RadiusCompensationPathSyntax", "UnconsumedCheckSyntax");

  ig::Word chamfer_{"Parsing.CornerBreak.C", ig::wake, "mm",
                    "Chamfer at the end of the move: distance from the corner to each end of the chamfer."};
  ig::Word rounding_{"Parsing.CornerBreak.R", ig::wake, "mm", "Radius of the arc at the end of the move."};
  CornerBreakWords corner_;
  ScaleAndMirror scale_and_mirror_;
  PlaneInForce plane_;
  ig::Name c_{",C"}, r_{",R"};

  ig::Status build(ig::Block& b) const {
    const bool was_open = corner_.is_open(b);
    const auto chamfer = b.take(chamfer_), rounding = b.take(rounding_);
    corner_.keep(b, chamfer || rounding ? describe(b, chamfer, rounding) : std::nullopt);
    return was_open || chamfer || rounding ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  std::optional<CornerBreakState::Corner> describe(ig::Block& b, std::optional<double> chamfer,
                                                   std::optional<double> rounding) const {
    const ig::Name& name = chamfer ? c_ : r_;
    const auto where = ig::Where::word(chamfer ? chamfer_.id() : rounding_.id());
    if (chamfer && rounding) {
      refuse(b, where, b.text(name), "the block has ,C and ,R");
      return std::nullopt;
    }
    const double size = chamfer ? *chamfer : *rounding;
    if (size == 0) return std::nullopt;
    if (!(size > 0)) {
      refuse(b, where, b.text(name), "its size is less than 0");
      return std::nullopt;
    }
    const PlaneAxes plane = plane_(b);
    const double factor = std::fabs(scale_and_mirror_.axis(b, plane.first).factor);
    if (std::fabs(factor - std::fabs(scale_and_mirror_.axis(b, plane.second).factor)) > 1e-12) {
      refuse(b, where, b.text(name), "the axes of the plane are scaled differently");
      return std::nullopt;
    }
    return CornerBreakState::Corner{name, chamfer ? CornerShape::legs : CornerShape::rounding, factor * size};
  }

  static void refuse(ig::Block& b, ig::Where where, std::string_view name, std::string_view why) {
    b.report(ig::diag("ISO-0480"), where, name, why);
    b.alarm();
  }
};

const ig::Register<CornerBreakSize> corner_break_size_syntax;

}  // namespace
}  // namespace iso
