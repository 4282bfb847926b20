/// What a canned cycle keeps from call to call, in CannedCycle: R, the bottom and the initial level in mm, Q P I J K as
/// programmed, and the return mode. Raises no diagnostic but ISO-0201 for G98 beside G99.
#pragma once

#include <span>

#include "cycles/cycle_block.hpp"

namespace iso {

/// A call with nothing missing; positions and levels in mm of program coordinates.
struct ResolvedHole {
  ig::Symbol cycle;
  const PlaneAxes& plane;  // as `levels`, of the build() that makes it
  ig::Vec3 position;       ///< its component along the tool axis is not used
  const CycleLevels& levels;
  double initial_level = 0;
  int count = 1;           ///< of holes
  ig::Vec3 step;           ///< from hole to hole
  bool is_drilled = true;  ///< false: the block is only data for later ones
};

class CycleData {
 public:
  using Address = CycleWords::Address;
  /// The words that are kept besides the levels; K is the last, because it is mostly a count and then not kept.
  static constexpr std::array words{Address::Q, Address::P, Address::I, Address::J, Address::K};

  /// The code of the cycle that is on; G80 in the block that cancels it, and nothing in others without a cycle.
  ig::Symbol term(const ig::Block& b) const { return b.get_or(term_, ig::Symbol{}); }
  ig::Symbol cancelled() const { return cancelled_; }
  void hide_cancelled(ig::Block& b) const { b.erase(term_); }
  /// Ends the cycle with all that it kept.
  void cancel(ig::Block& b) const;

  /// Takes G98 and G99; false where the block holds neither. Group 10 outlives the cycles.
  bool take_return_mode(ig::Block& b) const;

  /// The level to which G98 returns, where the tool is at `before`.
  double initial_level(const ig::Block& b, const ActiveCycle& now, double before) const {
    return level_rule_ == InitialLevel::cycle_entry && !now.is_entry ? b.get_or(initial_level_, before) : before;
  }
  CycleLevels levels(const ig::Block& b, std::size_t tool_axis) const {
    const ig::PartialVec3 old = b.get(hole_);
    return {b.get(r_), old.has(tool_axis) ? std::optional(old.value[tool_axis]) : std::nullopt};
  }
  /// R, the bottom and the initial level lie on the axis of the previous plane: on another axis they are not positions
  /// of the tool, which is at `level` there.
  void forget_levels(ig::Block& b, double level) const;

  std::optional<double> value(const ig::Block& b, std::size_t word) const { return b.get(kept_[word]); }
  bool has_q(const ig::Block& b) const { return b.has(kept_[0]); }
  /// The words of the pecks are Q, or I, J and K: a block that names one of them ends the other.
  void end_other_way_to_peck(ig::Block& b, const CycleWords& in) const;

  /// The cycle `code` is on, and nothing is drilled in this block.
  void enter(ig::Block& b, const ActiveCycle& now, ig::Symbol code, double level) const;
  /// Keeps the call, with the words `kept` of it: the data is fresh in a block that drills, and only corrected in one
  /// that does not.
  void store(ig::Block& b, const ActiveCycle& now, const CycleWords& in, const ResolvedHole& hole,
             std::span<const Address> kept) const;

 private:
  enum class InitialLevel { previous, cycle_entry };

  ig::Symbol return_mode(const ig::Block& b) const {
    const ig::Symbol of_group = b.is_raised(return_to_r_) ? g99_ : g98_;
    return b.get_or(return_mode_, of_group);
  }

  ig::Codes return_codes_{"G98", "G99"};
  ig::InWhile<ig::Symbol> term_{"CannedCycle.Term", nullptr, ig::write};
  ig::Out<ig::Symbol> return_mode_{"CannedCycle.ReturnMode"};
  ig::Out<double> initial_level_{"CannedCycle.InitialLevel"};
  ig::Xyz hole_{"CannedCycle.Params", ig::read | ig::write};
  ig::Out<double> r_{"CannedCycle.Params.R"};
  std::array<ig::Out<double>, words.size()> kept_{
      ig::Out<double>{"CannedCycle.Params.Q"}, ig::Out<double>{"CannedCycle.Params.P"},
      ig::Out<double>{"CannedCycle.Params.I"}, ig::Out<double>{"CannedCycle.Params.J"},
      ig::Out<double>{"CannedCycle.Params.K"}};
  // Group 10 outlives the cycles, CannedCycle.ReturnMode does not.
  ig::Signal return_to_r_{"CannedCycle.~ReturnToR", ig::read | ig::write, ig::Life::modal};
  ig::Name g98_{"G98"}, g99_{"G99"}, cancelled_{"G80"};
  ig::Choice<InitialLevel> level_rule_{"initial-level", "previous|cycle-entry", "previous",
                                       "The initial level, to which G98 returns and from which R counts under G91: the "
                                       "tool position before the block, or the one before the cycle began."};
};

}  // namespace iso
