// U, V and W of axes that the machine's table declares. Without such an axis the words stay, for UnconsumedCheckSyntax.
// It runs before lengths become millimetres, because U may be a rotary axis.
#include <isogloss/cnc/further_axes.hpp>
#include <isogloss/sdk.hpp>

#include "motion/further_axis_order.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct FurtherAxisWord {
  static constexpr auto spec =
      ig::syntax("FurtherAxisWordSyntax", "Words of the axes U, V and W that the machine has.")
          .after("ParameterizedFlagSyntax", "DecimalPointSyntax", "UnknownCodeSyntax")
          .before("UnitModeSyntax", "ProgrammableDataInputSyntax", "IsoLocalCoordinateOffsetSyntax",
                  "WorkCoordinateShiftSyntax", "MachineCoordSelectSyntax", "ReturnFromReferenceSyntax",
                  "ReferenceReturnSyntax", "ReferenceCheckSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0590", "{0} beside {1} is not executed: {1} acts on X, Y, Z, A, B and C alone"),
  };

  std::array<ig::Word, 3> letters_{ig::Word{"Parsing.U"}, ig::Word{"Parsing.V"}, ig::Word{"Parsing.W"}};
  std::array<ig::Field<double>, most_further_axes> words_{word(1), word(2), word(3), word(4), word(5), word(6)};
  ig::Signal named_{"FurtherAxes.~Named", ig::write};
  ig::Codes others_{{"G50.1", "G51", "G51.1"}, ig::read};
  ig::Codes orders_{{"G27", "G28", "G29", "G30", "G52", "G53", "G92"}, ig::read};
  FurtherAxisOrder no_position_{"NoPosition"};
  AxisNames axes_;
  std::array<std::optional<std::uint32_t>, 3> axis_of_{axes_.find("U"), axes_.find("V"), axes_.find("W")};

  FurtherAxisWord() {
    if (axes_.name(first_further_axis).empty()) ig::stay_idle();
  }

  ig::Status build(ig::Block& b) const {
    for (std::size_t i = 0; i < letters_.size(); ++i)
      if (axis_of_[i] && b.has(letters_[i])) b.move(letters_[i].id(), words_[*axis_of_[i] - first_further_axis].id());
    const auto code = b.find(others_);
    bool any = false;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (!b.has(words_[i])) continue;
      any = true;
      if (code) refuse(b, i, others_.name(*code));
    }
    if (any && !code) b.raise(named_);
    if (any && b.find(orders_)) no_position_.give(b);
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  static ig::Field<double> word(int number) {
    return ig::Field<double>("Parsing.FurtherAxis" + std::to_string(number), ig::read | ig::write | ig::take | ig::wake,
                             {ig::Life::word, "", ""});
  }

  void refuse(ig::Block& b, std::size_t i, ig::Symbol code) const {
    const std::string_view name = axes_.name(first_further_axis + static_cast<std::uint32_t>(i));
    b.report(ig::diag("ISO-0590"), ig::Where::word(words_[i].id()), name, b.text(code));
    b.take(words_[i].id());
  }
};

const ig::Register<FurtherAxisWord> further_axis_word_syntax;

}  // namespace
}  // namespace iso
