#include <catch2/catch.hpp>

#include "../../tests/support/fake_dependency.hpp"

using namespace isogloss_test;

namespace {

constexpr const char* macro = "isogloss.code-call/1";

constexpr const char* table_id = "SyntecParameterTable";
FakeDependency with(const FakeDependency::Rows& rows, std::map<std::string, std::string> options = {}) {
  return FakeDependency(*ig_plugin_v1(), table_id, rows, std::move(options));
}

}  // namespace

TEST_CASE("a control as delivered has the default parameters") {
  const FakeDependency table = with({});
  CHECK(number(table, number_format, "CalculatorDecimalPoint") == 0);
  CHECK(number(table, number_format, "LengthIncrement_mm") == 0.001);
  CHECK(number(table, number_format, "LengthIncrement_inch") == 0.0001);
  CHECK(number(table, number_format, "AngleIncrement_deg") == 0.001);
  CHECK(number(table, number_format, "Unknown") == -1000);
  CHECK(number(table, canned_cycle, "PeckRetractionDistance_mm") == 1);
  CHECK(number(table, canned_cycle, "HighSpeedPeckRetraction_mm") == 1);
  CHECK(number(table, canned_cycle, "PeckTappingRetraction_mm") == 1);
  CHECK(number(table, canned_cycle, "Unknown") == -1000);
  CHECK(number(table, motion_settings, "ArcRadiusTolerance_mm") == 0.01);
  CHECK(number(table, motion_settings, "RadiusCompensationStartUp") == 0);
  CHECK(number(table, motion_settings, "MaximumSpindleSpeed_rpm") == -1000);
  CHECK(number(table, motion_settings, "Unknown") == -1000);
  for (const char* const code : {"T", "M123", "G00", "G81", "G199.9", "G1000", "G", "GX", "G2000"})
    CHECK(number(table, macro, code) == -1000);
}

TEST_CASE("Pr4002 is one distance in basic length units for all cycles") {
  CHECK(number(with({{"4002", {{"Value", 2000}}}}), canned_cycle, "PeckRetractionDistance_mm") == 2);
  CHECK(number(with({{"4002", {{"Value", 2000}}}}), canned_cycle, "HighSpeedPeckRetraction_mm") == 2);
  const FakeDependency::Rows coarse{{"4002", {{"Value", 50}}}, {"17", {{"Value", 1}}}};
  const FakeDependency::Rows fine{{"4002", {{"Value", 500}}}, {"17", {{"Value", 3}}}};
  CHECK(number(with(coarse), canned_cycle, "PeckRetractionDistance_mm") == 0.5);
  CHECK(number(with(fine), canned_cycle, "PeckRetractionDistance_mm") == 0.05);
  CHECK(number(with(coarse, {{"pr4002-unit", "micron"}}), canned_cycle, "PeckRetractionDistance_mm") == 0.05);
  CHECK(number(with({{"4002", {{"Value", 0}}}}), canned_cycle, "PeckRetractionDistance_mm") == 0);
}

TEST_CASE("Pr17 and Pr3241 decide what a number without a point means") {
  const FakeDependency fine = with({{"17", {{"Value", 3}}}, {"3241", {{"Value", 1}}}});
  CHECK(number(fine, number_format, "LengthIncrement_mm") == 0.0001);
  CHECK(number(fine, number_format, "LengthIncrement_inch") == 0.00001);
  CHECK(number(fine, number_format, "CalculatorDecimalPoint") == 1);
  CHECK(number(with({{"17", {{"Value", 1}}}}), number_format, "LengthIncrement_mm") == 0.01);
}

TEST_CASE("Pr5003 and Pr3741 are read from the table") {
  const FakeDependency table = with({{"5003", {{"Value", 1}}}, {"3741", {{"Value", 12000}}}});
  CHECK(number(table, motion_settings, "RadiusCompensationStartUp") == 1);
  CHECK(number(table, motion_settings, "MaximumSpindleSpeed_rpm") == 12000);
  CHECK(number(with({{"5003", {{"Value", 2}}}}), motion_settings, "RadiusCompensationStartUp") == 0);
  CHECK(number(with({{"5003", {{"Value", 3}}}}), motion_settings, "RadiusCompensationStartUp") == 1);
  CHECK(number(with({{"5003", {{"Value", 1e300}}}}), motion_settings, "RadiusCompensationStartUp") == 0);
  CHECK(number(with({{"5003", {{"Value", -1}}}}), motion_settings, "RadiusCompensationStartUp") == 0);
}

