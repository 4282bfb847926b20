/// DIAMON and DIAM90: X of a turned part is a diameter. The word is converted to the radius before any other syntax
/// reads it, so that all positions of the run are distances from the axis.
#include <isogloss/cnc/modal_group.hpp>

#include "modes/axis_modes.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensDiameter {
  static constexpr auto spec =
      ig::syntax("SiemensDiameterSyntax", "DIAMON, DIAM90 and DIAMOF: X as a diameter.")
          .after("SiemensUnitSyntax", "PositioningModeSyntax", "SiemensFrameSyntax")
          .before("SiemensPolarSyntax", "SiemensMachineCoordinatesSyntax", "SiemensPositionSyntax");

  ig::Codes codes_{"DIAMON", "DIAM90", "DIAMOF"};
  ig::Field<ig::Symbol> term_{"DiameterProgramming.Term",
                              ig::read | ig::write | ig::wake_while,
                              {ig::Life::modal, "", "DIAMON or DIAM90, while X is a diameter."}};
  ig::Word x_{"Parsing.X", ig::read | ig::write}, i_{"Parsing.I", ig::read | ig::write},
      i1_{"Parsing.I1", ig::read | ig::write};
  AxisModes modes_{ig::read};
  ig::In<ig::Symbol> positioning_{"PositioningMode.Term"};
  ig::Name diamon_{"DIAMON"}, g91_{"G91"}, ac_{"AC"}, ic_{"IC"};

  ig::Status build(ig::Block& b) {
    const auto code = take_modal(b, codes_);
    if (code && *code == off)
      b.erase(term_);
    else if (code)
      b.set(term_, codes_.name(*code));
    if (!b.has(term_)) return code ? ig::Status::changed : ig::Status::unchanged;
    bool any = code.has_value();
    if (!is_radius(b, AxisModes::index_of("X"))) any |= halve(b, x_);
    if (!is_radius(b, AxisModes::index_of("I1"))) any |= halve(b, i1_);
    if (const auto mode = modes_.get(b, AxisModes::index_of("I")); mode && *mode == ac_) any |= halve(b, i_);
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  static constexpr std::size_t off = 2;

  /// Under DIAM90 distances remain radii.
  bool is_radius(const ig::Block& b, std::size_t word) const {
    const auto mode = modes_.get(b, word);
    const bool is_distance = mode ? *mode == ic_ : b.is(positioning_, g91_);
    return is_distance && !b.is(term_, diamon_);
  }
  static bool halve(ig::Block& b, const ig::Word& word) {
    const auto value = b.get(word);
    if (value) b.rewrite(word.id(), *value / 2);
    return value.has_value();
  }
};

const ig::Register<SiemensDiameter> siemens_diameter_syntax;

}  // namespace
}  // namespace siemens
