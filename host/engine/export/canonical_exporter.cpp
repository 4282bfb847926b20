// The motions of a run as plain blocks: cycles, macros, offsets and compensation are resolved, and each block is whole
// in itself. The words are rows of the dialect's ProgramText; nothing here knows one of them.
#include "isogloss/engine/canonical.hpp"

#include <algorithm>
#include <cmath>

#include "export/canonical_blocks.hpp"
#include "export/canonical_path.hpp"
#include "export/motion_reader.hpp"
#include "isogloss/engine/chain.hpp"

namespace isogloss {

namespace {

constexpr double seconds_per_minute = 60;
/// A frame that changes moves the program's coordinates further than rounding does.
constexpr double frame_change_mm = 1e-5;

class CanonicalExporter : public Exporter {
 public:
  CanonicalExporter(Output& output, const ProgramText& text, const CanonicalOptions& options, DiagnosticSink& sink)
      : blocks_(output, text, options.exact, sink), options_(options), reader_(options.zero_moves) {
    for (std::size_t i = 0; i < std::size(arcs_); ++i)
      arcs_[i] = text.find(std::string("arc ") + planes[i / 2] + (i % 2 == 0 ? " CW" : " CCW"));
  }

  void begin(Document& initial, const SymbolTable& symbols) override {
    reader_.begin(initial, symbols);
    const auto* const service =
        initial.chain == nullptr ? nullptr : initial.chain->service("isogloss.machine-kinematics/1");
    kinematics_ = static_cast<const ig_machine_kinematics_1*>(service);
    tool_length_ = initial.layout().id("ToolHeightCompensation.Offset_mm");
    at_ = {};
    has_ended_ = has_speed_ = false;
    blocks_.begin();
  }
  bool block(Document& document, const SymbolTable& symbols) override {
    document_ = &document;
    blocks_.at(document);
    reader_.read(document, symbols, *this);
    return blocks_.ok();
  }
  bool end() override {
    if (!has_ended_) blocks_.write("end", {});
    return blocks_.end();
  }

  // ---- Events, as the reader calls them.

  void tool(std::int64_t id) { blocks_.write("tool", {{"TOOL", static_cast<double>(id)}}); }
  void spindle(std::string_view direction, bool has_speed, double rpm) {
    Values values;
    if (has_speed)
      values.push_back({"SPEED", rpm});
    else if (has_speed_ && direction != "STOP")
      blocks_.report("IG-0623", {});
    has_speed_ = has_speed_ || has_speed;
    blocks_.write("spindle", values, direction);
  }
  void coolant(std::string_view mode) { blocks_.write("coolant", {}, mode); }
  void dwell(double seconds) { blocks_.write("dwell", {{"SECONDS", seconds}}); }
  void orient(double degrees) { blocks_.write("orient", {{"ANGLE", degrees}}); }
  void stop(std::string_view) { blocks_.write("stop", {}); }
  void end(std::string_view) {
    has_ended_ = true;
    blocks_.write("end", {});
  }

  void move(const Move& m) {
    const AxisPoint& goal = options_.frame == CanonicalOptions::Frame::machine ? m.machine : m.program;
    AxisPoint to = goal;
    for (unsigned i = 3; i < 6; ++i) {
      to.at[i] = m.machine.at[i];
      to.known |= m.machine.known & (1u << i);
    }
    if (m.kind != Move::Kind::rapid) {
      if (!m.has_feed) blocks_.report("IG-0190", {});
      stand_at_start(m);
    }
    if (m.kind == Move::Kind::arc)
      arc(m, to);
    else if (m.is_led && is_machine_frame())
      led(m, to);
    else
      line(m.kind == Move::Kind::rapid ? "rapid" : "feed", to, feed_of(m));
  }

 private:
  using Values = CanonicalBlocks::Values;
  static constexpr const char* planes[] = {"YZ", "ZX", "XY"};  // by the axis of their normal

  bool is_machine_frame() const { return options_.frame == CanonicalOptions::Frame::machine; }
  static std::optional<double> feed_of(const Move& m) {
    return m.has_feed ? std::optional(m.feed_mmds * seconds_per_minute) : std::nullopt;
  }
  /// As whoever reads the block finds it.
  double written(double value) const { return options_.exact ? value : std::round(value * 1e6) / 1e6; }

