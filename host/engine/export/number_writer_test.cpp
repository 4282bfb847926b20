#include "export/number_writer.hpp"

#include <catch2/catch.hpp>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>

namespace {

std::string decimal(double value) {
  char text[isogloss::number_room];
  return {text, isogloss::write_decimal(text, value)};
}
std::string exact(double value) {
  char text[isogloss::number_room];
  return {text, isogloss::write_exact(text, value)};
}
std::string integer(std::int64_t value) {
  char text[isogloss::number_room];
  return {text, isogloss::write_integer(text, value)};
}

/// What the C library prints, trimmed.
std::string expected(double value) {
  char text[400];
  std::snprintf(text, sizeof text, "%.6f", value);
  std::string s = text;
  s.erase(s.find_last_not_of('0') + 1);
  if (s.back() == '.') s.pop_back();
  return s == "-0" ? "0" : s;
}

double read(const std::string& text) {
  double value = std::numeric_limits<double>::quiet_NaN();
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  CHECK(result.ptr == text.data() + text.size());
  return value;
}

}  // namespace

TEST_CASE("decimals by hand") {
  const std::pair<double, const char*> table[] = {
      {0, "0"},
      {-0.0, "0"},
      {1, "1"},
      {-1, "-1"},
      {0.1, "0.1"},
      {-0.5, "-0.5"},
      {10.25, "10.25"},
      {1000, "1000"},
      {999999.999999, "999999.999999"},
      {1234567.000001, "1234567.000001"},
      {3.3333333333333335, "3.333333"},
      {2.0 / 3, "0.666667"},
      {0.9999999, "1"},
      {999.9999996, "1000"},
      {25.190799999999996, "25.1908"},
      {1e-7, "0"},
      {-4e-7, "0"},
      {-6e-7, "-0.000001"},
      {0.000001, "0.000001"},
      {0.0000005, "0"},  // the double lies below the tie
      {0.0000015, "0.000002"},
      {8e6, "8000000"},
      {7999999.999999, "7999999.999999"},
      {9e12, "9000000000000"},
      {123456789012.5, "123456789012.5"},
      {1e15, "1e+15"},
      {-1e300, "-1e+300"},
  };
  for (const auto& [value, text] : table) CHECK(decimal(value) == text);
}

TEST_CASE("a value that is not finite has no text") {
  for (double value : {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                       std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(decimal(value).empty());
    CHECK(exact(value).empty());
  }
}

TEST_CASE("decimals agree with printf") {
  std::mt19937_64 random(7);
  for (double limit : {1e-6, 1e-3, 1.0, 1e3, 1e6, 7.9e6, 1e9, 9e14}) {
    std::uniform_real_distribution<double> values(-limit, limit);
    for (int i = 0; i < 20000; ++i) {
      const double value = values(random);
      REQUIRE(decimal(value) == expected(value));
    }
  }
  for (int i = -200000; i < 200000; ++i) {  // ties, and next to them
    const double value = i * 0.0000005 + (i % 7) * 100;
    REQUIRE(decimal(value) == expected(value));
  }
  for (int i = 0; i < 4000; ++i) {  // exact ties in binary
    const double value = i + 0.0000152587890625 * (2 * i + 1);
    REQUIRE(decimal(value) == expected(value));
  }
}

TEST_CASE("exact text reads back, and is the shortest") {
  CHECK(exact(3.3333333333333335) == "3.3333333333333335");
  CHECK(exact(25.190799999999996) == "25.190799999999996");
  CHECK(exact(-0.25) == "-0.25");
  CHECK(exact(-0.0) == "0");
  CHECK(exact(1e-9) == "1e-09");
  CHECK(exact(1e22) == "1e+22");
  std::mt19937_64 random(11);
  for (double limit : {1e-9, 1e-3, 1.0, 1e3, 8e6, 1e12, 1e300}) {
    std::uniform_real_distribution<double> values(-limit, limit);
    for (int i = 0; i < 20000; ++i) {
      double value = values(random);
      if (i % 2 != 0 && limit < 1e10) value = std::round(value * 1e4) / 1e4;
      const std::string text = exact(value);
      REQUIRE(read(text) == value);
      char shortest[64];
      const auto length = std::to_chars(shortest, shortest + 64, value, std::chars_format::fixed).ptr - shortest;
      REQUIRE((value == 0 || text.size() <= static_cast<std::size_t>(length)));
    }
  }
}

TEST_CASE("integers") {
  CHECK(integer(0) == "0");
  CHECK(integer(7) == "7");
  CHECK(integer(65) == "65");
  CHECK(integer(1000) == "1000");
  CHECK(integer(1000007) == "1000007");
  CHECK(integer(999999999) == "999999999");
  CHECK(integer(1000000000) == "1000000000");
  CHECK(integer(-12) == "-12");
  CHECK(integer(std::numeric_limits<std::int64_t>::min()) == "-9223372036854775808");
}
