#include "isogloss/cnc/travel_end.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

/// X from -100 to 100, Z up to 50 without a lower end; Y is not known.
struct SomeTravel {
  ig_machine_axis_1 provided{sizeof(ig_machine_axis_1), 0, this, nullptr, nullptr, &travel, nullptr, nullptr};
  BlockDocument document;

  static std::int32_t travel(void*, char axis, double* minimum, double* maximum) {
    *minimum = axis == 'X' ? -100 : -HUGE_VAL;
    *maximum = axis == 'X' ? 100 : 50;
    return axis == 'Y' ? 0 : 1;
  }
  TravelEnd end() {
    document.services["isogloss.machine-axis/1"] = &provided;
    return document.create([] { return TravelEnd(); });
  }
};

}  // namespace

TEST_CASE("the first axis that reaches its end limits the way") {
  SomeTravel machine;
  const TravelEnd end = machine.end();
  CHECK(end.way({0, 0, 20}, {0, 0, 1}) == 30.0);
  // 30 / 0.8 = 37.5 for Z, (100 - 85) / 0.6 = 25 for X.
  CHECK(end.way({0, 0, 20}, {0.6, 0, 0.8}) == Approx(37.5));
  CHECK(end.way({85, 0, 20}, {0.6, 0, 0.8}) == Approx(25));
  CHECK(end.way({0, 0, 60}, {0, 0, 1}) == 0.0);
  CHECK(end.way({40, 0, 0}, {-1, 0, 0}) == 140.0);
}

TEST_CASE("without the end of an axis that would move the way is not known") {
  SomeTravel machine;
  const TravelEnd end = machine.end();
  CHECK_FALSE(end.way({0, 0, 0}, {0, 0, -1}).has_value());
  CHECK_FALSE(end.way({0, 0, 0}, {0, 0.6, 0.8}).has_value());
  CHECK_FALSE(end.way({0, 0, 0}, {0, 0, 0}).has_value());
  BlockDocument document;
  CHECK_FALSE(document.create([] { return TravelEnd(); }).way({0, 0, 0}, {0, 0, 1}).has_value());
}
