#include <catch2/catch.hpp>

#include "../../tests/support/fake_dependency.hpp"

using isogloss_test::FakeDependency;

namespace {

double number(const FakeDependency& table, const char* service, std::string_view name) {
  const auto* s = table.service<ig_config_1>(service);
  double out = -1000;
  return s->number(s->self, {name.data(), name.size()}, &out) != 0 ? out : -1000;
}

constexpr const char* format = "isogloss.number-format/1";
constexpr const char* motion = "isogloss.motion/1";
constexpr const char* frame = "isogloss.coordinate-system/1";
constexpr const char* cycle = "isogloss.canned-cycle/1";

}  // namespace

TEST_CASE("settings as shipped") {
  const FakeDependency table(*ig_plugin_v1(), "HaasSettings");
  CHECK(number(table, format, "CalculatorDecimalPoint") == 0);
  CHECK(number(table, format, "LengthIncrement_mm") == 0.001);
  CHECK(number(table, format, "LengthIncrement_inch") == 0.0001);
  CHECK(number(table, format, "AngleIncrement_deg") == 0.001);
  CHECK(number(table, format, "StartsInInch") == 0);
  CHECK(number(table, cycle, "TappingExtractionOverride_percent") == 100);
  CHECK(number(table, cycle, "PeckRetractionDistance_mm") == 0.508);
  CHECK(number(table, cycle, "HighSpeedPeckRetraction_mm") == 0.508);
  CHECK(number(table, cycle, "PeckClearanceAboveR_mm") == 0);
  CHECK(number(table, cycle, "ShiftDirectionX") == 2);
  CHECK(number(table, cycle, "ShiftDirectionY") == 3);
  CHECK(number(table, cycle, "ShiftDirectionZ") == 1);
  CHECK(number(table, motion, "ArcRadiusTolerance_mm") == 0.01);
  CHECK(number(table, motion, "ScalingFactor") == -1000);
  CHECK(number(table, frame, "RotationAngle_deg") == -1000);
  CHECK(number(table, frame, "RotationIsIncremental") == 0);
  CHECK(number(table, frame, "Unknown") == -1000);
  CHECK(number(table, motion, "Unknown") == -1000);
  CHECK(number(table, cycle, "Unknown") == -1000);
  CHECK(number(table, format, "Unknown") == -1000);
}

TEST_CASE("settings of another machine") {
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
  CHECK(number(table, format, "CalculatorDecimalPoint") == 1);
  CHECK(number(table, format, "StartsInInch") == 1);
  CHECK(number(table, motion, "ScalingFactor") == 2);
  CHECK(number(table, frame, "RotationAngle_deg") == -30);
  CHECK(number(table, frame, "RotationIsIncremental") == 1);
  CHECK(number(table, cycle, "TappingExtractionOverride_percent") == 300);
  CHECK(number(table, cycle, "PeckRetractionDistance_mm") == -1000);
  CHECK(number(table, cycle, "PeckClearanceAboveR_mm") == 2.54);
  CHECK(number(table, cycle, "ShiftDirectionZ") == -2);
}
