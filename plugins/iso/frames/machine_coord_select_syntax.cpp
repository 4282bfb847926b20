/// G53: for this block the axis words are positions of the gauge point in machine coordinates. No offset applies to
/// them, tool length included; axes that are not named do not move. Under G91 most controls ignore G53.
#include <isogloss/cnc/machine_target.hpp>
#include <isogloss/cnc/motion_event.hpp>
#include <isogloss/cnc/program_xyz.hpp>

#include "motion/further_axis_order.hpp"
#include "tool/untravelled_length.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

enum class Motion { modal, rapid };
enum class UnderG91 { ignored, words_too, absolute };

struct MachineCoordSelect {
  static constexpr auto spec =
      ig::syntax("MachineCoordSelectSyntax", "G53 machine coordinates for one block.")
          .after("PositioningModeSyntax", "CannedCycleResolveSyntax")
          .before("ProgramXyzSyntax", "McXyzSyntax", "CircularMotionSyntax", "LinearMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ISO-0330", "G53 is ignored under G91, so nothing moves: program G90"),
      ig::diagnostic(IG_NOTE, "ISO-0331", "G53 without an axis word: nothing moves"),
  };

  ig::Codes g53_{"G53"};
  ig::Xyz words_{"Parsing", ig::take};
  ig::Xyz program_{"ProgramXyz", ig::write};
  ig::Xyz machine_{"MachineCoordinate", ig::read | ig::write};
  std::array<ig_field, 3> rotary_{rotary_word("Parsing.A"), rotary_word("Parsing.B"), rotary_word("Parsing.C")};
  BlockMotion move_;
  NamesFurtherAxes names_further_;
  FurtherAxisOrder further_{"G53"}, drop_further_{"Nothing"};
  ig::Signal axis_words_void_{"MachineCoordSelect.~AxisWordsVoid", ig::write};
  DistanceMode distance_;
  LastProgramXyz last_;
  ig::Field<double> untravelled_ = untravelled_length(ig::read | ig::write);
  ig::Choice<Motion> motion_{"motion", "modal|rapid", "modal",
                             "How the block moves: by the code of group 01, or always by rapid."};
  ig::Choice<UnderG91> under_g91_{"under-g91", "ignored|words-too|absolute", "ignored",
                                  "G53 under G91: nothing moves and the words stay unused; G53 and its words are "
                                  "ignored; or X, Y and Z are positions as under G90."};

  ig::Status build(ig::Block& b) {
    if (!b.take(g53_)) return ig::Status::unchanged;
    ig_value unused[3];
    const bool turns = b.get_many(rotary_.data(), 3, unused) != 0;  // McAbcSyntax takes them
    const bool incremental = distance_.is_incremental(b) && (under_g91_ != UnderG91::absolute || turns);
    const ig::PartialVec3 named = incremental && under_g91_ != UnderG91::words_too ? b.get(words_) : b.take(words_);
    (incremental ? drop_further_ : further_).give(b);
    if (named.mask == 0 && !turns && !names_further_(b)) {
      b.report(ig::diag("ISO-0331"), ig::Where::word(g53_.id(0)));
      return ig::Status::changed;
    }
    if (incremental) {
      b.report(ig::diag("ISO-0330"), ig::Where::word(g53_.id(0)));
      b.raise(axis_words_void_);
      return ig::Status::changed;
    }
    if (named.mask == 0 && !turns) return ig::Status::changed;
    const ig::Vec3 to = named.or_else(machine_position(b, machine_, last_));
    if (!set_machine_target(b, machine_, program_, to)) b.report(ig::diag("ISO-0332"), ig::Where::block());
    if (named.has(2) && b.has(untravelled_)) b.erase(untravelled_);
    if (motion_ == Motion::rapid) move_.rapid(b);
    return ig::Status::changed;
  }

 private:
  static ig_field rotary_word(const char* path) {
    return ig::Field<double>(path, ig::read, {ig::Life::standard, "deg", ""}).id();
  }
};

const ig::Register<MachineCoordSelect> machine_coord_select_syntax;

}  // namespace
}  // namespace iso
