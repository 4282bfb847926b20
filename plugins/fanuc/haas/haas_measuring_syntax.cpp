/// G35, G36, G37 and G136 of a Haas: a feed move that a probe ends, and an offset that the control writes. The move is
/// made like that of G31; no offset changes.
#include <isogloss/sdk.hpp>

#include <string>

namespace fanuc {
namespace {

struct HaasMeasuring {
  static constexpr auto spec =
      ig::syntax("HaasMeasuringSyntax", "G35, G36, G37, G136 of a Haas: measuring moves.")
          .after("ParameterizedFlagSyntax", "UnitModeSyntax")
          .before("CannedCycleResolveSyntax", "IncrementalResolveSyntax", "SkipFunctionSyntax", "NotExecutedSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "FAN-0205", "{0}: nothing is measured here, {1} keeps its value"),
  };

  ig::Call measure_{{"G35", "G36", "G37", "G136"}, "X Y Z A B C I J K D[] H[] P[]"};
  ig::Call g31_{{"G31"}, "P[]", ig::read | ig::write};
  std::array<ig_field, 6> axes_{axis("X"), axis("Y"), axis("Z"), axis("A"), axis("B"), axis("C")};

  ig::Status build(ig::Block& b) const {
    const auto row = b.find(measure_);
    if (!row) return ig::Status::unchanged;
    const ig_field code = measure_.code(*row);
    b.take_code(measure_.codes(), measure_.code_count());
    bool moves = false;
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const ig_field word = measure_.word(*row, "XYZABC"[i]);
      if (!b.has(word)) continue;
      b.move(word, axes_[i]);
      moves = true;
    }
    static constexpr std::string_view own_letters[] = {"D", "IJK", "H", "IJK"};
    ig_value unused;
    for (const char letter : own_letters[*row]) b.take(measure_.word(*row, letter), unused);
    const auto where = ig::Where::word(code);
    const std::string_view name = b.text(measure_.name(*row));
    if (!moves) {
      b.report(ig::diag("FAN-0201"), where, name, std::string_view("no axis is named, so nothing moves"));
      return ig::Status::changed;
    }
    static constexpr std::string_view offsets[] = {"the tool's radius", "the work offset", "the tool's length",
                                                   "the work offset"};
    b.report(ig::diag("FAN-0205"), where, name, offsets[*row]);
    b.set_call(g31_, 0);
    return ig::Status::changed;
  }

 private:
  static ig_field axis(std::string_view letter) {
    const std::string path = "Parsing." + std::string(letter);
    return ig::Field<double>(path, ig::read | ig::write,
                             {ig::Life::standard, ig::detail::default_unit(letter.front()), ""})
        .id();
  }
};

const ig::Register<HaasMeasuring> haas_measuring_syntax;

}  // namespace
}  // namespace fanuc
