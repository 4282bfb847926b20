/// The contour with its corners broken: the move that remains of a block where it, or the block before it, ends in a
/// chamfer or a rounding. The next move must be known, so this is for syntaxes that look ahead.
#pragma once

#include <isogloss/cnc/rotary_words.hpp>
#include <isogloss/sdk.hpp>

#include "contour/contour_ahead.hpp"

namespace iso {

using namespace ig::cnc;

/// A member of each syntax that looks ahead and follows the contour. It must be asked in every block from a broken
/// corner to the next move.
class BrokenContour {
 public:
  struct Piece {
    ContourMotion motion;                 ///< of the block, shortened by the corners at its ends
    std::optional<ContourMotion> corner;  ///< what replaces the corner at its end
    std::string_view unbroken;            ///< why the corner is not broken although it should be
    bool is_expected = false;             ///< an unbroken corner here needs no report
    bool begins_behind_corner = false;
    std::optional<double> corner_feed_mmds{};  ///< where it is not that of the move
    std::optional<double> reduced_to{};        ///< the size with which the corner fits, in place of the programmed one
  };

  void forget() { start_.reset(); }

  Piece take(ig::Block& b, const ContourMotion& now) {
    Piece piece{.motion = now, .corner = std::nullopt, .unbroken = {}};
    if (now.kind == ContourMotion::Kind::by_steps) start_.reset();
    Point2 begin = now.move.start;
    if (now.kind == ContourMotion::Kind::move && start_) {
      begin = *start_;
      place(piece.motion.from, now.plane, begin);
      piece.motion.move = between_corners(now.move, begin, now.move.end);
      piece.begins_behind_corner = true;
      start_.reset();
    }
    const auto wanted = state_.get(b);
    if (!wanted) return piece;
    CornerBreaking broken;
    piece.unbroken = find(b, now, begin, *wanted, broken, piece.reduced_to);
    piece.is_expected = wanted->is_modal && broken.why == Unbroken::no;
    if (!piece.unbroken.empty() || broken.why != Unbroken::no) return piece;
    ContourMotion corner = now;
    corner.move = broken.corner.move();
    corner.from = corner.to = now.to;
    place(corner.from, now.plane, broken.corner.begin);
    place(corner.to, now.plane, broken.corner.end);
    piece.motion.move = between_corners(now.move, begin, broken.corner.begin);
    piece.motion.to = corner.from;
    piece.corner = corner;
    piece.corner_feed_mmds = wanted->feed_mmds;
    start_ = broken.corner.end;
    return piece;
  }

  void report(ig::Block& b, const Piece& piece) const {
    if (piece.corner && piece.reduced_to) b.report(ig::diag("ISO-0621"), where(b), b.text(term(b)), *piece.reduced_to);
    if (piece.unbroken.empty() || piece.is_expected) return;
    b.report(ig::diag("ISO-0480"), where(b), b.text(term(b)), piece.unbroken);
    if (unfit_ == Unfit::alarm) b.alarm();
  }

  ig::Symbol term(const ig::Block& b) const {
    const auto corner = state_.get(b);
    return corner ? corner->term : ig::Symbol{};
  }

 private:
  enum class Unfit { alarm, said, reduced };

  ig::Where where(const ig::Block& b) const {
    for (std::size_t i = 0; i < words_.size(); ++i)
      if (b.is_fresh(words_.id(i))) return ig::Where::word(words_.id(i));
    return ig::Where::block();
  }

  static void place(ig::Vec3& to, const PlaneAxes& plane, const Point2& p) {
    to[plane.first] = rounded(p.u);
    to[plane.second] = rounded(p.v);
  }
  static bool rises(const ContourMotion& m) { return std::fabs(m.to[m.plane.tool] - m.from[m.plane.tool]) > 1e-9; }

