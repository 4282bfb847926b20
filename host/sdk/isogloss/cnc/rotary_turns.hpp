/// Where a block sends the rotary axes while the frame turns with them, and the angles for which the frame is computed
/// (Fanuc 30i manuals, "Tool center point control"). Angles in degrees of the machine.
#pragma once

#include "isogloss/cnc/rotary_offset.hpp"
#include "isogloss/cnc/tool_kinematics.hpp"

namespace ig::cnc {

/// The angles for which the frame's entry PivotTransform is computed; none where the entry is the identity.
class PivotState {
 public:
  explicit PivotState(Access access)
      : ids_{field("PivotTransform.A", access), field("PivotTransform.B", access), field("PivotTransform.C", access)} {}

  PartialAngles get(const Block& b) const { return angles_of(b, ids_); }
  ig_field id(std::size_t axis) const { return ids_[axis]; }
  bool is_fresh(const Block& b) const { return b.is_any_fresh(all_); }
  void set(Block& b, const ToolKinematics& machine, const Angles& angles) const {
    set_angles(b, ids_, {machine.mask(), angles});
  }
  void erase(Block& b) const {
    for (const ig_field id : ids_) b.erase(id);
  }

 private:
  static ig_field field(const char* path, Access access) {
    return Field<double>(path, access, {Life::modal, "deg", "Angle for which the entry PivotTransform stands."}).id();
  }
  std::array<ig_field, 3> ids_;
  AnyOf all_{ids_};
};

/// What a block does with the rotary axes while the frame turns with them.
struct RotaryTurn {
  Angles from{}, to{};
  bool moves = false;
  bool is_followed = false;  ///< the frame is computed for some angles: those of `from`
  bool was_moved = false;    ///< another code (G28, G53) has turned the axes since: set the frame anew
};

/// Whether the words of the block are still angles of the program (before RotaryOffsetSyntax) or already angles of the
/// machine (after it).
enum class RotaryWordsAre { of_program, of_machine };

/// A member of each syntax that lets the frame follow the rotary axes.
class RotaryTurns {
 public:
  RotaryTurns(Access state, RotaryWordsAre words) : state_(state), words_are_(words) {}

  /// Everything about the turn in one pass, because most blocks under tool centre point control ask for it twice.
  RotaryTurn read(const Block& b, const ToolKinematics& machine) const {
    RotaryTurn turn;
    Angles words{};
    std::uint32_t named = 0;
    bool was_moved = false;
    for (std::size_t k = 0, count = machine.count(); k < count; ++k) {
      const std::size_t axis = machine.axis(k);
      ig_value v;
      const double now = b.get(machine_[axis], v) ? v.number : 0;
      turn.from[axis] = turn.to[axis] = now;
      if (b.get(state_.id(axis), v)) {
        turn.is_followed = true;
        was_moved |= v.number != now;
        turn.from[axis] = v.number;
      }
      if (b.get(words_[axis], v)) {
        words[axis] = v.number;
        named |= 1u << axis;
      }
    }
    if (was_moved) leave_for(b, machine, turn);
    if (named == 0) {
      turn.moves = moves(machine, turn);
      return turn;
    }
    const bool is_incremental = distance_.is_incremental(b);
    if (is_incremental && b.find(machine_select_)) named = 0;  // the control ignores G53 under G91
    const Angles offset = is_incremental ? Angles{} : offset_of_words(b);
    bool turns_on = false;  // a whole turn is a move as well
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if ((named >> axis & 1u) == 0) continue;
      const double now = turn.to[axis];
      turn.to[axis] = position(axis, words[axis], offset[axis], now, is_incremental);
      turns_on |= (is_incremental || increments_.has(b, axis)) && std::fabs(turn.to[axis] - now) > noise;
    }
    turn.moves = turns_on || moves(machine, turn);
    return turn;
  }
  bool moves(const ToolKinematics& machine, const RotaryTurn& turn) const {
    return differ(machine, turn.from, turn.to);
  }
  /// The machine angle that a word, read as a position, names.
  double to_machine(const Block& b, std::size_t axis, double word) const {
    return RotaryOffsets::to_machine(word, offset_of_words(b)[axis], axes_.rollover(axis));
  }
  bool is_incremental(const Block& b) const { return distance_.is_incremental(b); }
  const PivotState& state() const { return state_; }
  const RotaryAngles& angles() const { return angles_; }
  const RotaryAxes& axes() const { return axes_; }

 private:
  static constexpr double noise = 1e-9;

  /// If the axes are no longer at the angles for which the frame is computed, another code has turned them since, and
  /// the turn starts at their present angles; unless this block itself has written them.
  void leave_for(const Block& b, const ToolKinematics& machine, RotaryTurn& turn) const {
    const Angles& now = turn.to;
    if (!differ(machine, turn.from, now) || is_written(b)) return;
    turn.from = now;
    turn.was_moved = true;
  }

  /// The offset that still has to be added to the words of positions.
  Angles offset_of_words(const Block& b) const {
    return words_are_ == RotaryWordsAre::of_machine ? Angles{} : offset_of_program(b);
  }
  Angles offset_of_program(const Block& b) const {
    return offsets_.any(b) && !b.find(machine_select_) ? offsets_.get(b) : Angles{};
  }

  /// Where a word sends its axis. A word that McAbcSyntax will refuse turns nothing; a sign that is a direction is not
  /// part of the position.
  double position(std::size_t axis, double word, double offset, double now, bool is_incremental) const {
    if (!(std::fabs(word) < detail::countable_deg) || (axes_.any() && !axes_.has(axis))) return now;
    if (is_incremental) return now + word;
    word = RotaryOffsets::to_machine(word, offset, axes_.rollover(axis));
    return axes_.rollover(axis) == Rollover::signed_direction ? std::fabs(word) : word;
  }

  /// True when the axes differ. On an axis that counts on, a whole turn is a difference as well.
  bool differ(const ToolKinematics& machine, const Angles& a, const Angles& b) const {
    for (std::size_t k = 0; k < machine.count(); ++k) {
      const std::size_t axis = machine.axis(k);
      const double way = b[axis] - a[axis];
      if (way == 0) continue;
      const bool is_same_turn = std::fabs(way) < 180 || axes_.rollover(axis) == Rollover::counts_on;
      const double rest = is_same_turn ? way : std::remainder(way, 360.0);
      if (!(std::fabs(rest) <= noise)) return true;
    }
    return false;
  }
  static ig_field word(const char* path) { return Field<double>(path, ig::read, {Life::standard, "deg", ""}).id(); }
  bool is_written(const Block& b) const { return b.fresh_many(machine_.data(), 3) != 0; }

  RotaryIncrements increments_{ig::read};
  RotaryAngles angles_;
  PivotState state_;
  RotaryWordsAre words_are_;
  RotaryOffsets offsets_{ig::read};
  RotaryAxes axes_;
  DistanceMode distance_;
  Codes machine_select_{{"G53"}, ig::read};
  std::array<ig_field, 3> words_{word("Parsing.A"), word("Parsing.B"), word("Parsing.C")};
  std::array<ig_field, 3> machine_{In<double>("MachineCoordinate.A").id(), In<double>("MachineCoordinate.B").id(),
                                   In<double>("MachineCoordinate.C").id()};
};

}  // namespace ig::cnc
