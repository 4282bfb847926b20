/// Functions of Mazak's EIA/ISO programs that are recognised but not executed. D of a canned cycle is among them: it is
/// a distance there, not a tool radius number.
#include <isogloss/cnc/cycle_codes.hpp>
#include <isogloss/cnc/cycle_in_force.hpp>
#include <isogloss/cnc/recognised_codes.hpp>
#include <isogloss/sdk.hpp>

namespace fanuc {

using namespace ig::cnc;

namespace {

struct MazakCode {
  static constexpr auto spec =
      ig::syntax("MazakCodeSyntax", "Reports the functions of a Mazak that are not executed.")
          .after("ParameterizedFlagSyntax")
          .before("CannedCycleResolveSyntax", "RadiusCompensationSyntax", "NotExecutedSyntax", "UnconsumedCheckSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "FAN-0202", "D{0} of a canned cycle is ignored: the hole is drilled at one feed rate"),
  };

  RecognisedCodes codes_{ig::diag("FAN-0201"),
                         {
                             {ig::Call{{"G71.1", "G72.1", "G75", "G78", "G79", "G82.2", "G84.2", "G84.3"},
                                       "X Y Z R I J K L[] P[] Q D[] B E[mm/min]"},
                              "the cycle is missing, and blocks after it only move"},
                         }};

  ig::Word d_{"Parsing.D", ig::take | ig::wake, ""};
  CycleCalls cycles_{"", ig::read};
  CycleInForce cycle_;

  ig::Status build(ig::Block& b) {
    const bool is_hole = b.find(cycles_) || cycle_.is_on(b);
    const auto d = is_hole ? b.take(d_) : std::nullopt;
    if (d) b.report(ig::diag("FAN-0202"), ig::Where::word(d_.id()), *d);
    return codes_.report(b) || d ? ig::Status::changed : ig::Status::unchanged;
  }
};

const ig::Register<MazakCode> mazak_code_syntax;

}  // namespace
}  // namespace fanuc
