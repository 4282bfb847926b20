#include "isogloss/engine/cases.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "document/json_difference.hpp"

using namespace isogloss;
using Json = nlohmann::ordered_json;

TEST_CASE("A page is a title and its cases") {
  DiagnosticList said;
  const Page page = read_page(
      "# DwellSyntax\nProse.\n## One\n#Previous:\n```json\n{\"A\":1}\n```\n#Dependencies:\n```xml\n<T/>\n```\n"
      "#Ahead:\n```json\n[{}]\n```\n"
      "#BeforeBuild:\n```json\n{}\n```\nMore prose.\n#AfterBuild:\n```json\n{\"B\":2}\n```\n"
      "## A heading without a case\n```\n#BeforeBuild:\n```\n## Two\n#BeforeBuild:\r\n```\r\n{}\r\n```\r\n"
      "#AfterBuild:\n```\n{}\n```\n#BeforeBuild:\n```\n{\"C\":3}\n```\n#AfterBuild:\n```\n{}\n```\n",
      "page.md", said);
  CHECK(said.all.empty());
  CHECK(page.syntax == "DwellSyntax");
  REQUIRE(page.cases.size() == 3);
  CHECK(page.cases[0].heading == "One");
  CHECK(page.cases[0].line == 4);
  CHECK(page.cases[0].previous->text == "{\"A\":1}\n");
  CHECK(page.cases[0].previous->line == 6);
  CHECK(page.cases[0].dependencies->text == "<T/>\n");
  CHECK(page.cases[0].ahead->text == "[{}]\n");
  CHECK_FALSE(page.cases[1].ahead.has_value());
  CHECK(page.cases[0].after->text == "{\"B\":2}\n");
  CHECK_FALSE(page.cases[1].previous.has_value());
  CHECK(page.cases[2].heading == "Two");
  CHECK(page.cases[2].before->text == "{\"C\":3}\n");
}

TEST_CASE("A case without diagnostics expects none, and one that does not care says any") {
  DiagnosticList said;
  const Page page = read_page(
      "# DwellSyntax\n## One\n#BeforeBuild:\n```\n{}\n```\n#AfterBuild:\n```\n{}\n```\n"
      "## Two\n#BeforeBuild:\n```\n{}\n```\n#AfterBuild:\n```\n{}\n```\n#Diagnostics: any\n"
      "## Three\n#BeforeBuild:\n```\n{}\n```\n#AfterBuild:\n```\n{}\n```\n#Diagnostics:\n```\nA-1 A-2\n```\n",
      "page.md", said);
  CHECK(said.all.empty());
  REQUIRE(page.cases.size() == 3);
  CHECK_FALSE(page.cases[0].diagnostics.has_value());
  CHECK_FALSE(page.cases[0].accepts_any_code);
  CHECK(page.cases[1].accepts_any_code);
  CHECK(page.cases[2].diagnostics->text == "A-1 A-2\n");
  CHECK_FALSE(page.cases[2].accepts_any_code);
}

TEST_CASE("A page that is not whole says so") {
  const auto [text, line] = GENERATE(table<const char*, unsigned>({
      {"# X\n## A\n#BeforeBuild:\n```\n{}\n```\n", 3},
      {"# X\n## A\n#AfterBuild:\n```\n{}\n```\n", 3},
      {"# X\n## A\n#BeforeBuild:\n## B\n", 3},
      {"# X\n## A\n#BeforeBuild:\n```\n{}\n", 5},
  }));
  DiagnosticList said;
  const Page page = read_page(text, "page.md", said);
  CHECK(page.cases.empty());
  REQUIRE_FALSE(said.all.empty());
  CHECK(said.all[0].code == "IG-0501");
  CHECK(said.all[0].where.line == line);
}

TEST_CASE("Documents are compared by path, numbers by value") {
  const auto difference = [](const char* expected, const char* got) {
    return json_difference(Json::parse(expected), Json::parse(got));
  };
  CHECK(difference(R"({"A": 1, "B": {"C": [1, 2.0]}})", R"({"B": {"C": [1.0, 2]}, "A": 1.0})").empty());
  CHECK(difference(R"({"A": {"B": 1}})", R"({"A": {"B": 2}})") == "  A.B: expected 1, got 2\n");
  CHECK(difference(R"({"A": 1})", R"({})") == "  A: expected 1, is missing\n");
  CHECK(difference(R"({})", R"({"A": "x"})") == "  A: not expected, got \"x\"\n");
  CHECK(difference(R"({"L": [{"X": 1}, {"X": 2}]})", R"({"L": [{"X": 1}, {"X": 3}]})") ==
        "  L[1].X: expected 2, got 3\n");
  CHECK(difference(R"({"L": [1]})", R"({"L": [1, 2]})") == "  L: expected [1], got [1,2]\n");
  CHECK(difference(R"({"A": 1})", R"({"A": "1"})") == "  A: expected 1, got \"1\"\n");
  CHECK(difference(R"({"L": [{"X": 1}, {"X": 2}]})", R"({"L": [{"X": 3}]})") ==
        "  L[0].X: expected 1, got 3\n  L[1]: expected {\"X\":2}, is missing\n");
}

TEST_CASE("The first differences are a few short lines") {
  Json expected = Json::object(), got = Json::object();
  for (char name = 'A'; name <= 'G'; ++name) {
    expected[std::string(1, name)] = 1;
    got[std::string(1, name)] = std::string(1000, 'x');
  }
  const std::string text = first_differences(expected, got);
  CHECK(text.starts_with("  A: expected 1, got \"xxx"));
  CHECK(text.find("  F: ") == std::string::npos);
  CHECK(text.ends_with("…\n  … and 2 more paths\n"));
  CHECK(text.size() < 1200);
  got["A"] = 2;
  CHECK(first_differences({{"A", 1}}, {{"A", 2}}) == "  A: expected 1, got 2\n");
}

TEST_CASE("Leaves name records by their source") {
  const auto leaves =
      json_leaves(Json::parse(R"({"A": {"B": [1, 2]}, "T": [{"Source": "S", "M": [1]}], "L": [{"X": 1}]})"));
  REQUIRE(leaves.size() == 3);
  CHECK(leaves[0] == std::pair<std::string, std::string>("A.B", "[1,2]"));
  CHECK(leaves[1] == std::pair<std::string, std::string>("T[S].M", "[1]"));
  CHECK(leaves[2] == std::pair<std::string, std::string>("L[0].X", "1"));
}
