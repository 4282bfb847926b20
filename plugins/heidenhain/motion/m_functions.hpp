/// M functions, which may stand in any block: those that ISO has as well become its codes, the others are executed here
/// or reported. Positions are byte offsets into the text of the block; lengths are in the unit of the program.
#pragma once

#include <vector>

#include <isogloss/cnc/axis_names.hpp>
#include <isogloss/cnc/machine_codes.hpp>
#include <isogloss/cnc/rotary_axis.hpp>

#include "language/klartext_values.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// A member of each syntax whose blocks hold M functions.
class MFunctions {
 public:
  MFunctions();

  /// Reads the M at `position`; returns the position after it and after the words that belong to it.
  std::size_t scan(ig::Block& b, const Values& values, std::string_view text, std::size_t position) const;

  /// Executes a code for which other text stands, that from `begin` to `end`: one that is no M function is a leftover.
  /// Returns the position after the words that belong to it.
  std::size_t put(ig::Block& b, const Values& values, std::string_view text, std::string_view code, std::size_t begin,
                  std::size_t end) const;

  /// The block holds M140 MB.
  bool retracts(const ig::Block& b) const { return b.has(to_limit_) || b.has(distance_); }

 private:
  /// An M function whose words are in the text up to a position.
  struct Function {
    std::uint32_t number;
    std::size_t begin, end;
  };

  std::size_t act(ig::Block& b, const Values& values, std::string_view text, const Function& m) const {
    return m.number == 140 ? retract(b, values, text, m) : execute(b, values, text, m);
  }
  /// An M function of the control, executed or not.
  bool knows(std::uint32_t m) const;
  /// An M function of the machine's builder: `row` of MachineCodes.
  std::size_t of_builder(ig::Block& b, const Values& values, std::string_view text, const Function& m,
                         const ig_machine_code& row) const;
  std::size_t execute(ig::Block& b, const Values& values, std::string_view text, const Function& m) const;
  /// M140 MB 50, M140 MB MAX: a retract along the tool axis. An F of its own may follow.
  std::size_t retract(ig::Block& b, const Values& values, std::string_view text, const Function& m) const;
  /// M92: positions from the builder's datum, or from machine zero where the table of axes gives no axis a datum.
  void name_datum(ig::Block& b, const Values& values, const Function& m) const;
  /// M94 and M94 C: removes whole turns from the display of the axes. Axes without limits do not move.
  std::size_t reduce(ig::Block& b, std::string_view text, const Function& m) const;
  /// M128. Without a TOOL CALL before it the tool in the spindle is used; its length is not known.
  void lead_tip(ig::Block& b, const Function& m) const;
  /// The code of the same number that a syntax of the chain knows; a leftover where none does.
  void code(ig::Block& b, const Function& m) const;

  MachineCodes machine_;
  MachineCodeRecord record_;
  ig::Fields codes_{"codes", "Parsing.Flags.* Parsing.*", ig::write, "The codes that syntaxes of this chain know.",
                    IG_CODE};
  std::vector<ig_field> table_;
  ig::Codes g53_{{"G53"}, ig::write};
  ig::Out<bool> from_datum_{"KlartextPath.IsFromDatum",
                            {ig::Life::block, "", "M92: positions are measured from the builder's datum."}};
  AxisNames axis_names_;
  ig::Out<bool> to_limit_{"KlartextPath.RetractsToLimit",
                          {ig::Life::block, "", "M140 MB MAX: along the tool axis to the end of the travel."}};
  ig::Field<double> distance_{
      "Parsing.MB", ig::read | ig::write, {ig::Life::word, "mm", "M140 MB: how far along the tool axis."}};
  ig::Codes feed_modes_{{"G94", "G95"}, ig::write};
  ig::Call tcp_{{"G43.4"}, "H[]", ig::write};
  ig::Previous<std::int64_t> offset_id_{"ToolHeightCompensation.OffsetId"};
  ig::Call length_{{"G43"}, "", ig::write};
  ig::Previous<ig::Symbol> length_term_{"ToolHeightCompensation.Term"};
  ig::Name led_{"G43.4"}, led_by_direction_{"G43.5"};
  ig::Out<bool> call_{"KlartextCycle.IsCalled",
                      {ig::Life::block, "", "The block calls the cycle: CYCL CALL, M99 or M89."}};
  ig::Out<bool> modal_call_{"KlartextCycle.IsModal",
                            {ig::Life::modal, "", "M89: each positioning block calls the cycle."}};
  ig::Out<ig::Symbol> rotary_path_{"RotaryPath.Term",
                                   {ig::Life::modal, "", "M126 or M127: how rotary axes go to a position."}};
  ig::Out<ig::Symbol> feed_on_arcs_{
      "RadiusCompensation.FeedOnArcs",
      {ig::Life::modal, "", "Center, Contour or ContourInside: where F holds on an arc."}};
  RotaryAxes axes_;
  ig::Signal per_revolution_{"KlartextFeed.~PerRevolution", ig::write, ig::Life::modal};
};

}  // namespace heidenhain
