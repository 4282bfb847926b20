// RND and CHF stand in a block of their own between two moves. The move before must end short of the corner, so each
// feed move looks whether such a block follows, and gets the corner from which CornerBreakPathSyntax and cutter radius
// compensation make the path.
#include <isogloss/cnc/contour_approach.hpp>
#include <isogloss/cnc/corner_break_state.hpp>
#include <isogloss/sdk.hpp>

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextCorner {
  static constexpr std::uint32_t window = 16;
  static constexpr auto spec =
      ig::syntax("KlartextCornerSyntax", "RND and CHF: the corner at the end of the previous move.")
          .after("KlartextPathSyntax", "KlartextMotionSyntax", "LinearMotionSyntax", "CircularMotionSyntax",
                 "RadiusCompensationSyntax")
          .before("RadiusCompensationPathSyntax", "CornerBreakPathSyntax")
          .looks_ahead(window);

  /// Looking ahead costs more than the move itself, so moves of a surface and of five axes, which have no such corners,
  /// do not.
  ig::In<bool> in_plane_{
      "KlartextPath.IsFeedInPlane", ig::wake, {ig::Life::block, "", "The move may end in a corner."}};
  ig::In<ig::Symbol> form_{"MotionEvent.Form", ig::read | ig::ends_ahead};
  ig::In<double> radius_{"KlartextCorner.Radius_mm", ig::wake | ig::ends_ahead, {ig::Life::block, "mm", "RND R"}};
  ig::In<double> chamfer_{"KlartextCorner.Chamfer_mm", ig::wake | ig::ends_ahead, {ig::Life::block, "mm", "CHF"}};
  ig::In<double> feed_{"KlartextCorner.Feedrate_mmds", ig::read, {ig::Life::block, "mm/s", "F of RND or CHF"}};
  ig::Signal open_{"KlartextCorner.~Open", ig::read | ig::wake_while, ig::Life::modal};
  ig::In<bool> is_rapid_{"MotionEvent.IsRapid"};
  ig::In<ig::Symbol> compound_{"CompoundMotion.Term", ig::read | ig::ends_ahead};
  ContourApproach approach_{ig::wake};
  ig::In<double> tool_radius_{"RadiusCompensation.Radius_mm"};
  CornerBreakState corner_{ig::write};
  ig::Signal path_{"CornerBreak.~Path", ig::write};
  ig::Name rnd_{"RND"}, chf_{"CHF"};

  bool is_announced_ = false;  ///< the next RND or CHF block belongs to a move that already has it
  bool is_open_ = false;       ///< up to the next move, which begins after the corner

  ig::Status restart(ig::Block&) {
    is_announced_ = is_open_ = false;
    return ig::Status::unchanged;
  }

  ig::Status build(ig::Block& b) {
    const bool was_open = is_open_;
    if (was_open) b.raise(path_);
    if (approach_.get(b) && b.get_or(tool_radius_, 0.0) == 0)
      b.report(ig::diag("HEI-0130"), ig::Where::block(), std::string_view("APPR"),
               std::string_view("the tool has no radius, it goes straight to the first point of the contour"));
    if (b.has_any(radius_, chamfer_)) {
      if (!is_announced_)
        b.report(ig::diag("HEI-0130"), ig::Where::block(), std::string_view(b.has(radius_) ? "RND" : "CHF"),
                 std::string_view("no feed move in the plane stands before it, the corner stays sharp"));
      is_announced_ = false;
      return ig::Status::changed;
    }
    const bool moves = b.has_any(form_, compound_);
    if (moves) is_open_ = is_announced_ = false;
    const bool can_break = b.has(in_plane_) && b.has(form_) && !b.has(compound_) && !b.get_or(is_rapid_, false);
    if (!can_break || !find_corner(b)) return was_open ? ig::Status::changed : ig::Status::unchanged;
    b.raise(path_);
    is_open_ = is_announced_ = true;
    return ig::Status::changed;
  }

 private:
  bool find_corner(ig::Block& b) const {
    for (std::uint32_t k = 1; k <= window; ++k) {
      std::optional<ig::Block> following = b.ahead(k);
      if (!following) return false;
      const ig::Block& ahead = *following;
      if (ahead.has_any(form_, compound_)) return false;
      if (!ahead.has_any(radius_, chamfer_)) continue;
      const bool is_rounding = ahead.has(radius_);
      CornerBreakState::Corner corner{rnd_, CornerShape::rounding, ahead.get_or(radius_, 0.0)};
      if (!is_rounding) corner = {chf_, CornerShape::legs, ahead.get_or(chamfer_, 0.0)};
      corner.feed_mmds = ahead.get(feed_);
      corner_.set(b, corner);
      return true;
    }
    return false;
  }
};

const ig::Register<KlartextCorner> klartext_corner_syntax;

}  // namespace
}  // namespace heidenhain
