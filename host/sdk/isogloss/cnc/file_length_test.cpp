#include "isogloss/cnc/file_length.hpp"

#include <catch2/catch.hpp>

#include "isogloss/cnc/units.hpp"

using namespace ig::cnc;

TEST_CASE("a length in inches becomes mm without digits that nobody wrote, and back") {
  CHECK(fixed_text(length_in_mm(3, mm_per_inch)) == "76.2");
  CHECK(fixed_text(length_in_unit(76.2, mm_per_inch)) == "3");
  for (const double mm : {120.5, -0.012, 0.003, 1e-9, 2999.999999999})
    CHECK(length_in_mm(length_in_unit(mm, mm_per_inch), mm_per_inch) == mm);
  CHECK(fixed_text(length_in_mm(0.1 + 0.2, 1)) == "0.30000000000000004");
  CHECK(fixed_text(length_in_unit(-0.25, 1)) == "-0.25");
  CHECK(fixed_text(1e21) == "1000000000000000000000");
}
