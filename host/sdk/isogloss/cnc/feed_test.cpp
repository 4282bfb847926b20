#include "isogloss/cnc/feed.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

struct FeedProgram {
  BlockDocument document;
  FeedInForce feed = document.member<FeedInForce>(ig::read | ig::write);
  ig::Block block = document.block();
  ig::Where word = ig::Where::word(document.id("Parsing.F"));
  void set_mode(const char* code) { feed.set_mode(block, document.symbol_of(code)); }
  double mmds(double path_mm) const {
    return feed.mmds(block, [path_mm] { return path_mm; });
  }
};

using Report = BlockDocument::Report;

}  // namespace

TEST_CASE("the first F selects G94, and a later F keeps the mode in force") {
  FeedProgram p;
  CHECK(p.document.text_of(p.feed.mode(p.block)) == "G94");
  CHECK_FALSE(p.feed.value(p.block).has_value());
  p.feed.resolve(p.block, 600);
  CHECK(p.feed.value(p.block) == 600);
  CHECK(p.document.name("Feedrate.Term") == "G94");
  CHECK(p.document.name("Feedrate.Unit") == "mm/min");
  p.set_mode("G95");
  p.feed.resolve(p.block, 0.2);
  CHECK(p.feed.value(p.block) == 0.2);
  CHECK(p.document.name("Feedrate.Term") == "G95");
  CHECK(p.document.reports.empty());
}

TEST_CASE("a block without F leaves the feed as it was") {
  FeedProgram p;
  p.feed.resolve(p.block, std::nullopt);
  CHECK_FALSE(p.document.has("Feedrate.Term"));
  p.feed.resolve(p.block, 600);
  p.feed.resolve(p.block, std::nullopt);
  CHECK(p.feed.value(p.block) == 600);
}

TEST_CASE("an F of 0 or less is an error at its word, and the previous feed stays in force") {
  FeedProgram p;
  p.feed.resolve(p.block, 600);
  p.feed.resolve(p.block, 0, p.word);
  p.feed.resolve(p.block, -5, p.word);
  CHECK(p.feed.value(p.block) == 600);
  CHECK(p.document.reports == std::vector{Report{"ISO-0210", IG_ERROR, "Parsing.F", {"0"}},
                                          Report{"ISO-0210", IG_ERROR, "Parsing.F", {"-5"}}});
}

TEST_CASE("each feed mode has its unit") {
  FeedProgram p;
  p.set_mode("G93");
  CHECK(p.document.name("Feedrate.Unit") == "1/min");
  CHECK(p.feed.is_inverse_time(p.block));
  p.set_mode("G95");
  CHECK(p.document.name("Feedrate.Unit") == "mm/rev");
  CHECK_FALSE(p.feed.is_inverse_time(p.block));
  p.set_mode("G94");
  CHECK(p.document.name("Feedrate.Unit") == "mm/min");
}

TEST_CASE("the feed along a path is F by the minute, by the revolution or by the length of the path") {
  FeedProgram p;
  CHECK(p.mmds(30) == 0);
  p.feed.resolve(p.block, 600);
  CHECK(p.mmds(30) == 10);
  p.set_mode("G95");
  CHECK(p.mmds(30) == 0);  // the spindle has no speed
  p.document.carry("SpindleSpeed.SpindleSpeed_rpm", 3);
  CHECK(p.mmds(30) == 30);
  p.set_mode("G93");
  p.feed.resolve(p.block, 2);
  CHECK(p.mmds(30) == 1);
}

TEST_CASE("the length of the path is computed only under G93") {
  FeedProgram p;
  p.feed.resolve(p.block, 600);
  int calls = 0;
  const auto length = [&calls] { return static_cast<double>(++calls); };
  CHECK(p.feed.mmds(p.block, length) == 10);
  CHECK(calls == 0);
  p.set_mode("G93");
  CHECK(p.feed.mmds(p.block, length) == 10);
  CHECK(calls == 1);
}

TEST_CASE("a feed move names the reason why it has no feed") {
  FeedProgram p;
  p.feed.report_missing(p.block);
  p.feed.resolve(p.block, 600);
  p.feed.end(p.block);
  p.set_mode("G95");
  p.feed.report_missing(p.block);
  p.feed.resolve(p.block, 0.2);
  p.feed.report_missing(p.block);
  CHECK(p.document.reports == std::vector{Report{"ISO-0302", IG_ERROR, "", {}},
                                          Report{"ISO-0211", IG_ERROR, "", {"G95", "mm/min"}},
                                          Report{"ISO-0303", IG_ERROR, "", {}}});
}

TEST_CASE("after a change of mode ended the feed, the next F ends that reason as well") {
  FeedProgram p;
  p.feed.resolve(p.block, 600);
  p.feed.end(p.block);
  CHECK_FALSE(p.feed.value(p.block).has_value());
  p.feed.resolve(p.block, 300);
  p.feed.forget(p.block);
  p.feed.report_missing(p.block);
  CHECK(p.document.reports == std::vector{Report{"ISO-0302", IG_ERROR, "", {}}});
}
