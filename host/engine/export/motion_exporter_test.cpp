#include <catch2/catch.hpp>

#include "export/test_motions.hpp"

using namespace isogloss;
using namespace isogloss::test;

TEST_CASE("motions as JSON Lines, character for character") {
  Stream s({.header = true, .dialect = "acme"});
  s.t.shift(0, 0, -100);
  s.block(7, [&] { s.t.line(true, 30, 20, 5); });
  s.block(8, [&] { s.t.line(false, 30, 20, -10.5, 200.0 / 60); });
  s.block(9, [&] { s.t.arc(true, 20, 30, -10.5, 20, 20, -10.5, 5); });
  s.block(10, [&] { s.t.number("Dwell.Time", 0.5); });
  s.block(11, [&] { s.t.name("ProgramEnd.Term", "END"); });
  CHECK(s.text() ==
        R"({"Isogloss":1,"Dialect":"acme","Units":"mm, deg, s, mm/s"})"
        "\n"
        R"({"File":"part.nc","Line":7,"Event":"rapid","ProgramXyz":{"X":30,"Y":20,"Z":5},)"
        R"("MachineCoordinate":{"X":30,"Y":20,"Z":-95}})"
        "\n"
        R"({"File":"part.nc","Line":8,"Event":"feed","ProgramXyz":{"X":30,"Y":20,"Z":-10.5},)"
        R"("MachineCoordinate":{"X":30,"Y":20,"Z":-110.5},"Feedrate_mmds":3.333333})"
        "\n"
        R"({"File":"part.nc","Line":9,"Event":"arc","ProgramXyz":{"X":20,"Y":30,"Z":-10.5},)"
        R"("MachineCoordinate":{"X":20,"Y":30,"Z":-110.5},"ArcCenter":{"X":20,"Y":20,"Z":-10.5},"Plane":"XY",)"
        R"("IsCcw":true,"AdditionalCircleNum":0,"Feedrate_mmds":5,"MachineArcCenter":{"X":20,"Y":20,"Z":-110.5},)"
        R"("Normal":{"X":0,"Y":0,"Z":1},"Sweep_deg":90})"
        "\n"
        R"({"File":"part.nc","Line":10,"Event":"dwell","Time":0.5})"
        "\n"
        R"({"File":"part.nc","Line":11,"Event":"end","Term":"END"})"
        "\n");
}

TEST_CASE("a move of the tip with turning axes says so, last in its line") {
  const auto move = [](Stream& s) {
    s.block(1, [&] {
      s.t.line(false, 1, 2, 3, 5);
      s.t.name("MotionEvent.Form", "ClLinear");
      s.t.number("MachineCoordinate.A", 30);
    });
    s.block(2, [&] { s.t.line(false, 1, 2, 4, 5); });
  };
  Stream json({});
  move(json);
  CHECK(json.text() == R"({"File":"part.nc","Line":1,"Event":"feed","ProgramXyz":{"X":1,"Y":2,"Z":3},)"
                       R"("MachineCoordinate":{"X":1,"Y":2,"Z":3,"A":30},"Feedrate_mmds":5,"Form":"ClLinear"})"
                       "\n"
                       R"({"File":"part.nc","Line":2,"Event":"feed","ProgramXyz":{"X":1,"Y":2,"Z":4},)"
                       R"("MachineCoordinate":{"X":1,"Y":2,"Z":4,"A":30},"Feedrate_mmds":5})"
                       "\n");
}

TEST_CASE("exact numbers read back to the same double") {
  Stream s({.exact = true});
  s.block(1, [&] { s.t.line(false, 0.1 + 0.2, 1e-9, 25.190799999999996, 10.0 / 3); });
  const Json e = s.events().at(0);
  CHECK(e["ProgramXyz"]["X"].get<double>() == 0.1 + 0.2);
  CHECK(e["ProgramXyz"]["Y"].get<double>() == 1e-9);
  CHECK(e["ProgramXyz"]["Z"].get<double>() == 25.190799999999996);
  CHECK(e["Feedrate_mmds"].get<double>() == 10.0 / 3);
}

