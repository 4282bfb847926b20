#include "isogloss/cnc/hole_layout.hpp"

#include <catch2/catch.hpp>

using namespace ig::cnc;

namespace {

bool lies_at(const Point2& p, double u, double v) { return std::fabs(p.u - u) < 1e-12 && std::fabs(p.v - v) < 1e-12; }

}  // namespace

TEST_CASE("a hole of a circle lies at the radius in the direction from the centre") {
  CHECK(lies_at(hole_towards({10, 20}, 5, Turn::by(90)), 10, 25));
  CHECK(lies_at(hole_towards({10, 20}, 10, Turn::by(210)), 10 - 5 * std::sqrt(3.0), 15));
  CHECK(lies_at(hole_towards({10, 20}, -5, Turn::by(90)), 10, 15));  // a negative distance leads away
}

TEST_CASE("the rows of a grid turn with its angle") {
  const HoleGrid grid{{1, 2}, Turn::by(90), Turn::by(90), 10, 4};
  CHECK(lies_at(grid.at(0, 0), 1, 2));
  CHECK(lies_at(grid.at(3, 0), 1, 32));
  CHECK(lies_at(grid.at(0, 2), -7, 2));
  CHECK(lies_at(grid.at(3, 2), -7, 32));
}

TEST_CASE("a grid is sheared where rows and columns have directions of their own") {
  const HoleGrid grid{{0, 0}, Turn::by(0), Turn::by(-45), 10, std::sqrt(2.0)};
  CHECK(lies_at(grid.at(0, 1), 1, 1));
  CHECK(lies_at(grid.at(2, 3), 23, 3));
}

TEST_CASE("rows run in alternating direction") {
  CHECK(alternating_column(0, 0, 4) == 0);
  CHECK(alternating_column(1, 0, 4) == 3);
  CHECK(alternating_column(1, 3, 4) == 0);
  CHECK(alternating_column(2, 1, 4) == 1);
  CHECK(alternating_column(1, 0, 1) == 0);
}
