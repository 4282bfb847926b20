#include <isogloss_axis.h>
#include <isogloss_machine_code.h>
#include <isogloss_tool.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "../../tests/support/fake_dependency.hpp"
#include "machine/row_fields.hpp"

using namespace isogloss_test;

namespace {

ig_text text(std::string_view s) { return {s.data(), s.size()}; }

bool offset(const FakeDependency& table, std::string_view id, double (&out)[3]) {
  const auto* s = table.service<ig_work_offset_1>("isogloss.work-offset/1");
  return s->get(s->self, text(id), out) != 0;
}

}  // namespace

TEST_CASE("work offsets: every offset of the control exists, and is zero until it is measured") {
  const FakeDependency table(*ig_plugin_v1(), "IsoCoordinateTable", {{"G55", {{"X", 100}, {"Z", -120}}}});
  double o[3];
  REQUIRE(offset(table, "G55", o));
  CHECK((o[0] == 100 && o[1] == 0 && o[2] == -120));
  for (const char* id : {"EXT", "G54", "G59", "G59.1", "G59.9", "G54.1P1", "G54.1P300"}) {
    CAPTURE(id);
    REQUIRE(offset(table, id, o));
    CHECK((o[0] == 0 && o[1] == 0 && o[2] == 0));
  }
  for (const char* id : {"", "G5", "G53", "G60", "G59.10", "G59.", "G54.1P0", "G54.1P301", "G54.1P", "G54.1P1x"}) {
    CAPTURE(id);
    CHECK_FALSE(offset(table, id, o));
  }
}

TEST_CASE("work offsets: values that G10 writes are read back, and no new offset appears") {
  const FakeDependency table(*ig_plugin_v1(), "IsoCoordinateTable");
  const auto* s = table.service<ig_work_offset_1>("isogloss.work-offset/1");
  const double origin[3] = {1, 2, 3};
  double o[3];
  CHECK(s->set(s->self, text("G54.1P7"), origin) == 1);
  REQUIRE(offset(table, "G54.1P7", o));
  CHECK((o[0] == 1 && o[1] == 2 && o[2] == 3));
  CHECK(s->set(s->self, text("G53"), origin) == 0);
  CHECK(table.service<ig_work_offset_1>("isogloss.tool-offset/1") == nullptr);
}

TEST_CASE("work offsets: rotary axes have origins of their own") {
  const FakeDependency table(*ig_plugin_v1(), "IsoCoordinateTable", {{"G55", {{"X", 100}, {"C", 12.5}}}});
  const auto* s = table.service<ig_work_offset_1>("isogloss.work-offset/1");
  double o[3] = {1, 1, 1};
  REQUIRE(s->get_rotary(s->self, text("G55"), o) == 1);
  CHECK((o[0] == 0 && o[1] == 0 && o[2] == 12.5));
  REQUIRE(s->get_rotary(s->self, text("G54.1P300"), o) == 1);
  CHECK((o[0] == 0 && o[1] == 0 && o[2] == 0));
  const double turned[3] = {-90, 0, 30};
  CHECK(s->set_rotary(s->self, text("G54.1P7"), turned) == 1);
  CHECK(s->set_rotary(s->self, text("G55"), turned) == 1);
  for (const char* id : {"G54.1P7", "G55"}) {
    REQUIRE(s->get_rotary(s->self, text(id), o) == 1);
    CHECK((o[0] == -90 && o[1] == 0 && o[2] == 30));
  }
  REQUIRE(offset(table, "G55", o));
  CHECK((o[0] == 100 && o[1] == 0 && o[2] == 0));
  CHECK(s->get_rotary(s->self, text("G53"), o) == 0);
  CHECK(s->set_rotary(s->self, text("G53"), turned) == 0);
}

