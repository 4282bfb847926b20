/// The motion stream as text: one event a line, as JSON Lines, as CSV, or as columns for people. The first two are bulk
/// output: each event is written through one pointer, numbers by number_writer, what does not change (the file) once.
#pragma once

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>

#include "export/motion_reader.hpp"
#include "export/text_buffer.hpp"
#include "isogloss/engine/exporter.hpp"
#include "isogloss/engine/printable.hpp"

namespace isogloss {

/// Room for everything that an event holds besides names and file.
inline constexpr std::size_t event_room = 2048;

template <bool exact>
char* put_number(char* out, double value) {
  if constexpr (exact)
    return write_exact(out, value);
  else
    return write_decimal(out, value);
}

/// A number that is often the same from event to event (the level of a pocket, the axes of a hole, the feed): its text
/// is kept.
template <bool exact>
class RepeatedNumber {
 public:
  char* put(char* out, double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    if (bits != bits_) {
      bits_ = bits;
      size_ = 0;
      return put_number<exact>(out, value);
    }
    if (size_ == 0) return keep(out, put_number<exact>(out, value));
    std::memcpy(out, text_, sizeof text_);
    return out + size_;
  }

 private:
  char* keep(const char* begin, char* end) {
    const auto size = static_cast<std::size_t>(end - begin);
    if (size > sizeof text_) return end;
    size_ = size;
    std::memcpy(text_, begin, sizeof text_);  // behind the number as well: there is room for the longest
    return end;
  }

  std::uint64_t bits_ = 0;
  std::size_t size_ = 0;  // 0: no text is kept, as of a value that has come once
  char text_[24] = {};
};

template <bool exact>
using RepeatedPoint = std::array<RepeatedNumber<exact>, 3>;

/// What the formats share: where the events of this block stand.
class EventLines {
 public:
  explicit EventLines(Output& output) : buffer_(output) {}
  TextBuffer& buffer() { return buffer_; }
  /// A new run: its file's name may stand where the last one's stood.
  void forget_file() { seen_ = {}; }

 protected:
  TextBuffer buffer_;
  std::string prefix_;  // up to the line number
  std::uint32_t line_ = 0;

  /// True when the file has changed.
  bool enter(const BlockSource& source) {
    line_ = source.line;
    const bool same_text = source.file.data() == seen_.data() && source.file.size() == seen_.size();
    if (!prefix_.empty() && (same_text || source.file == file_)) return false;
    seen_ = source.file;
    file_ = source.file;
    return true;
  }
  const std::string& file() const { return file_; }

 private:
  std::string file_;
  std::string_view seen_;  // compared by address: within a run one file is named by the same text
};

template <bool exact>
class JsonLines : public EventLines {
 public:
  using EventLines::EventLines;

  void header(const MotionOptions& options) {
    if (!options.header) return;
    buffer_.append(R"({"Isogloss":1,"Dialect":)" + json_string(options.dialect) +
                   R"(,"Units":"mm, deg, s, mm/s"})"
                   "\n");
  }
  void block(const BlockSource& source) {
    if (enter(source)) prefix_ = R"({"File":)" + json_string(file()) + R"(,"Line":)";
  }

