/// F and G93/G94/G95: the feed in force and what it counts. F and its mode are modal; under G93, where F is the inverse
/// of the block's own time, F holds for its block only.
#include "cycle_codes.hpp"
#include "feed_util.hpp"
#include "modal_group.hpp"

namespace iso {
namespace {

enum class ModeChange { keep, require_f };

struct Feedrate {
  static constexpr auto spec = ig::syntax("FeedrateSyntax", "F and G93/G94/G95 feed modes.")
                                   .after("UnitModeSyntax")
                                   .before("CannedCycleResolveSyntax", "CircularMotionSyntax", "LinearMotionSyntax");

  ig::Codes modes_{"G93", "G94", "G95"};
  ig::Word f_{"Parsing.F"};
  ig::InWhile<ig::Symbol> while_inverse_time_{"Feedrate.Term", "G93"};
  FeedInForce feed_{ig::read | ig::write};
  ig::In<ig::Symbol> unit_{"Feedrate.Unit"};
  ig::Choice<ModeChange> mode_change_{"mode-change", "keep|require-f", "keep",
                                      "What G94 and G95 do with the number of the other one."};
  ig::Name g93_{"G93"};
  ig::Call cycles_{cycle_codes, "F", ig::read};

  ig::Status build(ig::Block& b) {
    const auto f = b.take(f_);
    const bool is_feed = f && *f > 0;
    const auto mode = take_modal(b, modes_);
    if (mode) change_mode(b, *mode, is_feed);
    const bool expired = !is_feed && feed_.is_inverse_time(b) && feed_.value(b).has_value();
    if (expired) feed_.forget(b);
    feed_.resolve(b, f, ig::Where::word(f_.id()));
    return f || mode || expired ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  /// An F that the cycle of this block will put in force.
  bool has_cycle_feed(const ig::Block& b) const {
    const auto cycle = b.find(cycles_);
    ig_value f;
    return cycle && b.host()->get(b.raw(), cycles_.row(*cycle)[0], &f) != 0 && f.number > 0;
  }
  void change_mode(ig::Block& b, std::size_t mode, bool with_f) const {
    const ig::Symbol before = feed_.mode(b);
    const ig::Symbol now = modes_.name(mode);
    if (before != now && !with_f && feed_.value(b)) {
      const bool from_or_to_time = before == g93_ || now == g93_;
      if (!from_or_to_time && mode_change_ == ModeChange::require_f && !has_cycle_feed(b))
        b.report(diag("ISO-0211"), ig::Where::word(modes_.id(mode)), b.text(now),
                 b.text(b.get_or(unit_, ig::Symbol{})));
      if (from_or_to_time || mode_change_ == ModeChange::require_f) feed_.forget(b);
    }
    feed_.set_mode(b, now);
  }
};

const ig::Register<Feedrate> registered;

}  // namespace
}  // namespace iso
