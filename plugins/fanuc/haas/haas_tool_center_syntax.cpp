/// G234 of a Haas: tool centre point control, the same as G43.4 of a Fanuc.
#include <isogloss/sdk.hpp>

namespace fanuc {
namespace {

struct HaasToolCenter {
  static constexpr auto spec = ig::syntax("HaasToolCenterSyntax", "G234 tool centre point control, as G43.4.")
                                   .after("ParameterizedFlagSyntax")
                                   .before("ToolCenterPointSyntax", "HaasCodeSyntax");

  ig::Call g234_{{"G234"}, "H[]", ig::read | ig::take | ig::wake};
  ig::Call g43_4_{{"G43.4"}, "H[]", ig::read | ig::write};

  /// The words stay where they are in the text, so that whatever is said of G43.4 names G234.
  ig::Status build(ig::Block& b) {
    ig_value unused;
    if (!b.get(g234_.code(0), unused)) return ig::Status::unchanged;
    b.move(g234_.code(0), g43_4_.code(0));
    if (b.get(g234_.word(0, 'H'), unused)) b.move(g234_.word(0, 'H'), g43_4_.word(0, 'H'));
    return ig::Status::changed;
  }
};

const ig::Register<HaasToolCenter> haas_tool_center_syntax;

}  // namespace
}  // namespace fanuc
