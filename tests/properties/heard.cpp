#include "heard.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace isogloss::properties {

namespace {

bool is_close(double a, double b) { return std::abs(a - b) <= 1e-6 * std::max({1.0, std::abs(a), std::abs(b)}); }

bool is_close(const MotionPoint& a, const MotionPoint& b) {
  for (unsigned axis = 0; axis < 6; ++axis)
    if (a.has(axis) != b.has(axis) || (a.has(axis) && !is_close(a.at[axis], b.at[axis]))) return false;
  return true;
}

std::string difference_of(const Event& one, const Event& other, bool compares_feed) {
  if (one.kind != other.kind || one.line != other.line) return "another event";
  if (!is_close(one.machine, other.machine)) return "another place of the machine";
  if (!is_close(one.program, other.program)) return "another place of the program";
  if (one.has_feed != other.has_feed) return "a feed in one run alone";
  if (one.has_feed && compares_feed && !is_close(one.feed, other.feed)) return "another feed";
  if (one.has_value != other.has_value || (one.has_value && !is_close(one.value, other.value))) return "another value";
  if (one.tool != other.tool || one.term != other.term) return "another tool or term";
  if (one.has_center != other.has_center) return "a circle in one run alone";
  for (std::size_t i = 0; one.has_center && i < 3; ++i)
    if (!is_close(one.center[i], other.center[i])) return "another centre";
  return is_close(one.sweep, other.sweep) ? "" : "another sweep";
}

/// The lines in which a rotary axis turns, or has a place for the first time: F of all their moves counts degrees.
std::set<std::uint32_t> turning_lines(const Events& events) {
  std::set<std::uint32_t> out;
  Axes at{};
  std::set<unsigned> known;
  for (const Event& event : events) {
    const Axes to = event.goal(at);
    bool turns = !std::equal(at.begin() + 3, at.end(), to.begin() + 3);
    for (unsigned axis = 3; axis < 6; ++axis) turns |= event.machine.has(axis) && known.insert(axis).second;
    if (turns) out.insert(event.line);
    at = to;
  }
  return out;
}

bool moves_xyz(const Event& event, const Axes& from, const Axes& to) {
  return event.kind == Motion::Event::arc || !std::equal(from.begin(), from.begin() + 3, to.begin());
}

using CodesOfLines = std::multiset<std::pair<std::uint32_t, std::string>>;

CodesOfLines codes_of(const DiagnosticList& said) {
  CodesOfLines out;
  for (const Diagnostic& d : said.all) out.emplace(d.where.line, d.code);
  return out;
}

std::string only_in(const CodesOfLines& some, const CodesOfLines& others, const std::string& run) {
  std::string out;
  for (const auto& one : some)
    if (some.count(one) != others.count(one))
      out += "  only " + run + ": " + one.second + " at line " + std::to_string(one.first) + "\n";
  return out;
}

}  // namespace

Heard heard(const Case& program, const std::string& text) {
  Heard out;
  out.events = events_of(program.dialect, text, options_of(program), {}, {}, out.said);
  return out;
}

std::string difference_of(const Heard& one, const Heard& other, const std::string& first, const std::string& second,
                          RotaryFeeds feeds) {
  std::string out;
  const std::set<std::uint32_t> turning = turning_lines(one.events);
  Axes at{};
  for (std::size_t i = 0; i < std::min(one.events.size(), other.events.size()) && out.empty(); ++i) {
    const Event& event = one.events[i];
    const Axes to = event.goal(at);
    const bool compares_feed =
        feeds == RotaryFeeds::compared || (!turning.contains(event.line) && moves_xyz(event, at, to));
    const std::string what = difference_of(event, other.events[i], compares_feed);
    if (!what.empty()) out = "line " + std::to_string(event.line) + ": " + what + "\n";
    at = to;
  }
  if (out.empty() && one.events.size() != other.events.size())
    out = std::to_string(one.events.size()) + " events " + first + ", " + std::to_string(other.events.size()) + " " +
          second + "\n";
  const CodesOfLines of_one = codes_of(one.said), of_other = codes_of(other.said);
  return out + only_in(of_one, of_other, first) + only_in(of_other, of_one, second);
}

}  // namespace isogloss::properties
