#include <catch2/catch.hpp>

#include "../../tests/support/fake_dependency.hpp"

using namespace isogloss_test;

TEST_CASE("a control as delivered has the default parameters") {
  const FakeDependency table(*ig_plugin_v1(), "FanucParameterTable");
  CHECK(number(table, number_format, "CalculatorDecimalPoint") == 0);
  CHECK(number(table, number_format, "LengthIncrement_mm") == 0.001);
  CHECK(number(table, number_format, "LengthIncrement_inch") == 0.0001);
  CHECK(number(table, number_format, "AngleIncrement_deg") == 0.001);
  CHECK(number(table, number_format, "FeedIncrement_mm") == 1);
  CHECK(number(table, number_format, "FeedIncrement_inch") == 0.01);
  CHECK(number(table, number_format, "RevolutionFeedIncrement_mm") == 0.01);
  CHECK(number(table, number_format, "RevolutionFeedIncrement_inch") == 0.0001);
  CHECK(number(table, canned_cycle, "PeckRetractionDistance_mm") == 1);
  CHECK(number(table, canned_cycle, "HighSpeedPeckRetraction_mm") == 1);
  CHECK(number(table, canned_cycle, "BoringReturnOverride_percent") == 100);
  CHECK(number(table, motion_settings, "ArcRadiusTolerance_mm") == 0.01);
  CHECK(number(table, motion_settings, "HelixFeedAlongPath") == 0);
  CHECK(number(table, motion_settings, "ScalingUnit") == 0.001);
  CHECK(number(table, motion_settings, "ScalingFactor") == -1000);
  CHECK(number(table, motion_settings, "Unknown") == -1000);
}

TEST_CASE("bits and increments in the table replace the defaults") {
  const FakeDependency fine(*ig_plugin_v1(), "FanucParameterTable",
                            {{"1013", {{"Value", 2}}},
                             {"1403", {{"Value", 33}}},
                             {"1405", {{"Value", 2}}},
                             {"3401", {{"Value", 1}}},
                             {"5115", {{"Value", 5000}}}});
  CHECK(number(fine, number_format, "FeedIncrement_mm") == 0.001);
  CHECK(number(fine, number_format, "FeedIncrement_inch") == 0.00001);
  CHECK(number(fine, motion_settings, "HelixFeedAlongPath") == 1);
  CHECK(number(fine, number_format, "RevolutionFeedIncrement_mm") == 0.001);
  CHECK(number(fine, number_format, "RevolutionFeedIncrement_inch") == 0.00001);
  CHECK(number(fine, number_format, "CalculatorDecimalPoint") == 1);
  CHECK(number(fine, number_format, "LengthIncrement_mm") == 0.0001);
  CHECK(number(fine, canned_cycle, "PeckRetractionDistance_mm") == 0.5);
  const FakeDependency coarse(*ig_plugin_v1(), "FanucParameterTable",
                              {{"1013", {{"Value", 1}}},
                               {"3401", {{"Value", 130}}},
                               {"3410", {{"Value", 0}}},
                               {"5149", {{"Value", 200}}},
                               {"5400", {{"Value", 1}}},
                               {"5440", {{"Y", -50}}},
                               {"5411", {{"Value", 50000}}}});
  CHECK(number(coarse, motion_settings, "ScalingUnit") == 0.00001);
  CHECK(number(coarse, motion_settings, "ScalingFactor") == 0.5);
  CHECK(number(coarse, motion_settings, "UnidirectionalOverrunY_mm") == -0.5);
  CHECK(number(coarse, motion_settings, "UnidirectionalOverrunX_mm") == -1000);
  CHECK(number(coarse, number_format, "CalculatorDecimalPoint") == 0);
  CHECK(number(coarse, number_format, "LengthIncrement_mm") == 0.01);
  CHECK(number(coarse, canned_cycle, "HighSpeedPeckRetraction_mm") == 10);
  CHECK(number(coarse, canned_cycle, "BoringReturnOverride_percent") == 200);
  CHECK(number(coarse, motion_settings, "ArcRadiusTolerance_mm") == 0);
}

