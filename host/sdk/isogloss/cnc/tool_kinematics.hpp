/// What the rotary axes do to the tool: its direction, the frame that turns with them, and the angles for a direction
/// (Fanuc 30i manuals, "Tool axis direction control", "Tool center point control"). Lengths in mm, angles in degrees.
#pragma once

#include <algorithm>
#include <vector>

#include "isogloss/cnc/rotary_offset.hpp"
#include "isogloss/cnc/tilt_transform.hpp"

namespace ig::cnc {

inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The machine's rotary axes, as the service isogloss.machine-kinematics/1 describes them. False where no axis is
/// known: then tool_axis(), pivot() and solve() must not be called.
class ToolKinematics {
 public:
  explicit operator bool() const { return count_ != 0; }
  std::size_t count() const { return count_; }
  /// The axis number i, from 0, as 0 for A, 1 for B, 2 for C; the axis nearer the machine's base comes first.
  std::size_t axis(std::size_t i) const { return axes_[i]; }
  bool has(std::size_t axis) const { return (mask_ >> axis & 1u) != 0; }
  /// A bit for each of A, B and C.
  std::uint32_t mask() const { return mask_; }
  /// True when one axis carries the tool (head) and the other one the workpiece (table).
  bool is_mixed() const { return count_ == 2 && is_table_[0] != is_table_[1]; }
  bool is_table(std::size_t i) const { return is_table_[i]; }

  /// The unit vector from the tip to the holder, in coordinates of the workpiece; nothing for angles that are not
  /// finite.
  std::optional<Vec3> tool_axis(const Angles& angles) const {
    double t[3];
    if (service_->tool_axis(service_->self, angles.data(), t) == 0) return std::nullopt;
    return Vec3{t[0], t[1], t[2]};
  }
  std::optional<Mat4> pivot(const Angles& angles) const {
    Mat4 m;
    if (service_->pivot(service_->self, angles.data(), m.data()) == 0) return std::nullopt;
    return m;
  }
  std::size_t solve(const Vec3& direction, const Angles& present, std::array<ig_rotary_solution, 2>& out) const {
    const double d[3] = {direction.x, direction.y, direction.z};
    return service_->solve(service_->self, d, present.data(), out.data());
  }

 private:
  std::size_t ask() {
    if (!service_) return 0;
    char names[2] = {};
    const std::size_t n = std::min<std::size_t>(2, service_->axes(service_->self, names));
    for (std::size_t i = 0; i < n; ++i) {
      axes_[i] = rotary_names.find(names[i]);
      if (axes_[i] > 2) return 0;
    }
    for (std::size_t i = 0; i < n; ++i) mask_ |= 1u << axes_[i];
    for (std::size_t i = 0; i < n; ++i) {
      Angles quarter{};
      quarter[axes_[i]] = 90;
      Mat4 turned = identity_frame, zero = identity_frame;
      service_->pivot(service_->self, quarter.data(), turned.data());
      service_->pivot(service_->self, Angles{}.data(), zero.data());
      for (const std::size_t e : {0u, 1u, 2u, 4u, 5u, 6u, 8u, 9u, 10u})
        is_table_[i] = is_table_[i] || std::fabs(turned[e] - zero[e]) > 1e-6;
    }
    return n;
  }

  Service<ig_machine_kinematics_1> service_{"isogloss.machine-kinematics/1", Need::optional,
                                            "The kinematics of the rotary axes."};
  std::array<std::size_t, 2> axes_{};
  std::uint32_t mask_ = 0;
  std::array<bool, 2> is_table_{};
  std::size_t count_ = ask();
};

/// The relation between X Y Z of the machine and the tip of a tool of this length in the workpiece, in coordinates with
/// all rotary axes at zero. Each function gives nothing for angles that are not finite.
struct ToolTip {
  const ToolKinematics& machine;
  double length;

  std::optional<Vec3> in_workpiece(const Vec3& xyz, const Angles& angles) const {
    const auto pivot = machine.pivot(angles);
    const auto axis = machine.tool_axis(angles);
    if (!pivot || !axis) return std::nullopt;
    const Mat4& m = *pivot;
    const Vec3 way = xyz - Vec3{m[12], m[13], m[14]};
    Vec3 out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = dot(way, {m[4 * i], m[4 * i + 1], m[4 * i + 2]});
    return out - length * *axis;
  }
  std::optional<Vec3> machine_point(const Vec3& tip, const Angles& angles) const {
    const auto pivot = machine.pivot(angles);
    const auto axis = machine.tool_axis(angles);
    if (!pivot || !axis) return std::nullopt;
    return mapped(*pivot, tip + length * *axis);
  }
};

/// Which pair of angles is chosen where several give the tool its direction.
enum class SolutionChoice { min_first, min_sum, min_max, positive, negative };

inline constexpr const char* solution_choices = "min-first|min-sum|min-max|positive|negative";

struct RotaryCandidates {
  std::array<Angles, 2> angles{};
  std::size_t count = 0;
  bool is_reachable = false;  ///< some angles give the direction, inside the limits or not
};

/// The angles for a direction of the tool: both solutions, each axis in the nearest turn that is inside its travel.
class RotarySolver {
 public:
  /// Condition on an axis: its angle is 0 or has this sign; with sign 0 every angle is allowed.
  struct Sign {
    std::size_t axis;
    int sign;
  };

