/// Functions of a Haas mill that are recognised but not executed. F of such a block is the feed in force all the same.
#include "brand_diagnostics.hpp"
#include "recognised_codes.hpp"
#include "whole_number.hpp"

namespace fanuc {
namespace {

struct HaasCode {
  static constexpr auto spec = ig::syntax("HaasCodeSyntax", "Says the functions of a Haas that are not executed.")
                                   .after("ParameterizedFlagSyntax")
                                   .before("NotExecutedSyntax", "UnconsumedCheckSyntax");

  iso::RecognisedCodes codes_{
      brand_diag("FAN-0201"),
      {
          {ig::Call{{"G107"}, "X Y Z A B C Q R"}, "the path is not wrapped around the cylinder"},
          {ig::Call{{"G143"}, "H[]"}, "positions do not follow the rotary axes"},
          {ig::Call{{"G174", "G184"}, "X Y Z R"}, "the cycle is missing, and blocks after it only move"},
          {ig::Call{{"G153", "G155", "G161", "G162", "G163", "G164", "G165", "G166", "G169"}, "E I J K L[] P[] Q"},
           "the cycle is missing, and blocks after it only move"},
          {ig::Call{{"M96"}, "P[] Q[]"}, "the program goes on with the next block, whatever the input is"},
          {ig::Call{{"M109"}, "P[]"}, "nobody answers, and its variable keeps its value"},
      }};
  /// Under G141 each block says by I, J and K where the tool touches.
  ig::Call compensation_on_{{"G141"}, "D[]"};
  ig::In<std::int64_t> offset_id_{"RadiusCompensation.OffsetId"};
  ig::Service<ig_tool_offset_1> table_{"isogloss.tool-offset/1", ig::Need::optional, "Radius geometry and wear of D."};
  ig::Codes compensation_off_{{"G40", "G41", "G42"}, ig::read};
  ig::Signal compensation_{"HaasCode.~Compensation", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  std::array<ig::Word, 3> contact_{ig::Word{"Parsing.I", ig::take}, ig::Word{"Parsing.J", ig::take},
                                   ig::Word{"Parsing.K", ig::take}};
  ig::Codes arcs_{{"G02", "G03"}, ig::read};

  ig::Status build(ig::Block& b) {
    bool changed = take_contact(b);
    changed |= say_compensation(b);
    return codes_.say(b) || changed ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  /// Without a radius the path is right as it is.
  bool say_compensation(ig::Block& b) const {
    const auto words = b.take(compensation_on_);
    if (!words) return false;
    const auto where = ig::Where::word(compensation_on_.code(0));
    const double d = (*words)['D'].value_or(static_cast<double>(b.get_or(offset_id_, std::int64_t{0})));
    const auto id = iso::whole_number(d);
    double geometry = 0, wear = 0;
    if (id && table_ && table_->get(table_->self, *id, 2, &geometry) == 0) geometry = 0;
    if (id && table_ && table_->get(table_->self, *id, 3, &wear) == 0) wear = 0;
    if (!id || geometry + wear != 0)
      b.report(brand_diag("FAN-0201"), where, std::string_view("G141"),
               std::string_view(id ? "the path is not compensated, up to G40" : "D is no offset number"));
    else if (*id != 0)
      b.report(brand_diag("FAN-0208"), where, d);
    return true;
  }

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

const ig::Register<HaasCode> registered;

}  // namespace
}  // namespace fanuc
