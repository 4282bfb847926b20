#include <catch2/catch.hpp>
#include <cmath>

#include "export/test_motions.hpp"

using namespace isogloss;
using namespace isogloss::test;

TEST_CASE("events of one block come in the order of execution") {
  Stream s({});
  s.block(1, [&] {
    s.t.name("ProgramEnd.Term", "END");
    s.t.name("ProgramStop.Term", "HALT");
    s.t.line(true, 1, 0, 0);
    s.t.number("Dwell.Time", 1);
    s.t.name("Coolant.Mode", "FLOOD");
    s.t.name("SpindleSpeed.Direction", "CW");
    s.t.integer("ToolChange.ToolId", 1);
    s.t.integer("ToolChange.IsChange", 1);
  });
  s.block(2, [&] {
    s.t.name("SpindleSpeed.Direction", "STOP");
    s.t.name("Coolant.Mode", "OFF");
    s.t.line(true, 2, 0, 0);
  });
  CHECK(s.names() ==
        EventNames{"tool", "spindle", "coolant", "dwell", "rapid", "stop", "end", "rapid", "spindle", "coolant"});
}

TEST_CASE("spindle and coolant are told only when they change") {
  Stream s({});
  s.block(1, [&] { s.t.name("SpindleSpeed.Direction", "STOP"); });        // stands already
  s.block(2, [&] { s.t.name("Coolant.Mode", "OFF"); });                   // is off already
  s.block(3, [&] { s.t.number("SpindleSpeed.SpindleSpeed_rpm", 500); });  // does not turn yet
  s.block(4, [&] { s.t.name("SpindleSpeed.Direction", "CW"); });
  s.block(5, [&] { s.t.name("SpindleSpeed.Direction", "CW"); });
  s.block(6, [&] { s.t.number("SpindleSpeed.SpindleSpeed_rpm", 600); });
  s.block(7, [&] { s.t.name("Coolant.Mode", "FLOOD"); });
  s.block(8, [&] { s.t.name("Coolant.Mode", "FLOOD"); });
  s.block(9, [&] { s.t.name("Coolant.Mode", "MIST"); });
  const auto events = s.events();
  REQUIRE(events.size() == 4);
  CHECK(events[0].dump() == R"({"File":"part.nc","Line":4,"Event":"spindle","Direction":"CW","SpindleSpeed_rpm":500})");
  CHECK(events[1].dump() == R"({"File":"part.nc","Line":6,"Event":"spindle","Direction":"CW","SpindleSpeed_rpm":600})");
  CHECK(events[2].dump() == R"({"File":"part.nc","Line":7,"Event":"coolant","Mode":"FLOOD"})");
  CHECK(events[3].dump() == R"({"File":"part.nc","Line":9,"Event":"coolant","Mode":"MIST"})");
}

TEST_CASE("a new speed alone keeps the way the spindle turns, whatever the block leaves in force after its steps") {
  Stream s({}, [](TestDocument& t) {
    t.name("SpindleSpeed.Direction", "CW");
    t.number("SpindleSpeed.SpindleSpeed_rpm", 900);
  });
  s.block(1, [&] {
    s.t.number("SpindleSpeed.SpindleSpeed_rpm", 400);
    s.t.d.write(s.t.layout.id("SpindleSpeed.Direction"), {.symbol = s.t.symbols.intern("CCW")});  // not fresh
    s.t.item();
    s.t.item_name("SpindleControl.Direction", "CCW");
  });
  const auto events = s.events();
  REQUIRE(events.size() == 2);
  CHECK(events[0].dump() == R"({"File":"part.nc","Line":1,"Event":"spindle","Direction":"CW","SpindleSpeed_rpm":400})");
  CHECK(events[1].dump() ==
        R"({"File":"part.nc","Line":1,"Event":"spindle","Direction":"CCW","SpindleSpeed_rpm":400})");
}

TEST_CASE("an oriented stop includes the stop, the restart is a change") {
  Stream s({}, [](TestDocument& t) {
    t.name("SpindleSpeed.Direction", "CW");
    t.number("SpindleSpeed.SpindleSpeed_rpm", 900);
  });
  s.block(1, [&] {
    s.t.item();
    s.t.item_number("SpindleOrientation.Angle_deg", 0);
    s.t.item();
    s.t.item_name("SpindleControl.Direction", "STOP");  // stands already
    s.t.item();
    s.t.item_name("SpindleControl.Direction", "CW");
    s.t.item();
    s.t.item_name("SpindleControl.Direction", "CW");
  });
  s.block(2, [&] { s.t.number("SpindleOrientation.Angle_deg", 90); });
  s.block(3, [&] { s.t.number("SpindleSpeed.SpindleSpeed_rpm", 100); });  // starts nothing
  s.block(4, [&] { s.t.name("SpindleSpeed.Direction", "CW"); });
  const auto events = s.events();
  CHECK(s.names() == EventNames{"orient", "spindle", "orient", "spindle"});
  CHECK(events[1].dump() == R"({"File":"part.nc","Line":1,"Event":"spindle","Direction":"CW","SpindleSpeed_rpm":900})");
  CHECK(events[2]["Angle_deg"] == 90);
  CHECK(events[3]["Line"] == 4);
}

