#include <catch2/catch.hpp>
#include <stdexcept>
#include <vector>

#include "isogloss/engine/motion.hpp"
#include "test_document.hpp"

using namespace isogloss;

namespace {

/// Keeps what it is told, with the texts that end with the call.
struct Heard {
  struct Event {
    Motion motion;
    MotionArc arc;
    std::string term;
  };
  std::vector<Event> events;
  TestDocument t;
  std::unique_ptr<Exporter> exporter;

  explicit Heard(std::size_t most = 100, MotionListenerOptions options = {}) {
    exporter = make_motion_listener(
        [this, most](const Motion& m) {
          events.push_back({m, m.arc == nullptr ? MotionArc{} : *m.arc, std::string(m.term)});
          return events.size() < most;
        },
        options);
    exporter->begin(t.d, t.symbols);
  }
  template <class Fill>
  bool block(std::uint32_t line, Fill fill) {
    t.block(line);
    fill();
    return exporter->block(t.d, t.symbols);
  }
};

}  // namespace

TEST_CASE("motions as values have ends, starts and feeds in machine and program") {
  Heard h;
  h.t.shift(0, 0, -100);
  CHECK(h.block(7, [&] { h.t.line(true, 30, 20, 5); }));
  CHECK(h.block(8, [&] { h.t.line(false, 30, 20, -10.5, 10); }));
  REQUIRE(h.events.size() == 2);
  const Motion& feed = h.events[1].motion;
  CHECK(feed.event == Motion::Event::feed);
  CHECK(feed.line == 8);
  CHECK(feed.program.known == 7);
  CHECK(feed.program.at[2] == -10.5);
  CHECK(feed.machine.at[2] == -110.5);
  CHECK(feed.machine_start.at[2] == -95);
  CHECK(feed.has_feed);
  CHECK(feed.feed_mm_s == 10);
  CHECK(feed.arc == nullptr);
  CHECK_FALSE(h.events[0].motion.has_feed);
  CHECK_FALSE(h.events[0].motion.machine.has(3));
}

TEST_CASE("an arc as a value has its centre, normal and sweep") {
  Heard h;
  h.t.shift(0, 0, -100);
  h.block(1, [&] { h.t.line(true, 30, 20, 5); });
  h.block(2, [&] { h.t.arc(true, 20, 30, 5, 20, 20, 5); });
  REQUIRE(h.events.size() == 2);
  CHECK(h.events[1].motion.event == Motion::Event::arc);
  REQUIRE(h.events[1].motion.arc != nullptr);
  const MotionArc& arc = h.events[1].arc;
  CHECK(arc.has_center);
  CHECK(arc.is_ccw);
  CHECK(arc.center[0] == 20);
  CHECK(arc.program_start[0] == 30);
  CHECK(arc.machine_center[2] == -95);
  CHECK(arc.normal[2] == 1);
  CHECK(arc.sweep_deg == Approx(90));
}

TEST_CASE("events without a move carry a value or a term") {
  Heard h;
  h.block(1, [&] { h.t.number("Dwell.Time", 0.5); });
  h.block(2, [&] { h.t.name("ProgramEnd.Term", "END"); });
  REQUIRE(h.events.size() == 2);
  CHECK(h.events[0].motion.event == Motion::Event::dwell);
  CHECK(h.events[0].motion.has_value);
  CHECK(h.events[0].motion.value == 0.5);
  CHECK(h.events[1].motion.event == Motion::Event::end);
  CHECK(h.events[1].term == "END");
}

TEST_CASE("a listener that has had enough ends the run after the block") {
  Heard h(2);
  CHECK(h.block(1, [&] { h.t.line(true, 1, 0, 0); }));
  CHECK_FALSE(h.block(2, [&] {
    h.t.line(true, 2, 0, 0);
    h.t.name("ProgramEnd.Term", "END");
  }));
  CHECK(h.events.size() == 2);
}

TEST_CASE("moves that go nowhere are told when they are asked for") {
  for (const bool kept : {false, true}) {
    Heard h(100, {.zero_moves = kept});
    h.block(1, [&] { h.t.line(true, 1, 0, 0); });
    h.block(2, [&] { h.t.line(true, 1, 0, 0); });
    CHECK(h.events.size() == (kept ? 2 : 1));
  }
}

TEST_CASE("what a listener throws comes out") {
  TestDocument t;
  const auto exporter = make_motion_listener([](const Motion&) -> bool { throw std::runtime_error("enough"); });
  exporter->begin(t.d, t.symbols);
  t.block(1);
  t.line(true, 1, 0, 0);
  CHECK_THROWS_AS(exporter->block(t.d, t.symbols), std::runtime_error);
}
