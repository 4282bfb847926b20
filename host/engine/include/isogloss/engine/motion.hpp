/// The motions of a run as values, for programs that embed the host and want no text: the same events, in the same
/// order, as the lines of make_motion_exporter().
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include "isogloss/engine/exporter.hpp"

namespace isogloss {

/// A position by axes X Y Z A B C: mm, and degrees for A B C. An axis that is not known has the value 0.
struct MotionPoint {
  double at[6] = {};
  std::uint32_t known = 0;  ///< a bit for each axis, X is bit 0
  bool has(unsigned axis) const { return (known >> axis & 1u) != 0; }
};

/// Where an arc lies. It ends at `Motion::program`.
struct MotionArc {
  std::string_view plane;  ///< "XY", "ZX", "YZ"
  bool is_ccw = false;     ///< seen against the third axis of the plane
  std::int64_t additional_circles = 0;
  bool has_center = false;        ///< without one nothing below is known
  double program_start[3] = {};   ///< mm, program coordinates, in the frame of this block
  double center[3] = {};          ///< mm, program coordinates, at the level of the start
  double machine_center[3] = {};  ///< mm, machine coordinates
  double normal[3] = {};          ///< unit vector, machine coordinates
  double sweep_deg = 0;           ///< about `normal`, counter-clockwise when positive; with all whole turns
};

/// One event. All texts and the whole struct are borrowed: they end with the call that hands them out.
struct Motion {
  enum class Event : std::uint8_t { rapid, feed, arc, dwell, spindle, orient, tool, coolant, stop, end };
  Event event = Event::rapid;
  std::string_view file;   ///< of the block: a subprogram's block names the subprogram's file
  std::uint32_t line = 0;  ///< from 1

  // rapid, feed, arc
  MotionPoint program;        ///< the end; X Y Z at most
  MotionPoint machine;        ///< the end
  MotionPoint machine_start;  ///< where the axes stood before
  bool is_manual = false;     ///< the operator makes the move by hand (a rapid)
  bool is_led = false;        ///< "ClLinear": rotary axes turn while the tip goes straight in the workpiece
  bool has_feed = false;
  double feed_mm_s = 0;            ///< mm/s; deg/s of a move that only turns rotary axes
  const MotionArc* arc = nullptr;  ///< of an arc alone

  // all others
  bool has_value = false;
  double value = 0;       ///< dwell: s; spindle: rpm; orient: degrees
  std::int64_t tool = 0;  ///< tool: its number
  std::string_view term;  ///< spindle: direction; coolant: mode; stop and end: the code of the program
};

/// Called for each event on the thread that runs the program, in the order in which the machine performs them. False
/// ends the run quietly, after the block. What it throws comes out of run(), and ends it.
using MotionListener = std::function<bool(const Motion&)>;

struct MotionListenerOptions {
  bool zero_moves = false;  ///< keep linear moves that change no machine axis
};

/// An exporter for run(). It belongs to one run at a time, and keeps a copy of `listener`.
std::unique_ptr<Exporter> make_motion_listener(MotionListener listener, const MotionListenerOptions& options = {});

}  // namespace isogloss
