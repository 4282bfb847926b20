#include "isogloss/engine/document_json.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "test_document.hpp"

using namespace isogloss;

namespace {

/// Loads, shows, and gives back both what was shown and what passed through.
struct Loaded {
  TestDocument t;
  Json rest;
  explicit Loaded(const char* json) {
    t.block(1);
    rest = load_json(Json::parse(json), t.d, t.symbols);
  }
  Json shown() const { return show_json(t.d, t.symbols); }
};

void check_same(const char* json) {
  CAPTURE(json);
  const Loaded loaded(json);
  CHECK(loaded.rest.empty());
  CHECK(nlohmann::json(loaded.shown()) == nlohmann::json::parse(json));
}

std::string error_of(const char* json) {
  try {
    Loaded loaded(json);
    return "";
  } catch (const std::runtime_error& e) {
    return e.what();
  }
}

}  // namespace

TEST_CASE("what is loaded is shown again") {
  for (
      const char* json : {
          "{}",
          R"({"Parsing":{"X":10,"Y":-2.5}})",
          R"({"Parsing":{"Flags":["A2","A1","A3.1"]}})",
          R"({"Parsing":{"Flags":["A2","Z99","A1","Z98"],"X":1}})",
          R"({"Parsing":{"A70":{"X":1,"Q":2.5},"X":3}})",
          R"({"Parsing":{"A70":{}}})",
          R"({"Parsing":{"B5.1":{"P":12}}})",
          R"({"Parsing":{"X":"#1","A70":{"Q":"[#2+1]"},"U":7,"W":1.5}})",
          R"({"Feedrate":{"FeedrateValue":600,"Term":"T","Unit":"mm/min"}})",
          R"({"ToolChange":{"ToolId":5,"IsChange":true}})",
          R"({"Comment":{"Symbol":"(","Text":"caf\u00e9 \"1\""}})",
          R"({"CannedCycle":{"Term":"T","ReturnMode":"R","Params":{"X":50,"Z":-10.125}}})",
          R"({"MotionEvent":{"Form":"McArc","ArcCenter":{"X":1,"Y":2,"Z":3},"IsCcw":false,"AdditionalCircleNum":0}})",
          R"({"ProgramToMcTransform":[{"Source":"Tilt","Kind":"Static","Mat4d":[0,1,0,0,-1,0,0,0,0,0,1,0,0,0,0.5,1]}]})",
          R"({"ProgramToMcTransform":[{"Source":"Tilt","Kind":"Dynamic","Mat4d":[0,1,0,0,-1,0,0,0,0,0,1,0,0,0,0,1]}]})",
          R"({"CompoundMotion":{"Term":"T","Items":[
               {"ProgramXyz":{"X":50,"Y":30,"Z":0},"MotionEvent":{"Form":"McLinear","IsRapid":true}},
               {"Dwell":{"Time":0.5}},
               {"SpindleControl":{"Direction":"STOP"}}]},"ProgramXyz":{"X":50,"Y":30,"Z":0}})",
      })
    check_same(json);
}

TEST_CASE("what is loaded counts as written in this block") {
  Loaded loaded(R"({"Parsing":{"X":10,"Y":2.5,"Flags":["A2"],"A70":{"Q":1}},"Unit":{"System":"Metric"}})");
  Document& d = loaded.t.d;
  const Layout& layout = loaded.t.layout;
  for (const char* path :
       {"Parsing.X", "Parsing.Y", "Parsing.Flags.A2", "Parsing.A70", "Parsing.A70.Q", "Unit.System"}) {
    CAPTURE(path);
    CHECK(d.present(layout.id(path)));
    CHECK(d.fresh(layout.id(path)));
    CHECK(d.writer(layout.id(path)) == 0);
  }
  CHECK(d.without_point(layout.id("Parsing.X")));
  CHECK_FALSE(d.without_point(layout.id("Parsing.Y")));
  CHECK(d.value(layout.id("Parsing.Flags.A2")).integer == 1);
  CHECK(d.value(layout.id("Parsing.A70")).integer == 2);
  CHECK(d.has_leftovers());
}