TEST_CASE("linear moves that change no machine axis are left out") {
  const auto run = [](bool zero_moves) {
    Stream s({.zero_moves = zero_moves}, [](TestDocument& t) { t.place(1, 2, 3); });
    s.block(1, [&] { s.t.line(true, 1, 2, 3); });           // the initial position
    s.block(2, [&] { s.t.line(false, 1, 2, 3 + 1e-10); });  // noise
    s.block(3, [&] { s.t.line(false, 1, 2, 3.000001); });
    s.block(4, [&] {
      s.t.line(false, 1, 2, 3.000001);
      s.t.number("MachineCoordinate.C", 5);  // a new axis moves
    });
    s.block(5, [&] {
      s.t.line(false, 1, 2, 3.000001);
      s.t.number("MachineCoordinate.C", 6);
    });
    s.block(6, [&] { s.t.line(true, 1, 2, 3.000001); });
    s.block(7, [&] { s.t.arc(true, 1, 2, 3.000001, 0, 2, 3); });  // a full circle
    std::vector<int> lines;
    for (const Json& e : s.events()) lines.push_back(e["Line"]);
    return lines;
  };
  CHECK(run(false) == std::vector{3, 4, 5, 7});
  CHECK(run(true) == std::vector{1, 2, 3, 4, 5, 6, 7});
}

TEST_CASE("the first move is told where no position is known") {
  Stream s({});
  s.block(1, [&] { s.t.line(true, 0, 0, 0); });
  s.block(2, [&] { s.t.line(true, 0, 0, 0); });
  CHECK(s.events().size() == 1);
}

TEST_CASE("the steps of a compound motion come in order, rotary axes keep their place") {
  Stream s({}, [](TestDocument& t) {
    t.shift(0, 0, 50);
    t.place(0, 0, 0);
    t.number("MachineCoordinate.A", 15);
  });
  s.block(4, [&] {
    s.t.item_line(true, 5, 0, 0);
    s.t.item_line(true, 5, 0, 0);
    s.t.item_line(false, 5, 0, -9, 2);
    s.t.item();
    s.t.item_number("Dwell.Time", 0.25);
    s.t.item_line(true, 5, 0, 0);
    s.t.item_value("MotionEvent.IsManual", {.integer = 1});
    s.t.name("CompoundMotion.Term", "DRILL");
  });
  const auto events = s.events();
  REQUIRE(events.size() == 4);
  CHECK(events[0].dump() == R"({"File":"part.nc","Line":4,"Event":"rapid","ProgramXyz":{"X":5,"Y":0,"Z":0},)"
                            R"("MachineCoordinate":{"X":5,"Y":0,"Z":50,"A":15}})");
  CHECK(events[1]["Event"] == "feed");
  CHECK(events[1]["Feedrate_mmds"] == 2);
  CHECK(events[2]["Time"] == 0.25);
  CHECK(events[3].dump() == R"({"File":"part.nc","Line":4,"Event":"rapid","ProgramXyz":{"X":5,"Y":0,"Z":0},)"
                            R"("MachineCoordinate":{"X":5,"Y":0,"Z":50,"A":15},"Manual":true})");
}

