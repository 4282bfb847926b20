#include "isogloss/cnc/arc.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

using namespace ig::cnc;

namespace {

constexpr double degree = std::numbers::pi / 180;

struct RadiusCase {
  const char* block;
  bool is_ccw;
  double radius, center_v, sweep_deg;
};

}  // namespace

// From X0 Y0 to X50 Y0 with radius 30: the worked table of the Fanuc manual's four arcs.
TEST_CASE("R gives the centre of each of the manual's four arcs") {
  const RadiusCase c = GENERATE(RadiusCase{"G02 X50. R30.", false, 30, -16.583123951777, -112.885380476162},
                                RadiusCase{"G02 X50. R-30.", false, -30, 16.583123951777, -247.114619523838},
                                RadiusCase{"G03 X50. R30.", true, 30, 16.583123951777, 112.885380476162},
                                RadiusCase{"G03 X50. R-30.", true, -30, -16.583123951777, 247.114619523838});
  CAPTURE(c.block);
  const Point2 start{0, 0}, end{50, 0};
  const Point2 center = center_by_radius(start, end, c.radius, c.is_ccw);
  CHECK(center.u == Approx(25));
  CHECK(center.v == Approx(c.center_v));
  CHECK(sweep(start, end, center, c.is_ccw) / degree == Approx(c.sweep_deg));
}

TEST_CASE("a radius without sensible bounds gives a centre that is a number") {
  for (const double radius : {1e200, -1e308}) {
    const Point2 center = center_by_radius({0, 0}, {30, 40}, radius, true);
    CHECK(std::isfinite(center.u));
    CHECK(std::hypot(center.u / radius, center.v / radius) == Approx(1));
  }
}

TEST_CASE("a radius too short for the chord is replaced by half the chord") {
  const Point2 start{0, 0}, end{30, 40};
  CHECK(radius_shortfall(start, end, 20) == Approx(5));
  CHECK(radius_shortfall(start, end, -20) == Approx(5));
  CHECK(radius_shortfall(start, end, 30) == Approx(-5));
  const Point2 center = center_by_radius(start, end, 20, true);
  CHECK(center.u == Approx(15));
  CHECK(center.v == Approx(20));
}

TEST_CASE("the centre has the distance R from both ends in every direction") {
  for (int i = 0; i < 36; ++i) {
    const double angle = i * 10 * degree;
    const Point2 start{3, -7}, end{start.u + 20 * std::cos(angle), start.v + 20 * std::sin(angle)};
    for (const double radius : {11.0, -11.0, 100.0, -100.0})
      for (const bool is_ccw : {false, true}) {
        CAPTURE(i, radius, is_ccw);
        const Point2 center = center_by_radius(start, end, radius, is_ccw);
        CHECK((start - center).length() == Approx(std::fabs(radius)));
        CHECK((end - center).length() == Approx(std::fabs(radius)));
        const double turn = sweep(start, end, center, is_ccw);
        CHECK((turn > 0) == is_ccw);
        CHECK((std::fabs(turn) > std::numbers::pi) == (radius < 0));
      }
  }
}

TEST_CASE("an arc that ends where it starts is a whole circle, and a rise makes its path longer") {
  const Point2 start{20, 0}, center{0, 0};
  CHECK(sweep(start, start, center, true) == Approx(2 * std::numbers::pi));
  CHECK(sweep(start, start, center, false) == Approx(-2 * std::numbers::pi));
  CHECK(arc_length(start, start, center, true, 0) == Approx(125.66370614));
  CHECK(arc_length(start, start, center, true, -5) == Approx(std::sqrt(125.66370614 * 125.66370614 + 25)));
  CHECK(arc_length({10, 0}, {0, 12}, center, true, 0) == Approx(11 * std::numbers::pi / 2));
}

TEST_CASE("an arc whose ends lie in one direction from the centre is a whole circle, whatever rounding makes of it") {
  const Point2 center{100, -9};
  for (const double rounding : {-1e-14, 0.0, 1e-14, 1e-9})
    for (const bool is_ccw : {true, false}) {
      CAPTURE(rounding, is_ccw);
      const double turn = sweep({100, 1}, {100 + rounding, 0}, center, is_ccw);
      CHECK(turn / degree == Approx(is_ccw ? 360 : -360));
    }
  CHECK(sweep({100, 1}, {100 - 1e-5, 0}, center, true) / degree == Approx(6.37e-5).epsilon(1e-3));
}

TEST_CASE("a sweep of a quarter turn has the sign of its direction") {
  const Point2 e{1, 0}, n{0, 1}, center{0, 0};
  CHECK(sweep(e, n, center, true) / degree == Approx(90));
  CHECK(sweep(e, n, center, false) / degree == Approx(-270));
  CHECK(sweep(n, e, center, false) / degree == Approx(-90));
  CHECK(sweep(n, e, center, true) / degree == Approx(270));
  CHECK(sweep(e, {-1, 0}, center, true) / degree == Approx(180));
  CHECK(sweep(e, {-1, 0}, center, false) / degree == Approx(-180));
}

TEST_CASE("the turning points of a coordinate are the extremes of samples along the arc") {
  for (int i = 0; i < 200; ++i) {
    const double a = 0.37 * i, b = a + 0.05 + 0.031 * i;
    const bool is_ccw = i % 2 == 0;
    const Point2 center{3, -4}, start{3 + 10 * std::cos(a), -4 + 10 * std::sin(a)},
        end{3 + 10 * std::cos(b), -4 + 10 * std::sin(b)};
    const ArcCoordinate along{7, std::cos(i), std::sin(i), i % 3 == 0 ? 0.0 : i - 100.0};
    CAPTURE(i);
    const double turn = sweep(start, end, center, is_ccw);
    const auto value = [&](double part) {
      const double angle = a + part * turn;
      return along.from + 10 * (along.first * std::cos(angle) + along.second * std::sin(angle)) + part * along.rise;
    };
    double low = std::min(value(0), value(1)), high = std::max(value(0), value(1)), seen_low = low, seen_high = high;
    visit_turning_points(along, start, end, center, is_ccw, [&](double at) {
      low = std::min(low, at);
      high = std::max(high, at);
    });
    for (int k = 1; k < 5000; ++k) {
      seen_low = std::min(seen_low, value(k / 5000.0));
      seen_high = std::max(seen_high, value(k / 5000.0));
    }
    CHECK(low == Approx(seen_low).margin(1e-4));
    CHECK(high == Approx(seen_high).margin(1e-4));
  }
}
