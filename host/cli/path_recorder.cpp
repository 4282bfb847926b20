// Listens to the motions of a run and keeps where the tip of the tool goes in the workpiece.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "isogloss/engine/chain.hpp"
#include "isogloss_tool.h"
#include "path_machine.hpp"

namespace isogloss::cli {

namespace {

using Kind = PathMove::Kind;

double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

Point between(const Point& a, const Point& b, double part) {
  return {a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part, a[2] + (b[2] - a[2]) * part};
}

Point difference(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// Both ends of a move on the machine's axes. An axis that is not known stands where it will be known, or at 0.
struct Axes {
  Point from{}, to{}, from_angles{}, to_angles{};

  explicit Axes(const Motion& m) {
    for (unsigned i = 0; i < 6; ++i) {
      const double end = m.machine.has(i) ? m.machine.at[i] : m.machine_start.has(i) ? m.machine_start.at[i] : 0;
      const double start = m.machine_start.has(i) ? m.machine_start.at[i] : end;
      (i < 3 ? from[i] : from_angles[i - 3]) = start;
      (i < 3 ? to[i] : to_angles[i - 3]) = end;
    }
  }
  double turn() const {
    double out = 0;
    for (std::size_t i = 0; i < 3; ++i) out = std::max(out, std::abs(to_angles[i] - from_angles[i]));
    return out;
  }
};

/// In machine coordinates.
PathArc arc_of(const Motion& m, const Axes& axes) {
  PathArc out;
  const MotionArc& arc = *m.arc;
  out.sweep = arc.sweep_deg * std::numbers::pi / 180;
  const double* const n = arc.normal;
  double height_of_start = 0, height = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    height_of_start += (axes.from[i] - arc.machine_center[i]) * n[i];
    height += (axes.to[i] - axes.from[i]) * n[i];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    out.center[i] = arc.machine_center[i] + height_of_start * n[i];
    out.r[i] = axes.from[i] - out.center[i];
    out.rise[i] = height * n[i];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    out.q[i] = n[j] * out.r[k] - n[k] * out.r[j];
  }
  return out;
}

class PathRecorder : public Exporter {
 public:
  PathRecorder(ToolPath& path, const RapidRates& rates, const ToolPathOptions& options)
      : path_(path), rates_(rates), options_(options) {
    reader_ = make_motion_listener([this](const Motion& m) { return listen(m); });
  }

  void begin(Document& initial, const SymbolTable& symbols) override {
    machine_ = PathMachine(initial.chain);
    path_.kinematics = machine_.describe();
    names_ = service<ig_tool_name_1>(initial, "isogloss.tool-name/1");
    offsets_ = service<ig_tool_offset_1>(initial, "isogloss.tool-offset/1");
    tool_length_ = initial.layout().id("ToolHeightCompensation.Offset_mm");
    lever_ = initial.layout().id("PivotTransform.Lever_mm");
    select(0);
    reader_->begin(initial, symbols);
  }
  bool block(Document& document, const SymbolTable& symbols) override {
    document_ = &document;
    return reader_->block(document, symbols) && !path_.is_cut;
  }
  bool end() override { return reader_->end() || path_.is_cut; }

 private:
  template <class Service>
  static const Service* service(const Document& initial, std::string_view id) {
    return initial.chain == nullptr ? nullptr : static_cast<const Service*>(initial.chain->service(id));
  }

  bool listen(const Motion& m) {
    switch (m.event) {
      case Motion::Event::rapid:
      case Motion::Event::feed:
      case Motion::Event::arc: return add_move(m);
      case Motion::Event::dwell: add_dwell(m); break;
      case Motion::Event::tool: select(m.tool); break;
      default: break;
    }
    return true;
  }

  void select(std::int64_t number) {
    const auto [found, is_new] = tools_.try_emplace(number, static_cast<std::uint16_t>(path_.tools.size()));
    if (is_new && path_.tools.size() < UINT16_MAX) path_.tools.push_back(describe(number));
    tool_ = std::min<std::uint16_t>(found->second, static_cast<std::uint16_t>(path_.tools.size() - 1));
  }

  PathTool describe(std::int64_t number) const {
    PathTool out;
    out.number = number;
    if (number <= 0) return out;
    if (names_ != nullptr) {
      const ig_text name = names_->name(names_->self, number);
      if (name.size > 0) out.name.assign(name.data, name.size);
    }
    if (offsets_ != nullptr) {
      offsets_->get(offsets_->self, number, IG_TOOL_RADIUS, &out.radius_mm);
      offsets_->get(offsets_->self, number, IG_TOOL_LENGTH, &out.length_mm);
    }
    return out;
  }

