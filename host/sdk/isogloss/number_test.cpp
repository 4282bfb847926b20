#include "isogloss/number.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>

namespace {

void check_same(const ig::Decimal& a, const ig::Decimal& b) {
  CHECK(a.ok == b.ok);
  CHECK(a.end == b.end);
  CHECK(a.has_point == b.has_point);
  CHECK(a.decimals == b.decimals);
  CHECK(a.value == b.value);
  CHECK(std::signbit(a.value) == std::signbit(b.value));
}

}  // namespace

TEST_CASE("decimal numbers as programs write them") {
  struct Row {
    std::string_view text;
    std::size_t position;
    double value;
    std::size_t end;
    std::ptrdiff_t decimals;
    bool has_point;
  };
  for (const Row& r :
       {Row{"X10", 1, 10, 3, 0, false}, Row{"X-.5Y", 1, -0.5, 4, 1, true}, Row{"+12.", 0, 12, 4, 0, true},
        Row{"X37.028 Y-15.138", 1, 37.028, 7, 3, true}, Row{"X37.028 Y-15.138", 9, -15.138, 16, 3, true},
        Row{"Z12345.67", 1, 12345.67, 9, 2, true}, Row{"Z12345.678", 1, 12345.678, 10, 3, true},
        Row{"N12345678 X1", 1, 12345678, 9, 0, false}, Row{"Q-0.0000001", 1, -0.0000001, 11, 7, true},
        Row{"1.5.2", 0, 1.5, 3, 1, true}, Row{"0", 0, 0, 1, 0, false}}) {
    CAPTURE(r.text, r.position);
    const ig::Decimal d = ig::read_decimal(r.text, r.position);
    CHECK(d.ok);
    CHECK(d.value == r.value);
    CHECK(d.end == r.end);
    CHECK(d.decimals == r.decimals);
    CHECK(d.has_point == r.has_point);
  }
  for (const std::string_view text : {"", "-", ".", "+.", "X", "--1", "e5", "\xb3", "-.           "}) {
    CAPTURE(text);
    const ig::Decimal d = ig::read_decimal(text, 0);
    CHECK_FALSE(d.ok);
    CHECK(d.end == 0);
  }
}

TEST_CASE("a number reads the same whether its bytes are read one by one or at once") {
  std::mt19937 random(5);
  constexpr std::string_view bytes = "01234567890123456789012345....+-X \t\r,E/:;\x80\xff";
  for (int i = 0; i < 20'000; ++i) {
    std::string text(random() % 18, ' ');
    for (char& c : text) c = bytes[random() % bytes.size()];
    const std::size_t position = random() % (text.size() + 1);
    CAPTURE(text, position);
    check_same(ig::read_decimal(text, position), ig::detail::read_any_decimal(text, position));
  }
}

TEST_CASE("digits are a whole number up to 18 of them") {
  struct Row {
    std::string_view text;
    std::size_t position;
    std::uint64_t value;
    std::size_t end;
  };
  for (const Row& r : {Row{"12 L", 0, 12, 2}, Row{"N0012X", 1, 12, 5}, Row{"1234567 L X+1", 0, 1234567, 7},
                       Row{"12345678 L", 0, 12345678, 8}, Row{"123456789 L X", 0, 123456789, 9},
                       Row{"123456789012345678", 0, 123456789012345678, 18}, Row{"1.5 L", 0, 1, 1}}) {
    CAPTURE(r.text);
    const ig::Digits d = ig::read_digits(r.text, r.position);
    CHECK(d.ok);
    CHECK(d.value == r.value);
    CHECK(d.end == r.end);
  }
  for (const std::string_view text : {"", "L", "+1", "-1 LONG TEXT", ".5 LONG TEXT"}) {
    CAPTURE(text);
    CHECK_FALSE(ig::read_digits(text, 0).ok);
    CHECK(ig::read_digits(text, 0).end == 0);
  }
  const ig::Digits longer = ig::read_digits("1234567890123456789 L", 0);
  CHECK_FALSE(longer.ok);
  CHECK(longer.end == 19);
  CHECK(ig::read_digits("12", 2).end == 2);
}

TEST_CASE("digits end where they end, whether their bytes are read one by one or at once") {
  std::mt19937 random(6);
  constexpr std::string_view bytes = "012345678901234567890123456789 /:;.L\x80\xff";
  for (int i = 0; i < 20'000; ++i) {
    std::string text(random() % 24, ' ');
    for (char& c : text) c = bytes[random() % bytes.size()];
    const std::size_t position = random() % (text.size() + 1);
    CAPTURE(text, position);
    std::size_t end = position;
    std::uint64_t value = 0;
    for (; end < text.size() && text[end] >= '0' && text[end] <= '9'; ++end)
      value = value * 10 + static_cast<std::uint64_t>(text[end] - '0');
    const ig::Digits d = ig::read_digits(text, position);
    CHECK(d.end == end);
    CHECK(d.ok == (end > position && end - position <= 18));
    if (d.ok) CHECK(d.value == value);
  }
}
