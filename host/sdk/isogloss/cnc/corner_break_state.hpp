/// The section CornerBreak: the chamfer or rounding that replaces the corner at the end of the block's move. Syntaxes
/// that read a control's words for it write the section; syntaxes that make the path read it.
#pragma once

#include <optional>

#include "isogloss/sdk.hpp"

#include "isogloss/cnc/corner_break.hpp"

namespace ig::cnc {

class CornerBreakState {
 public:
  struct Corner {
    Symbol term;  ///< the control's own name for it
    CornerShape shape = CornerShape::legs;
    double size = 0;                                 ///< mm; see CornerShape
    bool is_modal = false;                           ///< set for every corner: a block without a corner is no fault
    std::optional<double> feed_mmds = std::nullopt;  ///< of the corner; that of the move before it without a value
  };
  explicit CornerBreakState(Access access)
      : term_("CornerBreak.Term", access,
              {Life::block, "", "What stands at the end of the move, as the control calls it."}),
        shape_("CornerBreak.Shape", access, {Life::block, "", "Legs, Length or Rounding: what the size means."}),
        size_("CornerBreak.Size_mm", access,
              {Life::block, "mm", "From the corner to both ends of a chamfer, its length, or the radius."}),
        feed_("CornerBreak.Feedrate_mmds", access, {Life::block, "mm/s", "The feed rate of the corner."}),
        is_modal_("CornerBreak.IsModal", access, {Life::block, "", "Not of this corner alone."}) {}

  bool is_there(const Block& b) const { return b.has(term_); }
  std::optional<Corner> get(const Block& b) const {
    if (!b.has(term_)) return std::nullopt;
    const Symbol shape = b.get_or(shape_, Symbol{});
    return Corner{b.get_or(term_, Symbol{}),
                  shape == rounding_ ? CornerShape::rounding
                  : shape == length_ ? CornerShape::length
                                     : CornerShape::legs,
                  b.get_or(size_, 0.0), b.get_or(is_modal_, false), b.get(feed_)};
  }
  void set(Block& b, const Corner& corner) const {
    b.set(term_, corner.term);
    b.set(shape_, corner.shape == CornerShape::rounding ? rounding_
                  : corner.shape == CornerShape::length ? length_
                                                        : legs_);
    b.set(size_, corner.size);
    if (corner.feed_mmds) b.set(feed_, *corner.feed_mmds);
    if (corner.is_modal) b.set(is_modal_, true);
  }

 private:
  Field<Symbol> term_, shape_;
  Field<double> size_, feed_;
  Field<bool> is_modal_;
  Name legs_{"Legs"}, length_{"Length"}, rounding_{"Rounding"};
};

/// A member of each syntax whose words stand in the block of the move. keep() writes the corner and keeps the path
/// syntaxes awake from the block of the corner up to the next move, because until then the path differs from the words.
class CornerBreakWords {
 public:
  bool is_open(const Block& b) const { return b.is_raised(open_); }
  void keep(Block& b, const std::optional<CornerBreakState::Corner>& corner) const {
    const bool was_open = is_open(b);
    if (corner) state_.set(b, *corner);
    if (was_open || corner) b.raise(path_);
    if (corner && !was_open) b.raise(open_);
    if (was_open && !corner && b.has_any(form_, compound_)) b.erase(open_);
  }

 private:
  CornerBreakState state_{write};
  Signal open_{"CornerBreak.~Open", read | write | wake_while, Life::modal};
  Signal path_{"CornerBreak.~Path", write};
  In<Symbol> form_{"MotionEvent.Form"}, compound_{"CompoundMotion.Term"};
};

}  // namespace ig::cnc
