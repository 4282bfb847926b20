/// G96, G961, G962 and G97 are in one group with G93, G94 and G95, so they also set the unit of F. G96 sets feed per
/// revolution, G961 feed per minute, G962 keeps the unit; and G93, G94 or G95 end G96. What remains is the G96 or G97
/// that SpindleSpeedSyntax knows.
#include <isogloss/sdk.hpp>

namespace siemens {
namespace {

struct SiemensFeedType {
  static constexpr auto spec = ig::syntax("SiemensFeedTypeSyntax", "G96, G961, G962, G971 and G972: the unit of F.")
                                   .before("FeedrateSyntax", "SpindleSpeedSyntax");

  ig::Codes kin_{"G961", "G971", "G962", "G972"};
  ig::Codes constant_{{"G96"}, ig::read | ig::write | ig::wake};
  ig::Codes ended_{{"G97"}, ig::read | ig::write};
  ig::Codes types_{{"G93", "G94", "G95"}, ig::read | ig::write | ig::wake};
  ig::In<ig::Symbol> rate_{"SpindleSpeed.Term"};

  ig::Status build(ig::Block& b) {
    const auto kin = b.take(kin_);
    if (!kin && !b.find(constant_)) return end_rate(b);
    if (kin) raise(b, *kin % 2 == 0 ? constant_.id(0) : ended_.id(0));
    const bool keeps_type = kin && *kin >= 2;
    if (keeps_type || b.find(types_)) return kin ? ig::Status::changed : ig::Status::unchanged;
    raise(b, types_.id(kin ? per_minute : per_revolution));
    return ig::Status::changed;
  }

 private:
  static constexpr std::size_t per_minute = 1, per_revolution = 2;

  /// Raises G97 where a feed type replaces G96 in the group.
  ig::Status end_rate(ig::Block& b) const {
    if (!b.find(types_) || b.find(ended_) || !b.is(rate_, constant_.name(0))) return ig::Status::unchanged;
    raise(b, ended_.id(0));
    return ig::Status::changed;
  }

  static void raise(ig::Block& b, ig_field code) { b.raise(code); }
};

const ig::Register<SiemensFeedType> siemens_feed_type_syntax;

}  // namespace
}  // namespace siemens
