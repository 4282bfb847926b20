/// G54.2 P: the fixture offset that follows the rotary table. P0 cancels it, which changes nothing where it never was;
/// the offsets themselves stand in no table here.
#include "brand_diagnostics.hpp"

namespace fanuc {
namespace {

struct FanucFixtureOffset {
  static constexpr auto spec =
      ig::syntax("FanucFixtureOffsetSyntax", "Says that a fixture offset (G54.2 P) does not follow the rotary table.")
          .after("ParameterizedFlagSyntax")
          .before("NotExecutedSyntax", "UnconsumedCheckSyntax");

  ig::Call code_{{"G54.2"}, "P[]"};

  ig::Status build(ig::Block& b) {
    if (!b.find(code_)) return ig::Status::unchanged;
    const ig_field code = code_.code(0);
    ig_value p{};
    std::uint32_t found = 0;
    const bool has_p = b.host()->take(b.raw(), code_.word(0, 'P'), &p) != 0;
    b.host()->take_code(b.raw(), &code, 1, &found);
    if (!has_p)
      b.report(brand_diag("FAN-0211"), ig::Where::word(code));
    else if (p.number != 0)
      b.report(brand_diag("FAN-0210"), ig::Where::word(code), p.number);
    return ig::Status::changed;
  }
};

const ig::Register<FanucFixtureOffset> registered;

}  // namespace
}  // namespace fanuc