TEST_CASE("tool offsets: a number without a row is zero, or missing where the table says so") {
  const FakeDependency::Rows rows{{"1", {{"H", 125.4}, {"HWear", -0.1}, {"D", 5}}}};
  const FakeDependency zero(*ig_plugin_v1(), "ToolOffsetTable", rows, {{"size", "99"}});
  const FakeDependency missing(*ig_plugin_v1(), "ToolOffsetTable", rows, {{"unlisted", "missing"}});
  const auto get = [](const FakeDependency& t, std::int64_t id, std::uint32_t column) {
    const auto* s = t.service<ig_tool_offset_1>("isogloss.tool-offset/1");
    double mm = 0;
    return s->get(s->self, id, column, &mm) != 0 ? mm : -1;
  };
  for (const FakeDependency* t : {&zero, &missing}) {
    CHECK(get(*t, 1, 0) == 125.4);
    CHECK(get(*t, 1, 1) == -0.1);
    CHECK(get(*t, 1, 2) == 5);
    CHECK(get(*t, 1, 3) == 0);
    CHECK(get(*t, 1, 4) == -1);
    CHECK(get(*t, 0, 0) == -1);
  }
  CHECK(get(zero, 2, 0) == 0);
  CHECK(get(zero, 100, 0) == -1);
  CHECK(get(missing, 2, 0) == -1);

  const auto* s = missing.service<ig_tool_offset_1>("isogloss.tool-offset/1");
  CHECK(s->set(s->self, 2, 0, 50) == 1);
  CHECK(get(missing, 2, 0) == 50);
  CHECK(s->set(s->self, 401, 0, 50) == 0);
}

TEST_CASE("tool offsets: what is no length and no radius is known only where a row gives it") {
  const FakeDependency table(*ig_plugin_v1(), "ToolOffsetTable",
                             {{"1",
                               {{"CornerRadius", 1.5},
                                {"CornerRadiusWear", -0.1},
                                {"TipAngle", 118},
                                {"Teeth", 4},
                                {"MaximumSpeed", 9000},
                                {"Type", 120},
                                {"CuttingLength", 22.5},
                                {"PlungeAngle", 3},
                                {"Life", 60},
                                {"LifeAtCall", 55},
                                {"UsedLife", 12}}},
                              {"2", {{"H", 10}}}});
  const auto* s = table.service<ig_tool_offset_1>("isogloss.tool-offset/1");
  const auto get = [&](std::int64_t id, std::uint32_t column) {
    double value = 0;
    return s->get(s->self, id, column, &value) != 0 ? value : -1;
  };
  CHECK(get(1, IG_TOOL_CORNER_RADIUS) == 1.5);
  CHECK(get(1, IG_TOOL_CORNER_RADIUS_WEAR) == -0.1);
  CHECK(get(1, IG_TOOL_TIP_ANGLE) == 118);
  CHECK(get(1, IG_TOOL_TEETH) == 4);
  CHECK(get(1, IG_TOOL_MAXIMUM_SPEED) == 9000);
  CHECK(get(1, IG_TOOL_TYPE) == 120);
  CHECK(get(1, IG_TOOL_CUTTING_LENGTH) == 22.5);
  CHECK(get(1, IG_TOOL_PLUNGE_ANGLE) == 3);
  CHECK(get(1, IG_TOOL_LIFE) == 60);
  CHECK(get(1, IG_TOOL_LIFE_AT_CALL) == 55);
  CHECK(get(1, IG_TOOL_USED_LIFE) == 12);
  CHECK(get(1, IG_TOOL_USED_LIFE + 1) == -1);
  for (const std::int64_t id : {2, 3}) CHECK(get(id, IG_TOOL_CORNER_RADIUS) == -1);
  CHECK(get(3, IG_TOOL_RADIUS_WEAR) == 0);
}

TEST_CASE("tool names: the tools of a name in the order of the rows, in any case of letters") {
  const FakeDependency table(*ig_plugin_v1(), "ToolOffsetTable",
                             {{"12", {{"H", 1}, {"Name", "Mill"}}},
                              {"3", {{"H", 2}}},
                              {"12.1", {{"H", 3}, {"Name", "MILL"}}},
                              {"5", {{"H", 4}, {"Name", "DRILL"}}},
                              {"8", {{"H", 5}, {"Name", "mill"}}}});
  const auto* s = table.service<ig_tool_name_1>("isogloss.tool-name/1");
  const auto all = [&](std::string_view name) {
    std::vector<std::int64_t> ids;
    for (std::int64_t id = s->find(s->self, text(name), 0); id != 0; id = s->find(s->self, text(name), id))
      ids.push_back(id);
    return ids;
  };
  const std::int64_t indexed = 12 + IG_TOOL_INDEX_STEP;
  CHECK(all("mILL") == std::vector<std::int64_t>{12, indexed, 8});
  CHECK(all("DRILL") == std::vector<std::int64_t>{5});
  CHECK(all("") == std::vector<std::int64_t>{12, indexed, 5, 8});
  CHECK(all("SAW").empty());
  CHECK(s->find(s->self, text("MILL"), 5) == 8);
  CHECK(s->find(s->self, text("MILL"), 77) == 0);
  const FakeDependency none(*ig_plugin_v1(), "ToolOffsetTable", {{"3", {{"H", 2}}}});
  const auto* n = none.service<ig_tool_name_1>("isogloss.tool-name/1");
  CHECK(n->find(n->self, text(""), 0) == 0);
}

