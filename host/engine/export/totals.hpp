/// The totals of a run: lengths, extents, times. Everything in machine space, arcs by their true length and bulge; but
/// a feed that leads the tip while rotary axes turn has the length of the tip's path, and is slowed down where an axis
/// would exceed its rapid rate.
#pragma once

#include <algorithm>
#include <cmath>

#include "export/helix.hpp"
#include "export/motion_reader.hpp"
#include "export/move_time.hpp"
#include "isogloss/engine/exporter.hpp"

namespace isogloss {

/// Adds up the events of a reader.
class Totals {
 public:
  explicit Totals(Summary& summary) : s_(summary) {}

  void block() { ++s_.blocks; }
  void tool(std::int64_t) {
    ++s_.events;
    ++s_.tool_changes;
  }
  void spindle(std::string_view, bool, double) { ++s_.events; }
  void coolant(std::string_view) { ++s_.events; }
  void orient(double) { ++s_.events; }
  void stop(std::string_view) { ++s_.events; }
  void end(std::string_view) { ++s_.events; }
  void dwell(double seconds) {
    ++s_.events;
    s_.dwell_seconds += seconds;
  }

  /// A run begins: the machine stands where no move of it has led.
  void begin() { reached_ = 0; }

  /// `time` is that of this move.
  void move(const Move& m, const MoveTime& time) {
    ++s_.events;
    s_.axes |= m.machine.known;
    add_turns(m);
    switch (m.kind) {
      case Move::Kind::rapid:
        ++s_.rapids;
        s_.rapid_length_mm += time.length_mm;
        add_rapid_time(time);
        break;
      case Move::Kind::feed:
        ++s_.feeds;
        s_.feed_length_mm += time.length_mm;
        add_feed_time(time);
        reach_start(m);
        break;
      case Move::Kind::arc:
        ++s_.arcs;
        s_.feed_length_mm += time.length_mm;
        add_feed_time(time);
        reach_start(m);
        bulge(m);
        break;
    }
    reach(m);
  }

 private:
  void add_turns(const Move& m) {
    if ((m.machine.known & m.from.known) >> 3 == 0) return;
    for (unsigned i = 3; i < 6; ++i)
      if (m.from.has(i) && m.machine.has(i)) s_.turned_deg[i - 3] += std::abs(m.machine.at[i] - m.from.at[i]);
  }

  void add_rapid_time(const MoveTime& time) {
    s_.rapid_time_known = s_.rapid_time_known && time.is_known;
    s_.rapid_seconds += time.seconds;
  }
  void add_feed_time(const MoveTime& time) {
    s_.feed_time_known = s_.feed_time_known && time.is_known;
    s_.feed_seconds += time.seconds;
    if (time.is_slowed) ++s_.slowed_feeds;
  }

  void bulge(const Move& m) {
    const Arc& a = m.arc;
    if (!a.has_center || !m.from.has_xyz() || !m.machine.has_xyz()) return;
    const Helix way(m.from.at, m.machine.at, a.machine_center, a.normal, sweep_deg(m));
    for (unsigned i = 0; i < 3; ++i)
      way.turning_points(i, [&](double at) { widen(machine_known_, i, at, s_.minimum, s_.maximum); });
    if (!m.program.has_xyz()) return;
    double normal[3] = {0, 0, 0};
    normal[a.plane == "YZ" ? 0 : a.plane == "ZX" ? 1 : 2] = 1;
    const Helix programmed(a.start, m.program.at, a.center, normal, sweep_deg(m));
    for (unsigned i = 0; i < 3; ++i)
      programmed.turning_points(
          i, [&](double at) { widen(program_known_, i, at, s_.program_minimum, s_.program_maximum); });
  }

  /// The start of a cut is included; the start of a rapid move is not (the first one starts at home). Where a move has
  /// led there, it has counted the place.
  void reach_start(const Move& m) {
    if ((m.from.known & m.machine.known & ~reached_) == 0) return;
    for (unsigned i = 0; i < 6; ++i)
      if (m.from.has(i) && m.machine.has(i)) widen(machine_known_, i, m.from.at[i], s_.minimum, s_.maximum);
  }
  void reach(const Move& m) {
    s_.any_motion = true;
    reached_ |= m.machine.known;
    widen_all(machine_known_, m.machine, 6, s_.minimum, s_.maximum);
    widen_all(program_known_, m.program, 3, s_.program_minimum, s_.program_maximum);
  }
  static void widen_all(std::uint32_t& known, const AxisPoint& to, unsigned axes, double* minimum, double* maximum) {
    constexpr std::uint32_t xyz = AxisPoint::xyz;
    if (to.known == xyz && (known & xyz) == xyz) {
      for (unsigned i = 0; i < 3; ++i) {
        minimum[i] = std::min(minimum[i], to.at[i]);
        maximum[i] = std::max(maximum[i], to.at[i]);
      }
      return;
    }
    for (unsigned i = 0; i < axes; ++i)
      if (to.has(i)) widen(known, i, to.at[i], minimum, maximum);
  }
  static void widen(std::uint32_t& known, unsigned axis, double at, double* minimum, double* maximum) {
    const bool is_first = (known >> axis & 1u) == 0;
    known |= 1u << axis;
    minimum[axis] = is_first ? at : std::min(minimum[axis], at);
    maximum[axis] = is_first ? at : std::max(maximum[axis], at);
  }

  Summary& s_;
  std::uint32_t machine_known_ = 0, program_known_ = 0;
  std::uint32_t reached_ = 0;  ///< a bit for each axis that a move of this run has led somewhere
};

}  // namespace isogloss
