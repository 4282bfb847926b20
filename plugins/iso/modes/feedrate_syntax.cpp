/// F and G93, G94, G95: the feed in force and its unit. F and its mode are modal; under G93, where F is the inverse of
/// the block's time, F holds for its block only.
#include <isogloss/cnc/feed.hpp>
#include <isogloss/cnc/modal_group.hpp>

namespace iso {

using namespace ig::cnc;

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
  ig::Choice<ModeChange> mode_change_{"mode-change", "keep|require-f", "keep",
                                      "What G94 and G95 do with the feed rate of the other mode."};
  ig::Name g93_{"G93"};

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
  void change_mode(ig::Block& b, std::size_t mode, bool with_f) const {
    const ig::Symbol before = feed_.mode(b);
    const ig::Symbol now = modes_.name(mode);
    if (before != now && !with_f && feed_.value(b)) {
      if (before == g93_ || now == g93_)
        feed_.forget(b);
      else if (mode_change_ == ModeChange::require_f)
        feed_.end(b);
    }
    feed_.set_mode(b, now);
  }
};

const ig::Register<Feedrate> feedrate_syntax;

}  // namespace
}  // namespace iso