TEST_CASE("fallback settings: a distance that is not set follows the other one") {
  const FakeDependency config(*ig_plugin_v1(), "FallbackConfig", {}, {{"HighSpeedPeckRetraction_mm", "0.5"}});
  CHECK(number(config, "isogloss.canned-cycle/1", "PeckRetractionDistance_mm") == 5);
  CHECK(number(config, "isogloss.canned-cycle/1", "HighSpeedPeckRetraction_mm") == 0.5);
  const FakeDependency shared(*ig_plugin_v1(), "FallbackConfig", {}, {{"PeckRetractionDistance_mm", "2"}});
  CHECK(number(shared, "isogloss.canned-cycle/1", "HighSpeedPeckRetraction_mm") == 2);
  CHECK(number(config, "isogloss.canned-cycle/1", "ArcRadiusTolerance_mm") == -1000);
  CHECK(number(config, "isogloss.motion/1", "ArcRadiusTolerance_mm") == 0.01);
  CHECK(config.service<ig_config_1>("isogloss.number-format/1") == nullptr);
}

TEST_CASE("settings without a parameter table: boring and tapping as a Fanuc is delivered") {
  const FakeDependency shipped(*ig_plugin_v1(), "FallbackConfig");
  const FakeDependency other(*ig_plugin_v1(), "FallbackConfig", {},
                             {{"ShiftDirectionX", "-3"},
                              {"ShiftDirectionY", "-1"},
                              {"ShiftDirectionZ", "-2"},
                              {"RigidTapping", "true"},
                              {"TappingSpindleStop", "false"},
                              {"PeckTappingToR", "true"},
                              {"PeckTappingRetraction_mm", "0.4"},
                              {"TappingExtractionOverride_percent", "150"}});
  struct Row {
    const char* key;
    double shipped, other;
  };
  const Row row = GENERATE(Row{"ShiftDirectionX", 2, -3}, Row{"ShiftDirectionY", 3, -1}, Row{"ShiftDirectionZ", 1, -2},
                           Row{"RigidTapping", 0, 1}, Row{"TappingSpindleStop", 1, 0}, Row{"PeckTappingToR", 0, 1},
                           Row{"PeckTappingRetraction_mm", 1, 0.4}, Row{"TappingExtractionOverride_percent", 100, 150});
  CAPTURE(row.key);
  CHECK(number(shipped, "isogloss.canned-cycle/1", row.key) == row.shipped);
  CHECK(number(other, "isogloss.canned-cycle/1", row.key) == row.other);
}

TEST_CASE("machine axes: an axis exists where it has a row") {
  const FakeDependency machine(
      *ig_plugin_v1(), "MachineAxes",
      {{"Z", {{"Home", 250}, {"Reference2", -50}, {"RapidRate", 18000}, {"Minimum", -500}, {"Maximum", 0}}}});
  const auto* s = machine.service<ig_machine_axis_1>("isogloss.machine-axis/1");
  double a = -1, b = -1;
  CHECK((s->home(s->self, 'Z', &a) == 1 && a == 250));
  CHECK((s->home(s->self, 'X', &a) == 1 && a == 0));
  CHECK(s->home(s->self, 'C', &a) == 0);
  CHECK((s->reference(s->self, 'Z', 1, &a) == 1 && a == 0));
  CHECK((s->reference(s->self, 'Z', 2, &a) == 1 && a == -50));
  CHECK(s->reference(s->self, 'Z', 3, &a) == 0);
  CHECK(s->reference(s->self, 'Z', 0, &a) == 0);
  CHECK(s->reference(s->self, 'Z', 5, &a) == 0);
  CHECK((s->travel(s->self, 'Z', &a, &b) == 1 && a == -500 && b == 0));
  CHECK(s->travel(s->self, 'X', &a, &b) == 0);
  CHECK((s->rapid_rate(s->self, 'Z', &a) == 1 && a == 300));
  CHECK(s->rapid_rate(s->self, 'X', &a) == 0);
}

