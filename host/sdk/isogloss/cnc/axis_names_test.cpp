#include "isogloss/cnc/axis_names.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

/// C is called C1, too, and the machine has a further axis U.
struct NamedAxes {
  ig_axis_name_1 provided{sizeof(ig_axis_name_1), 0, this, &find, &name, &further, &is_rotary, &position, &travel};
  BlockDocument document;

  static std::int32_t find(void*, ig_text name) {
    return ig::to_view(name) == "C1" ? 5 : ig::to_view(name) == "U" ? 6 : -1;
  }
  static ig_text name(void*, std::uint32_t axis) { return ig::to_text(axis == 6 ? std::string_view("U") : ""); }
  static ig_text further(void*, std::uint32_t axis) { return ig::to_text(axis == 5 ? std::string_view("C1") : ""); }
  static std::int32_t is_rotary(void*, std::uint32_t axis) { return axis == 5 ? 1 : 0; }
  static std::int32_t position(void*, std::uint32_t axis, ig_axis_position which, double* out) {
    *out = 12.5;
    return axis == 2 && which == IG_AXIS_DATUM ? 1 : 0;
  }
  static std::int32_t travel(void*, std::uint32_t axis, double* minimum, double* maximum) {
    *minimum = -5;
    *maximum = 7;
    return axis == 6 ? 1 : 0;
  }
  AxisNames names() {
    document.services["isogloss.axis-name/1"] = &provided;
    return document.create([] { return AxisNames(); });
  }
};

}  // namespace

TEST_CASE("an axis is found by its letter and by the name that the machine gives it") {
  NamedAxes machine;
  const AxisNames names = machine.names();
  CHECK(names.find("X") == 0u);
  CHECK(names.find("C1") == 5u);
  CHECK(names.find("U") == 6u);
  CHECK_FALSE(names.find("B1").has_value());
  CHECK_FALSE(names.find("").has_value());
  CHECK(names.letter_of("C1") == "C");
  CHECK(names.letter_of("U") == "U");
  CHECK(names.letter_of("B1") == "B1");
  CHECK(names.name(6) == "U");
  CHECK(names.further_names(5) == "C1");
  CHECK(names.is_rotary(5));
}

TEST_CASE("positions and travel are known only where the machine gives them") {
  NamedAxes machine;
  const AxisNames names = machine.names();
  CHECK(names.position(2, IG_AXIS_DATUM) == 12.5);
  CHECK_FALSE(names.position(2, IG_AXIS_RETRACT).has_value());
  REQUIRE(names.travel(6).has_value());
  CHECK((names.travel(6)->minimum == -5 && names.travel(6)->maximum == 7));
  CHECK_FALSE(names.travel(0).has_value());
}

TEST_CASE("without a table of axes each is called by its letter") {
  BlockDocument document;
  const auto names = document.create([] { return AxisNames(); });
  CHECK(names.find("C") == 5u);
  CHECK_FALSE(names.find("C1").has_value());
  CHECK_FALSE(names.position(0, IG_AXIS_HOME).has_value());
  CHECK_FALSE(names.travel(0).has_value());
  CHECK((names.name(0).empty() && names.further_names(5).empty()));
  CHECK_FALSE(names.is_rotary(5));
}
