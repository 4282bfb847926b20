/// Events as values, for a listener.
#pragma once

#include <algorithm>
#include <iterator>
#include <utility>

#include "export/motion_reader.hpp"
#include "isogloss/engine/motion.hpp"

namespace isogloss {

inline MotionPoint point_of(const AxisPoint& from, unsigned axes) {
  MotionPoint out;
  out.known = from.known & ((1u << axes) - 1);
  for (unsigned i = 0; i < axes; ++i)
    if (out.has(i)) out.at[i] = from.at[i];
  return out;
}

inline MotionArc arc_of(const Move& m) {
  MotionArc out;
  out.plane = m.arc.plane;
  out.is_ccw = m.arc.is_ccw;
  out.additional_circles = m.arc.additional_circles;
  out.has_center = m.arc.has_center;
  if (!out.has_center) return out;
  std::copy(std::begin(m.arc.start), std::end(m.arc.start), out.program_start);
  std::copy(std::begin(m.arc.center), std::end(m.arc.center), out.center);
  std::copy(std::begin(m.arc.machine_center), std::end(m.arc.machine_center), out.machine_center);
  std::copy(std::begin(m.arc.normal), std::end(m.arc.normal), out.normal);
  out.sweep_deg = sweep_deg(m);
  return out;
}

class MotionTeller {
 public:
  explicit MotionTeller(MotionListener listener) : listener_(std::move(listener)) {}

  void begin() { goes_on_ = true; }
  /// Of the events that follow; borrowed until the next call.
  void block(const BlockSource& source) { source_ = &source; }
  /// False once the listener has had enough.
  bool goes_on() const { return goes_on_; }

  void move(const Move& m) {
    Motion out = motion(m.kind == Move::Kind::arc     ? Motion::Event::arc
                        : m.kind == Move::Kind::rapid ? Motion::Event::rapid
                                                      : Motion::Event::feed);
    out.program = point_of(m.program, 3);
    out.machine = point_of(m.machine, 6);
    out.machine_start = point_of(m.from, 6);
    out.is_manual = m.is_manual;
    out.is_led = m.is_led;
    out.has_feed = m.has_feed;
    out.feed_mm_s = m.feed_mmds;
    MotionArc arc;
    if (m.kind == Move::Kind::arc) {
      arc = arc_of(m);
      out.arc = &arc;
    }
    tell(out);
  }
  void dwell(double seconds) { number(Motion::Event::dwell, seconds); }
  void orient(double degrees) { number(Motion::Event::orient, degrees); }
  void tool(std::int64_t number) {
    Motion out = motion(Motion::Event::tool);
    out.tool = number;
    tell(out);
  }
  void spindle(std::string_view direction, bool has_speed, double rpm) {
    Motion out = motion(Motion::Event::spindle);
    out.term = direction;
    out.has_value = has_speed;
    out.value = has_speed ? rpm : 0;
    tell(out);
  }
  void coolant(std::string_view mode) { term(Motion::Event::coolant, mode); }
  void stop(std::string_view code) { term(Motion::Event::stop, code); }
  void end(std::string_view code) { term(Motion::Event::end, code); }

 private:
  Motion motion(Motion::Event event) const {
    Motion out;
    out.event = event;
    out.file = source_->file;
    out.line = source_->line;
    return out;
  }
  void number(Motion::Event event, double value) {
    Motion out = motion(event);
    out.has_value = true;
    out.value = value;
    tell(out);
  }
  void term(Motion::Event event, std::string_view text) {
    Motion out = motion(event);
    out.term = text;
    tell(out);
  }
  /// Once the listener has had enough, the rest of the block is not told.
  void tell(const Motion& m) { goes_on_ = goes_on_ && listener_(m); }

  MotionListener listener_;
  const BlockSource* source_ = nullptr;
  bool goes_on_ = true;
};

}  // namespace isogloss
