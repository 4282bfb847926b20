/// G54.2 P: the fixture offset that follows the rotary table; G54.4 P: workpiece setting error compensation. P0 cancels
/// them, which changes nothing where they were never active; the offsets of P1 and above are in no table here.

#include <isogloss/sdk.hpp>

namespace fanuc {
namespace {

struct FanucFixtureOffset {
  static constexpr auto spec =
      ig::syntax(
          "FanucFixtureOffsetSyntax",
          "Reports that a fixture offset (G54.2 P) and a setting error of the workpiece (G54.4 P) are not executed.")
          .after("ParameterizedFlagSyntax")
          .before("NotExecutedSyntax", "UnconsumedCheckSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "FAN-0210", "{0} P{1} is not executed: {2}"),
      ig::diagnostic(IG_ERROR, "FAN-0211",
                     "{0} has no P, so it selects nothing: write P0 to cancel, or the number of a row"),
  };

  ig::Call codes_{{"G54.2", "G54.4"}, "P[]"};

  ig::Status build(ig::Block& b) {
    bool any = false;
    for (std::uint32_t row = 0; row < codes_.code_count(); ++row) any |= take(b, row);
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  bool take(ig::Block& b, std::uint32_t row) const {
    const ig_field code = codes_.code(row);
    if (b.take_code(&code, 1) < 0) return false;
    ig_value p{};
    const std::string_view name = b.text(codes_.name(row));
    if (!b.take(codes_.word(row, 'P'), p))
      b.report(ig::diag("FAN-0211"), ig::Where::word(code), name);
    else if (p.number != 0)
      b.report(ig::diag("FAN-0210"), ig::Where::word(code), name, p.number, missing[row]);
    return true;
  }

  static constexpr std::array<std::string_view, 2> missing{
      "the fixture offset is not known here, so positions do not follow the rotary table",
      "positions are those of a workpiece without a setting error"};
};

const ig::Register<FanucFixtureOffset> fanuc_fixture_offset_syntax;

}  // namespace
}  // namespace fanuc
