#include <catch2/catch.hpp>

#include "../../tests/support/fake_dependency.hpp"

using isogloss_test::FakeDependency;

namespace {

double number(const FakeDependency& table, const char* service, std::string_view name) {
  const auto* s = table.service<ig_config_1>(service);
  double out = -1;
  return s->number(s->self, {name.data(), name.size()}, &out) != 0 ? out : -1;
}

constexpr const char* format = "isogloss.number-format/1";
constexpr const char* cycle = "isogloss.canned-cycle/1";
constexpr const char* motion = "isogloss.motion/1";

}  // namespace

TEST_CASE("a control as delivered") {
  const FakeDependency table(*ig_plugin_v1(), "FanucParameterTable");
  CHECK(number(table, format, "CalculatorDecimalPoint") == 0);
  CHECK(number(table, format, "LengthIncrement_mm") == 0.001);
  CHECK(number(table, format, "LengthIncrement_inch") == 0.0001);
  CHECK(number(table, format, "AngleIncrement_deg") == 0.001);
  CHECK(number(table, cycle, "PeckRetractionDistance_mm") == 1);
  CHECK(number(table, cycle, "HighSpeedPeckRetraction_mm") == 1);
  CHECK(number(table, motion, "ArcRadiusTolerance_mm") == 0.01);
  CHECK(number(table, motion, "Unknown") == -1);
}

TEST_CASE("bits and increments of another control") {
  const FakeDependency fine(*ig_plugin_v1(), "FanucParameterTable",
                            {{"1013", {{"Value", 2}}}, {"3401", {{"Value", 1}}}, {"5115", {{"Value", 5000}}}});
  CHECK(number(fine, format, "CalculatorDecimalPoint") == 1);
  CHECK(number(fine, format, "LengthIncrement_mm") == 0.0001);
  CHECK(number(fine, cycle, "PeckRetractionDistance_mm") == 0.5);
  const FakeDependency coarse(*ig_plugin_v1(), "FanucParameterTable",
                              {{"1013", {{"Value", 1}}}, {"3401", {{"Value", 130}}}, {"3410", {{"Value", 0}}}});
  CHECK(number(coarse, format, "CalculatorDecimalPoint") == 0);
  CHECK(number(coarse, format, "LengthIncrement_mm") == 0.01);
  CHECK(number(coarse, cycle, "HighSpeedPeckRetraction_mm") == 10);
  CHECK(number(coarse, motion, "ArcRadiusTolerance_mm") == 0);
}

TEST_CASE("axes have their own values") {
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
