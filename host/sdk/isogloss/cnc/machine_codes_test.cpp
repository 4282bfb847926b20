#include "isogloss/cnc/machine_codes.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"

using namespace ig::cnc;
using isogloss_test::BlockDocument;

namespace {

struct OneCode {
  ig_machine_code row{sizeof(ig_machine_code),
                      IG_CODE_ACTS,
                      ig::to_text("M92"),
                      ig::to_text("M08 M50"),
                      {},
                      {},
                      {},
                      0,
                      0,
                      {},
                      ig::to_text("M92"),
                      0,
                      0,
                      {}};
  ig_machine_code_1 provided{sizeof(ig_machine_code_1), 0, this, &find, &family};
  BlockDocument document;

  static const ig_machine_code* find(void* self, ig_text name) {
    return name.size == 0 || ig::to_view(name) == "M92" ? &static_cast<OneCode*>(self)->row : nullptr;
  }
  static const ig_machine_code* family(void*, ig_text) { return nullptr; }
  MachineCodes codes() {
    document.services["isogloss.machine-code/1"] = &provided;
    return document.create([] { return MachineCodes(); });
  }
};

}  // namespace

TEST_CASE("a code of the builder is found by its name, and a chain without a table finds none") {
  OneCode one;
  const MachineCodes codes = one.codes();
  REQUIRE(codes.find("M92") != nullptr);
  CHECK(codes.find("M93") == nullptr);
  CHECK(codes.holds_any());
  BlockDocument document;
  const auto none = document.create([] { return MachineCodes(); });
  CHECK(none.find("M92") == nullptr);
  CHECK_FALSE(none.holds_any());
}

TEST_CASE("a code has a whole number, or none") {
  CHECK(whole_number_of_code("M08") == 8u);
  CHECK(whole_number_of_code("G4294967295") == 4294967295u);
  for (const char* code : {"", "M", "G54.1", "G54.", "M99999999999", "M-1"}) CHECK_FALSE(whole_number_of_code(code));
}

TEST_CASE("a row that acts as several codes names each of them") {
  const OneCode one;
  std::string seen;
  for_each_code(one.row, [&](std::string_view code) { seen.append(code).append("/"); });
  CHECK(seen == "M08/M50/");
}

TEST_CASE("the numbers of a code's words: the last one counts, and the number of the code is none of them") {
  const NumbersOfWords words{"M131 p5 Q-2.5P7 R#1"};
  CHECK(words("P") == 7.0);
  CHECK(words("q") == -2.5);
  for (const char* name : {"M", "R", "L", "1", "", "PQ"}) CHECK_FALSE(words(name));
}

TEST_CASE("a value that the program gives has a name, and perhaps another value instead") {
  CHECK_FALSE(GivenValue::read("5"));
  CHECK_FALSE(GivenValue::read("{P"));
  const auto alone = GivenValue::read("{P}"), other = GivenValue::read("{ Q240 : 0.5 }");
  REQUIRE((alone && other));
  CHECK((alone->name == "P" && alone->otherwise.empty()));
  CHECK((other->name == "Q240" && other->otherwise == "0.5"));
}

TEST_CASE("assignments come one after the other, without blanks around them") {
  std::string seen;
  for_each_assignment(" Coolant.Mode = FLOOD;;Dwell.Time={P} ; X", [&](std::string_view path, std::string_view value) {
    seen.append(path).append("|").append(value).append("/");
  });
  CHECK(seen == "Coolant.Mode|FLOOD/Dwell.Time|{P}/X|/");
}

TEST_CASE("a value is that of its row until the program overwrites it") {
  ig::RowOrigins<int> rows;
  rows.overwrite(5);
  rows.give(5, "005");
  rows.give(6, "6");
  REQUIRE(rows.of(5) != nullptr);
  CHECK(*rows.of(5) == "005");
  rows.overwrite(5);
  CHECK(rows.of(5) == nullptr);
  CHECK(*rows.of(6) == "6");
}
