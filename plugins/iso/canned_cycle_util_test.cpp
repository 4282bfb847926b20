#include "canned_cycle_util.hpp"

#include <catch2/catch.hpp>

using namespace iso;

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

TEST_CASE("levels of a canned cycle") {
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

TEST_CASE("holes of a repeat") {
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
