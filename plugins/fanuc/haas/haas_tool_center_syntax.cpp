/// G234 of a Haas: tool centre point control, the same as G43.4 of a Fanuc.
#include <isogloss/sdk.hpp>

namespace fanuc {
namespace {

struct HaasToolCenter {
  static constexpr auto spec = ig::syntax("HaasToolCenterSyntax", "G234 tool centre point control, as G43.4.")
                                   .after("ParameterizedFlagSyntax")
                                   .before("ToolCenterPointSyntax", "HaasCodeSyntax");

  ig::Call g234_{{"G234"}, "H[]"};
  ig::Call g43_4_{{"G43.4"}, "H[]", ig::read | ig::write};

  ig::Status build(ig::Block& b) {
    const auto words = b.take(g234_);
    if (!words) return ig::Status::unchanged;
    b.set_call(g43_4_, 0);
    if (const auto h = (*words)['H']) b.set_word(g43_4_, 0, 'H', *h);
    return ig::Status::changed;
  }
};

const ig::Register<HaasToolCenter> haas_tool_center_syntax;

}  // namespace
}  // namespace fanuc
