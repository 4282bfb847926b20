#include "link/pattern.hpp"

#include <catch2/catch.hpp>

using isogloss::FieldPattern;

TEST_CASE("braces behind a pattern ask for the unit of the field") {
  const FieldPattern pattern("Parsing.**{mm}");
  CHECK(pattern.owner_unit().empty());
  CHECK(pattern.matches("Parsing.G81.X", "mm"));
  CHECK(pattern.matches("Parsing.X", "mm"));
  CHECK_FALSE(pattern.matches("Parsing.G81.P", "s"));
}

TEST_CASE("braces inside a pattern ask for the unit of what owns the field") {
  const FieldPattern pattern("Parsing.*{canned-cycle}.X");
  CHECK(pattern.path() == "Parsing.*.X");
  CHECK_FALSE(pattern.is_literal());
  CHECK(pattern.owner_unit() == "canned-cycle");
  CHECK(pattern.matches("Parsing.G181.X", "mm"));
  CHECK_FALSE(pattern.matches("Parsing.G181.Y", "mm"));
  CHECK(pattern.owner("Parsing.G181.X") == "Parsing.G181");
  CHECK(pattern.owner("Parsing.G68.2.X") == "Parsing.G68.2");
}

TEST_CASE("a pattern may ask for both units") {
  const FieldPattern pattern("Parsing.*{canned-cycle}.*{mm}");
  CHECK(pattern.owner_unit() == "canned-cycle");
  CHECK(pattern.matches("Parsing.G181.X", "mm"));
  CHECK_FALSE(pattern.matches("Parsing.G181.P", "s"));
}

TEST_CASE("a star stands for one segment, with the decimals of a code") {
  const FieldPattern pattern("Parsing.*.X");
  CHECK(pattern.matches("Parsing.G81.X", ""));
  CHECK(pattern.matches("Parsing.G68.2.X", ""));
  CHECK(pattern.matches("Parsing.Flags.X", ""));
  CHECK_FALSE(pattern.matches("Parsing.X", ""));
  CHECK_FALSE(pattern.matches("Parsing.G81.R.X", ""));
  CHECK_FALSE(pattern.matches("Parsing.G81.2.3.X", ""));
  CHECK_FALSE(pattern.matches("Parsing.Flags.2.X", ""));
}