  std::uint16_t file(std::string_view name) {
    if (!path_.files.empty() && path_.files[file_] == name) return file_;
    const auto found = std::find(path_.files.begin(), path_.files.end(), name);
    file_ = static_cast<std::uint16_t>(std::min<std::ptrdiff_t>(found - path_.files.begin(), UINT16_MAX - 1));
    if (file_ == path_.files.size()) path_.files.emplace_back(name);
    return file_;
  }

  PathMove start(const Motion& m, Kind kind) {
    PathMove out;
    out.kind = kind;
    out.file = file(m.file);
    out.line = m.line;
    out.tool = tool_;
    out.first = static_cast<std::uint32_t>(path_.points.empty() ? 0 : path_.points.size() - 1);
    return out;
  }

  void keep(const PathMove& move, const Axes* axes) {
    ++path_.tools[tool_].moves;
    path_.moves.push_back(move);
    if (options_.keeps_ends) {
      std::array<float, 6> end{};
      for (std::size_t i = 0; axes != nullptr && i < 6; ++i)
        end[i] = static_cast<float>(i < 3 ? axes->to[i] : axes->to_angles[i - 3]);
      path_.ends.push_back(end);
    }
  }

  void add_dwell(const Motion& m) {
    if (path_.points.empty()) add_point({}, {});
    PathMove move = start(m, Kind::dwell);
    move.seconds = static_cast<float>(m.value);
    path_.dwell_seconds += m.value;
    keep(move, nullptr);
  }

  double led_length() const {
    double length = 0;
    for (const ig_field f : {tool_length_, lever_})
      if (f != IG_NO_FIELD && document_->present(f)) length += document_->number(f);
    return length;
  }

  bool add_move(const Motion& m) {
    constexpr std::size_t most_points = 100'000'000;
    if (path_.moves.size() >= options_.most_moves || path_.points.size() >= most_points) {
      path_.is_cut = true;
      return false;
    }
    const Axes axes(m);
    length_ = led_length();
    PathMove move = start(m, m.event == Motion::Event::rapid  ? Kind::rapid
                             : m.event == Motion::Event::feed ? Kind::feed
                                                              : Kind::arc);
    // Where the machine stands before its first move, nobody knows.
    const bool is_first = path_.points.empty() && m.event == Motion::Event::rapid;
    const Point tip =
        is_first ? machine_.tip(axes.to, axes.to_angles, length_) : machine_.tip(axes.from, axes.from_angles, length_);
    if (path_.points.empty() || distance(path_.points.back(), tip) > same_place_mm)
      add_point(tip, is_first ? axes.to_angles : axes.from_angles);
    move.first = static_cast<std::uint32_t>(path_.points.size() - 1);
    if (m.event != Motion::Event::rapid) path_.extent.add(tip);
    const double way = add_points(m, axes, move);
    move.segments = static_cast<std::uint32_t>(path_.points.size() - 1 - move.first);
    move.feed_mm_s = static_cast<float>(m.has_feed ? m.feed_mm_s : 0);
    add_time(m, axes, way, move);
    keep(move, &axes);
    return true;
  }

  /// The points behind the first one; returns the length of the way.
  double add_points(const Motion& m, const Axes& axes, PathMove& move) {
    const double turn = axes.turn();
    const bool is_turned = turn > 0 && machine_.is_known();
    if (m.arc != nullptr && m.arc->has_center && std::isfinite(m.arc->sweep_deg) && m.arc->sweep_deg != 0)
      return add_arc(arc_of(m, axes), axes, is_turned, move);
    const Point from = path_.points.back(), end = machine_.tip(axes.to, axes.to_angles, length_);
    constexpr double step_deg = 3, most = 2'000;
    const bool is_curved = is_turned && path_.points.size() > 1;
    const int steps = is_curved ? static_cast<int>(std::clamp(std::ceil(turn / step_deg), 1.0, most)) : 1;
    for (int i = 1; i <= steps; ++i) {
      const double part = static_cast<double>(i) / steps;
      const Point angles = between(axes.from_angles, axes.to_angles, part);
      if (i == steps)
        add_point(end, angles);
      else if (m.is_led)
        add_point(between(from, end, part), angles);
      else
        add_point(machine_.tip(between(axes.from, axes.to, part), angles, length_), angles);
      path_.extent.add(path_.points.back());
    }
    return m.is_led ? distance(from, end) : distance(axes.from, axes.to);
  }

