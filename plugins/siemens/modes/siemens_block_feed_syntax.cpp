/// FB=: the feed of one block, in the unit of F. The modal F does not change.
#include <isogloss/sdk.hpp>

namespace siemens {
namespace {

struct SiemensBlockFeed {
  static constexpr auto spec =
      ig::syntax("SiemensBlockFeedSyntax", "FB=: the feed of one block.")
          .after("FeedrateSyntax", "SpindleSpeedSyntax", "CircularMotionSyntax", "LinearMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0281",
                     "FB={0} is not a feed rate, so F is used instead: program FB= greater than 0"),
      ig::diagnostic(IG_WARNING, "SIE-0282",
                     "FB= has no effect, because this block has no feed move: program FB= with G1, G2 or G3"),
      ig::diagnostic(IG_ERROR, "SIE-0283",
                     "FB= needs a feed rate F to compare with, so the speed is not known: program F before it"),
  };

  ig::Word fb_{"Parsing.FB", ig::wake, "mm/min", "The feed of this block."};
  ig::In<double> value_{"Feedrate.FeedrateValue"};
  ig::In<ig::Symbol> form_{"MotionEvent.Form"};
  ig::In<bool> is_rapid_{"MotionEvent.IsRapid"};
  ig::Field<double> feedrate_{"MotionEvent.Feedrate_mmds", ig::read | ig::write, {ig::Life::standard, "mm/s", ""}};

  ig::Status build(ig::Block& b) {
    const auto fb = b.take(fb_);
    if (!fb) return ig::Status::unchanged;
    const auto where = ig::Where::word(fb_.id());
    const double f = b.get_or(value_, 0.0), mmds = b.get_or(feedrate_, 0.0);
    if (!(*fb > 0))
      b.report(ig::diag("SIE-0281"), where, *fb);
    else if (!b.has(form_) || b.get_or(is_rapid_, false))
      b.report(ig::diag("SIE-0282"), where);
    else if (f > 0 && mmds > 0 && mmds * (*fb / f) < 1e9)
      b.set(feedrate_, mmds * (*fb / f));
    else
      b.report(ig::diag("SIE-0283"), where);
    return ig::Status::changed;
  }
};

const ig::Register<SiemensBlockFeed> siemens_block_feed_syntax;

}  // namespace
}  // namespace siemens
