#include "events.hpp"

#include <algorithm>
#include <cmath>

#include "product.hpp"

namespace isogloss::properties {

Event::Event(const Motion& m)
    : kind(m.event),
      line(m.line),
      program(m.program),
      machine(m.machine),
      is_led(m.is_led),
      has_feed(m.has_feed),
      has_value(m.has_value),
      feed(m.feed_mm_s),
      value(m.value),
      tool(m.tool),
      term(m.term) {
  if (m.arc == nullptr || !m.arc->has_center) return;
  has_center = true;
  std::copy_n(m.arc->machine_center, 3, center.begin());
  std::copy_n(m.arc->normal, 3, normal.begin());
  sweep = m.arc->sweep_deg;
}

bool Event::moves() const {
  return kind == Motion::Event::rapid || kind == Motion::Event::feed || kind == Motion::Event::arc;
}

Axes Event::goal(Axes at) const {
  for (unsigned axis = 0; axis < 6; ++axis)
    if (machine.has(axis)) at[axis] = machine.at[axis];
  return at;
}

double Event::way(const Axes& at) const {
  const Axes to = goal(at);
  double out = 0;
  for (unsigned axis = 0; axis < 6; ++axis) out = std::max(out, std::abs(to[axis] - at[axis]));
  return out;
}

Events events_of(const std::string& dialect, const std::string& text, const RunOptions& options,
                 const MotionListenerOptions& kept, std::vector<Exporter*> others, DiagnosticSink& sink) {
  Events out;
  const auto listener = make_motion_listener(
      [&](const Motion& motion) {
        out.emplace_back(motion);
        return true;
      },
      kept);
  others.push_back(listener.get());
  const std::unique_ptr<Source> source = memory_source(text);
  run(product::dialect(dialect), *source, "program", options, others, sink);
  return out;
}

}  // namespace isogloss::properties
