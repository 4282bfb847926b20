// The totals of a run: lengths, extents, times. Everything in machine space, arcs by their true length and bulge; but
// a feed that leads the tip while rotary axes turn has the length of the tip's path, and is slowed down where an axis
// would exceed its rapid rate.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "export/led_move.hpp"
#include "export/motion_reader.hpp"
#include "isogloss/engine/chain.hpp"
#include "isogloss/engine/exporter.hpp"

namespace isogloss {

namespace {

/// A circular or helical path: center + r·cos φ + q·sin φ + rise·φ/sweep, φ from 0 to sweep (radians, about the
/// normal).
struct Helix {
  double center[3], r[3], q[3], rise[3];
  double sweep;

  Helix(const double* start, const double* end, const double* middle, const double* normal, double degrees)
      : sweep(degrees * std::numbers::pi / 180) {
    double height_of_start = 0, height = 0;
    for (int i = 0; i < 3; ++i) {
      height_of_start += (start[i] - middle[i]) * normal[i];
      height += (end[i] - start[i]) * normal[i];
    }
    for (int i = 0; i < 3; ++i) {
      center[i] = middle[i] + height_of_start * normal[i];
      r[i] = start[i] - center[i];
      rise[i] = height * normal[i];
    }
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      q[i] = normal[j] * r[k] - normal[k] * r[j];
    }
  }

  double at(int axis, double angle) const {
    return center[axis] + r[axis] * std::cos(angle) + q[axis] * std::sin(angle) + rise[axis] * angle / sweep;
  }

  double length(const double* end) const {
    double start_radius = 0, end_radius = 0, height = 0;
    for (int i = 0; i < 3; ++i) {
      const double out = end[i] - rise[i] - center[i];
      start_radius += r[i] * r[i];
      end_radius += out * out;
      height += rise[i] * rise[i];
    }
    const double arc = (std::sqrt(start_radius) + std::sqrt(end_radius)) / 2 * sweep;
    return std::sqrt(arc * arc + height);
  }

  /// Calls visit(position) for the turning points of one axis between start and end.
  template <class Visit>
  void turning_points(int axis, Visit visit) const {
    const double radius = std::sqrt(r[axis] * r[axis] + q[axis] * q[axis]);
    if (sweep == 0 || radius <= std::abs(rise[axis] / sweep)) return;
    // q·cos φ - r·sin φ + rise/sweep = 0, as radius·cos(φ + shift) = -rise/sweep
    const double shift = std::atan2(r[axis], q[axis]);
    const double half = std::acos(-rise[axis] / sweep / radius);
    const double low = std::min(0.0, sweep), high = std::max(0.0, sweep);
    constexpr double turn = 2 * std::numbers::pi;
    for (const double root : {half - shift, -half - shift}) {
      // Turn after turn they shift by the same amount: the first and the last tell.
      const double first = root + turn * std::ceil((low - root) / turn);
      const double last = root + turn * std::floor((high - root) / turn);
      if (first > high) continue;
      visit(at(axis, first));
      visit(at(axis, last));
    }
  }
};

class SummaryExporter : public Exporter {
 public:
  SummaryExporter(Summary& summary, const RapidRates& rates) : reader_(false), s_(summary), rates_(rates) {}

  void begin(Document& initial, const SymbolTable& symbols) override {
    reader_.begin(initial, symbols);
    const auto* const service =
        initial.chain == nullptr ? nullptr : initial.chain->service("isogloss.machine-kinematics/1");
    kinematics_ = static_cast<const ig_machine_kinematics_1*>(service);
    tool_length_ = initial.layout().id("ToolHeightCompensation.Offset_mm");
    lever_ = initial.layout().id("PivotTransform.Lever_mm");
  }
  bool block(Document& document, const SymbolTable& symbols) override {
    ++s_.blocks;
    document_ = &document;
    reader_.read(document, symbols, *this);
    return true;
  }
  bool end() override { return true; }

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

  void move(const Move& m) {
    ++s_.events;
    s_.axes |= m.machine.known;
    add_turns(m);
    switch (m.kind) {
      case Move::Kind::rapid:
        ++s_.rapids;
        s_.rapid_length_mm += straight(m, 0, 3);
        add_rapid_time(m);
        break;
      case Move::Kind::feed: {
        ++s_.feeds;
        const double length = m.is_led ? way_of_tip(m) : straight(m, 0, 3);
        s_.feed_length_mm += length;
        // A feed that turns rotary axes alone is in degrees a second.
        add_feed_time(m, length > 0 ? length : straight(m, 3, 6));
        reach_start(m);
        break;
      }
      case Move::Kind::arc:
        ++s_.arcs;
        arc(m);
        break;
    }
    reach(m);
  }

 private:
  static double straight(const Move& m, unsigned first, unsigned last) {
    double sum = 0;
    for (unsigned i = first; i < last; ++i)
      if (m.from.has(i) && m.machine.has(i)) sum += (m.machine.at[i] - m.from.at[i]) * (m.machine.at[i] - m.from.at[i]);
    return std::sqrt(sum);
  }

  /// Under tip control the feed is that of the tip in the workpiece; the machine's axes take another path.
  static double way_of_tip(const Move& m) {
    constexpr double rests_mm = 1e-7;  // shorter lengths come from a frame there and back
    if (!m.start.has_xyz() || !m.program.has_xyz()) return straight(m, 0, 3);
    double sum = 0;
    for (unsigned i = 0; i < 3; ++i) sum += (m.program.at[i] - m.start.at[i]) * (m.program.at[i] - m.start.at[i]);
    return sum > rests_mm * rests_mm ? std::sqrt(sum) : 0;
  }

