// The canonical program of a run, read as ISO, makes the motions of that run. tests/cli/canonical_test.py holds the
// same of the golden programs, by the command.
#include <algorithm>
#include <cmath>

#include "events.hpp"
#include "isogloss/engine/canonical.hpp"
#include "product.hpp"
#include "property.hpp"
#include "running.hpp"

namespace isogloss::properties {

namespace {

using Kind = Motion::Event;

constexpr double written = 1.0e-6;  // mm and degrees: six decimals, and what adding to a rounded start costs
constexpr double of_arc = 2e-4;     // mm: how far a radius that is right to six decimals moves the centre's height
constexpr double tolerance = 0.001;
constexpr double degrees_per_radian = 57.29577951308232;

Vector place(const Axes& axes) { return {axes[0], axes[1], axes[2]}; }
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool near(const Axes& a, const Axes& b) {
  return std::equal(a.begin(), a.end(), b.begin(), [](double p, double q) { return std::abs(p - q) <= 2 * written; });
}

/// How far from the axis of the arc.
double radius_of(const Event& arc, const Vector& point) {
  const Vector off = minus(point, arc.center);
  const double along = dot(off, arc.normal);
  return std::sqrt(std::max(0.0, dot(off, off) - along * along));
}

/// Where the path may pass its end more than once.
bool turns(const Event& event) { return event.kind == Kind::arc && event.has_center; }

/// Degrees that a straight move covers of the arc.
double angle_of(const Event& arc, const Vector& from, const Vector& to) {
  if (!turns(arc)) return 0;
  const Vector a = minus(from, arc.center), b = minus(to, arc.center), &n = arc.normal;
  const double sine =
      n[0] * (a[1] * b[2] - a[2] * b[1]) + n[1] * (a[2] * b[0] - a[0] * b[2]) + n[2] * (a[0] * b[1] - a[1] * b[0]);
  const double cosine = dot(a, b) - dot(a, n) * dot(b, n);
  return std::abs(std::atan2(sine, cosine)) * degrees_per_radian;
}

/// Takes the events of both runs side by side.
class Comparison {
 public:
  Comparison(Events program, Events canonical) : program_(std::move(program)), canonical_(std::move(canonical)) {}

  /// Where they part; empty: nowhere.
  std::string run() {
    for (const Event& event : program_) {
      if (event.moves())
        move(event);
      else
        other(event);
      if (!fault_.empty()) return fault_;
    }
    for (std::size_t i = next_; i < canonical_.size(); ++i)
      if (!canonical_[i].moves() || canonical_[i].way(read_) > written) return "the canonical program goes on";
    return {};
  }

 private:
  struct Step {
    Axes before;
    const Event* event;
  };

  void fault(const Event& event, const std::string& text) {
    if (fault_.empty()) fault_ = "line " + std::to_string(event.line) + ": " + text;
  }

  /// The next event of the canonical program, without moves that rounding has left; null: its end.
  const Event* take(std::optional<Kind> wanted) {
    while (next_ < canonical_.size()) {
      const Event& event = canonical_[next_++];
      const bool is_rest = (event.kind == Kind::rapid || event.kind == Kind::feed) && wanted != Kind::arc &&
                           event.kind != wanted && event.way(read_) <= written;
      if (!is_rest) return &event;
    }
    return nullptr;
  }

  void other(const Event& event) {
    const Event* const got = take({});
    if (got == nullptr || got->kind != event.kind) return fault(event, "another event reads back");
    const bool stops = event.kind == Kind::spindle && event.term == "STOP";
    const bool same_value =
        stops || !event.has_value || (got->has_value && std::abs(event.value - got->value) <= written);
    if (!same_value || event.tool != got->tool || event.term != got->term) fault(event, "another value reads back");
  }

  void move(const Event& event) {
    const Axes start = original_, goal = event.goal(original_);
    if (event.kind != Kind::arc && event.way(original_) <= written && !near(read_, goal))
      return fault(event, "nothing moves, but the machine stands elsewhere");
    original_ = goal;
    const std::vector<Step> found = steps(event, goal);
    has_moved_ = true;
    if (!fault_.empty()) return;
    if (event.kind == Kind::arc && event.has_center)
      arc(event, start, goal, found);
    else if (!event.is_led && found.size() > 1 && event.kind != Kind::arc)
      fault(event, std::to_string(found.size()) + " moves in place of one");
    for (const Step& step : found)
      if (event.kind == Kind::feed && !event.is_led) feed(event, *step.event);
  }

  /// The moves of the canonical program up to where this one ends.
  std::vector<Step> steps(const Event& event, const Axes& goal) {
    std::vector<Step> out;
    double turned = 0;
    while (true) {
      if (out.empty() && event.kind != Kind::arc && near(goal, read_)) {
        const Event* const ahead = next_ < canonical_.size() ? &canonical_[next_] : nullptr;
        if (ahead == nullptr || ahead->kind != event.kind || ahead->way(read_) > 2 * written) return out;
      }
      const Event* const got = take(event.kind);
      // From where the machine stands before the first block.
      if (got != nullptr && event.kind == Kind::arc && got->kind == Kind::rapid && out.empty() && !has_moved_) {
        read_ = got->goal(read_);
        continue;
      }
      const bool is_line = got != nullptr && (got->kind == Kind::rapid || got->kind == Kind::feed);
      const bool is_allowed = got != nullptr && (got->kind == event.kind || (event.is_led && is_line) ||
                                                 (event.kind == Kind::arc && got->kind == Kind::feed));
      if (!is_allowed) {
        fault(event, "no such move reads back");
        return out;
      }
      out.push_back({read_, got});
      const Vector before = place(read_);
      read_ = got->goal(read_);
      turned += got->kind == Kind::arc ? std::abs(got->sweep) : angle_of(event, before, place(read_));
      if (near(goal, read_) && (!turns(event) || turned > std::abs(event.sweep) - sweep_off(event))) return out;
    }
  }