TEST_CASE("a parameter assigns a code to the program that it calls") {
  const char* const calls = "isogloss.code-call/1";
  const FakeDependency table(*ig_plugin_v1(), "FanucParameterTable",
                             {{"6050", {{"Value", 100}}},
                              {"6051", {{"Value", -101}}},
                              {"6059", {{"Value", 65.5}}},
                              {"6071", {{"Value", 6}}},
                              {"6072", {{"Value", 0}}},
                              {"6081", {{"Value", 80}}},
                              {"6082", {{"Value", -81}}}});
  CHECK(number(table, calls, "M81") == -1000);
  CHECK(number(table, calls, "G100") == 9010);
  CHECK(number(table, calls, "G101") == -9011);
  CHECK(number(table, calls, "G65.5") == 9019);
  CHECK(number(table, calls, "M06") == 9001);
  CHECK(number(table, calls, "M80") == 9021);
  CHECK(number(table, calls, "M100") == -1000);
  CHECK(number(table, calls, "M00") == -1000);
  CHECK(number(table, calls, "G") == -1000);
  CHECK(number(table, calls, "T") == -1000);
  const FakeDependency tools(*ig_plugin_v1(), "FanucParameterTable", {{"6001", {{"Value", 32}}}});
  CHECK(number(tools, calls, "T") == 9000);
}

TEST_CASE("boring and tapping of a control as delivered have their defaults") {
  const FakeDependency table(*ig_plugin_v1(), "FanucParameterTable");
  CHECK(number(table, canned_cycle, "ShiftDirectionX") == 2);
  CHECK(number(table, canned_cycle, "ShiftDirectionY") == 3);
  CHECK(number(table, canned_cycle, "ShiftDirectionZ") == 1);
  CHECK(number(table, canned_cycle, "TappingSpindleStop") == 1);
  CHECK(number(table, canned_cycle, "RigidTapping") == 0);
  CHECK(number(table, canned_cycle, "PeckTappingToR") == 0);
  CHECK(number(table, canned_cycle, "PeckTappingRetraction_mm") == 1);
  CHECK(number(table, canned_cycle, "TappingExtractionOverride_percent") == -1000);
}

TEST_CASE("5148 of the boring axis gives the direction of a shift before 5101") {
  const auto with = [](double bits) {
    return FakeDependency::Rows{{"5101", {{"Value", bits}}}, {"5148", {{"X", 0}, {"Y", -1}}}};
  };
  const FakeDependency minus_x(*ig_plugin_v1(), "FanucParameterTable", with(16));
  CHECK(number(minus_x, canned_cycle, "ShiftDirectionZ") == -1);
  CHECK(number(minus_x, canned_cycle, "ShiftDirectionX") == -2);
  CHECK(number(minus_x, canned_cycle, "ShiftDirectionY") == -1);
  const FakeDependency plus_y(*ig_plugin_v1(), "FanucParameterTable", with(32));
  CHECK(number(plus_y, canned_cycle, "ShiftDirectionZ") == 2);
  CHECK(number(plus_y, canned_cycle, "ShiftDirectionX") == 3);
  const FakeDependency minus_y(*ig_plugin_v1(), "FanucParameterTable", {{"5101", {{"Value", 48}}}});
  CHECK(number(minus_y, canned_cycle, "ShiftDirectionZ") == -2);
  CHECK(number(minus_y, canned_cycle, "ShiftDirectionY") == -1);
}

TEST_CASE("each bit of tapping has its own answer") {
  const FakeDependency table(*ig_plugin_v1(), "FanucParameterTable",
                             {{"5101", {{"Value", 64}}},
                              {"5200", {{"Value", 1 + 16 + 32}}},
                              {"5211", {{"Value", 150}}},
                              {"5213", {{"Value", 500}}}});
  CHECK(number(table, canned_cycle, "TappingSpindleStop") == 0);
  CHECK(number(table, canned_cycle, "RigidTapping") == 1);
  CHECK(number(table, canned_cycle, "PeckTappingToR") == 1);
  CHECK(number(table, canned_cycle, "PeckTappingRetraction_mm") == 0.5);
  CHECK(number(table, canned_cycle, "TappingExtractionOverride_percent") == 150);
}