  /// The reason why the corner is not broken; empty where it is broken, or where there is none to break.
  std::string_view find(ig::Block& b, const ContourMotion& now, const Point2& begin,
                        const CornerBreakState::Corner& wanted, CornerBreaking& out,
                        std::optional<double>& reduced) const {
    if (now.kind != ContourMotion::Kind::move || b.get_or(is_rapid_, false))
      return "its block makes no feed move in the plane";
    if (rises(now)) return "its move leaves the plane";
    if (rotary_.fresh(b) != 0) return "rotary axes turn in its block";
    ContourMotion next;
    if (const std::string_view why = find_next(b, now, next); !why.empty()) return why;
    out = break_corner(now.move, begin, next.move, wanted.size, wanted.shape);
    if (unfit_ == Unfit::reduced && is_too_large(out.why)) {
      reduced = fitting_size(now.move, begin, next.move, wanted);
      if (reduced) out = break_corner(now.move, begin, next.move, *reduced, wanted.shape);
    }
    switch (out.why) {
      case Unbroken::doubles_back: return "the next move goes back the same way";
      case Unbroken::no_place: return "no arc of this radius touches both moves";
      case Unbroken::first_too_short: return "the move before it is too short";
      case Unbroken::second_too_short: return "the move after it is too short";
      case Unbroken::length_at_arc: return "a chamfer by its length needs straight moves on both sides";
      case Unbroken::no:
      case Unbroken::straight_on: break;
    }
    return {};
  }

  static bool is_too_large(Unbroken why) {
    return why == Unbroken::first_too_short || why == Unbroken::second_too_short || why == Unbroken::no_place;
  }
  /// The largest size that fits and leaves something of both moves; nothing where hardly any does.
  static std::optional<double> fitting_size(const ContourMove& first, const Point2& begin, const ContourMove& second,
                                            const CornerBreakState::Corner& wanted) {
    constexpr double left_mm = 0.001;
    double fits = 0, too_large = wanted.size;
    while (too_large - fits > left_mm / 10) {
      const double middle = fits + (too_large - fits) / 2;
      if (middle <= fits || middle >= too_large) break;  // no number lies between them
      const bool is_fitting = break_corner(first, begin, second, middle, wanted.shape).why == Unbroken::no;
      (is_fitting ? fits : too_large) = middle;
    }
    const double size = std::floor((fits - left_mm / 2) / left_mm) * left_mm;
    return size > left_mm ? std::optional(size) : std::nullopt;
  }

  /// Fanuc allows one block without a move, a dwell for example, between the two moves.
  std::string_view find_next(ig::Block& b, const ContourMotion& now, ContourMotion& next) const {
    std::int64_t rests = 0;
    for (std::uint32_t k = 1; k <= ContourAhead::window; ++k) {
      std::optional<ig::Block> following = b.ahead(k);
      if (!following) return "no move follows";
      ig::Block& ahead = *following;
      next = motion_(ahead);
      if (ahead.frame_changed()) return "the coordinate system changes before the next move";
      if (!(next.plane == now.plane)) return "the plane changes before the next move";
      const bool is_plain = next.kind == ContourMotion::Kind::move && !ahead.get_or(is_rapid_, false) && !rises(next);
      if (is_plain) return {};
      if (next.kind != ContourMotion::Kind::rest || next.has_event)
        return "the next move is not a feed move in the plane";
      if (!is_comment_line(ahead.source()) && ++rests > rests_allowed_) return "no move follows directly";
    }
    return "no move follows directly";
  }

  ContourMotionOf motion_;
  CornerBreakState state_{ig::read};
  ig::Fields words_{"corner-words", "Parsing.CornerBreak.?", ig::read,
                    "The words of a corner: a diagnostic points to the one that the block has."};
  ig::Choice<Unfit> unfit_{"corner-does-not-fit", "alarm|said|reduced", "alarm",
                           "A corner that cannot be broken stops the control, stays sharp, or is made smaller."};
  ig::In<bool> is_rapid_{"MotionEvent.IsRapid"};
  RotaryPosition rotary_{ig::read};
  ig::IntegerOption rests_allowed_{
      "blocks-at-corner", "1", {0, 10}, "Blocks without a move that may stand between the moves of a broken corner."};
  std::optional<Point2> start_;  ///< where the next move begins: after the broken corner
};

}  // namespace iso
