#include "isogloss/cnc/motion_event.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

struct MovingProgram {
  BlockDocument document;
  MotionGroup group = document.member<MotionGroup>();
  BlockMotion motion = document.member<BlockMotion>();
  ig::Block block = document.block();
  std::uint32_t found = 0;
  void feed_mode(const char* code, double f) {
    document.carry_name("Feedrate.Term", code);
    document.carry("Feedrate.FeedrateValue", f);
  }
  void feed_along(double mm) {
    motion.feed(block, [mm] { return mm; });
  }
  std::vector<std::string> codes_reported() const {
    std::vector<std::string> out;
    for (const BlockDocument::Report& report : document.reports) out.push_back(report.code);
    return out;
  }
};

using Reported = std::vector<std::string>;

}  // namespace

TEST_CASE("G00 is in force until a block selects another motion") {
  MovingProgram p;
  CHECK(p.group.in_force(p.block) == MotionGroup::g00);
  CHECK_FALSE(p.group.is_answered(p.block));
  for (const std::size_t code :
       {MotionGroup::g01, MotionGroup::g02, MotionGroup::g03, MotionGroup::g33, MotionGroup::g00}) {
    p.group.put_in_force(p.block, code);
    CHECK(p.group.in_force(p.block) == code);
    CHECK(p.group.is_answered(p.block));
  }
  p.document.next_block();
  CHECK_FALSE(p.group.is_answered(p.block));
}

TEST_CASE("the last motion code of a block is in force, and ISO-0201 warns where there are several") {
  MovingProgram p;
  CHECK_FALSE(p.group.find(p.block, p.found).has_value());
  p.document.put_code("Parsing.Flags.G03");
  CHECK(p.group.find(p.block, p.found) == std::size_t{MotionGroup::g03});
  CHECK(p.found == 1);
  p.group.take(p.block, MotionGroup::g03, p.found);
  CHECK(p.document.reports.empty());
  p.document.next_block();
  p.document.put_code("Parsing.Flags.G01");
  p.document.put_code("Parsing.Flags.G00");
  CHECK(p.group.find(p.block, p.found) == std::size_t{MotionGroup::g00});
  CHECK(p.found == 2);
  p.group.take(p.block, MotionGroup::g00, p.found);
  CHECK(p.document.reports == std::vector{BlockDocument::Report{"ISO-0201", IG_WARNING, "Parsing.Flags.G00", {"G00"}}});
  CHECK(p.group.in_force(p.block) == MotionGroup::g00);
}

TEST_CASE("a block has one motion, single or compound") {
  MovingProgram p;
  CHECK_FALSE(p.motion.is_moving(p.block));
  p.motion.rapid(p.block);
  CHECK(p.motion.is_moving(p.block));
  p.document.forget("MotionEvent.Form");
  p.document.carry_name("CompoundMotion.Term", "G81");
  CHECK(p.motion.is_moving(p.block));
}

TEST_CASE("a rapid is a straight move without a feed") {
  MovingProgram p;
  p.motion.rapid(p.block);
  CHECK(p.document.name("MotionEvent.Form") == "McLinear");
  CHECK(p.document.integer("MotionEvent.IsRapid") == 1);
  CHECK_FALSE(p.document.has("MotionEvent.Feedrate_mmds"));
}

TEST_CASE("a feed move has the feed in force in mm/s") {
  MovingProgram p;
  p.feed_mode("G94", 600);
  p.feed_along(30);
  CHECK(p.document.name("MotionEvent.Form") == "McLinear");
  CHECK(p.document.number("MotionEvent.Feedrate_mmds") == 10);
  CHECK_FALSE(p.document.has("MotionEvent.IsRapid"));
}

TEST_CASE("a feed move without a feed is kept, and reported") {
  MovingProgram p;
  p.feed_along(30);
  CHECK(p.document.name("MotionEvent.Form") == "McLinear");
  CHECK_FALSE(p.document.has("MotionEvent.Feedrate_mmds"));
  CHECK(p.codes_reported() == Reported{"ISO-0302"});
}

TEST_CASE("a path without length needs no feed under G93, but an F of its own") {
  MovingProgram p;
  p.document.carry_name("Feedrate.Term", "G93");
  p.feed_along(0);
  CHECK(p.codes_reported() == Reported{"ISO-0302"});
  p.feed_mode("G93", 2);
  p.feed_along(0);
  CHECK(p.document.reports.size() == 1);
}

TEST_CASE("a spindle without a speed stops the feed per revolution; under G96 that has been reported already") {
  MovingProgram p;
  p.feed_mode("G95", 0.2);
  p.feed_along(30);
  CHECK(p.codes_reported() == Reported{"ISO-0303"});
  p.document.carry_name("SpindleSpeed.Term", "G96");
  p.feed_along(30);
  CHECK(p.document.reports.size() == 1);
}

TEST_CASE("an arc has a centre, a sense and no additional circles") {
  MovingProgram p;
  p.feed_mode("G94", 600);
  p.motion.arc(p.block, {1, 2, 3}, true, [] { return 1.0; });
  CHECK(p.document.name("MotionEvent.Form") == "McArc");
  CHECK(p.document.number("MotionEvent.ArcCenter.Y") == 2);
  CHECK(p.document.integer("MotionEvent.IsCcw") == 1);
  CHECK(p.document.integer("MotionEvent.AdditionalCircleNum") == 0);
  CHECK(p.document.number("MotionEvent.Feedrate_mmds") == 10);
}

TEST_CASE("while the rotary axes turn under tool centre point control, straight moves lead the tip") {
  MovingProgram p;
  p.document.carry_flag("PivotTransform.~Turns");
  CHECK(p.motion.turns(p.block));
  p.motion.straight(p.block, 0);
  CHECK(p.document.name("MotionEvent.Form") == "ClLinear");
  CHECK_FALSE(p.document.has("MotionEvent.Feedrate_mmds"));
  p.motion.straight(p.block, 5);
  CHECK(p.document.number("MotionEvent.Feedrate_mmds") == 5);
  CHECK(p.document.reports.empty());
}