TEST_CASE("a value that a parameter cannot have is refused, not ignored") {
  const auto why = [](const FakeDependency::Rows& rows) -> std::string {
    try {
      with(rows);
    } catch (const std::exception& e) {
      return e.what();
    }
    return "taken";
  };
  using Catch::Matchers::Contains;
  for (const double precision : {0.0, 4.0, 2.5, -1.0, 1e300})
    CHECK_THAT(why({{"17", {{"Value", precision}}}}), Contains("parameter '17': it is 1, 2 or 3"));
  CHECK_THAT(why({{"4002", {{"Value", -1}}}}), Contains("parameter '4002': it is 0 or more"));
  CHECK_THAT(why({{"3741", {{"Value", -1}}}}), Contains("parameter '3741': it is 0 or more"));
  CHECK_THAT(why({{"1420", {{"Y", -1}}}}), Contains("parameter '1420': a rapid rate is 0 or more"));
  for (const char* const of_axes : {"1006", "1020", "1240", "1243", "1320", "1321", "1420"})
    CHECK_THAT(why({{of_axes, {{"Value", 1}}}}), Contains("not Value"));
  for (const char* const one : {"17", "3215", "3241", "3601", "3610", "3701", "3710", "3741", "4002", "5003"})
    CHECK_THAT(why({{one, {{"Z", 1}}}}), Contains("not Z"));
  for (const char* const name : {"Pr17", ""})
    CHECK_THAT(why({{name, {{"Value", 1}}}}), Contains("its name is the number of a parameter"));
  CHECK(why({{"9999", {{"Value", -1}, {"X", -1}}}, {"1244", {{"Value", 1}}}}) == "taken");
}

TEST_CASE("a code answers with the number of the macro that it calls") {
  CHECK(number(with({}), macro, "G200") == 200);
  CHECK(number(with({}), macro, "G200.1") == 200);
  CHECK(number(with({}), macro, "G999") == 999);
  CHECK(number(with({}), macro, "G68.18") == 0);
  const FakeDependency table = with({{"3215", {{"Value", 2}}},
                                     {"3601", {{"Value", 6}}},
                                     {"3610", {{"Value", 123}}},
                                     {"3701", {{"Value", -1}}},
                                     {"3702", {{"Value", 4}}},
                                     {"3703", {{"Value", 14}}}});
  CHECK(number(table, macro, "T") == 0);
  CHECK(number(table, macro, "M06") == 6);
  CHECK(number(table, macro, "M123") == 123);
  CHECK(number(table, macro, "M00") == -1000);
  CHECK(number(table, macro, "G00") == 0);
  CHECK(number(table, macro, "G53") == 53);
  CHECK(number(table, macro, "G53.1") == -1000);
  CHECK(number(table, macro, "G01") == -1000);
}

TEST_CASE("each axis of the machine answers with its own parameters") {
  const FakeDependency table = with({{"1240", {{"Z", 350}, {"A", 0}}},
                                     {"1420", {{"X", 30000}}},
                                     {"1006", {{"A", 1}, {"B", 2}, {"C", 0}}},
                                     {"1320", {{"X", 500}}},
                                     {"1321", {{"X", -10}}}});
  const auto* axis = table.service<ig_machine_axis_1>("isogloss.machine-axis/1");
  double at = 1, high = 1;
  REQUIRE(axis->home(axis->self, 'Z', &at) == 1);
  CHECK(at == 350);
  CHECK(axis->home(axis->self, 'A', &at) == 1);
  CHECK(axis->home(axis->self, 'B', &at) == 0);
  CHECK(axis->reference(axis->self, 'Z', 2, &at) == 0);
  CHECK(axis->reference(axis->self, 'Z', 0, &at) == 0);
  CHECK(axis->reference(axis->self, 'Z', 5, &at) == 0);
  REQUIRE(axis->rapid_rate(axis->self, 'X', &at) == 1);
  CHECK(at == 500);
  CHECK(axis->rapid_rate(axis->self, 'B', &at) == 0);
  REQUIRE(axis->travel(axis->self, 'X', &at, &high) == 1);
  CHECK(at == -10);
  CHECK(high == 500);
  CHECK(axis->travel(axis->self, 'Y', &at, &high) == 0);
  std::uint32_t mode = 9;
  REQUIRE(axis->rollover(axis->self, 'A', &mode) == 1);
  CHECK(mode == 1);
  REQUIRE(axis->rollover(axis->self, 'B', &mode) == 1);
  CHECK(mode == 2);
  REQUIRE(axis->rollover(axis->self, 'C', &mode) == 1);
  CHECK(mode == 0);
  CHECK(axis->rollover(axis->self, 'X', &mode) == 0);
}

TEST_CASE("Pr1020 names the axis of a column") {
  const FakeDependency table = with({{"1020", {{"A", 67}, {"C", 200}}}, {"1240", {{"A", 90}, {"Y", 7}, {"C", 8}}}});
  const auto* axis = table.service<ig_machine_axis_1>("isogloss.machine-axis/1");
  double at = 1;
  REQUIRE(axis->home(axis->self, 'C', &at) == 1);
  CHECK(at == 90);
  CHECK(axis->home(axis->self, 'A', &at) == 0);
  REQUIRE(axis->home(axis->self, 'Y', &at) == 1);  // column Y comes before column C
  CHECK(at == 7);
  CHECK(axis->home(axis->self, '?', &at) == 0);
}
