// The call of a cycle for holes, and the parameters that most of these cycles share.
#include "cycles/hole_cycle.hpp"

#include <algorithm>

namespace heidenhain {

using namespace ig::cnc;

std::optional<HoleCycle::Call> HoleCycle::called(ig::Block& b) const {
  std::optional<Call> found;
  const bool is_called = b.has(call_);
  const ig::PartialVec3 named = b.get(words_);
  if (b.is_raised(done_) || (!is_called && (!b.has(modal_call_) || named.mask == 0))) return found;
  const std::int64_t number = b.get_or(number_, std::int64_t{0});
  const auto cycle = std::find_if(cycles_.begin(), cycles_.end(), [&](const Term& t) { return t.number == number; });
  if (cycle == cycles_.end() || b.find(others_)) return found;
  if (number < 100 && pattern_.is_set(b)) return found;  // a pattern calls cycles with numbers from 200
  b.raise(done_);
  Call& call = found.emplace();
  call.term = cycle->term;
  call.named = named;
  HoleRun& c = call.hole;
  c.number = number;
  c.plane = plane_(b);
  c.hole = last_(b);
  c.offset = b.has(at_position_) ? named.value[c.plane.tool] * (named.has(c.plane.tool) ? 1 : 0) : 0;
  call.points = pattern_(b, c.plane);
  c.level = named.or_else(c.hole)[c.plane.tool];
  return found;
}

bool HoleCycle::begin_steps(ig::Block& b, const Call& call, double steps_of_hole) const {
  if (call.points.count == 0) {
    b.report(ig::diag("HEI-0183"), ig::Where::block());
    return false;
  }
  if (!(steps_of_hole * static_cast<double>(call.points.count) <= most_steps)) {
    b.report(ig::diag("HEI-0177"), ig::Where::block(), static_cast<double>(call.hole.number), most_steps);
    return false;
  }
  b.take(words_);
  motion.begin(b, call.term);
  return true;
}

std::optional<double> HoleCycle::get(const ig::Block& b, std::uint32_t q) const {
  const auto of_pattern = pattern_.get(b, q);
  return of_pattern ? of_pattern : definition_.get(b, q);
}

std::optional<double> HoleCycle::needed(ig::Block& b, const HoleRun& c, std::uint32_t q) const {
  const auto value = get(b, q);
  if (!value)
    b.report(ig::diag("HEI-0163"), ig::Where::block(), static_cast<double>(c.number), CycleDefinition::name(q));
  return value;
}

double HoleCycle::feed(ig::Block& b, const HoleRun& c, std::uint32_t q) const {
  const auto value = needed(b, c, q);
  if (!value) return 0;
  const double mmds = in_mmds(b, *value);
  if (mmds > 0) return mmds;
  b.report(ig::diag("HEI-0166"), ig::Where::block(), static_cast<double>(c.number), CycleDefinition::name(q), *value);
  return 0;
}

double HoleCycle::in_mmds(const ig::Block& b, double feed) const {
  return b.is(feed_mode_, g95_) ? feed * speed(b) / 60 : feed / 60;
}

bool HoleCycle::drills(ig::Block& b, HoleRun& c) const {
  const auto depth = needed(b, c, 201);
  return depth && levels(b, c, *depth) && feeds(b, c);
}

bool HoleCycle::levels(ig::Block& b, HoleRun& c, double depth) const {
  if (depth == 0) {
    b.report(ig::diag("HEI-0164"), ig::Where::block(), static_cast<double>(c.number));
    return false;
  }
  if (depth > 0) b.report(ig::diag("HEI-0165"), ig::Where::block(), static_cast<double>(c.number));
  const double out = depth > 0 ? -1 : 1;
  c.safe = c.surface + out * c.clearance;
  c.bottom = c.surface + depth;
  const double second = get_or(b, 204, 0);
  c.end = second > c.clearance ? c.surface + out * second : c.safe;
  return true;
}

bool HoleCycle::feeds(ig::Block& b, HoleRun& c) const {
  c.feed = feed(b, c, 206);
  const double retract = get_or(b, 208, 0);
  c.retract = retract >= fmax_feed ? 0 : retract > 0 ? in_mmds(b, retract) : c.feed;
  c.dwell = get_or(b, 211, 0);
  return c.feed > 0;
}

PeckStrokes HoleCycle::shrinking_strokes(const ig::Block& b, const HoleRun& c, double infeed) const {
  const double less = std::fabs(get_or(b, 212, 0));
  if (less == 0) return {c.surface, c.bottom, infeed};
  const double least = std::fabs(get_or(b, 205, 0));
  // Without a least infeed, the last positive infeed is repeated.
  const double floor = least > 0 ? std::fmin(least, infeed) : infeed - less * std::floor((infeed - 1e-9) / less);
  return {c.surface, c.bottom, infeed, less, floor > 0 ? floor : infeed};
}

bool HoleCycle::find_surface(ig::Block& b, HoleRun& c) const {
  const auto clearance = needed(b, c, 200);
  if (!clearance) return false;
  c.clearance = std::fabs(*clearance);
  c.surface = get_or(b, 203, 0) + c.offset;
  return true;
}

}  // namespace heidenhain
