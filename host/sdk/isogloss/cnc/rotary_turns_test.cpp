#include "isogloss/cnc/rotary_turns.hpp"

#include "isogloss/cnc/five_axis_test.hpp"

using namespace ig::cnc;

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
