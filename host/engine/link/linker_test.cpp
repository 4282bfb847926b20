#include <catch2/catch.hpp>

#include "test_dialect.hpp"

using namespace isogloss;
using namespace isogloss::test;

TEST_CASE("a sound chain links without a word") {
  Plugin plugin("p");
  Syntax& writer = plugin.syntax("Writer");
  writer.fields = {field("Acme.Count", IG_WRITE)};
  writer.before = {"Reader", "NotInThisChain"};
  plugin.syntax("Reader").fields = {field("Acme.Count", IG_READ | IG_REQUIRED)};
  Hand hand{"p"};
  hand.add("Writer");
  hand.add("Reader");
  CHECK(faults(hand, {&plugin}).empty());
}

TEST_CASE("names that do not exist are told with the nearest one") {
  Plugin plugin("p");
  plugin.syntax("DrillSyntax").options = {option("retract", IG_OPTION_TEXT, "")};
  plugin.dependency("OffsetTable");
  DiagnosticList found;

  Hand no_plugin{"q"};
  CHECK(faults(no_plugin, {&plugin}) == Strings{"IG-0201 1"});

  Hand no_syntax{"p"};
  no_syntax.add("DrilSyntax");
  CHECK(faults(no_syntax, {&plugin}, &found) == Strings{"IG-0202 2"});
  CHECK(found.all[0].hint == "did you mean DrillSyntax?");

  Hand not_listed{};
  not_listed.add("DrillSyntax");
  CHECK(faults(not_listed, {&plugin}) == Strings{"IG-0202 1"});

  Hand no_dependency{"p"};
  no_dependency.depend("OfsetTable");
  CHECK(faults(no_dependency, {&plugin}, &found) == Strings{"IG-0203 2"});
  CHECK(found.all[0].hint == "did you mean OffsetTable?");

  Hand no_option{"p"};
  no_option.add("DrillSyntax", {{"retrakt", "x"}});
  CHECK(faults(no_option, {&plugin}, &found) == Strings{"IG-0204 3"});
  CHECK(found.all[0].hint == "did you mean retract?");
}

TEST_CASE("options are checked for type, range and presence") {
  Plugin plugin("p");
  plugin.syntax("S").options = {
      option("choice", IG_OPTION_CHOICE, "a", "a|b"), option("number", IG_OPTION_NUMBER, "1", "", 0, 2),
      option("integer", IG_OPTION_INTEGER, "1", "", 0, 2), option("boolean", IG_OPTION_BOOLEAN, "true")};
  plugin.syntax("Demanding").options = {option("needed", IG_OPTION_TEXT, nullptr)};
  const std::vector<std::pair<const char*, const char*>> wrong{
      {"choice", "c"},   {"choice", ""},     {"number", "2.1"}, {"number", "-1"}, {"number", "1e0"},  {"number", "x"},
      {"number", "nan"}, {"integer", "1.5"}, {"integer", "3"},  {"boolean", "1"}, {"boolean", "True"}};
  for (const auto& given : wrong) {
    CAPTURE(given.first, given.second);
    Hand hand{"p"};
    hand.add("S", {given});
    CHECK(faults(hand, {&plugin}) == Strings{"IG-0205 3"});
  }
  Hand right{"p"};
  right.add("S", {{"choice", "b"}, {"number", "0.5"}, {"integer", "2"}, {"boolean", "false"}});
  CHECK(faults(right, {&plugin}).empty());
  Hand missing{"p"};
  missing.add("Demanding");
  CHECK(faults(missing, {&plugin}) == Strings{"IG-0213 2"});
  Hand every_fault{"p"};
  every_fault.add("S", {{"choice", "c"}, {"number", "3"}, {"nothing", ""}});
  every_fault.add("Demanding");
  CHECK(faults(every_fault, {&plugin}) == Strings{"IG-0205 3", "IG-0205 4", "IG-0204 5", "IG-0213 6"});
}

TEST_CASE("rows fit their table") {
  Plugin plugin("p");
  Dependency& table = plugin.dependency("Table");
  table.out.row_element = "Row";
  table.out.row_key = "id";
  table.columns = {column("X", nullptr, -10, 10)};
  plugin.dependency("Flat");
  Hand hand{"p"};
  DependencyElement& element = hand.depend("Table");
  const auto row = [&](DependencyElement& e, const char* name, std::vector<std::pair<const char*, const char*>> given) {
    TableRow out{name, {}, hand.next()};
    for (const auto& [key, value] : given) out.attributes.push_back({key, value, out.where});
    e.rows.push_back(out);
  };
  row(element, "Row", {{"id", "a"}, {"X", "-10"}});
  row(element, "Raw", {{"id", "a"}});
  row(element, "Row", {{"X", "1"}});
  row(element, "Row", {{"id", "b"}, {"Y", "1"}});
  row(element, "Row", {{"id", "c"}, {"X", "11"}});
  row(element, "Row", {{"id", "d"}, {"X", "eleven"}});
  row(element, "Row", {{"id", "a"}});
  row(hand.depend("Flat"), "Row", {});
  CHECK(faults(hand, {&plugin}) ==
        Strings{"IG-0217 4", "IG-0218 5", "IG-0219 6", "IG-0220 7", "IG-0220 8", "IG-0433 9", "IG-0217 11"});
}