TEST_CASE("motions as CSV, character for character") {
  Stream s({.format = Format::csv});
  s.block(1, [&] {
    s.t.integer("ToolChange.ToolId", 5);
    s.t.integer("ToolChange.IsChange", 1);
  });
  s.block(2, [&] {
    s.t.number("SpindleSpeed.SpindleSpeed_rpm", 1200);
    s.t.name("SpindleSpeed.Direction", "CW");
    s.t.name("Coolant.Mode", "FLOOD");
    s.t.line(true, 1, 2, 3);
    s.t.number("MachineCoordinate.B", 90);
  });
  s.block(3, [&] { s.t.arc(false, 1, 2, 3, 2, 2, 3); });
  s.block(4, [&] { s.t.number("SpindleOrientation.Angle_deg", 30); });
  s.block(5, [&] { s.t.name("ProgramStop.Term", "HALT"); });
  CHECK(s.text() ==
        "file,line,event,px,py,pz,mx,my,mz,a,b,c,feed_mm_s,cx,cy,cz,ccw,circles,plane,mcx,mcy,mcz,nx,ny,nz,sweep,"
        "value,term\n"
        "part.nc,1,tool,,,,,,,,,,,,,,,,,,,,,,,,5,\n"
        "part.nc,2,spindle,,,,,,,,,,,,,,,,,,,,,,,,1200,CW\n"
        "part.nc,2,coolant,,,,,,,,,,,,,,,,,,,,,,,,,FLOOD\n"
        "part.nc,2,rapid,1,2,3,1,2,3,,90,,,,,,,,,,,,,,,,,\n"
        "part.nc,3,arc,1,2,3,1,2,3,,90,,10,2,2,3,0,0,XY,2,2,3,0,0,1,-360,,\n"
        "part.nc,4,orient,,,,,,,,,,,,,,,,,,,,,,,,30,\n"
        "part.nc,5,stop,,,,,,,,,,,,,,,,,,,,,,,,,HALT\n");
}

TEST_CASE("every CSV line has the header's columns") {
  Stream s({.format = Format::csv});
  s.block(1, [&] {
    s.t.integer("ToolChange.SpindleToolId", 5);
    s.t.integer("ToolChange.IsChange", 1);
    s.t.name("SpindleSpeed.Direction", "CW");
    s.t.name("Coolant.Mode", "MIST");
    s.t.number("Dwell.Time", 1);
    s.t.name("ProgramStop.Term", "HALT");
    s.t.name("ProgramEnd.Term", "END");
    s.t.item_line(false, 1, 2, 3, 4);
    s.t.item();
    s.t.item_number("SpindleOrientation.Angle_deg", 0);
    s.t.item_line(true, 1, 2, 4);
    s.t.item_value("MotionEvent.IsManual", {.integer = 1});
    s.t.item();
    s.t.item_name("MotionEvent.Form", "McArc");
  });
  std::istringstream lines(s.text());
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) CHECK(std::count(line.begin(), line.end(), ',') == 27);
  CHECK(count == 11);
}

TEST_CASE("names and files may hold any byte") {
  const std::string file = std::string("a\"b\\c\n\x01,\xc3\xa9\xff\xe2\x82") + ".nc";
  TestDocument t;
  StringOutput json, csv;
  const auto run = [&](Exporter& e) {
    e.begin(t.d, t.symbols);
    t.block(1, "", file);
    t.name("ProgramEnd.Term", "E\"\xfe");
    CHECK(e.block(t.d, t.symbols));
    CHECK(e.end());
  };
  run(*make_motion_exporter(json, {}));
  run(*make_motion_exporter(csv, {.format = Format::csv}));
  const Json e = Json::parse(json.text);
  CHECK(e["File"] == "a\"b\\c\n\x01,\xc3\xa9\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd.nc");
  CHECK(e["Term"] == "E\"\xef\xbf\xbd");
  CHECK(csv.text.find("\"a\"\"b\\c\n\x01,\xc3\xa9\xef\xbf\xbd") != std::string::npos);
  CHECK(csv.text.find(",\"E\"\"\xef\xbf\xbd\"\n") != std::string::npos);
}

TEST_CASE("a file name longer than the buffer is written whole") {
  const std::string file(300000, 'f');
  TestDocument t;
  StringOutput out;
  const auto e = make_motion_exporter(out, {});
  e->begin(t.d, t.symbols);
  for (std::uint32_t line = 1; line < 4; ++line) {
    t.block(line, "", file);
    t.number("Dwell.Time", line);
    CHECK(e->block(t.d, t.symbols));
  }
  CHECK(e->end());
  CHECK(out.text.size() ==
        3 * (file.size() + std::string(R"({"File":"","Line":1,"Event":"dwell","Time":1})").size() + 1));
}

