// The totals of a run: lengths, extents, times. Everything in machine space, arcs by their true length and bulge; but
// a feed that leads the tip while rotary axes turn has the length of the tip's path, and is slowed down where an axis
// would exceed its rapid rate.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "export/helix.hpp"
#include "export/motion_reader.hpp"
#include "export/move_time.hpp"
#include "isogloss/engine/exporter.hpp"

namespace isogloss {

namespace {

class SummaryExporter : public Exporter {
 public:
  SummaryExporter(Summary& summary, const RapidRates& rates) : reader_(false), s_(summary), timer_(rates) {}

  void begin(Document& initial, const SymbolTable& symbols) override {
    reader_.begin(initial, symbols);
    timer_.begin(initial);
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
        s_.rapid_length_mm += straight_length(m, 0, 3);
        add_rapid_time(m);
        break;
      case Move::Kind::feed: {
        ++s_.feeds;
        const double length = line_length(m);
        s_.feed_length_mm += length;
        add_feed_time(m, length > 0 ? length : straight_length(m, 3, 6));
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
  void add_turns(const Move& m) {
    if ((m.machine.known & m.from.known) >> 3 == 0) return;
    for (unsigned i = 3; i < 6; ++i)
      if (m.from.has(i) && m.machine.has(i)) s_.turned_deg[i - 3] += std::abs(m.machine.at[i] - m.from.at[i]);
  }

  void add_rapid_time(const Move& m) {
    const MoveTime time = timer_.rapid(m, *document_);
    s_.rapid_time_known = s_.rapid_time_known && time.is_known;
    s_.rapid_seconds += time.seconds;
  }
  void add_feed_time(const Move& m, double length) {
    const MoveTime time = timer_.feed(m, length, *document_);
    s_.feed_time_known = s_.feed_time_known && time.is_known;
    s_.feed_seconds += time.seconds;
    if (time.is_slowed) ++s_.slowed_feeds;
  }

  void arc(const Move& m) {
    reach_start(m);
    const Arc& a = m.arc;
    if (!a.has_center || !m.from.has_xyz() || !m.machine.has_xyz()) {
      const double length = straight_length(m, 0, 3);
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
  MoveTimer timer_;
  const Document* document_ = nullptr;
  std::uint32_t machine_known_ = 0, program_known_ = 0;
};

}  // namespace

RapidRates rapid_rates(const Chain& chain) {
  RapidRates rates;
  const auto* const axes = static_cast<const ig_machine_axis_1*>(chain.service("isogloss.machine-axis/1"));
  if (axes == nullptr) return rates;
  for (std::size_t i = 0; i < std::size(rates.per_second); ++i)
    if (axes->rapid_rate(axes->self, "XYZABC"[i], &rates.per_second[i]) == 0) rates.per_second[i] = 0;
  return rates;
}

std::unique_ptr<Exporter> make_summary_exporter(Summary& summary, const RapidRates& rates) {
  return std::make_unique<SummaryExporter>(summary, rates);
}

}  // namespace isogloss
