#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "test_document.hpp"

using namespace isogloss;

namespace {

constexpr double pi = 3.14159265358979323846;

/// Runs blocks, each filled by one function; the first fills the initial state.
Summary summarize(const std::vector<std::function<void(TestDocument&)>>& blocks, const RapidRates& rates = {}) {
  TestDocument t;
  Summary s;
  const auto e = make_summary_exporter(s, rates);
  blocks.front()(t);
  e->begin(t.d, t.symbols);
  for (std::size_t i = 1; i < blocks.size(); ++i) {
    t.block(static_cast<std::uint32_t>(i));
    blocks[i](t);
    CHECK(e->block(t.d, t.symbols));
  }
  CHECK(e->end());
  return s;
}

}  // namespace

TEST_CASE("counts, lengths and times of straight moves") {
  const Summary s = summarize({
                                  [](TestDocument& t) { t.place(0, 0, 0); },
                                  [](TestDocument& t) { t.line(true, 30, 40, 0); },        // 50 mm; X 3 s, Y 2 s
                                  [](TestDocument& t) { t.line(false, 30, 40, -10, 5); },  // 2 s
                                  [](TestDocument& t) { t.number("Dwell.Time", 0.75); },
                                  [](TestDocument& t) { t.line(false, 30, 40, -10, 5); },  // nowhere
                                  [](TestDocument& t) {
                                    t.integer("ToolChange.ToolId", 2);
                                    t.integer("ToolChange.IsChange", 1);
                                  },
                                  [](TestDocument&) {},
                              },
                              {{10, 20, 20, 0, 0, 0}});
  CHECK(s.blocks == 6);
  CHECK(s.events == 4);
  CHECK(s.rapids == 1);
  CHECK(s.feeds == 1);
  CHECK(s.arcs == 0);
  CHECK(s.tool_changes == 1);
  CHECK(s.rapid_length_mm == Approx(50));
  CHECK(s.feed_length_mm == Approx(10));
  CHECK(s.rapid_seconds == Approx(3));
  CHECK(s.feed_seconds == Approx(2));
  CHECK(s.dwell_seconds == 0.75);
  CHECK(s.rapid_time_known);
  CHECK(s.feed_time_known);
  CHECK(s.any_motion);
  CHECK(s.axes == 7);
}

TEST_CASE("a missing feed or rate makes the time unknown") {
  const auto at_zero = [](TestDocument& t) { t.place(0, 0, 0); };
  CHECK_FALSE(summarize({at_zero, [](TestDocument& t) { t.line(false, 1, 0, 0); }}).feed_time_known);
  CHECK_FALSE(summarize({at_zero, [](TestDocument& t) { t.line(true, 1, 0, 0); }}).rapid_time_known);
  const Summary still = summarize({at_zero, [](TestDocument& t) { t.number("Dwell.Time", 1); }});
  CHECK(still.rapid_time_known);
  CHECK(still.feed_time_known);
  CHECK_FALSE(still.any_motion);
}

TEST_CASE("a feed that only turns a rotary axis is in degrees a second") {
  const Summary s = summarize({[](TestDocument& t) {
                                 t.place(0, 0, 0);
                                 t.number("MachineCoordinate.B", 0);
                               },
                               [](TestDocument& t) {
                                 t.line(false, 0, 0, 0, 30);
                                 t.number("MachineCoordinate.B", 90);
                               }});
  CHECK(s.feed_length_mm == 0);
  CHECK(s.feed_seconds == Approx(3));
  CHECK(s.maximum[4] == 90);
  CHECK(s.axes == 0b10111);
}

TEST_CASE("under tip control a feed has the length and the time of the tip's way") {
  const auto led = [](double x, double machine_x, double b) {
    return [=](TestDocument& t) {
      t.point("ProgramXyz", x, 0, 0);
      t.point("MachineCoordinate", machine_x, 0, 40);
      t.number("MachineCoordinate.B", b);
      t.name("MotionEvent.Form", "ClLinear");
      t.number("MotionEvent.Feedrate_mmds", 5);
    };
  };
  const Summary s = summarize({[](TestDocument& t) {
                                 t.place(50, 0, 0);
                                 t.number("MachineCoordinate.B", 0);
                               },
                               [](TestDocument& t) { t.line(true, 0, 0, 0); }, led(10, 300, 30),  // 10 mm of the tip
                               led(10, -500, 90)});  // the tip rests: 60 degrees
  CHECK(s.feed_length_mm == Approx(10));
  CHECK(s.feed_seconds == Approx(10 / 5.0 + 60 / 5.0));
  CHECK(s.feed_time_known);
  CHECK(s.minimum[0] == -500);
  CHECK(s.maximum[0] == 300);
}

