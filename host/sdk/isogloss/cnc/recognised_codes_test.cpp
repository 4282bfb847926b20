#include "isogloss/cnc/recognised_codes.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

const ig::Diagnostics recognised_codes_diagnostics{
    ig::diagnostic(IG_WARNING, "TEST-0001", "{0} is not executed: {1}", "", "")};

/// A dialect that knows G05.1 and G08, whose look-ahead is not supported, and G07, whose axis is not.
struct RecognisingDialect {
  BlockDocument document;
  RecognisedCodes codes = document.create([] {
    return RecognisedCodes(ig::diag("TEST-0001"), {{ig::Call({"G05.1", "G08"}, "P[] Q[]"), "look-ahead"},
                                                   {ig::Call({"G07"}, "X[]"), "hypothetical axis"}});
  });
  ig::Block block = document.block();
};

}  // namespace

TEST_CASE("a recognised code is reported once, with what is missing, and taken with its words") {
  RecognisingDialect d;
  d.document.put_code("Parsing.G08");
  d.document.put_word("Parsing.G08.P", 1);
  CHECK(d.codes.report(d.block));
  REQUIRE(d.document.reports.size() == 1);
  CHECK(d.document.reports[0] == BlockDocument::Report{"TEST-0001", IG_WARNING, "Parsing.G08", {"G08", "look-ahead"}});
  CHECK_FALSE(leftover(d.block, 0).has_value());
  CHECK_FALSE(d.codes.report(d.block));
  CHECK(d.document.reports.size() == 1);
}

TEST_CASE("each recognised code of a block has a diagnostic of its own") {
  RecognisingDialect d;
  d.document.put_code("Parsing.G07");
  d.document.put_code("Parsing.G05.1");
  CHECK(d.codes.report(d.block));
  REQUIRE(d.document.reports.size() == 2);
  CHECK(d.document.reports[0].arguments == std::vector<std::string>{"G05.1", "look-ahead"});
  CHECK(d.document.reports[1].arguments == std::vector<std::string>{"G07", "hypothetical axis"});
}

TEST_CASE("a recognised code that another syntax has answered is not reported") {
  RecognisingDialect d;
  d.document.put_code("Parsing.G08");
  const ig_field g08 = d.document.id("Parsing.G08");
  d.block.take_code(&g08, 1);
  CHECK_FALSE(d.codes.report(d.block));
  CHECK(d.document.reports.empty());
}

TEST_CASE("a block without a recognised code keeps its words") {
  RecognisingDialect d;
  d.document.put_word("Parsing.P", 1);
  CHECK_FALSE(d.codes.report(d.block));
  CHECK(leftover(d.block, 0)->name == "P");
}
