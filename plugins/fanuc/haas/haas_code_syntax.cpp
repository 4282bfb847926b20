/// Functions of a Haas mill that are recognised but not executed. F of such a block becomes the feed in force all the
/// same.
#include <isogloss/cnc/recognised_codes.hpp>
#include <isogloss/cnc/tool_dimension.hpp>
#include <isogloss/cnc/whole_number.hpp>
#include <isogloss/sdk.hpp>

namespace fanuc {

using namespace ig::cnc;

namespace {

struct HaasCode {
  static constexpr auto spec = ig::syntax("HaasCodeSyntax", "Reports the functions of a Haas that are not executed.")
                                   .after("ParameterizedFlagSyntax")
                                   .before("NotExecutedSyntax", "UnconsumedCheckSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "FAN-0208",
                     "G141: D{0} has no radius in the tool table, so the path is not compensated up to G40"),
      ig::diagnostic(IG_WARNING, "FAN-0212",
                     "G143: H{0} has no length in the tool table, so nothing is added along the tool up to G49"),
  };

  RecognisedCodes codes_{
      ig::diag("FAN-0201"),
      {
          {ig::Call{{"G107"}, "X Y Z A B C Q R"}, "the path is not wrapped around the cylinder"},
          {ig::Call{{"G268"}, "X Y Z I J K Q[]"}, "positions up to G269 are not in the tilted plane"},
          {ig::Call{{"G253"}, ""}, "the rotary axes do not turn to the tilted plane"},
          {ig::Call{{"G174", "G184"}, "X Y Z R"}, "the cycle is missing, and blocks after it only move"},
          {ig::Call{{"G153", "G155", "G161", "G162", "G163", "G164", "G165", "G166", "G169"}, "E I J K L[] P[] Q"},
           "the cycle is missing, and blocks after it only move"},
          {ig::Call{{"M96"}, "P[] Q[]"}, "the program goes on with the next block, whatever the input is"},
          {ig::Call{{"M109"}, "P[]"}, "no operator answers, so the variable keeps its value"},
      }};
  ig::Call length_{{"G143"}, "H[]"};
  ig::Call plane_off_{{"G269"}, ""};
  /// Under G141 each block gives the point of contact by I, J and K.
  ig::Call compensation_on_{{"G141"}, "D[]"};
  ig::In<std::int64_t> offset_id_{"RadiusCompensation.OffsetId"};
  ig::Service<ig_tool_offset_1> table_{"isogloss.tool-offset/1", ig::Need::optional,
                                       "Length of H and radius of D, with their wear."};
  ig::Codes compensation_off_{{"G40", "G41", "G42"}, ig::read};
  ig::Signal compensation_{"HaasCode.~Compensation", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  std::array<ig::Word, 3> contact_{ig::Word{"Parsing.I", ig::take}, ig::Word{"Parsing.J", ig::take},
                                   ig::Word{"Parsing.K", ig::take}};
  ig::Codes arcs_{{"G02", "G03"}, ig::read};

  ig::Status build(ig::Block& b) {
    bool changed = take_contact(b);
    changed |= report_compensation(b);
    changed |= report_length(b);
    changed |= b.take(plane_off_).has_value();  // nothing to end: G268 has been reported
    return codes_.report(b) || changed ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  /// Reports missing compensation; without a radius the path is right without it.
  bool report_compensation(ig::Block& b) const {
    const auto words = b.take(compensation_on_);
    if (!words) return false;
    const auto where = ig::Where::word(compensation_on_.code(0));
    const double d = (*words)['D'].value_or(static_cast<double>(b.get_or(offset_id_, std::int64_t{0})));
    const auto id = whole_number(d);
    if (!id || offset(*id, ToolDimension::radius) != 0)
      b.report(ig::diag("FAN-0201"), where, std::string_view("G141"),
               std::string_view(id ? "the path up to G40 is not compensated" : "D is no offset number"));
    else if (*id != 0)
      b.report(ig::diag("FAN-0208"), where, d);
    return true;
  }

  /// Reports a missing tool length; without a length the machine goes to the programmed positions as well.
  bool report_length(ig::Block& b) const {
    const auto words = b.take(length_);
    if (!words) return false;
    const auto where = ig::Where::word(length_.code(0));
    const auto h = (*words)['H'];
    const auto id = h ? whole_number(*h) : std::nullopt;
    if (!id || offset(*id, ToolDimension::length) != 0)
      b.report(ig::diag("FAN-0201"), where, std::string_view("G143"),
               std::string_view(id ? "up to G49 the length of H is not added along the turned tool"
                                   : "H is no offset number"));
    else if (*id != 0)
      b.report(ig::diag("FAN-0212"), where, *h);
    return true;
  }

  double offset(std::int64_t id, ToolDimension which) const { return tool_dimension(table_, id, which).value_or(0); }

  bool take_contact(ig::Block& b) const {
    const bool was_on = b.is_raised(compensation_), begins = b.find(compensation_on_).has_value();
    const bool ends = b.find(compensation_off_).has_value() && !begins;
    if (begins && !was_on) b.raise(compensation_);
    if (ends && was_on) b.erase(compensation_);
    bool any = begins != was_on && (begins || ends);
    if ((!was_on && !begins) || ends || b.find(arcs_)) return any;
    for (const ig::Word& word : contact_) any |= b.take(word).has_value();
    return any;
  }
};

const ig::Register<HaasCode> haas_code_syntax;

}  // namespace
}  // namespace fanuc