TEST_CASE("sweeps in the three planes") {
  struct Row {
    const char* plane;
    bool is_ccw;
    double start[3], end[3];
    double sweep;
    double normal[3];
  };
  const Row rows[] = {
      {"XY", true, {1, 0, 0}, {0, 1, 0}, 90, {0, 0, 1}},   {"XY", false, {1, 0, 0}, {0, 1, 0}, -270, {0, 0, 1}},
      {"XY", true, {1, 0, 0}, {1, 0, -2}, 360, {0, 0, 1}}, {"XY", false, {-1, 0, 0}, {1, 0, 0}, -180, {0, 0, 1}},
      {"ZX", true, {0, 0, 1}, {1, 0, 0}, 90, {0, 1, 0}},   {"ZX", false, {0, 0, 1}, {1, 0, 0}, -270, {0, 1, 0}},
      {"YZ", true, {0, 1, 0}, {0, 0, 1}, 90, {1, 0, 0}},   {"YZ", false, {0, 1, 0}, {0, 1, 0}, -360, {1, 0, 0}},
  };
  for (const Row& r : rows) {
    CAPTURE(r.plane, r.is_ccw, r.sweep);
    Stream s({}, [&](TestDocument& t) {
      t.shift(100, 200, 300);
      t.place(r.start[0], r.start[1], r.start[2]);
    });
    s.block(1, [&] {
      s.t.name("PlaneSelect.Plane", r.plane);
      s.t.arc(r.is_ccw, r.end[0], r.end[1], r.end[2], 0, 0, 0);
    });
    const Json e = s.events().at(0);
    CHECK(e["Plane"] == r.plane);
    CHECK(e["Sweep_deg"].get<double>() == Approx(r.sweep));
    CHECK(e["Normal"]["X"] == r.normal[0]);
    CHECK(e["Normal"]["Y"] == r.normal[1]);
    CHECK(e["Normal"]["Z"] == r.normal[2]);
    CHECK(e["MachineArcCenter"].dump() == R"({"X":100,"Y":200,"Z":300})");
  }
}

TEST_CASE("an arc whose ends lie in one direction from the centre is a whole circle, whatever rounding makes of it") {
  for (const double rounding : {-1e-14, 0.0, 1e-14}) {
    CAPTURE(rounding);
    Stream s({}, [](TestDocument& t) { t.place(2, 1, 0); });
    s.block(1, [&] { s.t.arc(true, 2 + rounding, 0, 0, 2, -9, 0); });
    CHECK(s.events().at(0)["Sweep_deg"].get<double>() == Approx(360));
  }
}

TEST_CASE("whole turns add to the sweep") {
  Stream s({}, [](TestDocument& t) { t.place(1, 0, 0); });
  s.block(1, [&] {
    s.t.arc(false, 0, -1, -4, 0, 0, 0);
    s.t.integer("MotionEvent.AdditionalCircleNum", 2);
  });
  const Json e = s.events().at(0);
  CHECK(e["AdditionalCircleNum"] == 2);
  CHECK(e["Sweep_deg"] == -810);
}

TEST_CASE("an arc's start stands in the frame of its own block") {
  Stream s({}, [](TestDocument& t) { t.place(10, 0, 0); });
  s.block(1, [&] {
    s.t.shift(10, 0, 0);  // the machine point (10,0,0) is now the program's (0,0,0)
    s.t.arc(true, 2, 0, 0, 1, 0, 0);
  });
  CHECK(s.events().at(0)["Sweep_deg"] == 180);
}

TEST_CASE("an arc's start stands in its own frame behind steps whose block has changed the frame after them") {
  Stream s({}, [](TestDocument& t) { t.place(0, 0, 0); });
  s.block(1, [&] {
    s.t.item_line(false, 10, 0, 0, 1);
    s.t.name("CompoundMotion.Term", "HOME");
    s.t.shift(10, 0, 0);
  });
  s.block(2, [&] { s.t.arc(true, 2, 0, 0, 1, 0, 0); });
  CHECK(s.events().at(1)["Sweep_deg"] == 180);
}

TEST_CASE("in a tilted frame the sweep about the normal leads from start to end in machine space") {
  const double c = std::cos(0.5), n = std::sin(0.5);
  for (const double mirror : {1.0, -1.0}) {
    Stream s({}, [&](TestDocument& t) {
      t.frame("Tilt", {mirror, 0, 0, 0, 0, c, n, 0, 0, -n, c, 0, 0, 0, 0, 1});
      t.shift(7, -3, 11);
      t.place(15, 4, 2);
    });
    s.block(1, [&] { s.t.arc(true, 10, 9, 2, 10, 4, 2); });
    const Json e = s.events().at(0);
    CAPTURE(mirror, e.dump());
    const auto point = [&](const char* key) {
      return std::array{e[key]["X"].get<double>(), e[key]["Y"].get<double>(), e[key]["Z"].get<double>()};
    };
    const auto end = point("MachineCoordinate"), center = point("MachineArcCenter"), normal = point("Normal");
    double start[3];
    s.t.d.composed().map({15, 4, 2}, start);
    const double angle = e["Sweep_deg"].get<double>() * std::acos(-1) / 180;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const double r = start[i] - center[i];
      const double q = normal[j] * (start[k] - center[k]) - normal[k] * (start[j] - center[j]);
      CHECK(center[i] + r * std::cos(angle) + q * std::sin(angle) == Approx(end[i]).margin(1e-5));
    }
    CHECK(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2] == Approx(1).margin(1e-5));
  }
}