TEST_CASE("machine axes: rotary axes tell how they turn, and a travel may have one known end") {
  const FakeDependency machine(*ig_plugin_v1(), "MachineAxes",
                               {{"A", {{"Minimum", -120}}},
                                {"B", {{"Rollover", 2}, {"Maximum", 90}}},
                                {"C", {{"Minimum", 1}, {"Maximum", 0}}},
                                {"X", {{"Maximum", 5}}}});
  const auto* s = machine.service<ig_machine_axis_1>("isogloss.machine-axis/1");
  const auto mode = [&](char axis) {
    std::uint32_t out = 9;
    return s->rollover(s->self, axis, &out) != 0 ? static_cast<int>(out) : -1;
  };
  CHECK(mode('A') == 0);
  CHECK(mode('B') == 2);
  CHECK(mode('C') == 1);
  CHECK(mode('X') == -1);
  const FakeDependency plain(*ig_plugin_v1(), "MachineAxes");
  const auto* p = plain.service<ig_machine_axis_1>("isogloss.machine-axis/1");
  std::uint32_t unused = 0;
  CHECK(p->rollover(p->self, 'A', &unused) == 0);
  double low = 0, high = 0;
  CHECK((s->travel(s->self, 'A', &low, &high) == 1 && low == -120 && high == HUGE_VAL));
  CHECK((s->travel(s->self, 'X', &low, &high) == 1 && low == -HUGE_VAL && high == 5));
  CHECK(s->travel(s->self, 'C', &low, &high) == 0);
}

TEST_CASE("machine axes: a row that names no axis is refused, not ignored") {
  for (const char* name : {"", "x", "Q", "1", "sp1", "1A", "M1", "S2", "T1", "I1", "R5", "A B"}) {
    CAPTURE(name);
    CHECK_THROWS_WITH(FakeDependency(*ig_plugin_v1(), "MachineAxes", {{name, {{"Home", 5}}}}),
                      Catch::Contains("its name is X, Y, Z, A, B or C"));
  }
  CHECK_THROWS_WITH(
      FakeDependency(*ig_plugin_v1(), "MachineAxes",
                     {{"Q1", {}}, {"Q2", {}}, {"Q3", {}}, {"Q4", {}}, {"Q5", {}}, {"Q6", {}}, {"Q7", {}}}),
      Catch::Contains("more than six axes"));
}

TEST_CASE("machine axes: programs may call an axis by further names, and further axes have numbers of their own") {
  const FakeDependency machine(*ig_plugin_v1(), "MachineAxes",
                               {{"X", {{"Names", "X1 mx1"}, {"Datum", -20.5}, {"FixedPoint2", 7}}},
                                {"C", {{"Names", "C1"}}},
                                {"U", {{"Home", 3}, {"Maximum", 50}, {"Reference3", 40}}},
                                {"VSP1", {{"Type", "rotary"}}}});
  const auto* s = machine.service<ig_axis_name_1>("isogloss.axis-name/1");
  const auto find = [&](std::string_view name) { return s->find(s->self, text(name)); };
  const auto shown = [](ig_text t) { return std::string(t.data, t.size); };
  for (const char* name : {"X", "x1", "MX1"}) {
    CAPTURE(name);
    CHECK(find(name) == 0);
  }
  CHECK(find("C1") == 5);
  CHECK(find("B") == -1);
  CHECK(find("U") == 6);
  CHECK(find("vsp1") == 7);
  CHECK((shown(s->name(s->self, 0)) == "X" && shown(s->name(s->self, 4)).empty() &&
         shown(s->name(s->self, 7)) == "VSP1"));
  CHECK(shown(s->name(s->self, 8)).empty());
  CHECK((shown(s->further_names(s->self, 0)) == "X1 MX1" && shown(s->further_names(s->self, 6)).empty()));
  CHECK((s->is_rotary(s->self, 7) == 1 && s->is_rotary(s->self, 6) == 0 && s->is_rotary(s->self, 5) == 1));
  double a = 0, b = 0;
  CHECK((s->position(s->self, 0, IG_AXIS_DATUM, &a) == 1 && a == -20.5));
  CHECK((s->position(s->self, 0, IG_AXIS_FIXED_POINT_1 + 1, &a) == 1 && a == 7));
  CHECK((s->position(s->self, 6, IG_AXIS_HOME, &a) == 1 && a == 3));
  for (const ig_axis_position which : {0u, 3u, 4u, 7u, 9u, 11u, 12u}) CHECK(s->position(s->self, 0, which, &a) == 0);
  CHECK((s->position(s->self, 6, IG_AXIS_REFERENCE_1, &a) == 1 && a == 0));
  CHECK((s->position(s->self, 6, IG_AXIS_REFERENCE_1 + 2, &a) == 1 && a == 40));
  CHECK(s->position(s->self, 99, IG_AXIS_HOME, &a) == 0);
  CHECK((s->travel(s->self, 6, &a, &b) == 1 && a == -HUGE_VAL && b == 50));
  CHECK((s->travel(s->self, 7, &a, &b) == 0 && s->travel(s->self, 99, &a, &b) == 0));
}

