/// How long a move takes: by its feed and length, and by the rapid rates of the axes, which nothing exceeds.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>

#include "export/helix.hpp"
#include "export/led_move.hpp"
#include "export/motion_reader.hpp"
#include "isogloss/engine/chain.hpp"
#include "isogloss/engine/exporter.hpp"

namespace isogloss {

/// Of the straight line in machine coordinates, by the axes from `first` up to `last`.
inline double straight_length(const Move& m, unsigned first, unsigned last) {
  double sum = 0;
  if (first == 0 && last == 3 && m.from.has_xyz() && m.machine.has_xyz()) {
    for (unsigned i = 0; i < 3; ++i) sum += (m.machine.at[i] - m.from.at[i]) * (m.machine.at[i] - m.from.at[i]);
    return std::sqrt(sum);
  }
  for (unsigned i = first; i < last; ++i)
    if (m.from.has(i) && m.machine.has(i)) sum += (m.machine.at[i] - m.from.at[i]) * (m.machine.at[i] - m.from.at[i]);
  return std::sqrt(sum);
}

/// Of a move along a line. Under tip control the feed is that of the tip in the workpiece; the machine's axes take
/// another path.
inline double line_length(const Move& m) {
  constexpr double rests_mm = 1e-7;  // shorter lengths come from a frame there and back
  if (!m.is_led || !m.start.has_xyz() || !m.program.has_xyz()) return straight_length(m, 0, 3);
  double sum = 0;
  for (unsigned i = 0; i < 3; ++i) sum += (m.program.at[i] - m.start.at[i]) * (m.program.at[i] - m.start.at[i]);
  return sum > rests_mm * rests_mm ? std::sqrt(sum) : 0;
}

/// Of an arc; of its chord where the centre is not known.
inline double arc_length(const Move& m) {
  if (!m.arc.has_center || !m.from.has_xyz() || !m.machine.has_xyz()) return straight_length(m, 0, 3);
  return Helix(m.from.at, m.machine.at, m.arc.machine_center, m.arc.normal, sweep_deg(m)).length(m.machine.at);
}

struct MoveTime {
  double seconds = 0;
  double length_mm = 0;    ///< of the path that a feed measures; of a rapid move: along a straight line
  bool is_known = true;    ///< false: an axis without a rapid rate, or a feed move without a feed
  bool is_slowed = false;  ///< an axis cannot follow the feed
};

class MoveTimer {
 public:
  explicit MoveTimer(const RapidRates& rates) : rates_(rates) {
    for (unsigned i = 0; i < 6; ++i) rated_ |= static_cast<std::uint32_t>(rates.per_second[i] > 0) << i;
  }

  void begin(const Document& initial) {
    const auto* const service =
        initial.chain == nullptr ? nullptr : initial.chain->service("isogloss.machine-kinematics/1");
    kinematics_ = static_cast<const ig_machine_kinematics_1*>(service);
    tool_length_ = initial.layout().id("ToolHeightCompensation.Offset_mm");
    lever_ = initial.layout().id("PivotTransform.Lever_mm");
  }

  MoveTime of(const Move& m, const Document& document) const {
    if (m.kind == Move::Kind::rapid) return rapid(m, document);
    const bool is_arc = m.kind == Move::Kind::arc;
    const double length = is_arc ? arc_length(m) : line_length(m);
    MoveTime out = feed(m, is_arc || length > 0 ? length : straight_length(m, 3, 6), document);
    out.length_mm = length;
    return out;
  }

 private:
  MoveTime rapid(const Move& m, const Document& document) const {
    MoveTime out = time(m, 0, document);
    out.length_mm = straight_length(m, 0, 3);
    for (std::uint32_t axes = m.from.known & m.machine.known & ~rated_; axes != 0; axes &= axes - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(axes));
      if (m.machine.at[i] != m.from.at[i]) out.is_known = false;
    }
    return out;
  }
  /// `length`: mm, or degrees of a move that turns rotary axes alone.
  MoveTime feed(const Move& m, double length, const Document& document) const {
    if (length == 0) return {};
    if (!m.has_feed || !(m.feed_mmds > 0)) return {0, 0, false, false};
    return time(m, length / m.feed_mmds, document);
  }
  /// Of a move whose feed alone would take this long; 0: a rapid move.
  MoveTime time(const Move& m, double feed_seconds, const Document& document) const {
    const double least = least_seconds(m);
    MoveTime out{std::max(least, feed_seconds), 0, true, least > feed_seconds * (1 + 1e-9)};
    if (m.is_led && kinematics_ != nullptr) {
      const LedMove::Time led = LedMove(*kinematics_, m, led_length(document)).time(feed_seconds, rates_.per_second);
      if (led.is_known) {
        out.is_slowed = led.is_slowed;
        out.seconds = std::max(out.seconds, led.seconds);
      }
    }
    out.is_slowed = out.is_slowed && feed_seconds > 0;
    return out;
  }

  /// The time of the slowest axis at its rapid rate: nothing moves faster. This limits a feed too, where a table must
  /// swing round while the tip moves a short distance.
  double least_seconds(const Move& m) const {
    double longest = 0;
    for (std::uint32_t axes = m.from.known & m.machine.known & rated_; axes != 0; axes &= axes - 1) {
      const auto i = static_cast<unsigned>(std::countr_zero(axes));
      longest = std::max(longest, std::abs(m.machine.at[i] - m.from.at[i]) / rates_.per_second[i]);
    }
    return longest;
  }
  /// From the gauge point to the point of the tool's axis that is led.
  double led_length(const Document& document) const {
    double length = 0;
    for (const ig_field f : {tool_length_, lever_})
      if (f != IG_NO_FIELD && document.present(f)) length += document.number(f);
    return length;
  }

  RapidRates rates_;
  std::uint32_t rated_ = 0;  ///< a bit for each axis whose rapid rate is known
  const ig_machine_kinematics_1* kinematics_ = nullptr;
  ig_field tool_length_ = IG_NO_FIELD, lever_ = IG_NO_FIELD;
};

}  // namespace isogloss
