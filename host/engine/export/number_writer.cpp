// Digits come in threes from a table; a value is scaled to an integer count of millionths. Where that could round to
// the wrong side of a tie, or does not fit, to_chars does the work.
#include "export/number_writer.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>

namespace isogloss {

namespace {

/// "000" to "999", and how many digits stay when zeros at the end are trimmed.
struct Triple {
  char digits[3];
  char significant;
};
/// "0" to "999" without leading zeros, and its length.
struct Leading {
  char digits[3];
  char length;
};

struct Tables {
  std::array<Triple, 1000> triples{};
  std::array<Leading, 1000> leading{};
};

constexpr Tables make_tables() {
  Tables tables;
  for (unsigned i = 0; i < 1000; ++i) {
    const char digits[] = {static_cast<char>('0' + i / 100), static_cast<char>('0' + i / 10 % 10),
                           static_cast<char>('0' + i % 10)};
    tables.triples[i] = {{digits[0], digits[1], digits[2]},
                         static_cast<char>(i % 10 != 0    ? 3
                                           : i % 100 != 0 ? 2
                                           : i != 0       ? 1
                                                          : 0)};
    const unsigned skip = i >= 100 ? 0 : i >= 10 ? 1 : 2;
    Leading& leading = tables.leading[i];
    for (unsigned k = skip; k < 3; ++k) leading.digits[k - skip] = digits[k];
    leading.length = static_cast<char>(3 - skip);
  }
  return tables;
}
constexpr Tables number_tables = make_tables();

/// All writers copy four bytes where they may keep fewer: the caller's room allows for it.
inline char* write_leading(char* out, std::uint32_t below_1000) {
  const Leading& l = number_tables.leading[below_1000];
  std::memcpy(out, &l, 4);
  return out + l.length;
}

inline char* write_triple(char* out, std::uint32_t below_1000) {
  std::memcpy(out, &number_tables.triples[below_1000], 4);
  return out + 3;
}

/// Enough for the fast path: fewer than 10 digits before the point.
inline char* write_whole(char* out, std::uint32_t value) {
  if (value < 1000) return write_leading(out, value);
  if (value < 1000000) return write_triple(write_leading(out, value / 1000), value % 1000);
  if (value < 1000000000) {
    out = write_leading(out, value / 1000000);
    return write_triple(write_triple(out, value / 1000 % 1000), value % 1000);
  }
  return std::to_chars(out, out + number_room, value).ptr;
}

/// Without a branch: how many digits a coordinate has cannot be foreseen, and a wrong guess costs more than the digits.
inline char* write_fraction(char* out, std::uint32_t millionths) {
  const Triple& high = number_tables.triples[millionths / 1000];
  const Triple& low = number_tables.triples[millionths % 1000];
  *out = '.';
  std::memcpy(out + 1, &high, 4);
  std::memcpy(out + 4, &low, 4);
  const int digits = low.significant != 0 ? 3 + low.significant : high.significant;
  return out + digits + static_cast<int>(digits != 0);
}

inline char* write_millionths(char* out, std::uint64_t millionths) {
  const auto whole = static_cast<std::uint32_t>(millionths / 1000000);
  return write_fraction(write_whole(out, whole), static_cast<std::uint32_t>(millionths % 1000000));
}

/// For values from 0 to 2^52; at a tie, or next to one, either neighbour.
std::int64_t nearest(double value) {
  const double raised = value + 0.5;
  return static_cast<std::int64_t>(raised);
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
  const auto rounded = nearest(scaled);
  if (std::fabs(scaled - static_cast<double>(rounded)) > 0.499) return write_decimal_slowly(out, value);
  *out = '-';
  out += static_cast<int>(value < 0) & static_cast<int>(rounded != 0);
  return write_millionths(out, static_cast<std::uint64_t>(rounded));
}

char* write_exact(char* out, double value) {
  const double size = std::fabs(value);
  if (size < fast_limit) {
    // A text of at most 15 digits that reads back is the only one so short, hence the shortest. Count and divisor are
    // exact, so the quotient is what a reader of the text gets.
    const auto rounded = nearest(size * 1e6);
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