TEST_CASE("a feed takes at least the time of its slowest axis") {
  const Summary s = summarize({[](TestDocument& t) {
                                 t.place(0, 0, 0);
                                 t.number("MachineCoordinate.C", 0);
                               },
                               [](TestDocument& t) { t.line(true, 0, 0, 0); },
                               [](TestDocument& t) {  // 1 mm of the tip, near the pole of table C
                                 t.point("ProgramXyz", 1, 0, 0);
                                 t.point("MachineCoordinate", 1, 0, 0);
                                 t.number("MachineCoordinate.C", 180);
                                 t.name("MotionEvent.Form", "ClLinear");
                                 t.number("MotionEvent.Feedrate_mmds", 10);
                               },
                               [](TestDocument& t) { t.line(false, 21, 0, 0, 10); }},
                              {{100, 100, 100, 0, 0, 90}});
  CHECK(s.feed_seconds == Approx(2 + 2));
}

TEST_CASE("rotary axes: the slowest axis makes the time of a rapid, turns there and back add up") {
  const auto turn = [](double b, double c, double x = 0) {
    return [=](TestDocument& t) {
      t.line(true, x, 0, 0);
      t.number("MachineCoordinate.B", b);
      t.number("MachineCoordinate.C", c);
    };
  };
  const auto start = [](TestDocument& t) {
    t.place(0, 0, 0);
    t.number("MachineCoordinate.B", 0);
    t.number("MachineCoordinate.C", 0);
  };
  const RapidRates rates{{100, 100, 100, 0, 30, 45}};
  const Summary s = summarize({start, turn(30, 450, 50), turn(-30, 450, 50), turn(-30, 450, 50)}, rates);
  CHECK(s.rapids == 2);  // the last one goes nowhere; one that only turns does not
  CHECK(s.rapid_length_mm == 50);
  CHECK(s.rapid_seconds == Approx(10 + 2));
  CHECK(s.turned_deg[0] == 0);
  CHECK(s.turned_deg[1] == 90);
  CHECK(s.turned_deg[2] == 450);
  CHECK(s.maximum[5] == 450);
  const Summary unknown = summarize({start, turn(0, 90)}, {{100, 100, 100, 0, 30, 0}});
  CHECK_FALSE(unknown.rapid_time_known);
}

TEST_CASE("the way from home counts as rapid length, home itself not as reached") {
  const Summary s =
      summarize({[](TestDocument& t) { t.place(-500, 0, 0); }, [](TestDocument& t) { t.line(true, -10, 0, 0); }});
  CHECK(s.rapid_length_mm == Approx(490));
  CHECK(s.minimum[0] == -10);
}

TEST_CASE("a cut from where no move has led counts its start, in each run") {
  TestDocument t;
  Summary s;
  const auto e = make_summary_exporter(s, {});
  const auto run = [&](double home, std::initializer_list<bool> rapids) {
    t.block(0);
    t.place(home, 0, 0);
    e->begin(t.d, t.symbols);
    double x = 10;
    for (const bool is_rapid : rapids) {
      t.block(1);
      t.line(is_rapid, x++, 0, 0, 5);
      CHECK(e->block(t.d, t.symbols));
    }
  };
  run(90, {true, false});
  CHECK(s.maximum[0] == 11);
  run(-20, {false});
  CHECK(s.minimum[0] == -20);
  run(-30, {true, false});
  CHECK(s.minimum[0] == -20);
  CHECK(s.maximum[0] == 11);
}