  double add_arc(const PathArc& arc, const Axes& axes, bool is_turned, PathMove& move) {
    constexpr double widest = std::numbers::pi / 4, most = 20'000;
    const double radius = arc.radius(), turned = std::abs(arc.sweep);
    const double ratio = radius > options_.chord_mm ? options_.chord_mm / radius : 1;
    const double step = std::min(widest, 2 * std::acos(1 - ratio));
    const double narrowest = turned / most;
    const int steps = static_cast<int>(std::clamp(std::ceil(turned / std::max(step, narrowest)), 1.0, most));
    const Point miss = difference(axes.to, arc.at(arc.sweep));  // a spiral ends nearer or further than it begins
    for (int i = 1; i <= steps; ++i) {
      const double part = static_cast<double>(i) / steps;
      const Point angles = between(axes.from_angles, axes.to_angles, part), on_circle = arc.at(arc.sweep * part);
      Point at = axes.to;
      for (std::size_t k = 0; i < steps && k < 3; ++k) at[k] = on_circle[k] + miss[k] * part;
      add_point(machine_.tip(at, angles, length_), angles);
      if (is_turned) path_.extent.add(path_.points.back());
    }
    if (!is_turned) keep_arc(arc, axes.to_angles, std::hypot(miss[0], miss[1], miss[2]), move);
    return std::hypot(radius * turned, std::hypot(arc.rise[0], arc.rise[1], arc.rise[2]));
  }

  /// The same arc in the workpiece, for those who draw arcs as such.
  void keep_arc(const PathArc& arc, const Point& angles, double miss, PathMove& move) {
    const auto moved = [&](const Point& by) {
      const Point at{arc.center[0] + by[0], arc.center[1] + by[1], arc.center[2] + by[2]};
      return machine_.tip(at, angles, length_);
    };
    PathArc out;
    out.center = moved({});
    out.r = difference(moved(arc.r), out.center);
    out.q = difference(moved(arc.q), out.center);
    out.rise = difference(moved(arc.rise), out.center);
    out.sweep = arc.sweep;
    path_.extent.add(out);
    if (miss > options_.chord_mm) return;
    move.arc = static_cast<std::uint32_t>(path_.arcs.size());
    path_.arcs.push_back(out);
  }

  void add_point(const Point& p, const Point& angles) {
    path_.points.push_back(p);
    const bool turns = angles[0] != 0 || angles[1] != 0 || angles[2] != 0;
    if (!turns && !path_.turns_axes) return;
    if (!path_.turns_axes) {
      // The first angle other than zero: all points before had none.
      path_.turns_axes = true;
      path_.turns.resize(path_.points.size() - 1, turned({}));
    }
    path_.turns.push_back(turned(angles));
  }
  std::array<float, 6> turned(const Point& angles) const {
    const Point axis = machine_.tool_axis(angles);
    std::array<float, 6> out{};
    for (std::size_t i = 0; i < 3; ++i) {
      out[i] = static_cast<float>(angles[i]);
      out[i + 3] = static_cast<float>(axis[i]);
    }
    return out;
  }

  /// As the summary of a run counts it. Where a rate is not known, one is assumed, which the picture says.
  void add_time(const Motion& m, const Axes& axes, double way, PathMove& move) {
    const bool is_rapid = m.event == Motion::Event::rapid;
    double least = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      const double by = std::abs(i < 3 ? axes.to[i] - axes.from[i] : axes.to_angles[i - 3] - axes.from_angles[i - 3]);
      if (by == 0) continue;
      double rate = rates_.per_second[i];
      if (!(rate > 0) && is_rapid) {
        rate = i < 3 ? assumed_rapid_mm_s : assumed_rapid_deg_s;
        move.is_time_assumed = true;
      }
      if (rate > 0) least = std::max(least, by / rate);
    }
    double seconds = least;
    if (!is_rapid) {
      const double length = way > same_place_mm ? way
                                                : std::hypot(axes.to_angles[0] - axes.from_angles[0],
                                                             axes.to_angles[1] - axes.from_angles[1],
                                                             axes.to_angles[2] - axes.from_angles[2]);
      move.is_time_assumed = length > 0 && !(m.has_feed && m.feed_mm_s > 0);
      seconds = std::max(least, length / (move.is_time_assumed ? assumed_feed_mm_s : m.has_feed ? m.feed_mm_s : 1));
    }
    if (move.is_time_assumed) ++(is_rapid ? path_.assumed_rapids : path_.assumed_feeds);
    (is_rapid ? path_.rapid_seconds : path_.feed_seconds) += seconds;
    move.seconds = static_cast<float>(seconds);
  }

  static constexpr double same_place_mm = 1e-7;
  ToolPath& path_;
  const RapidRates rates_;
  const ToolPathOptions options_;
  std::unique_ptr<Exporter> reader_;
  PathMachine machine_;
  const ig_tool_name_1* names_ = nullptr;
  const ig_tool_offset_1* offsets_ = nullptr;
  ig_field tool_length_ = IG_NO_FIELD, lever_ = IG_NO_FIELD;
  const Document* document_ = nullptr;
  std::map<std::int64_t, std::uint16_t> tools_;
  std::uint16_t tool_ = 0, file_ = 0;
  double length_ = 0;
};

}  // namespace

std::unique_ptr<Exporter> make_path_recorder(ToolPath& path, const RapidRates& rates, const ToolPathOptions& options) {
  return std::make_unique<PathRecorder>(path, rates, options);
}

}  // namespace isogloss::cli