  void move(const Move& m) {
    char* p = start();
    switch (m.kind) {
      case Move::Kind::rapid: p = put(p, R"(,"Event":"rapid")"); break;
      case Move::Kind::feed: p = put(p, R"(,"Event":"feed")"); break;
      case Move::Kind::arc: p = put(p, R"(,"Event":"arc")"); break;
    }
    if (m.program.known == 7)
      p = point(put(p, R"(,"ProgramXyz":)"), m.program.at, program_);
    else if (m.program.known != 0)
      p = axes(put(p, R"(,"ProgramXyz":)"), m.program);
    if (m.machine.known == 7)
      p = point(put(p, R"(,"MachineCoordinate":)"), m.machine.at, machine_);
    else if (m.machine.known != 0)
      p = axes(put(p, R"(,"MachineCoordinate":)"), m.machine);
    if (m.kind == Move::Kind::arc) p = arc(p, m.arc);
    if (m.has_feed) p = repeated(put(p, R"(,"Feedrate_mmds":)"), m.feed_mmds, feed_);
    if (m.kind == Move::Kind::arc && m.arc.has_center) {
      p = point(put(p, R"(,"MachineArcCenter":)"), m.arc.machine_center, machine_center_);
      p = put(p, R"(,"Normal":)");
      p = m.arc.normal[2] == 1 ? put(p, R"({"X":0,"Y":0,"Z":1})") : xyz(p, m.arc.normal);
      p = number(put(p, R"(,"Sweep_deg":)"), sweep_deg(m));
    }
    if (m.is_manual) p = put(p, R"(,"Manual":true)");
    if (m.is_led) p = put(p, R"(,"Form":"ClLinear")");
    finish(p);
  }
  void dwell(double seconds) { finish(number(put(start(), R"(,"Event":"dwell","Time":)"), seconds)); }
  void orient(double angle) { finish(number(put(start(), R"(,"Event":"orient","Angle_deg":)"), angle)); }
  void tool(std::int64_t id) { finish(write_integer(put(start(), R"(,"Event":"tool","ToolId":)"), id)); }
  void spindle(std::string_view direction, bool has_speed, double rpm) {
    const std::string name = json_string(direction);
    char* p = put(put(start(name.size()), R"(,"Event":"spindle","Direction":)"), name);
    if (has_speed) p = number(put(p, R"(,"SpindleSpeed_rpm":)"), rpm);
    finish(p);
  }
  void coolant(std::string_view mode) { named(R"(,"Event":"coolant","Mode":)", mode); }
  void stop(std::string_view term) { named(R"(,"Event":"stop","Term":)", term); }
  void end(std::string_view term) { named(R"(,"Event":"end","Term":)", term); }

 private:
  char* start(std::size_t more = 0) {
    char* const p = buffer_.reserve(prefix_.size() + event_room + more);
    return write_integer(put(p, std::string_view(prefix_)), line_);
  }
  void finish(char* p) { buffer_.commit(put(p, "}\n")); }
  void named(std::string_view key, std::string_view text) {
    const std::string name = json_string(text);
    finish(put(put(start(name.size()), key), name));
  }
  static char* number(char* p, double value) {
    char* const end = put_number<exact>(p, value);
    return end != p ? end : put(p, "null");
  }
  static char* repeated(char* p, double value, RepeatedNumber<exact>& kept) {
    char* const end = kept.put(p, value);
    return end != p ? end : put(p, "null");
  }
  static char* point(char* p, const double* at, RepeatedPoint<exact>& kept) {
    p = repeated(put(p, R"({"X":)"), at[0], kept[0]);
    p = repeated(put(p, R"(,"Y":)"), at[1], kept[1]);
    p = repeated(put(p, R"(,"Z":)"), at[2], kept[2]);
    *p = '}';
    return p + 1;
  }
  static char* xyz(char* p, const double* at) {
    p = number(put(p, R"({"X":)"), at[0]);
    p = number(put(p, R"(,"Y":)"), at[1]);
    p = number(put(p, R"(,"Z":)"), at[2]);
    *p = '}';
    return p + 1;
  }
  static char* axes(char* p, const AxisPoint& point) {
    char separator = '{';
    for (unsigned i = 0; i < 6; ++i) {
      if (!point.has(i)) continue;
      const char key[] = {separator, '"', "XYZABC"[i], '"', ':'};
      p = number(put(p, std::string_view(key, sizeof key)), point.at[i]);
      separator = ',';
    }
    *p = '}';
    return p + 1;
  }
  char* arc(char* p, const Arc& a) {
    if (a.has_center) p = point(put(p, R"(,"ArcCenter":)"), a.center, center_);
    p = put(p, R"(,"Plane":)");
    p = a.plane == "XY" ? put(p, R"("XY")") : put(p, json_string(a.plane.substr(0, 64)));
    p = a.is_ccw ? put(p, R"(,"IsCcw":true)") : put(p, R"(,"IsCcw":false)");
    return write_integer(put(p, R"(,"AdditionalCircleNum":)"), a.additional_circles);
  }