TEST_CASE("an arc has its length and its bulge") {
  // Counter-clockwise from 0 to 270 degrees about (100, 0): it passes the top and the left.
  const Summary s = summarize({[](TestDocument& t) {
                                 t.shift(1000, 0, 0);
                                 t.place(110, 0, 5);
                               },
                               [](TestDocument& t) { t.arc(true, 100, -10, 5, 100, 0, 5, 4); }});
  CHECK(s.arcs == 1);
  CHECK(s.feed_length_mm == Approx(15 * pi));
  CHECK(s.feed_seconds == Approx(15 * pi / 4));
  CHECK(s.minimum[0] == Approx(1090));
  CHECK(s.maximum[0] == Approx(1110));
  CHECK(s.minimum[1] == Approx(-10));
  CHECK(s.maximum[1] == Approx(10));
  CHECK(s.minimum[2] == Approx(5));
  CHECK(s.maximum[2] == Approx(5));
  CHECK(s.program_minimum[0] == Approx(90));
  CHECK(s.program_maximum[1] == Approx(10));
}

TEST_CASE("a short arc has no more than its ends, a clockwise one bulges on the other side") {
  const auto start = [](TestDocument& t) { t.place(std::cos(0.2), std::sin(0.2), 0); };
  const auto to = [](double angle, bool is_ccw) {
    return [=](TestDocument& t) { t.arc(is_ccw, std::cos(angle), std::sin(angle), 0, 0, 0, 0); };
  };
  const Summary brief = summarize({start, to(1.2, true)});
  CHECK(brief.maximum[0] == Approx(std::cos(0.2)));
  CHECK(brief.maximum[1] == Approx(std::sin(1.2)));
  CHECK(brief.minimum[0] == Approx(std::cos(1.2)));
  const Summary wide = summarize({start, to(-0.2, false)});
  CHECK(wide.maximum[0] == Approx(1));
  CHECK(wide.feed_length_mm == Approx(0.4));
}

TEST_CASE("a helix of several turns") {
  const Summary s = summarize({[](TestDocument& t) { t.place(3, 0, 10); },
                               [](TestDocument& t) {
                                 t.arc(false, 3, 0, -5, 0, 0, 10);
                                 t.integer("MotionEvent.AdditionalCircleNum", 2);
                               }});
  const double around = 3 * 2 * pi * 3;
  CHECK(s.feed_length_mm == Approx(std::sqrt(around * around + 15 * 15)));
  CHECK(s.minimum[0] == Approx(-3));
  CHECK(s.maximum[1] == Approx(3));
  CHECK(s.minimum[2] == Approx(-5));
  CHECK(s.maximum[2] == Approx(10));
}

TEST_CASE("extents of arcs and helices in a tilted frame agree with sampling") {
  const double c = std::cos(0.7), n = std::sin(0.7);
  for (const double drop : {0.0, -3.0, -80.0}) {
    for (const double angle : {0.4, 2.0, 3.9, 6.0}) {
      for (const bool is_ccw : {true, false}) {
        CAPTURE(drop, angle, is_ccw);
        TestDocument frame;
        const auto tilt = [&](TestDocument& t) {
          t.frame("Tilt", {c, 0, n, 0, 0, 1, 0, 0, -n, 0, c, 0, 5, 6, 7, 1});
          t.place(10, 0, 0);
        };
        tilt(frame);
        const double end = is_ccw ? angle : -angle;
        const Summary s = summarize(
            {tilt, [&](TestDocument& t) { t.arc(is_ccw, 10 * std::cos(end), 10 * std::sin(end), drop, 0, 0, 0); }});
        constexpr int samples = 20000;
        double low[3], high[3];
        for (int i = 0; i <= samples; ++i) {
          const double part = static_cast<double>(i) / samples, phi = end * part;
          double at[3];
          frame.d.composed().map({10 * std::cos(phi), 10 * std::sin(phi), drop * part}, at);
          for (int k = 0; k < 3; ++k) {
            low[k] = i == 0 ? at[k] : std::min(low[k], at[k]);
            high[k] = i == 0 ? at[k] : std::max(high[k], at[k]);
          }
        }
        for (int k = 0; k < 3; ++k) {
          CHECK(s.minimum[k] == Approx(low[k]).margin(1e-6));
          CHECK(s.maximum[k] == Approx(high[k]).margin(1e-6));
        }
        CHECK(s.feed_length_mm == Approx(std::sqrt(100 * angle * angle + drop * drop)));
      }
    }
  }
}
