#include "isogloss/cnc/tool_kinematics.hpp"

#include <catch2/catch.hpp>

#include <limits>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

/// A machine with a head B, which tilts the tool about its gauge point, and a table C about X10 Y0; or other axes by
/// `names`, of which only C is a table. solve() answers what the test gives.
struct HeadAndTable {
  std::string names = "BC";
  std::vector<ig_rotary_solution> solutions;
  std::optional<AngleRange> travel_of_b;
  ig_machine_kinematics_1 kinematics{};
  ig_machine_axis_1 axes{};

  HeadAndTable() {
    kinematics.struct_size = sizeof kinematics;
    kinematics.self = this;
    kinematics.axes = [](void* self, char* out) {
      const std::string& all = of(self).names;
      std::copy(all.begin(), all.end(), out);
      return static_cast<std::uint32_t>(all.size());
    };
    kinematics.tool_axis = [](void*, const double angles[3], double out[3]) {
      const double b = angles[1] * radians_per_degree, c = angles[2] * radians_per_degree;
      out[0] = std::sin(b) * std::cos(c);
      out[1] = -std::sin(b) * std::sin(c);
      out[2] = std::cos(b);
      return std::int32_t{std::isfinite(b) && std::isfinite(c)};
    };
    kinematics.pivot = [](void*, const double angles[3], double out[16]) {
      const double c = std::cos(angles[2] * radians_per_degree), s = std::sin(angles[2] * radians_per_degree);
      const Mat4 turned{c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 10 - 10 * c, -10 * s, 0, 1};
      std::copy(turned.begin(), turned.end(), out);
      return std::int32_t{std::isfinite(angles[2])};
    };
    kinematics.solve = [](void* self, const double*, const double*, ig_rotary_solution* out) {
      std::copy(of(self).solutions.begin(), of(self).solutions.end(), out);
      return static_cast<std::uint32_t>(of(self).solutions.size());
    };
    axes.struct_size = sizeof axes;
    axes.self = this;
    axes.home = [](void*, char, double*) { return std::int32_t{0}; };
    axes.reference = [](void*, char, std::uint32_t, double*) { return std::int32_t{0}; };
    axes.rapid_rate = [](void*, char, double*) { return std::int32_t{0}; };
    axes.travel = [](void* self, char axis, double* low, double* high) {
      const auto& travel = of(self).travel_of_b;
      if (axis != 'B' || !travel) return std::int32_t{0};
      *low = travel->minimum;
      *high = travel->maximum;
      return std::int32_t{1};
    };
  }
  HeadAndTable(const HeadAndTable&) = delete;
  HeadAndTable& operator=(const HeadAndTable&) = delete;

 private:
  static const HeadAndTable& of(void* self) { return *static_cast<const HeadAndTable*>(self); }
};

/// The members as a syntax has them; set up `machine` before.
struct FiveAxisProgram {
  BlockDocument document;
  ToolKinematics kinematics;
  RotarySolver solver;
  RotaryTurns turns;
  ig::Block block = document.block();
  explicit FiveAxisProgram(const HeadAndTable& machine)
      : kinematics(asked(machine).member<ToolKinematics>()),
        solver(document.member<RotarySolver>()),
        turns(document.member<RotaryTurns>(ig::read | ig::write, RotaryWordsAre::of_machine)) {}
  BlockDocument& asked(const HeadAndTable& machine) {
    document.services = {{"isogloss.machine-kinematics/1", &machine.kinematics},
                         {"isogloss.machine-axis/1", &machine.axes}};
    return document;
  }
  RotaryTurn turn() const { return turns.read(block, kinematics); }
};

ig_rotary_solution solution(double b, double c, std::uint32_t free = 0) { return {{0, b, c}, free, 0}; }