  void add_turns(const Move& m) {
    if ((m.machine.known & m.from.known) >> 3 == 0) return;
    for (unsigned i = 3; i < 6; ++i)
      if (m.from.has(i) && m.machine.has(i)) s_.turned_deg[i - 3] += std::abs(m.machine.at[i] - m.from.at[i]);
  }

  /// The time of the slowest axis at its rapid rate: nothing moves faster. This limits a feed too, where a table must
  /// swing round while the tip moves a short distance.
  double least_seconds(const Move& m) const {
    double longest = 0;
    for (unsigned i = 0; i < 6; ++i)
      if (m.from.has(i) && m.machine.has(i) && rates_.per_second[i] > 0)
        longest = std::max(longest, std::abs(m.machine.at[i] - m.from.at[i]) / rates_.per_second[i]);
    return longest;
  }

  void add_rapid_time(const Move& m) {
    for (unsigned i = 0; i < 6; ++i)
      if (m.from.has(i) && m.machine.has(i) && m.machine.at[i] != m.from.at[i] && !(rates_.per_second[i] > 0))
        s_.rapid_time_known = false;
    s_.rapid_seconds += time_of(m, 0);
  }

  /// For a move whose feed alone would take this long; 0: a rapid move.
  double time_of(const Move& m, double feed_seconds) {
    double least = least_seconds(m);
    bool is_slowed = least > feed_seconds * (1 + 1e-9);
    double seconds = std::max(least, feed_seconds);
    if (m.is_led && kinematics_ != nullptr) {
      const LedMove::Time led = LedMove(*kinematics_, m, led_length()).time(feed_seconds, rates_.per_second);
      if (led.is_known) {
        is_slowed = led.is_slowed;
        seconds = std::max(seconds, led.seconds);
      }
    }
    if (is_slowed && feed_seconds > 0) ++s_.slowed_feeds;
    return seconds;
  }
  /// From the gauge point to the point of the tool's axis that is led.
  double led_length() const {
    double length = 0;
    for (const ig_field f : {tool_length_, lever_})
      if (f != IG_NO_FIELD && document_->present(f)) length += document_->number(f);
    return length;
  }

  void add_feed_time(const Move& m, double length) {
    if (length == 0) return;
    if (m.has_feed && m.feed_mmds > 0)
      s_.feed_seconds += time_of(m, length / m.feed_mmds);
    else
      s_.feed_time_known = false;
  }

  void arc(const Move& m) {
    reach_start(m);
    const Arc& a = m.arc;
    if (!a.has_center || !m.from.has_xyz() || !m.machine.has_xyz()) {
      const double length = straight(m, 0, 3);
      s_.feed_length_mm += length;
      add_feed_time(m, length);
      return;
    }
    const Helix way(m.from.at, m.machine.at, a.machine_center, a.normal, sweep_deg(m));
    const double length = way.length(m.machine.at);
    s_.feed_length_mm += length;
    add_feed_time(m, length);
    for (int i = 0; i < 3; ++i)
      way.turning_points(i, [&](double at) { widen(machine_known_, i, at, s_.minimum, s_.maximum); });
    if (!m.program.has_xyz()) return;
    double normal[3] = {0, 0, 0};
    normal[a.plane == "YZ" ? 0 : a.plane == "ZX" ? 1 : 2] = 1;
    const Helix programmed(a.start, m.program.at, a.center, normal, sweep_deg(m));
    for (int i = 0; i < 3; ++i)
      programmed.turning_points(
          i, [&](double at) { widen(program_known_, i, at, s_.program_minimum, s_.program_maximum); });
  }

  /// The start of a cut is included; the start of a rapid move is not (the first one starts at home).
  void reach_start(const Move& m) {
    for (int i = 0; i < 6; ++i)
      if (m.from.has(static_cast<unsigned>(i)) && m.machine.has(static_cast<unsigned>(i)))
        widen(machine_known_, i, m.from.at[i], s_.minimum, s_.maximum);
  }
  void reach(const Move& m) {
    s_.any_motion = true;
    for (int i = 0; i < 6; ++i)
      if (m.machine.has(static_cast<unsigned>(i))) widen(machine_known_, i, m.machine.at[i], s_.minimum, s_.maximum);
    for (int i = 0; i < 3; ++i)
      if (m.program.has(static_cast<unsigned>(i)))
        widen(program_known_, i, m.program.at[i], s_.program_minimum, s_.program_maximum);
  }
  static void widen(std::uint32_t& known, int axis, double at, double* minimum, double* maximum) {
    const bool is_first = (known >> axis & 1u) == 0;
    known |= 1u << axis;
    minimum[axis] = is_first ? at : std::min(minimum[axis], at);
    maximum[axis] = is_first ? at : std::max(maximum[axis], at);
  }

  MotionReader reader_;
  Summary& s_;
  RapidRates rates_;
  const ig_machine_kinematics_1* kinematics_ = nullptr;
  const Document* document_ = nullptr;
  ig_field tool_length_ = IG_NO_FIELD, lever_ = IG_NO_FIELD;
  std::uint32_t machine_known_ = 0, program_known_ = 0;
};

}  // namespace

std::unique_ptr<Exporter> make_summary_exporter(Summary& summary, const RapidRates& rates) {
  return std::make_unique<SummaryExporter>(summary, rates);
}

}  // namespace isogloss
