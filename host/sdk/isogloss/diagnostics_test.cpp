#include "isogloss/diagnostics.hpp"

#include <catch2/catch.hpp>

const char* ig::embedded_page(const char*) noexcept { return nullptr; }
const char* ig::embedded_folder(const char*) noexcept { return nullptr; }
const ig::EmbeddedDiagnostic* ig::embedded_diagnostic(const char* code) noexcept {
  static constexpr EmbeddedDiagnostic words{"ACME-0002", "from the page", "M2"};
  return std::string_view(code) == words.code ? &words : nullptr;
}

TEST_CASE("a plugin's table holds each diagnostic once, in the order of codes") {
  ig::detail::DiagnosticTable table;
  table.add(std::array{ig::diagnostic(IG_ERROR, "ACME-0003", "three", "why", "M3")});
  table.add(std::array{ig::diagnostic(IG_ERROR, "ACME-0002", "two"), ig::diagnostic(IG_ERROR, "ACME-0003", "three")});
  const auto rows = table.complete({});
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].code == std::string_view("ACME-0002"));
  CHECK(table.find("ACME-0002") == 0);
  CHECK(table.find("ACME-0003") == 1);
  CHECK(table.find("ACME-0001") == ig::detail::DiagnosticTable::no_such_row);
  CHECK(table.find("ACME-0004") == ig::detail::DiagnosticTable::no_such_row);
}

TEST_CASE("two rows with one code and two texts both stay, so that the host refuses the plugin") {
  ig::detail::DiagnosticTable table;
  table.add(std::array{ig::diagnostic(IG_ERROR, "ACME-0002", "two")});
  table.add(std::array{ig::diagnostic(IG_ERROR, "ACME-0002", "another two")});
  table.add(std::array{ig::diagnostic(IG_NOTE, "ACME-0003", "three"), ig::diagnostic(IG_ERROR, "ACME-0003", "three")});
  CHECK(table.complete({}).size() == 4);
}

TEST_CASE("explanation and example come from the page where the source gives none") {
  ig::detail::DiagnosticTable table;
  table.add(std::array{ig::diagnostic(IG_NOTE, "ACME-0002", "two"),
                       ig::diagnostic(IG_NOTE, "ACME-0003", "three", "why", "M3"),
                       ig::diagnostic(IG_NOTE, "ACME-0004", "four")});
  const auto rows = table.complete({});
  CHECK(rows[0].explanation == std::string_view("from the page"));
  CHECK(rows[0].example == std::string_view("M2"));
  CHECK(rows[1].explanation == std::string_view("why"));
  CHECK(rows[2].explanation == std::string_view(""));
}

TEST_CASE("the diagnostics given to ISOGLOSS_PLUGIN() come first and keep their numbers") {
  ig::detail::DiagnosticTable table;
  table.add(std::array{ig::diagnostic(IG_ERROR, "ACME-0001", "one", "why", "M1")});
  const std::array leading{ig::diagnostic(IG_ERROR, "ACME-0009", "nine", "why", "M9"),
                           ig::diagnostic(IG_ERROR, "ACME-0008", "eight", "why", "M8")};
  const auto rows = table.complete(leading);
  REQUIRE(rows.size() == 3);
  CHECK(table.find("ACME-0009") == 0);
  CHECK(table.find("ACME-0008") == 1);
  CHECK(table.find("ACME-0001") == 2);
}
