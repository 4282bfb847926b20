// Calls of cycles that no earlier syntax has executed: each is reported, and the block moves as without the call.

#include <isogloss/cnc/machine_codes.hpp>
#include <isogloss/sdk.hpp>

#include "cycles/cycle_number.hpp"

namespace heidenhain {
namespace {

struct KlartextCycleCheck {
  static constexpr auto spec = ig::syntax("KlartextCycleCheckSyntax", "Reports calls of cycles that are not executed.")
                                   .after("KlartextCycleSyntax", "KlartextPathSyntax")
                                   .before("MachineCoordSelectSyntax", "ProgramXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0160", "cycle {0} is not executed: what it machines is missing from the path"),
      ig::diagnostic(IG_ERROR, "HEI-0162",
                     "{0} has no cycle to call, so nothing is machined: program CYCL DEF before it"),
      ig::diagnostic(IG_ERROR, "HEI-0167",
                     "{0} stands in the block of an arc, so the cycle is not executed: use a straight move"),
  };

  ig::In<bool> call_{"KlartextCycle.IsCalled", ig::wake, {ig::Life::block, "", ""}};
  ig::In<bool> modal_call_{"KlartextCycle.IsModal", ig::wake_while, {ig::Life::modal, "", ""}};
  ig::Signal done_{"KlartextCycle.~Done", ig::read};
  ig::Signal said_{"CycleDefinition.~Said", ig::read | ig::write, ig::Life::modal};
  ig::In<std::int64_t> number_{"CycleDefinition.Number", ig::read, {ig::Life::modal, "", ""}};
  ig::In<std::int64_t> pattern_{"KlartextPattern.Number", ig::read, {ig::Life::block, "", ""}};
  ig::Xyz words_{"Parsing", ig::read};
  ig::Codes others_{{"G02", "G03", "G53"}, ig::read};

  ig::Status build(ig::Block& b) const {
    if (b.is_raised(done_)) return ig::Status::unchanged;
    const bool is_called = b.has(call_);
    if (!is_called && (!b.has(modal_call_) || b.get(words_).mask == 0)) return ig::Status::unchanged;
    const bool is_pattern = b.has(pattern_);
    const std::string_view call = is_pattern ? "the pattern" : is_called ? "CYCL CALL, M99 or M89" : "M89";
    const std::int64_t number = b.get_or(number_, std::int64_t{0});
    if (number == 0) {
      b.report(ig::diag("HEI-0162"), ig::Where::block(), call);
    } else if (b.find(others_) && is_known(number)) {
      b.report(ig::diag("HEI-0167"), ig::Where::block(), call);
    } else if (!b.is_raised(said_)) {
      b.report(ig::diag("HEI-0160"), ig::Where::block(), static_cast<double>(number));
      b.raise(said_);
    }
    return ig::Status::changed;
  }

 private:
  static bool is_known(std::int64_t number) {
    return (number >= 200 && number <= 209) || number == 240 || number == 241 || (number >= 251 && number <= 254) ||
           number == 1 || number == 2 || number == 17;
  }
};

const ig::Register<KlartextCycleCheck> klartext_cycle_check_syntax;

}  // namespace
}  // namespace heidenhain