TEST_CASE("machine axes: a row whose names or columns have no effect is refused") {
  const FakeDependency two(*ig_plugin_v1(), "MachineAxes",
                           {{"A", {{"Names", "C1"}}}, {"C", {{"Names", "C1"}}}, {"B", {{"Names", "U"}}}, {"U", {}}});
  CHECK_THAT(two.row_fault("A"), Catch::Contains("the rows A and C both name C1"));
  CHECK_THAT(two.row_fault("C"), Catch::Contains("the rows C and A both name C1"));
  CHECK_THAT(two.row_fault("B"), Catch::Contains("is no name of an axis"));
  CHECK(two.row_fault("U").empty());
  for (const char* name : {"M1", "C", "C-1", "+C1", "S3"}) {
    CAPTURE(name);
    const FakeDependency one(*ig_plugin_v1(), "MachineAxes", {{"X", {{"Names", name}}}});
    CHECK_THAT(one.row_fault("X"), Catch::Contains("is no name of an axis"));
  }
  CHECK_THAT(FakeDependency(*ig_plugin_v1(), "MachineAxes", {{"X", {{"Type", "linear"}}}}).row_fault("X"),
             Catch::Contains("Type has no effect"));
  CHECK_THAT(FakeDependency(*ig_plugin_v1(), "MachineAxes", {{"U", {{"Type", "round"}}}}).row_fault("U"),
             Catch::Contains("linear or rotary"));
  for (const char* column :
       {"RapidRate", "Datum", "Rollover", "Retract", "FixedPoint1", "FixedPoint2", "FixedPoint3", "FixedPoint4"}) {
    CAPTURE(column);
    const FakeDependency further(*ig_plugin_v1(), "MachineAxes", {{"U", {{column, 1}}}});
    CHECK(further.row_fault("U") == column + std::string(" has no effect on a further axis: remove it"));
  }
}

TEST_CASE("machine codes: a code is found in any spelling, and its row says what it does") {
  const FakeDependency table(*ig_plugin_v1(), "MachineCodes",
                             {{"m8", {{"does", "codes"}, {"codes", "m9  G5.1"}}},
                              {"M92", {{"does", "position"}, {"position", "Z0 x-10.5"}, {"title", "park"}}},
                              {"cycl  def 392", {{"does", "call"}, {"program", "A"}, {"when", "called"}}}});
  const auto* s = table.service<ig_machine_code_1>("isogloss.machine-code/1");
  const auto find = [&](std::string_view name) { return s->find(s->self, text(name)); };
  const auto is = [](ig_text t, std::string_view expected) { return std::string_view(t.data, t.size) == expected; };
  for (const char* name : {"M8", "M08", "m008"}) {
    CAPTURE(name);
    REQUIRE(find(name) != nullptr);
    CHECK(find(name)->does == IG_CODE_ACTS);
    CHECK(is(find(name)->name, "M08"));
    CHECK(is(find(name)->codes, "M09 G05.1"));
  }
  REQUIRE(find("M92") != nullptr);
  CHECK(is(find("M92")->title, "park"));
  CHECK(find("M92")->axes == 5);
  CHECK((find("M92")->position[0] == -10.5 && find("M92")->position[2] == 0));
  REQUIRE(find("CYCL DEF 392") != nullptr);
  CHECK(is(find("CYCL DEF 392")->program, "A"));
  CHECK(find("CYCL DEF 392")->when == 2);
  CHECK(find("M80") == nullptr);
  CHECK(find("") != nullptr);
  for (const char* name : {"m8", "M92", "cycl  def 392"}) CHECK(table.row_fault(name).empty());
  const FakeDependency none(*ig_plugin_v1(), "MachineCodes");
  const auto* n = none.service<ig_machine_code_1>("isogloss.machine-code/1");
  CHECK(n->find(n->self, text("")) == nullptr);
}

