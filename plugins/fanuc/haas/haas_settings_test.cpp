#include <catch2/catch.hpp>

#include "../../tests/support/fake_dependency.hpp"

using namespace isogloss_test;

TEST_CASE("the settings of a delivered machine have their defaults") {
  const FakeDependency table(*ig_plugin_v1(), "HaasSettings");
  CHECK(number(table, number_format, "CalculatorDecimalPoint") == 0);
  CHECK(number(table, number_format, "LengthIncrement_mm") == 0.001);
  CHECK(number(table, number_format, "LengthIncrement_inch") == 0.0001);
  CHECK(number(table, number_format, "AngleIncrement_deg") == 0.001);
  CHECK(number(table, number_format, "StartsInInch") == 0);
  CHECK(number(table, canned_cycle, "TappingExtractionOverride_percent") == 100);
  CHECK(number(table, canned_cycle, "PeckRetractionDistance_mm") == 0.508);
  CHECK(number(table, canned_cycle, "HighSpeedPeckRetraction_mm") == 0.508);
  CHECK(number(table, canned_cycle, "PeckClearanceAboveR_mm") == 0);
  CHECK(number(table, canned_cycle, "ShiftDirectionX") == 2);
  CHECK(number(table, canned_cycle, "ShiftDirectionY") == 3);
  CHECK(number(table, canned_cycle, "ShiftDirectionZ") == 1);
  CHECK(number(table, motion_settings, "ArcRadiusTolerance_mm") == 0.01);
  CHECK(number(table, motion_settings, "ScalingFactor") == -1000);
  CHECK(number(table, coordinate_system, "RotationAngle_deg") == -1000);
  CHECK(number(table, coordinate_system, "RotationIsIncremental") == 0);
  CHECK(number(table, coordinate_system, "Unknown") == -1000);
  CHECK(number(table, motion_settings, "Unknown") == -1000);
  CHECK(number(table, canned_cycle, "Unknown") == -1000);
  CHECK(number(table, number_format, "Unknown") == -1000);
}

TEST_CASE("settings in the table replace the defaults") {
  const FakeDependency table(*ig_plugin_v1(), "HaasSettings",
                             {{"9", {{"Value", 1}}},
                              {"71", {{"Value", 2}}},
                              {"72", {{"Value", -30}}},
                              {"73", {{"Value", 1}}},
                              {"22", {{"Value", -1}}},
                              {"130", {{"Value", 3}}},
                              {"27", {{"Value", 4}}},
                              {"52", {{"Value", 2.54}}},
                              {"162", {{"Value", 1}}}});
  CHECK(number(table, number_format, "CalculatorDecimalPoint") == 1);
  CHECK(number(table, number_format, "StartsInInch") == 1);
  CHECK(number(table, motion_settings, "ScalingFactor") == 2);
  CHECK(number(table, coordinate_system, "RotationAngle_deg") == -30);
  CHECK(number(table, coordinate_system, "RotationIsIncremental") == 1);
  CHECK(number(table, canned_cycle, "TappingExtractionOverride_percent") == 300);
  CHECK(number(table, canned_cycle, "PeckRetractionDistance_mm") == -1000);
  CHECK(number(table, canned_cycle, "PeckClearanceAboveR_mm") == 2.54);
  CHECK(number(table, canned_cycle, "ShiftDirectionZ") == -2);
}
