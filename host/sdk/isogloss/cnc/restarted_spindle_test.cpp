#include "isogloss/cnc/restarted_spindle.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

struct RestartingCycle {
  BlockDocument document;
  ig::CompoundMotion motion = document.member<ig::CompoundMotion>();
  ig::Block block = document.block();
  ig::Spindle begin(const char* present) {
    document.carry_name("SpindleSpeed.Direction", present);
    return document.member<RestartedSpindle>().begin(block, motion, ig::Where::word(document.id("Parsing.G86")),
                                                     document.symbol_of("G86"));
  }
};

}  // namespace

TEST_CASE("a cycle restarts an M04 spindle clockwise, and ISO-0336 warns at its code") {
  RestartingCycle c;
  CHECK(c.begin("CCW") == ig::Spindle::cw);
  CHECK(c.document.reports == std::vector{BlockDocument::Report{"ISO-0336", IG_WARNING, "Parsing.G86", {"G86"}}});
  CHECK(c.document.name("SpindleSpeed.Direction") == "CW");
}

TEST_CASE("with restart as-before the spindle keeps its direction, without a report") {
  RestartingCycle c;
  c.document.options["restart"] = "as-before";
  CHECK(c.begin("CCW") == ig::Spindle::ccw);
  CHECK(c.document.name("SpindleSpeed.Direction") == "CCW");
  CHECK(c.begin("STOP") == ig::Spindle::cw);
  CHECK(c.document.reports.empty());
}

TEST_CASE("a spindle that turns clockwise or stands is restarted clockwise without a report") {
  for (const char* present : {"CW", "STOP"}) {
    RestartingCycle c;
    CHECK(c.begin(present) == ig::Spindle::cw);
    CHECK(c.document.reports.empty());
  }
}

TEST_CASE("the holes of a block are limited to those whose steps fit beside one step for an M code") {
  BlockDocument document;
  ig::Block block = document.block();
  CycleRun run;
  run.code = document.symbol_of("G87");
  run.count = 10'000;
  limit_steps(block, run, 9);
  CHECK(run.count == 10'000);
  CHECK(document.reports.empty());
  limit_steps(block, run, 11);
  CHECK(run.count == 9'090);
  CHECK(document.reports ==
        std::vector{BlockDocument::Report{"ISO-0352", IG_ERROR, "", {"G87", "10000", "11", "9090"}}});
}

TEST_CASE("one step of the block is kept for an M code") {
  BlockDocument document;
  ig::Block block = document.block();
  CycleRun run;
  run.code = document.symbol_of("G87");
  run.count = 10'000;
  limit_steps(block, run, 10);  // 100000 steps would fill the list
  CHECK(run.count == 9'999);
}
