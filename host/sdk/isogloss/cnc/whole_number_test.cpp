#include "isogloss/cnc/whole_number.hpp"

#include <catch2/catch.hpp>

#include <limits>

using ig::cnc::whole_number;

TEST_CASE("whole numbers from 0 to 99999999 are numbers of tools and rows") {
  for (const double n : {0.0, -0.0, 1.0, 99999999.0}) CHECK(whole_number(n) == static_cast<std::int64_t>(n));
}

TEST_CASE("a negative number, a fraction, a number of nine digits, infinity and NaN name nothing") {
  using Limits = std::numeric_limits<double>;
  for (const double n :
       {-1.0, -1e-9, 0.5, 12.000001, 100000000.0, Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()})
    CHECK_FALSE(whole_number(n).has_value());
}