  void feed(const Event& event, const Event& got) {
    if (!event.has_feed) return;
    if (!got.has_feed || std::abs(event.feed - got.feed) > 1e-6 * std::max(event.feed, 1.0))
      fault(event, "the feed reads back as " + std::to_string(got.feed));
  }

  void arc(const Event& event, const Axes& start, const Axes& goal, const std::vector<Step>& found) {
    const double first = radius_of(event, place(start)), last = radius_of(event, place(goal));
    double swept = 0;
    std::size_t arcs = 0;
    for (const Step& step : found) {
      if (step.event->kind != Kind::arc) continue;
      ++arcs;
      swept += std::abs(step.event->sweep);
      feed(event, *step.event);
      if (step.event->sweep * dot(step.event->normal, event.normal) * event.sweep <= 0)
        fault(event, "the sense of the arc is another");
      const Vector off = minus(step.event->center, event.center);
      const double along = dot(off, event.normal);
      if (std::sqrt(std::max(0.0, dot(off, off) - along * along)) > of_arc) fault(event, "the centre is another");
    }
    const double main_axis =
        std::max({std::abs(event.normal[0]), std::abs(event.normal[1]), std::abs(event.normal[2])});
    if (main_axis > 1 - 1e-12 && std::abs(first - last) < 4e-4 && std::abs(event.sweep) > 1 && arcs == 0)
      return fault(event, "an arc in a plane of two axes reads back as lines");
    if (arcs != 0 && std::abs(swept - std::abs(event.sweep)) > sweep_off(event))
      fault(event, "the sweep reads back as " + std::to_string(swept));
    if (arcs == 0) lines(event, first, last, found);
  }

  /// How far the sweep may be off, in degrees: of a small arc, six decimals are a large part.
  double sweep_off(const Event& event) const {
    return 0.01 + degrees_per_radian * 4 * written / std::max(radius_of(event, place(original_)), 1e-6);
  }

  /// Ends lie on the arc, and middles within the tolerance.
  void lines(const Event& event, double first, double last, const std::vector<Step>& found) {
    for (const Step& step : found) {
      const Vector a = place(step.before), b = place(step.event->goal(step.before));
      const Vector middle{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
      for (const auto& [point, off] : {std::pair{b, 2e-6}, std::pair{middle, tolerance + 2e-6}}) {
        const double radius = radius_of(event, point);
        if (radius < std::min(first, last) - off - 1e-5 || radius > std::max(first, last) + off + 1e-5)
          return fault(event, "a line in place of the arc leaves it");
      }
    }
  }

  Events program_, canonical_;
  Axes original_{}, read_{};
  std::size_t next_ = 0;
  bool has_moved_ = false;
  std::string fault_;
};

const ProgramText& words_of_iso() {
  static const ProgramText words = [] {
    DiagnosticList unheard;
    Chain chain(product::dialect("iso"), {}, unheard);
    return ProgramText::of(chain);
  }();
  return words;
}

}  // namespace

Verdict judge_canonical(const Case& program) {
  product::TextOutput canonical;
  DiagnosticList said, of_words, of_reading;
  const auto exporter = make_canonical_exporter(canonical, words_of_iso(), {}, of_words);
  Events events = events_of(program.dialect, program.text(), options_of(program), {}, {exporter.get()}, said);
  const auto is_end = [](const Event& e) { return e.kind == Kind::end; };
  std::erase_if(events, is_end);
  // An arc under unequal scales is no circle in the machine, so no program can say it.
  const auto is_no_circle = [](const Diagnostic& d) { return d.code == "SIE-0225" || d.code == "SIE-0245"; };
  if (events.empty() || std::any_of(said.all.begin(), said.all.end(), is_no_circle)) return {};
  RunOptions reading;
  // The canonical program writes where a rotary axis stands: 370 is another place than 10.
  for (const char* const axis : {"A", "B", "C"})
    reading.chain.assignments.emplace_back(std::string("MachineAxes.") + axis + ".Rollover", "0");
  Events back = events_of("iso", canonical.text, reading, {}, {}, of_reading);
  std::erase_if(back, is_end);
  // What the words of ISO cannot say was reported: a coolant without a code, a speed that is not known.
  for (const Diagnostic& d : of_words.all) {
    const bool is_coolant = d.code == "IG-0193" && d.message.find("coolant") != std::string::npos;
    if (!is_coolant && d.code != "IG-0623") continue;
    for (Events* const list : {&events, &back})
      std::erase_if(*list, [&](const Event& e) { return e.kind == (is_coolant ? Kind::coolant : Kind::spindle); });
  }
  std::string fault = Comparison(std::move(events), std::move(back)).run();
  if (!fault.empty()) fault += "\nthe canonical program:\n" + canonical.text;
  return {true, fault};
}

}  // namespace isogloss::properties
