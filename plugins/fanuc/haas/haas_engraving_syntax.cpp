/// G47 of a Haas: engraves text or a number. Its letters are a font of the control and are not shown; the tool goes to
/// the start of the text, and to R.
#include <cmath>

#include <isogloss/cnc/units.hpp>
#include <isogloss/cnc/whole_number.hpp>
#include <isogloss/sdk.hpp>

#include "haas/haas_cycle_target.hpp"

namespace fanuc {

using namespace ig::cnc;

namespace {

struct HaasEngraving {
  static constexpr auto spec =
      ig::syntax("HaasEngravingSyntax", "G47 of a Haas: moves to the start of an engraved text.")
          .after("UnitModeSyntax", "PositioningModeSyntax", "IsoCoordinateOffsetSyntax", "ToolHeightOffsetSyntax",
                 "ProgrammableMirrorSyntax")
          .before("CannedCycleResolveSyntax", "IncrementalResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax",
                  "NotExecutedSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "FAN-0206",
                     "G47: the strokes of the text are not executed; the text begins at X{0} Y{1}, {2} mm high, at "
                     "{3} degrees, and the tool is assumed to stay there{4}"),
  };

  ig::Call call_{{"G47"}, "X Y Z I[deg] J P[] R D[] E[mm/min]"};
  HaasCycleTarget target_;

  ig::Status build(ig::Block& b) const {
    const auto row = b.find(call_);
    if (!row) return ig::Status::unchanged;
    const auto where = ig::Where::word(call_.code(*row));
    const ig::Words words = *b.take(call_);
    if (const std::string_view fault = fault_of(b, words); !fault.empty()) {
      b.report(ig::diag("FAN-0201"), where, std::string_view("G47"), fault);
      return ig::Status::changed;
    }
    const ig::Vec3 start = target_.go_to_start(b, words);
    b.report(ig::diag("FAN-0206"), where, start.x, start.y, words['J'].value_or(mm_per_inch), words['I'].value_or(0),
             std::string_view(target_.is_incremental(b) ? ", where G91 continues" : ""));
    return ig::Status::changed;
  }

 private:
  /// The reason why the control cannot engrave either; empty where it can.
  static std::string_view fault_of(const ig::Block& b, const ig::Words& words) {
    const auto p = words['P'] ? whole_number(*words['P']) : std::nullopt;
    if (!p || (*p > 1 && *p < 32) || *p > 126) return "P is not 0 (text), 1 (a number) or 32 to 126 (a letter)";
    if (*p < 2 && b.source().find('(') == std::string_view::npos) return "its block has no text";
    if (!words['Z']) return "Z, the depth, is missing";
    if (words['J'] && !(*words['J'] > 0)) return "J, the height, is not greater than 0";
    return {};
  }
};

const ig::Register<HaasEngraving> haas_engraving_syntax;

}  // namespace
}  // namespace fanuc
