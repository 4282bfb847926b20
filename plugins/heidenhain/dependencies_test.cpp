#include <catch2/catch.hpp>

#include "../../tests/support/fake_dependency.hpp"
#include "cycles/point_tables.hpp"
#include "frames/datum_tables.hpp"

using namespace isogloss_test;

TEST_CASE("basic rotations: a row is the number of a preset, written without leading zeros") {
  const FakeDependency table(*ig_plugin_v1(), "HeidenhainBasicRotations", {{"0", {{"SPC", 30}}}, {"12", {{"SPA", 1}}}});
  for (const char* number : {"0", "7", "12"}) {
    CAPTURE(number);
    CHECK(table.row_fault(number).empty());
  }
  for (const char* name : {"", "-1", "07", "1.5", "x"}) {
    CAPTURE(name);
    CHECK_THAT(table.row_fault(name), Catch::Contains("numbers of presets"));
  }
}

TEST_CASE("datum tables: a row keeps the name that the user wrote") {
  const FakeDependency table(*ig_plugin_v1(), "HeidenhainDatums", {{"zero.d#5", {{"X", 10}}}});
  const auto* const tables = table.service<heidenhain::DatumTables>(heidenhain::datum_table_service);
  const auto* const zero = tables->find("ZERO.D");
  REQUIRE(zero != nullptr);
  REQUIRE(zero->rows.count(5) == 1);
  CHECK(zero->rows.at(5).name == "zero.d#5");
}

TEST_CASE("point tables: a row keeps the name that the user wrote, and a second row with its number is refused") {
  const FakeDependency table(
      *ig_plugin_v1(), "HeidenhainPoints",
      {{"HOLES.PNT#5", {{"X", 10}}}, {"holes.pnt#5", {{"X", 20}}}, {"holes.pnt#6", {{"X", 30}}}});
  const auto* const tables = table.service<heidenhain::PointTables>(heidenhain::point_table_service);
  const auto* const holes = tables->find("HOLES.PNT");
  REQUIRE(holes != nullptr);
  CHECK(holes->rows.at(5).name == "HOLES.PNT#5");
  CHECK(holes->rows.at(6).name == "holes.pnt#6");
  CHECK_FALSE(holes->rows.at(6).is_faded);
  CHECK(table.row_fault("HOLES.PNT#5").empty());
  CHECK_THAT(table.row_fault("holes.pnt#5"), Catch::Contains("same table and number"));
}
