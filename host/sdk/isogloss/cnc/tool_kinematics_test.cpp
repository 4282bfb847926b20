#include "isogloss/cnc/tool_kinematics.hpp"

#include <limits>

#include "isogloss/cnc/five_axis_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

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