void check_near(const std::optional<ig::Vec3>& got, const ig::Vec3& wanted) {
  REQUIRE(got.has_value());
  for (std::size_t i = 0; i < 3; ++i) CHECK((*got)[i] == Approx(wanted[i]).margin(1e-9));
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("a machine without the service, or with an unknown axis, has no kinematics") {
  BlockDocument document;
  CHECK_FALSE(document.member<ToolKinematics>());
  HeadAndTable machine;
  machine.names = "U";
  CHECK_FALSE(FiveAxisProgram(machine).kinematics);
  machine.names = "BU";
  const FiveAxisProgram half(machine);
  CHECK_FALSE(half.kinematics);
  CHECK(half.kinematics.mask() == 0);
}

TEST_CASE("the axes are those of the service, and an axis that turns the frame is a table") {
  const HeadAndTable machine;
  const FiveAxisProgram p(machine);
  REQUIRE(p.kinematics);
  CHECK(p.kinematics.count() == 2);
  CHECK(p.kinematics.axis(0) == 1);
  CHECK(p.kinematics.axis(1) == 2);
  CHECK(p.kinematics.mask() == 6);
  CHECK_FALSE(p.kinematics.has(0));
  CHECK_FALSE(p.kinematics.is_table(0));
  CHECK(p.kinematics.is_table(1));
  CHECK(p.kinematics.is_mixed());
  HeadAndTable heads;
  heads.names = "BA";
  CHECK_FALSE(FiveAxisProgram(heads).kinematics.is_mixed());
}

TEST_CASE("the tip of the tool maps to X Y Z of the machine and back") {
  const HeadAndTable machine;
  const FiveAxisProgram p(machine);
  const ToolTip tip{p.kinematics, 100};
  check_near(tip.machine_point({1, 2, 3}, {}), {1, 2, 103});
  check_near(tip.machine_point({0, 0, 0}, {0, 90, 0}), {100, 0, 0});
  check_near(tip.machine_point({20, 0, 0}, {0, 0, 90}), {10, 10, 100});
  const Angles angles{0, 30, -75};
  check_near(tip.in_workpiece(*tip.machine_point({1, 2, 3}, angles), angles), {1, 2, 3});
}

TEST_CASE("angles that are not finite give no tip") {
  const HeadAndTable machine;
  const FiveAxisProgram p(machine);
  const ToolTip tip{p.kinematics, 100};
  for (const Angles& angles : {Angles{0, not_a_number, 0}, Angles{0, 0, not_a_number}}) {
    CHECK_FALSE(tip.machine_point({}, angles).has_value());
    CHECK_FALSE(tip.in_workpiece({}, angles).has_value());
  }
}

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

TEST_CASE("tool centre point control is on under G43.4 and G43.5 alone") {
  BlockDocument document;
  const auto mode = document.member<ToolCenterMode>();
  const ig::Block block = document.block();
  CHECK_FALSE(mode.is_on(block));
  for (const auto& [code, is_on] : {std::pair{"G43", false}, {"G43.4", true}, {"G43.5", true}, {"G49", false}}) {
    document.carry_name("ToolHeightCompensation.Term", code);
    CHECK(mode.is_on(block) == is_on);
    CHECK(document.text_of(mode.term(block)) == code);
  }
}

TEST_CASE("the state of the pivot holds the axes of the machine, until it is erased") {
  const HeadAndTable machine;
  FiveAxisProgram p(machine);
  const PivotState& state = p.turns.state();
  CHECK_FALSE(state.is_fresh(p.block));
  state.set(p.block, p.kinematics, {1, 2, 3});
  CHECK(state.get(p.block).mask == 6);
  CHECK(state.get(p.block).value[2] == 3);
  CHECK(state.is_fresh(p.block));
  state.erase(p.block);
  CHECK(state.get(p.block).mask == 0);
}

TEST_CASE("the words of a block are positions of the rotary axes, and distances under G91") {
  const HeadAndTable machine;
  FiveAxisProgram p(machine);
  p.document.carry("MachineCoordinate.B", 10);
  CHECK_FALSE(p.turn().moves);
  p.document.put_word("Parsing.B", 30);
  CHECK(p.turn().from == Angles{0, 10, 0});
  CHECK(p.turn().to == Angles{0, 30, 0});
  CHECK(p.turn().moves);
  p.document.carry_name("PositioningMode.Term", "G91");
  CHECK(p.turn().to == Angles{0, 40, 0});
  p.document.put_word("Parsing.B", 360);
  CHECK(p.turn().moves);  // a whole turn is a move
}

TEST_CASE("under G91 the control ignores G53, and the words of its block turn nothing") {
  const HeadAndTable machine;
  FiveAxisProgram p(machine);
  p.document.put_code("Parsing.Flags.G53");
  p.document.put_word("Parsing.B", 30);
  CHECK(p.turn().to == Angles{0, 30, 0});
  p.document.carry_name("PositioningMode.Term", "G91");
  CHECK(p.turn().to == Angles{0, 0, 0});
  CHECK_FALSE(p.turn().moves);
}

TEST_CASE("a turn starts at the angles of the frame, or at the present ones where another code has turned the axes") {
  const HeadAndTable machine;
  FiveAxisProgram p(machine);
  p.document.carry("MachineCoordinate.C", 45);
  CHECK_FALSE(p.turn().is_followed);
  p.document.carry("PivotTransform.C", 45);
  CHECK(p.turn().is_followed);
  CHECK_FALSE(p.turn().was_moved);
  p.document.carry("MachineCoordinate.C", 90);
  CHECK(p.turn().was_moved);
  CHECK(p.turn().from[2] == 90);
  p.document.put_word("MachineCoordinate.C", 90);  // the block itself has written it
  CHECK_FALSE(p.turn().was_moved);
  CHECK(p.turn().from[2] == 45);
  CHECK(p.turn().moves);
}
