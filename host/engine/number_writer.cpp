// Digits come in threes from a table; a value is scaled to an integer count of millionths. Where that could round to
// the wrong side of a tie, or does not fit, to_chars does the work.
#include "number_writer.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

namespace isogloss {

namespace {

/// "000" to "999"; the fourth byte counts the digits that stay when zeros at the end are trimmed.
struct Triple {
  char digits[3];
  char significant;
};

constexpr std::array<Triple, 1000> make_triples() {
  std::array<Triple, 1000> all{};
  for (unsigned i = 0; i < 1000; ++i) {
    all[i] = {{static_cast<char>('0' + i / 100), static_cast<char>('0' + i / 10 % 10), static_cast<char>('0' + i % 10)},
              static_cast<char>(i % 10 != 0 ? 3 : i % 100 != 0 ? 2 : i != 0 ? 1 : 0)};
  }
  return all;
}
constexpr std::array<Triple, 1000> triples = make_triples();

/// Without leading zeros; "0" for 0. May write up to 3 bytes past the end that it returns.
char* write_leading(char* out, std::uint32_t below_1000) {
  const Triple& t = triples[below_1000];
  const std::uint32_t skip = below_1000 >= 100 ? 0 : below_1000 >= 10 ? 1 : 2;
  std::memcpy(out, t.digits + skip, 3 - skip);
  return out + 3 - skip;
}

char* write_triple(char* out, std::uint32_t below_1000) {
  std::memcpy(out, triples[below_1000].digits, 3);
  return out + 3;
}

/// Enough for the fast path: fewer than 10 digits before the point.
char* write_whole(char* out, std::uint32_t value) {
  if (value < 1000) return write_leading(out, value);
  if (value < 1000000) return write_triple(write_leading(out, value / 1000), value % 1000);
  if (value < 1000000000) {
    out = write_leading(out, value / 1000000);
    return write_triple(write_triple(out, value / 1000 % 1000), value % 1000);
  }
  return std::to_chars(out, out + number_room, value).ptr;
}

char* write_fraction(char* out, std::uint32_t millionths) {
  if (millionths == 0) return out;
  const std::uint32_t high = millionths / 1000, low = millionths % 1000;
  *out++ = '.';
  std::memcpy(out, triples[high].digits, 3);
  if (low == 0) return out + triples[high].significant;
  std::memcpy(out + 3, triples[low].digits, 3);
  return out + 3 + triples[low].significant;
}

char* write_millionths(char* out, std::uint64_t millionths) {
  const auto whole = static_cast<std::uint32_t>(millionths / 1000000);
  return write_fraction(write_whole(out, whole), static_cast<std::uint32_t>(millionths % 1000000));
}

/// Below this the product with 1e6 is off by less than 1e-3.
constexpr double fast_limit = 8e6;

char* write_decimal_slowly(char* out, double value) {
  if (!std::isfinite(value)) return out;
  if (std::fabs(value) >= 1e15) return std::to_chars(out, out + number_room, value).ptr;
  char* end = std::to_chars(out, out + number_room, value, std::chars_format::fixed, 6).ptr;
  while (end[-1] == '0') --end;
  if (end[-1] == '.') --end;
  if (end - out == 2 && out[0] == '-' && out[1] == '0') {
    out[0] = '0';
    return out + 1;
  }
  return end;
}

}  // namespace

char* write_decimal(char* out, double value) {
  const double size = std::fabs(value);
  if (!(size < fast_limit)) return write_decimal_slowly(out, value);
  const double scaled = size * 1e6;
  const auto rounded = static_cast<std::uint64_t>(scaled + 0.5);
  const double off = scaled - static_cast<double>(static_cast<std::int64_t>(rounded));
  if (std::fabs(off) > 0.499) return write_decimal_slowly(out, value);
  *out = '-';
  out += static_cast<int>(value < 0) & static_cast<int>(rounded != 0);
  return write_millionths(out, rounded);
}

char* write_exact(char* out, double value) {
  const double size = std::fabs(value);
  if (size < fast_limit) {
    // A text of at most 15 digits that reads back is the only one so short, hence the shortest. Count and divisor are
    // exact, so the quotient is what a reader of the text gets.
    const auto rounded = static_cast<std::int64_t>(size * 1e6 + 0.5);
    if (static_cast<double>(rounded) / 1e6 == size) {
      *out = '-';
      out += static_cast<int>(value < 0);
      return write_millionths(out, static_cast<std::uint64_t>(rounded));
    }
  }
  if (!std::isfinite(value)) return out;
  return std::to_chars(out, out + number_room, value).ptr;
}

char* write_integer(char* out, std::int64_t value) {
  if (value >= 0 && value < 1000000000) return write_whole(out, static_cast<std::uint32_t>(value));
  return std::to_chars(out, out + number_room, value).ptr;
}

}  // namespace isogloss