TEST_CASE("machine codes: the longest family answers, and none for a name of another kind") {
  FakeDependency::Rows rows;
  for (const char* name : {"m02*", "M21*", "M*", "G5*", "CYCLE9*", "CYCLE99*", "C*", "CYCL DEF 3*", "O95*", "L9*"})
    rows[name] = {{"does", "nothing"}};
  const FakeDependency table(*ig_plugin_v1(), "MachineCodes", rows);
  const auto* s = table.service<ig_machine_code_1>("isogloss.machine-code/1");
  const auto family = [&](std::string_view name) {
    const ig_machine_code* const row = s->find_family(s->self, text(name));
    return row == nullptr ? std::string() : std::string(row->row.data, row->row.size);
  };
  for (const auto& [name, row] :
       std::initializer_list<std::pair<std::string_view, std::string_view>>{{"M20", "m02*"},
                                                                            {"M215", "M21*"},
                                                                            {"M21", "m02*"},
                                                                            {"M2", "M*"},
                                                                            {"M02", "M*"},
                                                                            {"M8", "M*"},
                                                                            {"G54.1", "G5*"},
                                                                            {"G500", "G5*"},
                                                                            {"G5", ""},
                                                                            {"G05", ""},
                                                                            {"CYCLE995", "CYCLE99*"},
                                                                            {"CYCLE99", "CYCLE9*"},
                                                                            {"CYCLE9", "C*"},
                                                                            {"CYCL DEF 39", "CYCL DEF 3*"},
                                                                            {"CYCL DEF 3", ""},
                                                                            {"CYCL DEF 4", ""},
                                                                            {"O9501", "O95*"},
                                                                            {"O95", ""},
                                                                            {"L9", ""},
                                                                            {"l9000", "L9*"},
                                                                            {"MILL", ""},
                                                                            {"M1X", ""}}) {
    CAPTURE(name);
    CHECK(family(name) == row);
  }
  CHECK(s->find(s->self, text("M215")) == nullptr);
  CHECK(s->unknown_programs == 0);
}

TEST_CASE("machine codes: a point, zeros behind it and zeros of a cycle's number do not count") {
  const FakeDependency table(*ig_plugin_v1(), "MachineCodes",
                             {{"M92.", {{"does", "nothing"}}}, {"CYCL DEF 0392", {{"does", "nothing"}}}});
  const auto* s = table.service<ig_machine_code_1>("isogloss.machine-code/1");
  for (const char* name : {"M92", "M92.", "M92.0", "CYCL DEF 392"}) CHECK(s->find(s->self, text(name)) != nullptr);
  CHECK(s->find(s->self, text("M92.5")) == nullptr);
}

