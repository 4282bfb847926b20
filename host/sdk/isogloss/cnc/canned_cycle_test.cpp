#include "isogloss/cnc/canned_cycle.hpp"

#include <catch2/catch.hpp>

using namespace ig::cnc;

namespace {

struct LevelCase {
  const char* what;
  CycleLevels given, kept;
  double initial;
  bool incremental;
  CycleLevels expected;
};

constexpr std::nullopt_t none = std::nullopt;

}  // namespace

TEST_CASE("R and Z of a cycle are positions under G90, and distances from the initial level and from R under G91") {
  const LevelCase c = GENERATE(LevelCase{"G90, both given", {5, -20}, {}, 50, false, {5, -20}},
                               LevelCase{"G90, both kept", {}, {5, -20}, 50, false, {5, -20}},
                               LevelCase{"G90, Z alone", {none, -8}, {5, -20}, 50, false, {5, -8}},
                               LevelCase{"G90, R alone leaves Z", {2, none}, {5, -20}, 50, false, {2, -20}},
                               LevelCase{"G90, nothing known", {none, -8}, {}, 50, false, {none, -8}},
                               LevelCase{"G91, R from the initial level, Z from R", {-45, -20}, {}, 50, true, {5, -15}},
                               LevelCase{"G91, upwards (back boring)", {-95, 20}, {}, 50, true, {-45, -25}},
                               LevelCase{"G91, both kept", {}, {5, -15}, 50, true, {5, -15}},
                               LevelCase{"G91, Z alone from the kept R", {none, -8}, {5, -15}, 50, true, {5, -3}},
                               LevelCase{"G91, R alone takes Z along", {-40, none}, {5, -15}, 50, true, {10, -10}},
                               LevelCase{"G91, Z without any R stays unknown", {none, -8}, {}, 50, true, {}});
  CAPTURE(c.what);
  const CycleLevels levels = resolve_levels(c.given, c.kept, c.initial, c.incremental);
  CHECK(levels.r == c.expected.r);
  CHECK(levels.bottom == c.expected.bottom);
}

TEST_CASE("the holes of a repeat lie one increment apart, and later ones are approached at the return level") {
  CycleRun run;
  run.start = {0, 0, 50};
  run.first = {10, 0, -15};
  run.increment = {10, 0, 0};
  run.count = 3;
  run.return_level = 5;
  CHECK(run.hole(0).at(run.hole(0).approach_level) == ig::Vec3{10, 0, 50});
  CHECK(run.hole(1).at(run.hole(1).approach_level) == ig::Vec3{20, 0, 5});
  CHECK(run.hole(2).at(-15) == ig::Vec3{30, 0, -15});
}

namespace {

struct PeckCase {
  const char* what;
  double r, bottom, depth;
  double number;
};

}  // namespace

TEST_CASE("a hole has the fewest pecks that reach its bottom, and none for a rest that is only rounding") {
  const PeckCase c =
      GENERATE(PeckCase{"an exact multiple", 2, -22, 8, 3}, PeckCase{"a remainder", 2, -20, 8, 3},
               PeckCase{"one stroke", 2, -20, 22, 1}, PeckCase{"deeper than the hole", 2, -20, 30, 1},
               PeckCase{"0.3 of 0.1", 0, -0.3, 0.1, 3}, PeckCase{"0.3 of 0.1, below zero", 2, 1.7, 0.1, 3},
               PeckCase{"inches", 2.54, -5.08, 25.4 * 0.1, 3}, PeckCase{"upwards", -22, 2, 8, 3},
               PeckCase{"a sliver more", 0, -24 - 1e-9, 8, 3}, PeckCase{"a sliver less", 0, -24 + 1e-9, 8, 3},
               PeckCase{"the finest increment more", 0, -24.000001, 8, 4}, PeckCase{"no depth", 5, 5, 8, 1},
               PeckCase{"many", 0, -100, 0.01, 10000});
  CAPTURE(c.what);
  CHECK(PeckStrokes(c.r, c.bottom, c.depth).number() == c.number);
}

TEST_CASE("a peck too small for the depth gives a number of pecks beyond every integer") {
  CHECK_FALSE(PeckStrokes(0, -1e300, 1e-300).number() <= 1e9);
  CHECK_FALSE(PeckStrokes(0, -1, 5e-324).number() <= 1e9);
  CHECK_FALSE(PeckStrokes(0, -1e300, 1).number() <= 1e9);
  CHECK_FALSE(PeckStrokes(1.7e308, -1.7e308, 1).number() <= 1e9);
}

TEST_CASE("shrinking pecks end at the least one") {
  const PeckStrokes inch(0.1, -0.62, 0.25, 0.05, 0.1);
  REQUIRE(inch.number() == 5);
  const double levels[] = {-0.15, -0.35, -0.5, -0.6, -0.62};
  for (int k = 1; k <= 5; ++k) CHECK(inch.level(k, 5) == Approx(levels[k - 1]));

  CHECK(PeckStrokes(0, -10, 4, 0, 4).number() == 3);
  CHECK(PeckStrokes(0, -9, 4, 1, 1).number() == 3);   // 4 3 2
  CHECK(PeckStrokes(0, -10, 4, 1, 1).number() == 4);  // 4 3 2 1
  CHECK(PeckStrokes(0, -10.5, 4, 1, 1).number() == 5);
  CHECK(PeckStrokes(0, -10, 4, 100, 2).number() == 4);  // 4 2 2 2
  CHECK(PeckStrokes(0, -1e9, 1, 1e-300, 1e-300).number() >= 1e9);
  CHECK_FALSE(PeckStrokes(0, -1e300, 1e200, 1e-200, 1).number() <= 30'000);
  CHECK_FALSE(PeckStrokes(1.7e308, -1.7e308, 2, 1, 1).number() <= 30'000);
}

TEST_CASE("each peck goes one depth further, and the last one ends at the bottom") {
  const PeckStrokes down(2, -20, 8);
  CHECK(down.level(1, 3) == -6);
  CHECK(down.level(2, 3) == -14);
  CHECK(down.level(3, 3) == -20);
  CHECK(down.above(-6, 1) == -5);

  const PeckStrokes up(-20, 2, 8);
  CHECK(up.level(1, 3) == -12);
  CHECK(up.level(3, 3) == 2);
  CHECK(up.above(-12, 1) == -13);

  const PeckStrokes fine(0, -100, 0.1);
  REQUIRE(fine.number() == 1000);
  for (int k = 1; k < 1000; ++k) REQUIRE(fine.level(k, 1000) == -0.1 * k);
  CHECK(fine.level(1000, 1000) == -100);
}
