/// G150 of a Haas: a pocket whose contour is in a subprogram. How the control clears it is not known exactly, so it is
/// not milled here; the tool goes to the start of the pocket, and to R.
#include <isogloss/cnc/whole_number.hpp>
#include <isogloss/sdk.hpp>

#include "haas/haas_cycle_target.hpp"

namespace fanuc {

using namespace ig::cnc;

namespace {

struct HaasPocket {
  static constexpr auto spec = ig::syntax("HaasPocketSyntax", "G150 of a Haas: moves to the start of a pocket.")
                                   .after("UnitModeSyntax", "PositioningModeSyntax", "IsoCoordinateOffsetSyntax",
                                          "ToolHeightOffsetSyntax", "ProgrammableMirrorSyntax")
                                   .before("CannedCycleResolveSyntax", "IncrementalResolveSyntax", "ProgramXyzSyntax",
                                           "McXyzSyntax", "RadiusCompensationSyntax", "NotExecutedSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "FAN-0207",
                     "G150: the pocket of program {0}, down to Z{1}, is not milled here; the tool is assumed to "
                     "stand over its start"),
  };

  ig::Call call_{{"G150"}, "X Y Z I J K L[] P[] Q R D[]"};
  ig::Out<std::int64_t> offset_id_{"RadiusCompensation.OffsetId"};
  HaasCycleTarget target_;

  ig::Status build(ig::Block& b) {
    const auto row = b.find(call_);
    if (!row) return ig::Status::unchanged;
    const auto where = ig::Where::word(call_.code(*row));
    const ig::Words words = *b.take(call_);
    if (const std::string_view fault = fault_of(words); !fault.empty()) {
      b.report(ig::diag("FAN-0201"), where, std::string_view("G150"), fault);
      return ig::Status::changed;
    }
    if (const auto d = words['D']) b.set(offset_id_, *whole_number(*d));
    b.report(ig::diag("FAN-0207"), where, *words['P'], target_(b, 2, words['Z']));
    target_.go_to_start(b, words);
    return ig::Status::changed;
  }

 private:
  /// The reason why the control cannot mill it either; empty where it can.
  static std::string_view fault_of(const ig::Words& words) {
    if (!words['P'] || !whole_number(*words['P'])) return "P names no subprogram";
    if (!words['Z']) return "Z, the bottom, is missing";
    if (words['I'] && words['J']) return "both I and J give the width of a cut: only one may";
    if (words['Q'] && !(*words['Q'] > 0)) return "Q, the depth of a pass, is not greater than 0";
    if (words['D'] && !whole_number(*words['D'])) return "D is no offset number";
    return {};
  }
};

const ig::Register<HaasPocket> haas_pocket_syntax;

}  // namespace
}  // namespace fanuc