TEST_CASE("machine codes: a name that no program holds, and a column without effect, are refused") {
  for (const char* name : {"92", "X5", "FOO BAR", "CYCL DEF", "CYCL DEF X", "M", "M-1", "G54.10", "M92 P5", "", "*",
                           "9*", "M9*9", "CYCL DEF *5", "FOO BAR*"}) {
    CAPTURE(name);
    CHECK_THAT(FakeDependency(*ig_plugin_v1(), "MachineCodes", {{name, {{"does", "nothing"}}}}).row_fault(name),
               Catch::Contains("its name is a code"));
  }
  for (const char* name : {"M92", "G54.1", "CYCL DEF 392", "CYCLE996", "L9000", "_N_PARK", "OEM_PARK", "O9010", "M2*",
                           "CYCLE9*", "CYCL DEF *"}) {
    CAPTURE(name);
    CHECK(FakeDependency(*ig_plugin_v1(), "MachineCodes", {{name, {{"does", "nothing"}}}}).row_fault(name).empty());
  }
  for (const char* column : {"codes", "program", "position", "text"}) {
    CAPTURE(column);
    CHECK(FakeDependency(*ig_plugin_v1(), "MachineCodes", {{"M92", {{"does", "nothing"}, {column, "M8"}}}})
              .row_fault("M92") == column + std::string(" has no effect with does=\"nothing\": remove it"));
  }
  CHECK_THAT(FakeDependency(*ig_plugin_v1(), "MachineCodes", {{"M92", {{"does", "nothing"}, {"arguments", "none"}}}})
                 .row_fault("M92"),
             Catch::Contains("only G and M codes that call"));
  CHECK_THAT(FakeDependency(*ig_plugin_v1(), "MachineCodes",
                            {{"M92", {{"does", "call"}, {"program", "1"}, {"arguments", "some"}}}})
                 .row_fault("M92"),
             Catch::Contains("none of passed, none"));
  CHECK_THAT(FakeDependency(*ig_plugin_v1(), "MachineCodes", {{"M92", {{"does", "nothing"}, {"when", "called"}}}})
                 .row_fault("M92"),
             Catch::Contains("only CYCL DEF"));
}

TEST_CASE("machine codes: a row that says nothing, or only half of it, is refused") {
  const auto refusal = [](const FakeDependency::Rows& rows, const char* reason) {
    CHECK_THAT(FakeDependency(*ig_plugin_v1(), "MachineCodes", rows).row_fault("M92"), Catch::Contains(reason));
  };
  refusal({{"M92", {{"title", "park"}}}}, "does is missing");
  refusal({{"M92", {{"does", "park"}}}}, "is none of nothing");
  refusal({{"M92", {{"does", "codes"}}}}, "needs codes");
  refusal({{"M92", {{"does", "codes"}, {"codes", "M8 X10"}}}}, "a list of G and M codes");
  refusal({{"M92", {{"does", "call"}}}}, "needs program");
  refusal({{"M92", {{"does", "refused"}}}}, "needs text");
  refusal({{"M92", {{"does", "nothing"}, {"when", "later"}}}}, "is none of defined");
  refusal({{"M92", {{"does", "nothing"}}}, {"M092", {{"does", "nothing"}}}}, "is the same code");
  refusal({{"M92", {{"does", "call"}, {"program", "  "}}}}, "needs program");
  for (const char* position : {"U5", "X", "X1 X2", "X1Y2", "Z-", "Z--5", "5"})
    refusal({{"M92", {{"does", "position"}, {"position", position}}}}, "position is each axis");
}

TEST_CASE("machine codes: fields that a row cannot set are refused with the reason") {
  const auto fault_of = [](std::string_view fields) { return iso::fields_fault(fields); };
  CHECK(fault_of("Coolant.Mode=FLOOD; Dwell.Time={P:2} s;").empty());
  CHECK(fault_of("SpindleSpeed.SpindleSpeed_rpm = 8000 1/min").empty());
  for (const char* list : {"Dwell.Time", "=5", "Dwell.Time="}) CHECK(fault_of(list).starts_with("fields is a list"));
  for (const char* none : {";", " ; "}) CHECK(fault_of(none) == "fields names no field");
  CHECK(fault_of("Dwell.Time=1;Dwell.Time=2") == "Dwell.Time stands twice in fields");
  for (const char* word : {"Dwell.Time={}", "Dwell.Time={P", "Dwell.Time={0}", "Dwell.Time={PQR}", "Dwell.Time={P5P}"})
    CHECK(fault_of(word).find("is no word of a program") != std::string::npos);
  CHECK(fault_of("SpindleSpeed.Direction=LEFT") == "SpindleSpeed.Direction=LEFT is none of CW, CCW, STOP");
  CHECK(fault_of("Dwell.Time={P:-1}") == "Dwell.Time=-1 is less than 0");
  CHECK(fault_of("Feedrate.FeedrateValue=0") == "Feedrate.FeedrateValue=0 is not greater than 0");
  CHECK(iso::canonical_fields(" Coolant.Mode = FLOOD ;Dwell.Time={P:2} s; ") == "Coolant.Mode=FLOOD; Dwell.Time={P:2}");
}