TEST_CASE("unknown codes and words without a field are leftovers") {
  const Loaded loaded(R"({"Parsing":{"Flags":["Z99"],"U":7,"X":"#1"}})");
  const auto& left = loaded.t.d.leftovers;
  REQUIRE(left.size() == 3);
  CHECK((left[0].kind == IG_LEFT_UNKNOWN && left[0].name == "Z99"));
  CHECK((left[1].kind == IG_LEFT_WORD && left[1].name == "U"));
  CHECK((left[2].kind == IG_LEFT_EXPRESSION && left[2].field == loaded.t.layout.id("Parsing.X")));
}

TEST_CASE("what the layout does not know passes through") {
  const Loaded loaded(R"({"Acme":{"Deep":[1,{"a":null}]},"Feedrate":{"FeedrateValue":1,"Odd":2},"UnparsedText":"K 3",
      "Parsing":{"Z7":{"A":1},"A70":{"K":2,"Q":1}},
      "ProgramToMcTransform":[{"Source":"Nobody","Kind":"Static","Mat4d":[]}],
      "CompoundMotion":{"Items":[{"Dwell":{"Time":1}},{"Acme":{"X":1}}]}})");
  CHECK(loaded.rest == Json::parse(R"({"Acme":{"Deep":[1,{"a":null}]},"Feedrate":{"Odd":2},"UnparsedText":"K 3",
      "Parsing":{"Z7":{"A":1},"A70":{"K":2}},
      "ProgramToMcTransform":[{"Source":"Nobody","Kind":"Static","Mat4d":[]}],
      "CompoundMotion":{"Items":[{"Dwell":{"Time":1}},{"Acme":{"X":1}}]}})"));
  CHECK(loaded.shown() == Json::parse(R"({"Parsing":{"A70":{"Q":1}},"Feedrate":{"FeedrateValue":1}})"));
}

TEST_CASE("a value of a wrong type is refused with its path") {
  CHECK(error_of("[]").find("the document") == 0);
  CHECK(error_of(R"({"Feedrate":{"FeedrateValue":"fast"}})").find("Feedrate.FeedrateValue: a number") == 0);
  CHECK(error_of(R"({"Feedrate":{"Term":7}})").find("Feedrate.Term: a name") == 0);
  CHECK(error_of(R"({"ToolChange":{"ToolId":1.5}})").find("ToolChange.ToolId: a whole number") == 0);
  CHECK(error_of(R"({"ToolChange":{"IsChange":1}})").find("ToolChange.IsChange: true or false") == 0);
  CHECK(error_of(R"({"Comment":{"Text":1}})").find("Comment.Text: a text") == 0);
  CHECK(error_of(R"({"Parsing":{"X":true}})").find("Parsing.X: a number or an expression") == 0);
  CHECK(error_of(R"({"Parsing":{"X":null}})").find("Parsing.X") == 0);
  CHECK(error_of(R"({"Parsing":{"A70":{"Q":[1]}}})").find("Parsing.A70.Q") == 0);
  CHECK(error_of(R"({"Parsing":{"Flags":"A1"}})").find("Parsing.Flags: a list") == 0);
  CHECK(error_of(R"({"Parsing":{"Flags":[1]}})").find("Parsing.Flags") == 0);
  CHECK(error_of(R"({"Parsing":[]})").find("Parsing: an object") == 0);
  CHECK(error_of(R"({"CompoundMotion":{"Items":[{"Dwell":{"Time":"x"}}]}})")
            .find("CompoundMotion.Items[0].Dwell.Time: a number") == 0);
  CHECK(error_of(R"({"CompoundMotion":{"Items":{}}})").find("CompoundMotion.Items: a list") == 0);
  CHECK(error_of(R"({"ProgramToMcTransform":[{"Source":"Tilt","Mat4d":[1]}]})").find("ProgramToMcTransform.Tilt") == 0);
}

TEST_CASE("codes that were taken do not show, words of a taken code do") {
  Loaded loaded(R"({"Parsing":{"Flags":["A1","A2"],"A70":{"X":1,"Q":2}}})");
  ig_value ignored;
  CHECK(loaded.t.d.take(loaded.t.layout.id("Parsing.Flags.A1"), ignored));
  CHECK(loaded.t.d.take(loaded.t.layout.id("Parsing.A70"), ignored));
  CHECK(loaded.shown() == Json::parse(R"({"Parsing":{"Flags":["A2"],"A70":{"X":1,"Q":2}}})"));
  CHECK(loaded.t.d.take(loaded.t.layout.id("Parsing.A70.X"), ignored));
  CHECK(loaded.t.d.take(loaded.t.layout.id("Parsing.A70.Q"), ignored));
  CHECK(loaded.t.d.take(loaded.t.layout.id("Parsing.Flags.A2"), ignored));
  CHECK(loaded.shown().empty());
}