  // ---- Where a move starts.

  PathPoint point_of(const AxisPoint& p) const {
    PathPoint out;
    for (unsigned i = 0; i < 6; ++i) out[i] = p.has(i) ? p.at[i] : at_.at[i];
    return out;
  }

  /// The reader of the blocks must stand where a feed or an arc begins: at the very first, and, in program coordinates,
  /// where the frame has changed under the resting tool.
  void stand_at_start(const Move& m) {
    AxisPoint from = m.from;
    if (!is_machine_frame()) {
      if (!m.from.has_xyz()) return;
      double start[3];
      if (m.kind == Move::Kind::arc)
        std::copy_n(m.arc.start, 3, start);
      else if (m.is_led)
        std::copy_n(m.start.at, 3, start);
      else if (!document_->map_to_program({m.from.at[0], m.from.at[1], m.from.at[2]}, start))
        return;
      std::copy_n(start, 3, from.at);
    } else if (m.kind != Move::Kind::arc && !m.is_led) {
      return;
    }
    if (!from.has_xyz()) return;
    const double off = distance_xyz(point_of(from), point_of(at_));
    if (at_.has_xyz() && off <= frame_change_mm) return;
    if (at_.has_xyz()) blocks_.report("IG-0191", {fmt_number(off)});
    if (at_.has_xyz() || off > frame_change_mm) line("rapid", from, std::nullopt);
    advance(from);
  }
  std::string fmt_number(double value) const { return block_number(value, false, true); }

  // ---- Moves.

  void arc(const Move& m, const AxisPoint& to) {
    const Arc& a = m.arc;
    if (!a.has_center || !to.has_xyz() || !at_.has_xyz()) {
      blocks_.report("IG-0192", {});
      return line("feed", to, feed_of(m));
    }
    double normal[3] = {a.normal[0], a.normal[1], a.normal[2]};
    const double* center = a.machine_center;
    if (!is_machine_frame()) {
      for (int i = 0; i < 3; ++i) normal[i] = i == 3 - a.first_axis - a.second_axis ? 1 : 0;
      center = a.center;
    }
    const PathPoint end = point_of(to);
    const ArcPath path(point_of(at_), end, center, normal, sweep_deg(m));
    int axis = -1;  // along which the normal lies
    for (int i = 0; i < 3; ++i)
      if (std::abs(std::abs(normal[i]) - 1) < 1e-12) axis = i;
    constexpr double same_radius_mm = 0.0005;  // far below what a control lets pass
    if (axis < 0 || std::abs(path.radius() - path.end_radius()) > same_radius_mm || path.radius() < 1e-5) {
      const double turn = std::abs(path.sweep());
      const int pieces = std::max(1, static_cast<int>(std::ceil(turn / (std::numbers::pi / 2))));
      return lines(
          "feed", to, divide([&](double at) { return path.at(at); }, options_.tolerance_mm, pieces),
          [&](double at) { return path.at(at); }, [&](double) { return feed_of(m); });
    }
    constexpr double turn = 2 * std::numbers::pi;
    const double sweep = std::abs(path.sweep());
    // A block makes one turn at most; a full circle ends where it starts.
    const int circles = static_cast<int>(std::ceil(sweep / turn - 1e-9)) - 1;
    for (int i = 1; i <= circles; ++i)
      arc_block(m, axis, normal[axis] > 0, path.at(turn * i / sweep), to.known, center, true);
    const bool is_full = sweep - turn * circles > turn - 1e-9;
    arc_block(m, axis, normal[axis] > 0, end, to.known, center, is_full);
  }

