#include "isogloss/cnc/rotary_words.hpp"

#include <catch2/catch.hpp>

#include <limits>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

/// A machine whose only rotary axis is A, known by its rapid rate.
const ig_machine_axis_1* machine_with_a() {
  static const ig_machine_axis_1 machine = [] {
    ig_machine_axis_1 m{};
    m.struct_size = sizeof m;
    m.home = [](void*, char, double*) { return std::int32_t{0}; };
    m.reference = [](void*, char, std::uint32_t, double*) { return std::int32_t{0}; };
    m.travel = [](void*, char, double*, double*) { return std::int32_t{0}; };
    m.rapid_rate = [](void*, char axis, double* out) {
      *out = 30;
      return std::int32_t{axis == 'A'};
    };
    return m;
  }();
  return &machine;
}

struct TurningProgram {
  BlockDocument document;
  ig::Block block = document.block();
  void declare_a() { document.services["isogloss.machine-axis/1"] = machine_with_a(); }
  bool accepts(const RotaryWords& words, std::size_t axis, double angle) {
    return words.accept(block, axis, angle, document.id(std::string("Parsing.") + rotary_names[axis]));
  }
};

using Reports = std::vector<BlockDocument::Report>;

}  // namespace

TEST_CASE("a machine that declares no rotary axes has A, B and C, and a note says so once a run") {
  TurningProgram p;
  const auto words = p.document.member<RotaryWords>();
  CHECK_FALSE(words.axes().any());
  CHECK(p.accepts(words, 1, 30));
  CHECK(p.accepts(words, 2, 30));
  CHECK(p.document.reports == Reports{{"ISO-0402", IG_NOTE, "Parsing.B", {}}});
  p.document.next_block();
  CHECK(p.accepts(words, 0, 30));
  CHECK(p.document.reports.empty());
}

TEST_CASE("with undeclared-axes refuse a machine that declares no rotary axes has none") {
  TurningProgram p;
  p.document.options["undeclared-axes"] = "refuse";
  const auto words = p.document.member<RotaryWords>();
  CHECK_FALSE(p.accepts(words, 1, 30));
  CHECK(p.document.reports == Reports{{"ISO-0401", IG_ERROR, "Parsing.B", {"B"}}});
}

TEST_CASE("a word for an axis that the machine does not have is an error; its other axes turn without a note") {
  TurningProgram p;
  p.declare_a();
  const auto words = p.document.member<RotaryWords>();
  CHECK(p.accepts(words, 0, 30));
  CHECK(p.document.reports.empty());
  CHECK_FALSE(p.accepts(words, 2, 30));
  CHECK(p.document.reports == Reports{{"ISO-0401", IG_ERROR, "Parsing.C", {"C"}}});
}

TEST_CASE("an angle of 1e9 degrees or more, and one that is no number, turns no axis") {
  TurningProgram p;
  p.declare_a();
  const auto words = p.document.member<RotaryWords>();
  CHECK(p.accepts(words, 0, 999'999'999.5));
  CHECK_FALSE(p.accepts(words, 0, 1e9));
  CHECK_FALSE(p.accepts(words, 0, -1e10));
  CHECK_FALSE(p.accepts(words, 0, std::numeric_limits<double>::quiet_NaN()));
  REQUIRE(p.document.reports.size() == 3);
  CHECK(p.document.reports[1] == BlockDocument::Report{"ISO-0404", IG_ERROR, "Parsing.A", {"A", "-1e+10"}});
}

TEST_CASE("the rotary position holds the axes that were set, fresh in their block only") {
  BlockDocument document;
  const auto position = document.member<RotaryPosition>(ig::read | ig::write);
  ig::Block block = document.block();
  CHECK(position.get(block).mask == 0);
  position.set(block, {5u, {10, 0, -30}});
  CHECK(position.get(block).mask == 5);
  CHECK(position.get(block, 2) == -30);
  CHECK_FALSE(position.get(block, 1).has_value());
  CHECK(position.fresh(block) == 5);
  document.next_block();
  position.set(block, 1, 90);
  CHECK(position.fresh(block) == 2);
  CHECK(document.number("MachineCoordinate.B") == 90);
  CHECK(position.get(block).mask == 7);
}

TEST_CASE("a step holds the angles that were written into it, and only a step with a position is a move") {
  BlockDocument document;
  const auto steps = document.member<RotarySteps>();
  ig::Block block = document.block();
  steps.set_last(block, {});  // no step and no angle: nothing to write
  const ig_field x = document.id("CompoundMotion.Items[].MachineCoordinate.X");
  const ig_field dwell = document.id("CompoundMotion.Items[].Dwell.Time");
  const ig_value value{.number = 1};
  block.append(&x, 1, &value);
  block.append(&dwell, 1, &value);
  CHECK(steps.count(block) == 2);
  CHECK(steps.is_move(block, 0));
  CHECK_FALSE(steps.is_move(block, 1));
  steps.set(block, 0, {2u, {0, 45, 0}});
  steps.set_last(block, {4u, {0, 0, 90}});
  CHECK(steps.get(block, 0).mask == 2);
  CHECK(steps.get(block, 0).value[1] == 45);
  CHECK(steps.get(block, 1).mask == 4);
  CHECK(steps.get(block, 1).value[2] == 90);
}
