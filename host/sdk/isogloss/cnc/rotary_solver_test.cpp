#include "isogloss/cnc/rotary_solver.hpp"

#include "isogloss/cnc/five_axis_test.hpp"

using namespace ig::cnc;

namespace {

ig_rotary_solution solution(double b, double c, std::uint32_t free = 0) { return {{0, b, c}, free, 0}; }

}  // namespace

TEST_CASE("each solution is in the turn nearest to the present angles, and an undetermined axis stays") {
  HeadAndTable machine;
  machine.solutions = {solution(30, 10), solution(-30, 123, 4)};
  const FiveAxisProgram p(machine);
  const RotaryCandidates found = p.solver.candidates(p.kinematics, {0, 0, 1}, {7, 0, 350});
  REQUIRE(found.count == 2);
  CHECK(found.is_reachable);
  CHECK(found.angles[0] == Angles{7, 30, 370});
  CHECK(found.angles[1] == Angles{7, -30, 350});
}

TEST_CASE("a solution outside the travel is left out, and is_reachable tells that from a direction without solution") {
  HeadAndTable machine;
  machine.travel_of_b = AngleRange{-20, 110};
  machine.solutions = {solution(30, 0), solution(-30, 180)};
  const FiveAxisProgram p(machine);
  const RotaryCandidates one = p.solver.candidates(p.kinematics, {0, 0, 1}, {});
  REQUIRE(one.count == 1);
  CHECK(one.angles[0] == Angles{0, 30, 0});
  machine.solutions = {solution(-30, 180)};
  const RotaryCandidates outside = p.solver.candidates(p.kinematics, {0, 0, 1}, {});
  CHECK(outside.count == 0);
  CHECK(outside.is_reachable);
  machine.solutions.clear();
  CHECK_FALSE(p.solver.candidates(p.kinematics, {0, 0, 1}, {}).is_reachable);
}

TEST_CASE(
    "the sign of an angle is that of its position on the circle, or of the angle itself where travel is limited") {
  HeadAndTable machine;
  const FiveAxisProgram endless(machine);
  const RotarySolver::Sign positive{1, 1}, negative{1, -1};
  CHECK(endless.solver.has_sign(positive, 30));
  CHECK_FALSE(endless.solver.has_sign(negative, 30));
  CHECK_FALSE(endless.solver.has_sign(positive, 330));
  for (const double both : {0.0, 180.0, -180.0, 540.0}) {
    CHECK(endless.solver.has_sign(positive, both));
    CHECK(endless.solver.has_sign(negative, both));
  }
  machine.travel_of_b = AngleRange{-20, 400};
  const FiveAxisProgram limited(machine);
  CHECK(limited.solver.has_sign(positive, 330));
  CHECK_FALSE(limited.solver.has_sign(negative, 180));
}

TEST_CASE("the choice between two solutions compares the ways of the axes, or the sign of the first axis") {
  HeadAndTable machine;
  FiveAxisProgram mixed(machine);
  const Angles tilts{0, 40, 20}, turns{0, 0, 50};
  const RotaryCandidates both{{tilts, turns}, 2, true};
  const auto chosen = [&](const FiveAxisProgram& p, SolutionChoice choice) {
    return p.solver.choose(p.kinematics, both, {}, choice);
  };
  CHECK(chosen(mixed, SolutionChoice::min_first) == tilts);  // the table before the head
  CHECK(chosen(mixed, SolutionChoice::min_sum) == turns);
  CHECK(chosen(mixed, SolutionChoice::min_max) == tilts);
  CHECK(chosen(mixed, SolutionChoice::negative) == turns);
  const RotaryCandidates tilted{{tilts, tilts}, 1, true};
  CHECK_FALSE(mixed.solver.choose(mixed.kinematics, tilted, {}, SolutionChoice::negative).has_value());
  CHECK(mixed.solver.choose(mixed.kinematics, tilted, {}, SolutionChoice::positive) == tilts);
}