TEST_CASE("stages, sizes and lives that cannot be") {
  Plugin plugin("p");
  plugin.syntax("Ahead").out.look_ahead = 2;
  plugin.syntax("Inspector").out.inspects = 1;
  plugin.syntax("Text").fields = {field("Acme.Note", IG_READ | IG_WRITE, IG_TEXT, IG_LIFE_MODAL)};
  plugin.syntax("S");
  Hand hand{"p"};
  hand.add("Ahead");
  hand.add("Inspector");
  CHECK(faults(hand, {&plugin}) == Strings{"IG-0221 2", "IG-0223 3"});
  Hand right{"p"};
  right.add("Ahead", {}, Stage::post_logic);
  right.add("Inspector", {}, Stage::inspection);
  CHECK(faults(right, {&plugin}).empty());
  Hand text{"p"};
  text.add("Text");
  CHECK(faults(text, {&plugin}).at(0) == "IG-0222 2");
  Hand large{"p"};
  for (int i = 0; i < 1025; ++i) large.add("S").alias = "S" + std::to_string(i);
  CHECK(faults(large, {&plugin}) == Strings{"IG-0216 0"});
}

TEST_CASE("severities of the dialect hold while it is linked; an error stays one") {
  Plugin plugin("p");
  plugin.syntax("Writer").fields = {field("Acme.Level", IG_WRITE)};
  plugin.syntax("Needy").services = {{sizeof(ig_service_decl), 0, "test.offset/1", ""}};
  DiagnosticList found;
  Hand hand{"p"};
  hand.add("Writer");
  hand.dialect.severities["IG-0212"] = {Severity::warning, {}};
  faults(hand, {&plugin}, &found);
  CHECK(found.all.at(0).severity == Severity::warning);
  hand.add("Needy");
  hand.dialect.severities["IG-0211"] = {Severity::note, {}};
  faults(hand, {&plugin}, &found);
  CHECK(found.all.at(0).severity == Severity::error);
}

TEST_CASE("a severity for a code that no plugin declares is named") {
  Plugin plugin("p");
  plugin.syntax("S");
  plugin.diagnostics = {{sizeof(ig_diagnostic_decl), IG_NOTE, "ONE-1", "text", "", ""}};
  Plugin other("q");
  other.diagnostics = {{sizeof(ig_diagnostic_decl), IG_NOTE, "TWO-1", "text", "", ""}};
  Hand hand{"p"};
  hand.add("S");
  hand.dialect.severities["ONE-1"] = {Severity::warning, {"hand.xml", 3, 1}};
  hand.dialect.severities["IG-0212"] = {Severity::warning, {"hand.xml", 4, 1}};
  CHECK(faults(hand, {&plugin, &other}).empty());
  hand.dialect.severities["ONE-2"] = {Severity::warning, {"hand.xml", 5, 1}};
  hand.dialect.severities["TWO-1"] = {Severity::warning, {"hand.xml", 6, 1}};
  CHECK(faults(hand, {&plugin, &other}) == Strings{"IG-0235 5"});
}

TEST_CASE("the first of two providers of a plugin's name is kept") {
  Plugin one("same"), two("same"), three("other");
  one.syntax("A");
  two.syntax("B");
  three.syntax("A");
  Library library({});
  library.add(one.get());
  library.add(two.get());
  library.add(three.get());
  CHECK(library.plugins().size() == 1);
  REQUIRE(library.refused().size() == 2);
  CHECK(library.refused()[0].code == "IG-0306");
  CHECK(library.refused()[1].code == "IG-0307");
}

TEST_CASE("a code that means two things in two plugins is told, and one that they share is not") {
  Plugin first("first"), second("second");
  first.diagnostics = {{sizeof(ig_diagnostic_decl), IG_ERROR, "ACME-0001", "text", "why", "example"},
                       {sizeof(ig_diagnostic_decl), IG_ERROR, "ACME-0002", "shared", "why", "example"},
                       {sizeof(ig_diagnostic_decl), IG_ERROR, "ACME-0003", "text", "why", "example"}};
  second.diagnostics = first.diagnostics;
  second.diagnostics[0].text = "another text";
  second.diagnostics[2].severity = IG_WARNING;
  Library library({});
  library.add(first.get());
  library.add(second.get());
  const std::vector<Diagnostic> found = library.shared_codes();
  REQUIRE(found.size() == 2);
  CHECK(found[0].code == "IG-0310");
  CHECK(found[0].message.find("ACME-0001") != std::string::npos);
  CHECK(found[1].message.find("ACME-0003") != std::string::npos);
}

TEST_CASE("faults of parts hide no fault of the order") {
  Plugin plugin("p");
  plugin.syntax("A").before = {"B"};
  plugin.syntax("B");
  Hand hand{"p"};
  hand.add("B");
  hand.add("Missing");
  hand.add("A", {{"unknown", "1"}});
  CHECK(faults(hand, {&plugin}) == Strings{"IG-0202 3", "IG-0204 5", "IG-0207 4"});
}
