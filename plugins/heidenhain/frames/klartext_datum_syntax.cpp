// M92: the positions of the block are measured from a datum that the builder has set for each axis. They become
// positions of the machine, as those of M91, before any other syntax reads them.
#include <isogloss/cnc/axis_names.hpp>
#include <isogloss/sdk.hpp>

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextDatum {
  static constexpr auto spec =
      ig::syntax("KlartextDatumSyntax", "M92: positions from the builder's datum become positions of the machine.")
          .after("UnitModeSyntax")
          .before("KlartextRotaryStepSyntax", "KlartextMotionSyntax", "MachineCoordSelectSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0360",
                     "M92: the table of axes gives {0} no datum, so {0} is measured from machine zero: add Datum"),
  };

  ig::In<bool> from_datum_{"KlartextPath.IsFromDatum",
                           ig::wake,
                           {ig::Life::block, "", "M92: positions are measured from the builder's datum."}};
  std::array<ig::Word, 6> words_{
      ig::Word{"Parsing.X", ig::read | ig::write, "mm"},  ig::Word{"Parsing.Y", ig::read | ig::write, "mm"},
      ig::Word{"Parsing.Z", ig::read | ig::write, "mm"},  ig::Word{"Parsing.A", ig::read | ig::write, "deg"},
      ig::Word{"Parsing.B", ig::read | ig::write, "deg"}, ig::Word{"Parsing.C", ig::read | ig::write, "deg"}};
  AxisNames axes_;

  ig::Status build(ig::Block& b) const {
    if (!b.get_or(from_datum_, false)) return ig::Status::unchanged;
    bool any = false;
    for (std::uint32_t axis = 0; axis < words_.size(); ++axis) {
      const auto word = b.get(words_[axis]);
      if (!word) continue;
      const auto datum = axes_.position(axis, IG_AXIS_DATUM);
      if (!datum) b.report(ig::diag("HEI-0360"), ig::Where::word(words_[axis].id()), axis_letters.substr(axis, 1));
      if (datum.value_or(0) == 0) continue;
      b.rewrite(words_[axis].id(), *word + *datum);
      any = true;
    }
    return any ? ig::Status::changed : ig::Status::unchanged;
  }
};

const ig::Register<KlartextDatum> klartext_datum_syntax;

}  // namespace
}  // namespace heidenhain