TEST_CASE("each axis has values of its own") {
  const FakeDependency table(
      *ig_plugin_v1(), "FanucParameterTable",
      {{"1240", {{"Z", 350}, {"C", 90}}}, {"1241", {{"Z", 100}}}, {"1320", {{"X", 10}}}, {"1321", {{"X", -800}}}});
  const auto* s = table.service<ig_machine_axis_1>("isogloss.machine-axis/1");
  double a = -1, b = -1;
  CHECK((s->home(s->self, 'Z', &a) == 1 && a == 350));
  CHECK((s->home(s->self, 'X', &a) == 1 && a == 0));
  CHECK((s->reference(s->self, 'C', 1, &a) == 1 && a == 90));
  CHECK(s->home(s->self, 'A', &a) == 0);
  CHECK(s->home(s->self, 'Q', &a) == 0);
  CHECK((s->reference(s->self, 'Z', 2, &a) == 1 && a == 100));
  CHECK(s->reference(s->self, 'X', 2, &a) == 0);
  CHECK(s->reference(s->self, 'X', 0, &a) == 0);
  CHECK((s->travel(s->self, 'X', &a, &b) == 1 && a == -800 && b == 10));
  CHECK(s->travel(s->self, 'Y', &a, &b) == 0);
  CHECK((s->rapid_rate(s->self, 'Y', &a) == 1 && a == 400));
  CHECK(s->rapid_rate(s->self, 'C', &a) == 0);
}

TEST_CASE("the bits of coordinate systems and the angle of a rotation are read") {
  const FakeDependency shipped(*ig_plugin_v1(), "FanucParameterTable");
  CHECK(number(shipped, coordinate_system, "RotationAngle_deg") == 0);
  CHECK(number(shipped, coordinate_system, "RotationIsIncremental") == 0);
  CHECK(number(shipped, coordinate_system, "ResetCancelsLocalCoordinate") == 0);
  CHECK(number(shipped, coordinate_system, "Unknown") == -1000);
  const FakeDependency set(*ig_plugin_v1(), "FanucParameterTable",
                           {{"1202", {{"Value", 8}}}, {"5400", {{"Value", 1}}}, {"5410", {{"Value", 30000}}}});
  CHECK(number(set, coordinate_system, "RotationAngle_deg") == 30);
  CHECK(number(set, coordinate_system, "RotationIsIncremental") == 1);
  CHECK(number(set, coordinate_system, "ResetCancelsLocalCoordinate") == 1);
}

TEST_CASE("type, rollover and direction bits decide how a rotary axis turns") {
  const auto mode = [](const FakeDependency::Rows& rows) {
    const FakeDependency table(*ig_plugin_v1(), "FanucParameterTable", rows);
    const auto* s = table.service<ig_machine_axis_1>("isogloss.machine-axis/1");
    std::uint32_t out = 9;
    return s->rollover(s->self, 'C', &out) != 0 ? static_cast<int>(out) : -1;
  };
  const auto rows = [](double type, double bits) {
    return FakeDependency::Rows{{"1006", {{"C", type}}}, {"1008", {{"C", bits}}}};
  };
  CHECK(mode({}) == -1);
  CHECK(mode({{"1240", {{"C", 0}}}}) == -1);
  CHECK(mode(rows(1, 0)) == 0);
  CHECK(mode(rows(1, 1)) == 1);
  CHECK(mode(rows(1, 3)) == 2);
  CHECK(mode(rows(1, 5)) == 1);  // bit 2 is for the relative display
  CHECK(mode(rows(3, 1)) == 0);  // type B
  CHECK(mode(rows(0, 1)) == 0);  // a linear axis
  CHECK(mode({{"1008", {{"C", 1}}}}) == 1);
  const FakeDependency table(*ig_plugin_v1(), "FanucParameterTable", rows(1, 1));
  const auto* s = table.service<ig_machine_axis_1>("isogloss.machine-axis/1");
  std::uint32_t out = 9;
  CHECK(s->rollover(s->self, 'X', &out) == 0);
  CHECK(s->rollover(s->self, 'A', &out) == 0);
}

TEST_CASE("limits in the wrong order are no limits") {
  const FakeDependency table(*ig_plugin_v1(), "FanucParameterTable", {{"1320", {{"X", -10}}}, {"1321", {{"X", 10}}}});
  const auto* s = table.service<ig_machine_axis_1>("isogloss.machine-axis/1");
  double low = 0, high = 0;
  CHECK(s->travel(s->self, 'X', &low, &high) == 0);
}