  RepeatedPoint<exact> program_, machine_, center_, machine_center_;
  RepeatedNumber<exact> feed_;
};

/// A field of RFC 4180: in quotes where it must be.
inline std::string csv_field(std::string_view text) {
  std::string field = valid_utf8(text);
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string quoted = "\"";
  for (const char c : field) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

template <bool exact>
class CsvLines : public EventLines {
 public:
  using EventLines::EventLines;

  void header(const MotionOptions&) {
    buffer_.append(
        "file,line,event,px,py,pz,mx,my,mz,a,b,c,feed_mm_s,cx,cy,cz,ccw,circles,plane,mcx,mcy,mcz,nx,ny,nz,sweep,"
        "value,term\n");
  }
  void block(const BlockSource& source) {
    if (enter(source)) prefix_ = csv_field(file()) + ',';
  }

  void move(const Move& m) {
    char* p = start();
    switch (m.kind) {
      case Move::Kind::rapid: p = put(p, ",rapid"); break;
      case Move::Kind::feed: p = put(p, ",feed"); break;
      case Move::Kind::arc: p = put(p, ",arc"); break;
    }
    p = m.program.known == 7 ? point(p, m.program.at, program_) : axes<0, 3>(p, m.program);
    p = (m.machine.known & 7u) == 7 ? point(p, m.machine.at, machine_) : axes<0, 3>(p, m.machine);
    p = m.machine.known < 8 ? put(p, ",,,") : axes<3, 6>(p, m.machine);
    *p++ = ',';
    if (m.has_feed) p = feed_.put(p, m.feed_mmds);
    p = m.kind == Move::Kind::arc ? arc(p, m) : put(p, ",,,,,,,,,,,,,");
    p = m.is_manual ? put(p, ",,manual") : put(p, ",,");
    finish(p);
  }
  void dwell(double seconds) { value(",dwell", seconds); }
  void orient(double angle) { value(",orient", angle); }
  void tool(std::int64_t id) { finish(put(write_integer(blank(",tool"), id), ",")); }
  void spindle(std::string_view direction, bool has_speed, double rpm) {
    const std::string name = csv_field(direction);
    char* p = blank(",spindle", name.size());
    if (has_speed) p = put_number<exact>(p, rpm);
    finish(put(put(p, ","), name));
  }
  void coolant(std::string_view mode) { term(",coolant", mode); }
  void stop(std::string_view code) { term(",stop", code); }
  void end(std::string_view code) { term(",end", code); }

 private:
  char* start(std::size_t more = 0) {
    char* const p = buffer_.reserve(prefix_.size() + event_room + more);
    return write_integer(put(p, std::string_view(prefix_)), line_);
  }
  void finish(char* p) { buffer_.commit(put(p, "\n")); }
  /// All columns up to `value` empty.
  char* blank(std::string_view event, std::size_t more = 0) {
    return put(put(start(more), event), ",,,,,,,,,,,,,,,,,,,,,,,,");
  }
  void value(std::string_view event, double number) { finish(put(put_number<exact>(blank(event), number), ",")); }
  void term(std::string_view event, std::string_view text) {
    const std::string name = csv_field(text);
    finish(put(put(blank(event, name.size()), ","), name));
  }
  static char* xyz(char* p, const double* at) {
    for (int i = 0; i < 3; ++i) {
      *p = ',';
      p = put_number<exact>(p + 1, at[i]);
    }
    return p;
  }
  static char* point(char* p, const double* at, RepeatedPoint<exact>& kept) {
    for (std::size_t i = 0; i < 3; ++i) {
      *p = ',';
      p = kept[i].put(p + 1, at[i]);
    }
    return p;
  }
  template <unsigned first, unsigned last>
  static char* axes(char* p, const AxisPoint& point) {
    for (unsigned i = first; i < last; ++i) {
      *p++ = ',';
      if (point.has(i)) p = put_number<exact>(p, point.at[i]);
    }
    return p;
  }
  char* arc(char* p, const Move& m) {
    const Arc& a = m.arc;
    p = a.has_center ? point(p, a.center, center_) : put(p, ",,,");
    p = a.is_ccw ? put(p, ",1,") : put(p, ",0,");
    p = put(write_integer(p, a.additional_circles), ",");
    p = a.plane == "XY" ? put(p, "XY") : put(p, csv_field(a.plane.substr(0, 64)));
    if (!a.has_center) return put(p, ",,,,,,,");
    p = point(p, a.machine_center, machine_center_);
    p = a.normal[2] == 1 ? put(p, ",0,0,1,") : put(xyz(p, a.normal), ",");
    return put_number<exact>(p, sweep_deg(m));
  }

  RepeatedPoint<exact> program_, machine_, center_, machine_center_;
  RepeatedNumber<exact> feed_;
};

/// Columns for people; a title where an event is of another file than the one before it.
class TextLines : public EventLines {
 public:
  TextLines(Output& output, bool exact) : EventLines(output), exact_(exact) {}

  void header(const MotionOptions&) {}
  void block(const BlockSource& source) {
    if (enter(source)) prefix_ = "known";
  }

  void move(const Move& m) {
    const char* const name = m.kind == Move::Kind::arc     ? "arc"
                             : m.kind == Move::Kind::rapid ? (m.is_manual ? "manual" : "rapid")
                                                           : "feed";
    std::string line = fmt::format("{:<8}", name);
    for (unsigned i = 0; i < 3; ++i) line += fmt::format("{:>11}", m.program.has(i) ? length(m.program.at[i]) : "");
    line += "  ";
    for (unsigned i = 0; i < 3; ++i) line += fmt::format("{:>11}", m.machine.has(i) ? length(m.machine.at[i]) : "");
    line += fmt::format("{:>10}", m.has_feed ? number(m.feed_mmds * 60) : "");
    for (unsigned i = 3; i < 6; ++i)
      if (m.machine.has(i)) line += fmt::format("  {}{}", "XYZABC"[i], number(m.machine.at[i]));
    if (m.kind == Move::Kind::arc) line += arc(m);
    write(line);
  }
  void dwell(double seconds) { write(fmt::format("{:<8}{} s", "dwell", number(seconds))); }
  void orient(double angle) { write(fmt::format("{:<8}{} deg", "orient", number(angle))); }
  void tool(std::int64_t id) { write(fmt::format("{:<8}{}", "tool", id)); }
  void spindle(std::string_view direction, bool has_speed, double rpm) {
    const bool tells_speed = has_speed && direction != "STOP";
    write(fmt::format("{:<8}{}{}", "spindle", printable(direction), tells_speed ? " " + number(rpm) + " rpm" : ""));
  }
  void coolant(std::string_view mode) { write(fmt::format("{:<8}{}", "coolant", printable(mode))); }
  void stop(std::string_view term) { write(fmt::format("{:<8}{}", "stop", printable(term))); }
  void end(std::string_view term) { write(fmt::format("{:<8}{}", "end", printable(term))); }

 private:
  bool exact_;
  std::optional<std::string> titled_;  // the file that the last title names

  void title() {
    titled_ = file();
    buffer_.append(fmt::format("{}\n{:>6}  {:<8}{:>11}{:>11}{:>11}  {:>11}{:>11}{:>11}{:>10}\n", printable(file()),
                               "line", "event", "program X", "Y", "Z", "machine X", "Y", "Z", "mm/min"));
  }
  void write(std::string line) {
    if (titled_ != file()) title();
    line.erase(line.find_last_not_of(' ') + 1);
    buffer_.append(fmt::format("{:>6}  {}\n", line_, line));
  }
  std::string number(double value) const {
    char text[number_room];
    return {text, exact_ ? write_exact(text, value) : write_decimal(text, value)};
  }
  std::string length(double value) const {
    if (exact_) return number(value);
    const std::string text = fmt::format("{:.3f}", value);
    return text == "-0.000" ? "0.000" : text;
  }
  std::string arc(const Move& m) const {
    const Arc& a = m.arc;
    std::string text = fmt::format("  {} {}", printable(a.plane), a.is_ccw ? "ccw" : "cw");
    if (!a.has_center) return text;
    return text + fmt::format(" about {} {} {}, {} deg", number(a.center[0]), number(a.center[1]), number(a.center[2]),
                              number(std::abs(sweep_deg(m))));
  }
};

}  // namespace isogloss
