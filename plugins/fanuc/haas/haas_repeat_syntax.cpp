/// L in a block of plain motion: a Haas makes the move that many times. The block is run again, so that under G91 each
/// pass starts at the end of the one before.
#include <cmath>
#include <string>

#include <isogloss/cnc/whole_number.hpp>
#include <isogloss/flow.hpp>
#include <isogloss/provenance.hpp>
#include <isogloss/sdk.hpp>

namespace fanuc {

using namespace ig::cnc;

namespace {

struct HaasRepeat {
  static constexpr auto spec = ig::syntax("HaasRepeatSyntax", "L of a Haas: makes the move of its block L times.")
                                   .after("CannedCycleResolveSyntax", "CircularMotionSyntax", "LinearMotionSyntax")
                                   .before("HaasCodeSyntax", "UnconsumedCheckSyntax");

  /// An L that no cycle, call or pocket has taken.
  ig::Word repeats_{"Parsing.L", ig::take | ig::wake, ""};
  ig::In<ig::Symbol> form_{"MotionEvent.Form"};
  ig::IntegerOption most_{"max-repeats", "10000", {1, 1'000'000}, "How often one block may be executed."};
  ig::Flow flow_;
  ig::ExaminedConditions examined_;

  ig_place block_{};
  std::int64_t left_ = 0;

  ig::Status restart(ig::Block&) {
    left_ = 0;
    return ig::Status::unchanged;
  }

  ig::Status build(ig::Block& b) {
    const auto l = b.take(repeats_);
    if (!l) return ig::Status::unchanged;
    if (*l == 1) return ig::Status::changed;
    const auto count = whole_number(*l);
    if (!b.has(form_)) {
      report(b, "its block has no G00 to G03 move");
    } else if (!count || *count == 0) {
      report(b, "it is not a whole number above 0; the block is executed once");
    } else if (*count > most_) {
      report(b, "it exceeds max-repeats; the block is executed once");
    } else {
      again(b, *count);
    }
    return ig::Status::changed;
  }

 private:
  void again(ig::Block& b, std::int64_t count) {
    const ig_place here = flow_.here(b);
    const bool is_pass = left_ > 0 && here.frame == block_.frame && here.offset == block_.offset;
    left_ = is_pass ? left_ - 1 : count - 1;
    block_ = here;
    if (examined_.is_heard())
      examined_.add_reason(b, left_ > 0 ? "pass " + std::to_string(count - left_ + 1) + " of " + std::to_string(count) +
                                              " of the block follows"
                                        : "all " + std::to_string(count) + " passes of the block are made");
    if (left_ > 0 && !flow_.go_to(b, here).is_done()) {
      left_ = 0;
      report(b, "the remaining repeats are left out");
    }
  }

  void report(ig::Block& b, std::string_view why) const {
    b.report(ig::diag("FAN-0201"), ig::Where::word(repeats_.id()), std::string_view("L"), why);
  }
};

const ig::Register<HaasRepeat> haas_repeat_syntax;

}  // namespace
}  // namespace fanuc
