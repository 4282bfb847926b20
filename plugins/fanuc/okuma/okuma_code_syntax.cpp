/// Functions of an Okuma OSP that are recognised but not executed; and G04 F, G71, M53 and M54, which are executed.
#include <isogloss/cnc/cycle_codes.hpp>
#include <isogloss/cnc/recognised_codes.hpp>
#include <isogloss/sdk.hpp>

namespace fanuc {

using namespace ig::cnc;

namespace {

struct OkumaCode {
  static constexpr auto spec =
      ig::syntax("OkumaCodeSyntax", "Executes codes of an Okuma, and reports those that are not executed.")
          .after("ParameterizedFlagSyntax", "UnitModeSyntax", "PlaneSelectSyntax", "PathModeSyntax")
          .before("DwellSyntax", "CannedCycleResolveSyntax", "NotExecutedSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "FAN-0203", "M53: {0}, so cycles return to the level where they began"),
  };

  RecognisedCodes codes_{
      ig::diag("FAN-0201"),
      {
          {ig::Call{{"G54", "G55", "G57", "G58", "G59"}, "H[]"}, "positions lack the tool length"},
          {ig::Call{{"G10", "G11"}, "X Y Z P[deg]"}, "positions are neither shifted nor turned"},
          {ig::Call{{"G30"}, "P[]"}, "the move to the home position is left out"},
          {ig::Call{{"G62"}, "X Y Z"}, "positions are not mirrored"},
          {ig::Call{{"G274", "G284"}, "X Y Z R P[] Q"}, "the cycle is missing, and blocks after it only move"},
          {ig::Call{{"M52"}, ""}, "a cycle returns to the level at which it began, not to the upper limit"},
      }};
  ig::Call dwell_{{"G04"}, "F[s]"};
  ig::Call level_{{"G71"}, "Z"};
  ig::Codes returns_{"M53", "M54"};
  ig::Codes to_limit_{{"M52"}, ig::read};  // ends M54; that the limit is higher is reported
  ig::Out<double> time_{"Dwell.Time"};
  ig::Field<double> return_level_{
      "CannedCycle.ReturnLevel",
      ig::read | ig::write,
      {ig::Life::modal, "mm", "Level to which the cycles return where the program names it."}};
  ig::Out<ig::Symbol> return_mode_{"CannedCycle.ReturnMode"};
  ig::Signal return_to_r_{"CannedCycle.~ReturnToR", ig::read | ig::write, ig::Life::modal};
  ig::Signal return_to_level_{"CannedCycle.~ReturnToNamedLevel", ig::read | ig::write, ig::Life::modal};
  ig::In<ig::Symbol> plane_{"PlaneSelect.Term", ig::wake};
  ig::Name g17_{"G17"}, g98_{"G98"}, g99_{"G99"};

  ig::Status build(ig::Block& b) {
    bool any = wait(b);
    if (const auto words = b.take(level_)) {
      any = true;
      if (const auto z = (*words)['Z'])
        b.set(return_level_, *z);
      else
        b.report(ig::diag("FAN-0201"), ig::Where::word(level_.code(words->row)), b.text(words->code),
                 std::string_view("Z, the level, is missing"));
    }
    const auto code = b.take(returns_);
    if (code) {
      any = true;
      return_to(b, *code);
    }
    if (b.find(to_limit_)) return_to_initial(b);
    const bool leaves_z = b.is_fresh(plane_) && !is_along_z(b) && b.is_raised(return_to_level_);
    if (leaves_z && !code) report_level(b, ig::Where::block());
    return codes_.report(b) || any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  enum : std::size_t { to_level, to_r };

  /// G04 F1.5: seconds. With X or P DwellSyntax executes it. A negative time is not taken, so that it is reported as
  /// unused.
  bool wait(ig::Block& b) const {
    ig_value seconds;
    if (!b.get(dwell_.word(0, 'F'), seconds) || seconds.number < 0) return false;
    b.take(dwell_.word(0, 'F'), seconds);
    b.set(time_, seconds.number);
    return true;
  }

  void return_to_initial(ig::Block& b) const {
    b.erase(return_to_r_);
    b.erase(return_to_level_);
    if (b.has(return_mode_)) b.amend(return_mode_, static_cast<ig::Symbol>(g98_));
  }

  bool is_along_z(const ig::Block& b) const { return !b.has(plane_) || b.is(plane_, g17_); }

  void report_level(ig::Block& b, ig::Where where) const {
    b.report(ig::diag("FAN-0203"), where,
             std::string_view(is_along_z(b) ? "no G71 Z gives a level" : "G71 is executed in G17 alone"));
  }

  void return_to(ig::Block& b, std::size_t code) const {
    return_to_initial(b);
    if (code == to_r) {
      b.raise(return_to_r_);
      if (b.has(return_mode_)) b.amend(return_mode_, static_cast<ig::Symbol>(g99_));
      return;
    }
    b.raise(return_to_level_);
    if (!b.has(return_level_) || !is_along_z(b)) report_level(b, ig::Where::word(returns_.id(code)));
  }
};

const ig::Register<OkumaCode> okuma_code_syntax;

}  // namespace
}  // namespace fanuc
