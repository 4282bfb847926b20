#include "isogloss/engine/diagnostic_writer.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace isogloss;

namespace {

Diagnostic warning(std::string message = "odd") {
  return {Severity::warning, "AB-1", std::move(message), {"part.nc", 3, 5}, 8, ""};
}

/// What a writer with this policy says of these.
std::string said(DiagnosticPolicy policy, const std::vector<Diagnostic>& all) {
  std::string out;
  DiagnosticWriter writer(policy, [&](std::string_view text) { out += text; });
  for (const Diagnostic& d : all) writer.add(d);
  writer.finish();
  return out;
}

}  // namespace

TEST_CASE("Text has place, severity, message, code and hint") {
  Diagnostic d = warning();
  d.hint = "look closer";
  CHECK(said({}, {d}) == "part.nc:3:5: warning: odd [AB-1]\n  hint: look closer\n");
  d.where = {"part.nc", 0, 0};
  d.hint.clear();
  CHECK(said({}, {d}) == "part.nc: warning: odd [AB-1]\n");
  d.where = {};
  CHECK(said({}, {d}) == "isogloss: warning: odd [AB-1]\n");
}

TEST_CASE("Text shows what a terminal would obey, and bytes that are no text") {
  CHECK(said({}, {warning("a\x1b[31m\n")}) == "part.nc:3:5: warning: a\\x1b[31m\\x0a [AB-1]\n");
  CHECK(said({}, {warning("\xc2\x9b\x33\xc2\xa0")}) == "part.nc:3:5: warning: \\x9b3\xc2\xa0 [AB-1]\n");
  CHECK(said({}, {warning("\xff")}) == "part.nc:3:5: warning: \xef\xbf\xbd [AB-1]\n");
}

TEST_CASE("Repeats of one code are counted, in each program anew") {
  std::string out;
  DiagnosticWriter writer({.repeats = 2}, [&](std::string_view text) { out += text; });
  for (std::uint32_t line = 3; line < 8; ++line) {
    Diagnostic d = warning();
    d.where.line = line;
    writer.add(d);
  }
  writer.finish_program();
  CHECK(out.ends_with("… and 3 more [AB-1]\n"));
  CHECK(std::count(out.begin(), out.end(), '\n') == 3);
  writer.add(warning());
  writer.finish();
  CHECK(std::count(out.begin(), out.end(), '\n') == 4);
  CHECK(writer.warnings() == 6);
  CHECK(writer.by_code().at("AB-1").number == 6);
}

TEST_CASE("An error with other words is said beyond the repeats, one with other numbers is not") {
  std::string out;
  DiagnosticWriter writer({.repeats = 1}, [&](std::string_view text) { out += text; });
  for (const char* const message : {"I1.5 is odd", "I-2 is odd", "J3 is odd", "J4 'is' odd", "J5 'was' odd"}) {
    Diagnostic d = warning(message);
    d.severity = Severity::error;
    writer.add(d);
  }
  writer.finish();
  CHECK(out ==
        "part.nc:3:5: error: I1.5 is odd [AB-1]\npart.nc:3:5: error: J3 is odd [AB-1]\n"
        "part.nc:3:5: error: J4 'is' odd [AB-1]\n… and 2 more [AB-1]\n");
}

TEST_CASE("What a loop says again at the same place is written once") {
  CHECK(said({}, {warning(), warning("odder"), warning(), warning()}) ==
        "part.nc:3:5: warning: odd [AB-1]\npart.nc:3:5: warning: odder [AB-1]\n… and 2 more [AB-1]\n");
}

TEST_CASE("Warnings become errors on request, and errors have a limit") {
  DiagnosticWriter writer({.maximum_errors = 2, .warnings_are_errors = true}, [](std::string_view) {});
  writer.add(warning());
  CHECK(writer.errors() == 1);
  CHECK_FALSE(writer.limit_reached());
  writer.add(warning());
  CHECK(writer.limit_reached());
}

TEST_CASE("JSON Lines hold every diagnostic") {
  const std::string out = said({.style = DiagnosticStyle::json, .repeats = 1}, {warning("\"\xff\""), warning()});
  const auto first = nlohmann::json::parse(out.substr(0, out.find('\n')));
  CHECK(first["Message"] == "\"\xef\xbf\xbd\"");
  CHECK(first["Line"] == 3);
  CHECK(first["EndColumn"] == 8);
  CHECK(std::count(out.begin(), out.end(), '\n') == 2);
}

TEST_CASE("SARIF is one document, also when nothing is wrong") {
  const auto two = nlohmann::json::parse(said({.style = DiagnosticStyle::sarif}, {warning(), warning()}));
  CHECK(two["runs"][0]["results"].size() == 2);
  CHECK(two["runs"][0]["tool"]["driver"]["rules"][0]["id"] == "AB-1");
  const auto none = nlohmann::json::parse(said({.style = DiagnosticStyle::sarif}, {}));
  CHECK(none["runs"][0]["results"].empty());
}
