/// The events of a run, kept.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "running.hpp"

namespace isogloss::properties {

using Vector = std::array<double, 3>;
using Axes = std::array<double, 6>;

struct Event {
  explicit Event(const Motion& m);
  bool moves() const;
  /// Where the axes stand behind it.
  Axes goal(Axes at) const;
  /// The longest way of an axis.
  double way(const Axes& at) const;

  Motion::Event kind;
  std::uint32_t line;
  MotionPoint program, machine;
  bool is_led, has_feed, has_value;
  double feed, value;
  std::int64_t tool;
  std::string term;
  bool has_center = false;  ///< of an arc
  Vector center{}, normal{};
  double sweep = 0;
};

using Events = std::vector<Event>;

Events events_of(const std::string& dialect, const std::string& text, const RunOptions& options,
                 const MotionListenerOptions& kept, std::vector<Exporter*> others, DiagnosticSink& sink);

}  // namespace isogloss::properties