  /// `direction` points from the tip to the holder. Solutions outside the travel are left out; is_reachable tells the
  /// two reasons for none apart.
  RotaryCandidates candidates(const ToolKinematics& machine, const Vec3& direction, const Angles& present,
                              const Sign& wanted = {0, 0}) const {
    std::array<ig_rotary_solution, 2> found{};
    const std::size_t n = machine.solve(direction, present, found);
    RotaryCandidates out;
    out.is_reachable = n != 0;
    for (std::size_t i = 0; i < n; ++i) {
      Angles angles = present;
      bool is_inside = true;
      for (std::size_t k = 0; k < machine.count(); ++k) {
        const std::size_t axis = machine.axis(k);
        if ((found[i].free >> axis & 1u) == 0)
          angles[axis] =
              nearest_turn_inside(present[axis], found[i].angles[axis], axes_.travel(axis), HalfTurn::positive);
        if (axis == wanted.axis && wanted.sign != 0) angles[axis] = turn_with(wanted, angles[axis]);
        is_inside = is_inside && axes_.travel(axis).holds(angles[axis]);
      }
      if (is_inside) out.angles[out.count++] = angles;
    }
    return out;
  }

  static Sign sign_of(const ToolKinematics& machine, SolutionChoice choice) {
    return {machine.axis(0), choice == SolutionChoice::positive ? 1 : choice == SolutionChoice::negative ? -1 : 0};
  }

  /// True when the angle has the wanted sign. On an axis without limits the angle between -180 and 180 decides, and
  /// half a turn has both signs.
  bool has_sign(const Sign& wanted, double angle) const {
    const AngleRange& travel = axes_.travel(wanted.axis);
    const bool is_limited = std::isfinite(travel.minimum) || std::isfinite(travel.maximum);
    const double named = is_limited ? angle : std::remainder(angle, 360.0);
    return named * wanted.sign >= -same_angle_deg || (!is_limited && std::fabs(named) >= 180 - same_angle_deg);
  }

  /// The best solution in the order of the choice; nothing where the choice rules out all of them.
  std::optional<Angles> choose(const ToolKinematics& machine, const RotaryCandidates& from, const Angles& present,
                               SolutionChoice choice) const {
    const Sign wanted = sign_of(machine, choice);
    std::optional<Angles> best;
    for (std::size_t i = 0; i < from.count; ++i) {
      if (!has_sign(wanted, from.angles[i][wanted.axis])) continue;
      if (!best || comes_first(machine, from.angles[i], *best, present, choice)) best = from.angles[i];
    }
    return best;
  }

  const RotaryAxes& axes() const { return axes_; }

 private:
  /// The nearest turn of the angle that is inside the travel and has the sign; the angle itself where there is none.
  double turn_with(const Sign& wanted, double angle) const {
    for (const double turns : {0.0, 360.0, -360.0, 720.0, -720.0})
      if (has_sign(wanted, angle + turns) && axes_.travel(wanted.axis).holds(angle + turns)) return angle + turns;
    return angle;
  }

  static bool comes_first(const ToolKinematics& machine, const Angles& a, const Angles& b, const Angles& present,
                          SolutionChoice choice) {
    const auto key = [&](const Angles& angles) {
      std::array<double, 2> way{}, from_zero{};
      for (std::size_t k = 0; k < machine.count(); ++k) {
        const std::size_t axis = machine.axis(k);
        way[k] = std::fabs(angles[axis] - present[axis]);
        from_zero[k] = std::fabs(std::remainder(angles[axis], 360.0));
      }
      // Fanuc compares the table before the head.
      const std::size_t first = machine.is_mixed() && machine.is_table(1) ? 1 : 0, second = 1 - first;
      const double sum = way[0] + way[1], longest = std::fmax(way[0], way[1]);
      const double before = choice == SolutionChoice::min_sum   ? sum
                            : choice == SolutionChoice::min_max ? longest
                                                                : way[first];
      const double master = std::remainder(angles[machine.axis(0)], 360.0);
      const bool is_negative = master < 0 && master > -180 + same_angle_deg;  // half a turn is positive, too
      return std::array<double, 6>{before,           way[first],        way[second],
                                   from_zero[first], from_zero[second], is_negative ? 1.0 : 0.0};
    };
    const auto ka = key(a), kb = key(b);
    for (std::size_t i = 0; i < ka.size(); ++i)
      if (std::fabs(ka[i] - kb[i]) > same_angle_deg) return ka[i] < kb[i];
    return false;
  }

  RotaryAxes axes_;
};

/// The code of tool length compensation in force, and whether that is tool centre point control (G43.4, G43.5).
class ToolCenterMode {
 public:
  bool is_on(const Block& b) const {
    const Symbol term = b.get_or(term_, Symbol{});
    return term == g43_4_ || term == g43_5_;
  }
  Symbol term(const Block& b) const { return b.get_or(term_, Symbol{}); }

 private:
  In<Symbol> term_{"ToolHeightCompensation.Term"};
  Name g43_4_{"G43.4"}, g43_5_{"G43.5"};
};

/// The angles for which the frame's entry PivotTransform is computed; none where the entry is the identity.
class PivotState {
 public:
  explicit PivotState(Access access)
      : ids_{field("PivotTransform.A", access), field("PivotTransform.B", access), field("PivotTransform.C", access)} {}

  PartialAngles get(const Block& b) const { return angles_of(b, ids_); }
  ig_field id(std::size_t axis) const { return ids_[axis]; }
  bool is_fresh(const Block& b) const { return b.fresh_many(ids_.data(), 3) != 0; }
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
    if (words_are_ == RotaryWordsAre::of_machine || !offsets_.any(b) || b.find(machine_select_)) return {};
    return offsets_.get(b);
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
