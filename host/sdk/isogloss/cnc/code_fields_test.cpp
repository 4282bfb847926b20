#include "isogloss/cnc/code_fields.hpp"

#include <catch2/catch.hpp>

using ig::cnc::CodeFields;
using ig::cnc::CodeName;

TEST_CASE("a code has two digits at least, and one decimal where it is not 0") {
  CHECK(CodeName('G', 40).text() == "G04");
  CHECK(CodeName('G', 541).text() == "G54.1");
  CHECK(CodeName('M', 1230).text() == "M123");
  CHECK(CodeName('M', 0).text() == "M00");
}

TEST_CASE("a code is a number from 0 to 9999, whole or with one decimal") {
  CHECK(CodeFields::index_of(54.1) == 541);
  CHECK(CodeFields::index_of(0) == 0);
  CHECK(CodeFields::index_of(9999) == 99990);
  for (const double number : {-1.0, 1.55, 10000.0, 1e300}) CHECK_FALSE(CodeFields::index_of(number).has_value());
}