  void arc_block(const Move& m, int axis, bool is_upright, const PathPoint& end, std::uint32_t known,
                 const double* center, bool is_full) {
    AxisPoint to;
    to.known = known;
    std::copy_n(end.data(), 6, to.at);
    const int first = (axis + 1) % 3, second = (axis + 2) % 3;
    if (is_full) {
      to.at[first] = at_.at[first];
      to.at[second] = at_.at[second];
    } else if (written(to.at[first]) == written(at_.at[first]) && written(to.at[second]) == written(at_.at[second])) {
      return line("feed", to, feed_of(m));  // too short for an arc: it would read as a full circle
    }
    Values values = axes(to);
    for (const int i : {first, second})
      values.push_back(
          {std::string_view("IJK").substr(static_cast<std::size_t>(i), 1), center[i] - written(at_.at[i])});
    if (m.has_feed) values.push_back({"F", *feed_of(m)});
    const ProgramText::Row* const row = arcs_[2 * axis + (m.arc.is_ccw == is_upright ? 1 : 0)];
    if (row == nullptr) return blocks_.report("IG-0193", {std::string("arc ") + planes[axis]});
    advance(to);
    blocks_.put(*row, values);
  }

  void led(const Move& m, const AxisPoint& to) {
    const double length = document_->present(tool_length_) ? document_->number(tool_length_) : 0;
    const PathPoint start = point_of(m.from), end = point_of(to);
    const char* const form = m.kind == Move::Kind::rapid ? "rapid" : "feed";
    if (kinematics_ == nullptr || !m.from.has_xyz() || !to.has_xyz()) return line(form, to, feed_of(m));
    const LedPath path(*kinematics_, start, end, length);
    if (!path.is_known()) return line(form, to, feed_of(m));
    const auto at = [&](double place) { return path.at(place); };
    const auto feed_between = [&](const PathPoint& a, const PathPoint& b, double share) -> std::optional<double> {
      if (!m.has_feed) return std::nullopt;
      const double turn = std::hypot(end[3] - start[3], end[4] - start[4], end[5] - start[5]);
      const double tip = path.length_of_tip() > 1e-7 ? path.length_of_tip() : turn;
      const double way = distance_xyz(a, b) > 1e-7 ? distance_xyz(a, b) : turn * share;
      return tip > 0 && way > 0 ? *feed_of(m) * way / (tip * share) : *feed_of(m);
    };
    double before = 0;
    lines(form, to, divide(at, options_.tolerance_mm, 1), at, [&](double place) {
      const auto feed = feed_between(path.at(before), path.at(place), place - before);
      before = place;
      return feed;
    });
  }

  /// Lines to these places of the path; the last one to the end itself.
  template <class At, class Feed>
  void lines(const char* form, const AxisPoint& to, const std::vector<double>& places, At at, Feed feed) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      AxisPoint point = to;
      if (i + 1 < places.size()) {
        const PathPoint p = at(places[i]);
        std::copy_n(p.data(), 6, point.at);
      }
      line(form, point, feed(places[i]));
    }
  }

  void line(const char* form, const AxisPoint& to, std::optional<double> feed) {
    Values values = axes(to);
    if (feed) values.push_back({"F", *feed});
    advance(to);
    blocks_.write(form, values);
  }

  static Values axes(const AxisPoint& point) {
    Values out;
    for (unsigned i = 0; i < 6; ++i)
      if (point.has(i)) out.push_back({std::string_view("XYZABC").substr(i, 1), point.at[i]});
    return out;
  }
  void advance(const AxisPoint& to) {
    for (unsigned i = 0; i < 6; ++i)
      if (to.has(i)) at_.at[i] = to.at[i];
    at_.known |= to.known;
  }

  CanonicalBlocks blocks_;
  CanonicalOptions options_;
  MotionReader reader_;
  const ProgramText::Row* arcs_[6] = {};  // by the axis of the normal, clockwise first
  Document* document_ = nullptr;
  const ig_machine_kinematics_1* kinematics_ = nullptr;
  ig_field tool_length_ = IG_NO_FIELD;
  AxisPoint at_;  // where the reader of the blocks stands
  bool has_ended_ = false;
  bool has_speed_ = false;  // a block has written one
};

}  // namespace

std::unique_ptr<Exporter> make_canonical_exporter(Output& output, const ProgramText& text,
                                                  const CanonicalOptions& options, DiagnosticSink& sink) {
  return std::make_unique<CanonicalExporter>(output, text, options, sink);
}

}  // namespace isogloss