TEST_CASE("a closed output ends the run") {
  TestDocument t;
  StringOutput out;
  out.is_open = false;
  const auto e = make_motion_exporter(out, {});
  e->begin(t.d, t.symbols);
  bool goes_on = true;
  for (std::uint32_t line = 1; goes_on && line < 100000; ++line) {
    t.block(line);
    t.line(false, line, 0, 0);
    goes_on = e->block(t.d, t.symbols);
  }
  CHECK_FALSE(goes_on);
  CHECK_FALSE(e->end());
}

TEST_CASE("a second program goes into the same stream without a second header") {
  Stream s({.format = Format::csv});
  s.block(1, [&] { s.t.number("Dwell.Time", 1); });
  s.begin();
  s.block(1, [&] { s.t.number("Dwell.Time", 1); });
  const std::string text = s.text();
  CHECK(std::count(text.begin(), text.end(), '\n') == 3);
}

TEST_CASE("motions as text") {
  Stream s({.format = Format::text});
  s.block(7, [&] { s.t.line(true, 30, 20, 5); });
  s.block(8, [&] { s.t.arc(false, 30, 10, 5, 30, 15, 5, 10); });
  s.block(9, [&] { s.t.number("Dwell.Time", 0.5); });
  CHECK(s.text() ==
        "part.nc\n"
        "  line  event     program X          Y          Z    machine X          Y          Z    mm/min\n"
        "     7  rapid        30.000     20.000      5.000       30.000     20.000      5.000\n"
        "     8  arc          30.000     10.000      5.000       30.000     10.000      5.000       600"
        "  XY cw about 30 15 5, 180 deg\n"
        "     9  dwell   0.5 s\n");
}

TEST_CASE("a long stream, written beside the run, is what its pieces are") {
  constexpr std::uint32_t count = 20000;
  const auto fill = [](Stream& s, std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t line = first; line < last; ++line) {
      const double x = line * 0.25;
      s.block(line, [&] {
        if (line % 7 == 0)
          s.t.arc(line % 2 == 0, x, 1, -1, x, 0, -1, 5);
        else
          s.t.line(false, x, line % 3, -1, line);
        if (line % 100 == 0) s.t.name("Coolant.Mode", line % 200 == 0 ? "FLOOD" : "MIST");
        if (line % 1000 == 0) s.t.number("Dwell.Time", line);
      });
    }
  };
  for (const Format format : {Format::csv, Format::jsonl}) {
    Stream whole({.format = format});
    fill(whole, 1, count);
    // The same blocks in runs too short for a batch each: nothing of them is written beside the run.
    Stream pieces({.format = format});
    fill(pieces, 1, 300);
    for (std::uint32_t line = 300; line < count; line += 100) {
      const std::size_t written = pieces.text().size();
      CHECK(written > line);
      fill(pieces, line, std::min(line + 100, count));
    }
    CHECK(whole.text() == pieces.text());
  }
}

TEST_CASE("a name at the end of a batch is its own event's") {
  TestDocument t;
  StringOutput out;
  const auto e = make_motion_exporter(out, {.format = Format::csv});
  e->begin(t.d, t.symbols);
  std::string expected;
  for (std::uint32_t line = 1; line < 40000; ++line) {
    const std::string mode = "a name too long to stand beside its size, " + std::to_string(line);
    t.block(line);
    t.name("Coolant.Mode", mode);
    CHECK(e->block(t.d, t.symbols));
    expected += "part.nc," + std::to_string(line) + ",coolant,,,,,,,,,,,,,,,,,,,,,,,,,\"" + mode + "\"\n";
  }
  e->end();
  CHECK(out.text.substr(out.text.find('\n') + 1) == expected);
}

TEST_CASE("an exporter may go while lines wait") {
  TestDocument t;
  StringOutput out;
  const auto e = make_motion_exporter(out, {.format = Format::csv});
  e->begin(t.d, t.symbols);
  for (std::uint32_t line = 1; line < 40000; ++line) {
    t.block(line);
    t.line(false, line, 0, 0);
    CHECK(e->block(t.d, t.symbols));
  }
}

TEST_CASE("what an output throws comes out of the run, wherever it was thrown") {
  struct Throwing : Output {
    bool write(std::string_view) override { throw std::runtime_error("no room"); }
  } out;
  TestDocument t;
  const auto e = make_motion_exporter(out, {.format = Format::csv});
  const auto run = [&] {
    e->begin(t.d, t.symbols);
    for (std::uint32_t line = 1; line < 20000; ++line) {
      t.block(line);
      t.line(false, line, 0, 0);
      if (!e->block(t.d, t.symbols)) break;
    }
    e->end();
  };
  CHECK_THROWS_WITH(run(), "no room");
}