TEST_CASE("leftovers of scanned text show in their places") {
  TestDocument t;
  const std::string text = "A2 Z99 A1 X #1 U+7.50 V=[1+ 2] what";
  t.block(1, text);
  const auto at = [&](std::string_view piece) { return static_cast<std::uint32_t>(text.find(piece)); };
  const auto code = [&](const char* path, std::string_view piece) {
    const std::uint32_t begin = at(piece);
    t.d.set_word({t.layout.id(path),
                  static_cast<std::uint16_t>(begin),
                  static_cast<std::uint16_t>(begin + piece.size()),
                  {},
                  0,
                  0});
  };
  const auto left = [&](ig_leftover_kind kind, const char* path, std::string_view piece, std::string_view name) {
    const std::uint32_t begin = at(piece);
    t.d.add_leftover(kind, t.layout.id(path), begin, begin + static_cast<std::uint32_t>(piece.size()), name);
  };
  code("Parsing.Flags.A2", "A2");
  left(IG_LEFT_UNKNOWN, "", "Z99", "Z99");
  code("Parsing.Flags.A1", "A1");
  left(IG_LEFT_EXPRESSION, "Parsing.X", "X #1", "X");
  left(IG_LEFT_WORD, "", "U+7.50", "U");
  left(IG_LEFT_EXPRESSION, "", "V=[1+ 2]", "V");
  left(IG_LEFT_TEXT, "", "what", "what");
  t.d.leftovers.push_back({IG_LEFT_STATEMENT, IG_NO_FIELD, 0, 0, " GO ON "});
  CHECK(show_json(t.d, t.symbols) ==
        Json::parse(
            R"({"UnparsedText":"what GO ON","Parsing":{"Flags":["A2","Z99","A1"],"X":"#1","U":7.5,"V":"[1+ 2]"}})"));
}

TEST_CASE("switches and values that are no numbers do not show") {
  TestDocument t;
  t.block(1);
  t.d.set(t.layout.id("Parsing.~Seen"), {});
  t.number("Feedrate.FeedrateValue", std::nan(""));
  t.name("Feedrate.Term", "T");
  CHECK(show_json(t.d, t.symbols).dump() == R"({"Feedrate":{"Term":"T"}})");
}

TEST_CASE("sections come in the order of the data model and only those that are asked for") {
  Loaded loaded(R"({"Dwell":{"Time":1},"Unit":{"System":"Metric"},"Comment":{"Text":"c"},"Parsing":{"X":1}})");
  CHECK(loaded.shown().dump() ==
        R"({"Comment":{"Text":"c"},"Parsing":{"X":1},"Unit":{"System":"Metric"},"Dwell":{"Time":1}})");
  const std::set<std::string> sections{"Dwell", "Parsing", "Feedrate"};
  CHECK(show_json(loaded.t.d, loaded.t.symbols, &sections).dump() == R"({"Parsing":{"X":1},"Dwell":{"Time":1}})");
}

TEST_CASE("the sections in which one syntax wrote") {
  Loaded loaded(R"({"Unit":{"System":"Metric"},"Parsing":{"X":1}})");
  TestDocument& t = loaded.t;
  t.d.current = 3;
  t.number("Feedrate.FeedrateValue", 100);
  t.shift(1, 2, 3);
  t.d.current = 4;
  t.number("Dwell.Time", 1);
  CHECK(written_sections(t.d, 3) == std::set<std::string>{"Feedrate", "ProgramToMcTransform"});
  CHECK(written_sections(t.d, 4) == std::set<std::string>{"Dwell"});
  t.item_line(true, 1, 2, 3);
  t.d.add_leftover(IG_LEFT_TEXT, IG_NO_FIELD, 0, 1, "?");
  CHECK(written_sections(t.d, 4) == std::set<std::string>{"CompoundMotion", "Dwell", "UnparsedText"});
}

TEST_CASE("text that is no UTF-8 can be dumped") {
  TestDocument t;
  t.block(1);
  t.d.set_text(t.layout.id("Comment.Text"), "H\xd6HE");
  CHECK(show_json(t.d, t.symbols).dump() == "{\"Comment\":{\"Text\":\"H\xef\xbf\xbdHE\"}}");
}
