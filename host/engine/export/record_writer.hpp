/// Events as records of the binary motion stream.
#pragma once

#include <bit>
#include <cstring>
#include <limits>
#include <map>
#include <string>

#include "export/motion_reader.hpp"
#include "export/text_buffer.hpp"
#include "isogloss/engine/motion_stream.hpp"

namespace isogloss {

static_assert(std::endian::native == std::endian::little, "records are written as they lie in memory");

/// A text record holds this much of its text, in place of the coordinates and numbers.
inline constexpr std::size_t text_record_bytes = sizeof(MotionRecord) - offsetof(MotionRecord, program);

class RecordWriter {
 public:
  explicit RecordWriter(Output& output) : buffer_(output) {}

  void header() { buffer_.append(motion_stream_header()); }
  void block(const BlockSource& source) {
    line_ = source.line;
    if (source.file.data() == seen_.data() && source.file.size() == seen_.size()) return;
    seen_ = source.file;
    is_file_named_ = false;
  }
  /// A new run begins: its file's name may stand where the last one's stood.
  void forget_file() { seen_ = {}; }

  void move(const Move& m, double seconds) {
    name_file();
    constexpr Motion::Event events[] = {Motion::Event::rapid, Motion::Event::feed, Motion::Event::arc};
    const bool is_arc = m.kind == Move::Kind::arc;
    const std::uint32_t plane = is_arc ? number_of(m.arc.plane) : MotionRecord::no_text;
    const double sweep = is_arc && m.arc.has_center ? circle(m) : unknown;
    MotionRecord& r = add(events[static_cast<unsigned>(m.kind)]);
    r.flags = static_cast<std::uint8_t>((m.is_manual ? MotionRecord::manual : 0) | (m.is_led ? MotionRecord::led : 0) |
                                        (m.has_feed ? MotionRecord::has_feed : 0));
    r.known = static_cast<std::uint16_t>((m.program.known & 7u) | m.machine.known << 3);
    r.text = plane;
    copy_known<3>(r.program, m.program);
    copy_known<6>(r.machine, m.machine);
    r.feed = m.has_feed ? m.feed_mmds : unknown;
    r.seconds = seconds;
    if (is_arc) {
      r.flags |= static_cast<std::uint8_t>((m.arc.is_ccw ? MotionRecord::ccw : 0) |
                                           (m.arc.has_center ? MotionRecord::has_center : 0));
      r.count = m.arc.additional_circles;
      r.value = sweep;
    }
    finish();
  }
  void dwell(double seconds) {
    name_file();
    MotionRecord& r = with_value(Motion::Event::dwell, seconds);
    r.seconds = seconds;
    finish();
  }
  void orient(double degrees) {
    name_file();
    with_value(Motion::Event::orient, degrees);
    finish();
  }
  void tool(std::int64_t number) {
    name_file();
    add_still(Motion::Event::tool).count = number;
    finish();
  }
  void spindle(std::string_view direction, bool has_speed, double rpm) {
    name_file();
    const std::uint32_t text = number_of(direction);
    MotionRecord& r = has_speed ? with_value(Motion::Event::spindle, rpm) : add_still(Motion::Event::spindle);
    r.text = text;
    finish();
  }
  void coolant(std::string_view mode) { term(Motion::Event::coolant, mode); }
  void stop(std::string_view code) { term(Motion::Event::stop, code); }
  void end(std::string_view code) { term(Motion::Event::end, code); }

  /// False once the output accepts no more.
  bool ok() const { return buffer_.ok(); }
  bool flush() { return buffer_.flush(); }

 private:
  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  template <unsigned count>
  static void copy_known(double (&to)[count], const AxisPoint& from) {
    if (from.known == AxisPoint::xyz) {
      std::memcpy(to, from.at, 3 * sizeof to[0]);
      for (unsigned i = 3; i < count; ++i) to[i] = unknown;
      return;
    }
    for (unsigned i = 0; i < count; ++i) to[i] = from.has(i) ? from.at[i] : unknown;
  }

  /// All but the coordinates, feed and seconds.
  MotionRecord& add(Motion::Event event) {
    MotionRecord& r = *new (buffer_.reserve(sizeof(MotionRecord))) MotionRecord;
    r.line = line_;
    r.file = file_;
    r.event = static_cast<std::uint8_t>(event);
    r.flags = 0;
    r.known = 0;
    r.text = MotionRecord::no_text;
    r.value = unknown;
    r.count = 0;
    return r;
  }
  MotionRecord& add_still(Motion::Event event) {
    MotionRecord& r = add(event);
    for (double& p : r.program) p = unknown;
    for (double& m : r.machine) m = unknown;
    r.feed = unknown;
    r.seconds = 0;
    return r;
  }
  MotionRecord& with_value(Motion::Event event, double value) {
    MotionRecord& r = add_still(event);
    r.flags = MotionRecord::has_value;
    r.value = value;
    return r;
  }
  void term(Motion::Event event, std::string_view text) {
    name_file();
    const std::uint32_t number = number_of(text);
    add_still(event).text = number;
    finish();
  }
  void finish() { buffer_.commit(buffer_.reserve(0) + sizeof(MotionRecord)); }

  /// The record before the arc's own. Returns the sweep.
  double circle(const Move& m) {
    MotionRecord& r = add_still(Motion::Event::arc);
    r.event = MotionRecord::circle_record;
    std::memcpy(r.program, m.arc.center, sizeof r.program);
    std::memcpy(r.machine, m.arc.machine_center, sizeof m.arc.machine_center);
    std::memcpy(r.machine + 3, m.arc.normal, sizeof m.arc.normal);
    r.value = sweep_deg(m);
    const double sweep = r.value;
    finish();
    return sweep;
  }

  /// Before an event's other texts: a block without events names no file.
  void name_file() {
    if (is_file_named_) return;
    is_file_named_ = true;
    file_ = number_of(seen_);
  }

  std::uint32_t number_of(std::string_view text) {
    if (const auto known = texts_.find(text); known != texts_.end()) return known->second;
    const auto number = static_cast<std::uint32_t>(texts_.size());
    texts_.emplace(text, number);
    do {
      const std::string_view piece = text.substr(0, text_record_bytes);
      text.remove_prefix(piece.size());
      MotionRecord& r = add(Motion::Event::end);
      r.line = number;
      r.file = static_cast<std::uint32_t>(piece.size());
      r.event = MotionRecord::text_record;
      r.flags = text.empty() ? 0 : MotionRecord::goes_on;
      char* const room = reinterpret_cast<char*>(&r) + offsetof(MotionRecord, program);
      std::memset(room, 0, text_record_bytes);
      if (!piece.empty()) std::memcpy(room, piece.data(), piece.size());
      finish();
    } while (!text.empty());
    return number;
  }

  TextBuffer buffer_;
  std::map<std::string, std::uint32_t, std::less<>> texts_;
  std::string_view seen_;  // compared by address: within a run one file is named by the same text
  std::uint32_t file_ = 0, line_ = 0;
  bool is_file_named_ = true;
};

}  // namespace isogloss
