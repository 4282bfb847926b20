/// CHF=, CHR= and RND= after a move, and RNDM= after each move: kind and size of the chamfer or rounding at the corner
/// to the next move, and its feed by FRC= and FRCM=. CornerBreakPathSyntax and cutter radius compensation make the path
/// from this state.
#include <cmath>

#include <isogloss/cnc/corner_break_state.hpp>
#include <isogloss/sdk.hpp>

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensCorner {
  static constexpr auto spec =
      ig::syntax("SiemensCornerSyntax", "CHF=, CHR=, RND=, RNDM=, FRC= and FRCM=: chamfers and roundings.")
          .after("SiemensUnitSyntax", "SiemensTurnSyntax", "FeedrateSyntax", "SpindleSpeedSyntax",
                 "CircularMotionSyntax", "LinearMotionSyntax")
          .before("CornerBreakPathSyntax", "RadiusCompensationPathSyntax", "UnconsumedCheckSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0286", "{0}{1} is less than 0, so the corner stays sharp: program 0 or more"),
      ig::diagnostic(IG_ERROR, "SIE-0287",
                     "{0} is the second word for this corner and is ignored: chamfer or round it, not both"),
      ig::diagnostic(IG_ERROR, "SIE-0393",
                     "{0}{1} is not a feed rate, so the corner is cut with F: program a value greater than 0"),
  };

  struct Corner {
    ig::Word word;
    ig::Name name;
    CornerShape shape;
  };
  std::array<Corner, 3> corners_{
      Corner{ig::Word{"Parsing.CHF", ig::wake, "mm", "Length of the chamfer."}, ig::Name{"CHF="}, CornerShape::length},
      Corner{ig::Word{"Parsing.CHR", ig::wake, "mm", "From the corner to both ends of the chamfer."}, ig::Name{"CHR="},
             CornerShape::legs},
      Corner{ig::Word{"Parsing.RND", ig::wake, "mm", "Radius of the arc."}, ig::Name{"RND="}, CornerShape::rounding}};
  ig::Word modal_word_{"Parsing.RNDM", ig::wake, "mm", "Radius of the arcs at all corners; 0 ends it."};
  ig::Field<double> modal_{"CornerBreak.ModalRadius_mm",
                           ig::read | ig::write | ig::wake_while,
                           {ig::Life::modal, "mm", "RNDM=, as long as it is in force."}};
  ig::Word feed_word_{"Parsing.FRC", ig::wake, "mm/min", "Feed of the corner of this block."};
  ig::Word modal_feed_word_{"Parsing.FRCM", ig::wake, "mm/min", "Feed of all corners; 0 ends it."};
  ig::Field<double> modal_feed_{"CornerBreak.ModalFeed",
                                ig::read | ig::write,
                                {ig::Life::modal, "", "FRCM=, in the unit of F, as long as it is in force."}};
  ig::In<ig::Symbol> feed_type_{"Feedrate.Term"};
  ig::In<double> spindle_speed_{"SpindleSpeed.SpindleSpeed_rpm"};
  ig::Name per_revolution_{"G95"};
  CornerBreakWords corner_;
  ig::In<ig::Symbol> form_{"MotionEvent.Form"};
  ig::In<bool> is_rapid_{"MotionEvent.IsRapid"};
  ig::Name rndm_{"RNDM="};

  ig::Status build(ig::Block& b) const {
    if (const auto radius = b.take(modal_word_)) set_modal(b, *radius);
    if (const auto feed = b.take(modal_feed_word_)) set_modal_feed(b, *feed);
    auto corner = describe(b);
    if (corner) corner->feed_mmds = feed(b);
    corner_.keep(b, corner);
    return ig::Status::changed;
  }

 private:
  void set_modal(ig::Block& b, double radius) const {
    if (radius < 0)
      b.report(ig::diag("SIE-0286"), ig::Where::word(modal_word_.id()), b.text(rndm_), radius);
    else if (radius > 0)
      b.set(modal_, radius);
    else if (b.has(modal_))
      b.erase(modal_);
  }

  void set_modal_feed(ig::Block& b, double feed) const {
    if (feed < 0)
      b.report(ig::diag("SIE-0393"), ig::Where::word(modal_feed_word_.id()), std::string_view("FRCM="), feed);
    else if (feed > 0)
      b.set(modal_feed_, feed);
    else if (b.has(modal_feed_))
      b.erase(modal_feed_);
  }

  /// FRC= counts in the block of a corner only; elsewhere the word stays, and is reported as unused.
  std::optional<double> feed(ig::Block& b) const {
    auto feed = b.take(feed_word_);
    if (feed && !(*feed > 0)) {
      b.report(ig::diag("SIE-0393"), ig::Where::word(feed_word_.id()), std::string_view("FRC="), *feed);
      feed.reset();
    }
    if (!feed) feed = b.get(modal_feed_);
    if (!feed) return std::nullopt;
    const double mmds = *feed * (b.is(feed_type_, per_revolution_) ? b.get_or(spindle_speed_, 0.0) : 1) / 60;
    return mmds > 0 ? std::optional(mmds) : std::nullopt;
  }

  std::optional<CornerBreakState::Corner> describe(ig::Block& b) const {
    const Corner* found = nullptr;
    double size = 0;
    for (const Corner& corner : corners_) {
      const auto word = b.take(corner.word);
      if (!word) continue;
      if (found != nullptr) b.report(ig::diag("SIE-0287"), ig::Where::word(corner.word.id()), b.text(corner.name));
      if (*word < 0) b.report(ig::diag("SIE-0286"), ig::Where::word(corner.word.id()), b.text(corner.name), *word);
      if (found != nullptr) continue;
      found = &corner;
      size = *word;
    }
    if (found != nullptr)
      return size > 0 ? std::optional(CornerBreakState::Corner{found->name, found->shape, size}) : std::nullopt;
    const double radius = b.has(form_) && !b.get_or(is_rapid_, false) ? b.get_or(modal_, 0.0) : 0;
    if (!(radius > 0)) return std::nullopt;
    return CornerBreakState::Corner{rndm_, CornerShape::rounding, radius, true};
  }
};

const ig::Register<SiemensCorner> siemens_corner_syntax;

}  // namespace
}  // namespace siemens
