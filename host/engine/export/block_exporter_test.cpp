#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "isogloss/engine/document_json.hpp"
#include "test_document.hpp"

using namespace isogloss;

namespace {

constexpr const char* documents[] = {
    "{}",
    R"({"Parsing":{"Flags":["A2","Z99","A1"],"X":10,"Y":"#1","U":7,"A70":{"Q":2.25},"B5.1":{}},"Dwell":{"Time":0.1}})",
    R"({"Comment":{"Text":"a \"b\" \\ \u00e9 \n"},"Unit":{"System":"Metric"},"ToolChange":{"IsChange":false,"ToolId":-3}})",
    R"({"CompoundMotion":{"Term":"T","Items":[{"ProgramXyz":{"X":0.30000000000000004,"Y":1e-9,"Z":1e22},
        "MotionEvent":{"Form":"McArc","ArcCenter":{"X":1,"Y":2,"Z":3}}},{"Dwell":{"Time":2}}]}})",
    R"({"ProgramToMcTransform":[{"Source":"Offset","Kind":"Static","Mat4d":[1,0,0,0,0,1,0,0,0,0,1,0,0.1,0,-20,1]}]})",
};

std::string stream(TestDocument& t, Format format) {
  StringOutput out;
  const auto e = make_block_exporter(out, format);
  e->begin(t.d, t.symbols);
  CHECK(e->block(t.d, t.symbols));
  CHECK(e->end());
  return out.text;
}

}  // namespace

TEST_CASE("a block streams in the shape of show_json, with its source") {
  for (const char* json : documents) {
    CAPTURE(json);
    TestDocument t;
    t.block(12, "TEXT \"of\" the block\xff");
    load_json(Json::parse(json), t.d, t.symbols);
    const std::string line = stream(t, Format::jsonl);
    CHECK(line.back() == '\n');
    CHECK(line.find('\n') == line.size() - 1);
    Json streamed = Json::parse(line);
    CHECK(streamed["Source"].dump() ==
          "{\"File\":\"part.nc\",\"Line\":12,\"Text\":\"TEXT \\\"of\\\" the block\xef\xbf\xbd\"}");
    streamed.erase("Source");
    CHECK(streamed == show_json(t.d, t.symbols));
    CHECK(nlohmann::json(streamed) == nlohmann::json::parse(json));
  }
}

TEST_CASE("names and texts that a program made up are escaped") {
  TestDocument t;
  t.block(3, "\"\xfe=1");
  t.d.add_leftover(IG_LEFT_EXPRESSION, IG_NO_FIELD, 0, 4, "\"\xfe");
  t.d.add_leftover(IG_LEFT_UNKNOWN, IG_NO_FIELD, 1, 2, "\\\xff");
  const Json streamed = Json::parse(stream(t, Format::jsonl));
  CHECK(streamed["Parsing"].dump() == "{\"Flags\":[\"\\\\\xef\xbf\xbd\"],\"\\\"\xef\xbf\xbd\":\"1\"}");
  CHECK(streamed["Parsing"] == show_json(t.d, t.symbols)["Parsing"]);
}

TEST_CASE("a section that was carried shows what it holds in each block") {
  TestDocument t;
  StringOutput out;
  const auto e = make_block_exporter(out, Format::jsonl);
  e->begin(t.d, t.symbols);
  const auto shows_all = [&](std::uint32_t line) {
    out.text.clear();
    CHECK(e->block(t.d, t.symbols));
    CHECK(e->end());
    Json streamed = Json::parse(out.text);
    CHECK(streamed["Source"]["Line"] == line);
    streamed.erase("Source");
    CHECK(streamed == show_json(t.d, t.symbols));
  };
  t.block(1, "first");
  t.name("Unit.System", "Metric");
  t.number("Feedrate.FeedrateValue", 600);
  t.shift(1, 2, 3.5);
  t.place(10, 0, 5);
  shows_all(1);
  t.block(2, "carried");
  shows_all(2);
  t.block(3, "a value of another kind, one more, one less");
  t.number("Feedrate.FeedrateValue", -0.0);
  t.name("Feedrate.Unit", "mm/min");
  t.d.erase(t.layout.id("Unit.System"));
  shows_all(3);
  t.block(4, "written anew");
  t.number("Feedrate.FeedrateValue", 0.0);
  shows_all(4);
  t.block(5, "what is left over stands among the values");
  t.d.add_leftover(IG_LEFT_EXPRESSION, t.layout.id("Feedrate.FeedrateValue"), 0, 4, "what");
  shows_all(5);
  t.block(6, "another frame");
  t.shift(1, 2, 4.5);
  shows_all(6);
  t.block(7, "and back");
  t.name("Unit.System", "Metric");
  shows_all(7);
}

TEST_CASE("source fields that a syntax wrote stand with the block's own") {
  TestDocument t;
  t.block(3, "A1");
  t.integer("Source.N", 10);
  t.integer("Source.Line", 99);
  CHECK(stream(t, Format::jsonl) == R"({"Source":{"File":"part.nc","Line":3,"Text":"A1","N":10}})"
                                    "\n");
}

TEST_CASE("blocks as text show what the block wrote") {
  TestDocument t;
  t.name("Unit.System", "Metric");  // carried
  t.block(7, "A70 X30\tQ2.5\r");
  load_json(Json::parse(R"({"Parsing":{"Flags":["Z99","A1"],"A70":{"Q":2.5}},"UnparsedText":"?",
      "CompoundMotion":{"Term":"A70","Items":[
        {"ProgramXyz":{"X":50,"Y":30,"Z":0},"MotionEvent":{"Form":"McLinear","IsRapid":true}},{"Dwell":{"Time":0.5}}]},
      "Feedrate":{"FeedrateValue":600,"Unit":"mm/min"}})"),
            t.d, t.symbols);
  t.d.add_leftover(IG_LEFT_TEXT, IG_NO_FIELD, 0, 1, "odd");
  CHECK(stream(t, Format::text) ==
        "part.nc\n"
        "     7  A70 X30 Q2.5\n"
        "          UnparsedText odd\n"
        "          Parsing Flags=Z99,A1 A70(Q=2.5)\n"
        "          Feedrate FeedrateValue=600 Unit=mm/min\n"
        "          CompoundMotion Term=A70 Items\n"
        "            - ProgramXyz(X=50 Y=30 Z=0) MotionEvent(Form=McLinear IsRapid=true)\n"
        "            - Dwell(Time=0.5)\n");
}

TEST_CASE("a transform as text") {
  TestDocument t;
  t.block(1, "");
  t.shift(1, 2, 3.5);
  CHECK(stream(t, Format::text) ==
        "part.nc\n"
        "     1\n"
        "          ProgramToMcTransform\n"
        "            - Source=Offset Kind=Static Mat4d=1,0,0,0,0,1,0,0,0,0,1,0,1,2,3.5,1\n");
}
