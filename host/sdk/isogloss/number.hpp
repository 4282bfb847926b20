/// Reads a decimal number as programs write it: "10", "-.5", "+12."; no exponent, no other base, no locale.
#pragma once

#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace ig {

/// The result of read_decimal(). `ok` is false where no number begins at the position or no double can hold it.
struct Decimal {
  double value = 0;
  std::size_t end = 0;  ///< first position after the number; the start position where there is none
  bool has_point = false;
  bool ok = false;
  std::ptrdiff_t decimals = 0;  ///< digits after the point
};

namespace detail {

/// For more digits than two exact factors can hold. A number too small for a double becomes 0; false: it is too large.
inline bool read_long_decimal(const char* first, const char* end, double& value) {
  if (std::from_chars(first, end, value, std::chars_format::fixed).ec == std::errc{}) return true;
  while (first != end && *first == '0') ++first;
  return first == end || *first == '.';
}

inline constexpr double powers_of_ten[] = {1,   1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                           1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

/// The eight bytes from `p` on, in the order of their addresses from the lowest on; those behind the text are 0. False
/// where they cannot be read at once.
[[gnu::always_inline]] inline bool read_eight(std::string_view text, const char* p, std::uint64_t& out) {
  const std::ptrdiff_t left = text.data() + text.size() - p;
  if (left >= 8) [[likely]] {
    std::memcpy(&out, p, 8);
    return true;
  }
  if (text.size() < 8 || left <= 0) return false;
  std::memcpy(&out, text.data() + text.size() - 8, 8);
  out >>= 8 * (8 - left);
  return true;
}

/// Eight characters as digits, as read_eight() gives them: a digit becomes 0 to 9, any other character more.
constexpr std::uint64_t digit_values(std::uint64_t bytes) { return bytes ^ 0x3030303030303030; }
/// The highest bit of the first byte that is no digit; those of bytes behind it tell nothing.
constexpr std::uint64_t first_other(std::uint64_t values) {
  return ((values + 0x7676767676767676) | values) & 0x8080808080808080;
}
/// The number that the first 1 to 8 digits make.
constexpr std::uint64_t number_of(std::uint64_t values, int count) {
  values <<= 8 * (8 - count);  // leading zeros
  values = (values * 10 + (values >> 8)) & 0x00ff00ff00ff00ff;
  values = (values * 100 + (values >> 16)) & 0x0000ffff0000ffff;
  return (values * 10'000 + (values >> 32)) & 0xffffffff;
}

/// A number of at most eight digits and a point, without its sign: as nearly all are. False, with `out` as it was,
/// where it is longer, no number, or near the end of a text of a few bytes.
[[gnu::always_inline]] inline bool read_short_decimal(std::string_view text, const char* p, bool is_negative,
                                                      Decimal& out) {
  if constexpr (std::endian::native != std::endian::little) return false;
  std::uint64_t bytes;
  if (!read_eight(text, p, bytes)) return false;
  const std::uint64_t values = digit_values(bytes);
  std::uint64_t others = first_other(values);
  if (others == 0) return false;
  const int whole = std::countr_zero(others) / 8;
  std::uint64_t digits = values;
  int length = whole, count = whole;
  const bool has_point = (bytes >> (8 * whole) & 0xff) == '.';
  if (has_point) {
    others &= others - 1;
    length = others == 0 ? 8 : std::countr_zero(others) / 8;
    if (others == 0 && p + 8 != text.data() + text.size() && static_cast<unsigned char>(p[8] - '0') < 10) return false;
    count = length - 1;
    const std::uint64_t before = (std::uint64_t{1} << (8 * whole)) - 1;
    digits = (values & before) | (values >> 8 & ~before);
  }
  if (count == 0) return false;
  const auto number = static_cast<std::int64_t>(number_of(digits, count));
  const double value = static_cast<double>(number) / powers_of_ten[count - whole];
  out.value = is_negative ? -value : value;
  out.end = static_cast<std::size_t>(p - text.data() + length);
  out.has_point = has_point;
  out.ok = true;
  out.decimals = count - whole;
  return true;
}

/// A number of any length.
[[gnu::noinline]] inline Decimal read_any_decimal(std::string_view text, std::size_t position) {
  const char* const begin = text.data() + position;
  const char* const end = text.data() + text.size();
  const char* p = begin;
  const bool negative = p != end && *p == '-';
  if (p != end && (*p == '-' || *p == '+')) ++p;
  const char* const first = p;
  std::uint64_t digits = 0;
  unsigned d;
  while (p != end && (d = static_cast<unsigned>(*p) - '0') < 10) {
    digits = digits * 10 + d;
    ++p;
  }
  std::ptrdiff_t length = p - first;
  std::ptrdiff_t decimals = 0;
  Decimal out;
  if (p != end && *p == '.') {
    out.has_point = true;
    const char* const fraction = ++p;
    while (p != end && (d = static_cast<unsigned>(*p) - '0') < 10) {
      digits = digits * 10 + d;
      ++p;
    }
    decimals = p - fraction;
    length += decimals;
  }
  if (length == 0) {
    out.end = position;
    out.has_point = false;
    return out;
  }
  out.ok = true;
  out.decimals = decimals;
  out.end = static_cast<std::size_t>(p - text.data());
  double value;
  if (length <= 15) {  // both factors exact, one rounding
    value = static_cast<double>(static_cast<std::int64_t>(digits)) / powers_of_ten[decimals];
  } else {
    value = 0;
    out.ok = read_long_decimal(first, p, value);
  }
  out.value = negative ? -value : value;
  return out;
}

}  // namespace detail

/// The number that begins at `position` of the text, as the nearest double. A lone sign or a lone point is not a
/// number.
[[gnu::always_inline]] inline Decimal read_decimal(std::string_view text, std::size_t position) {
  const char* p = text.data() + position;
  const char sign = position < text.size() ? *p : '\0';
  const bool has_sign = sign == '-' || sign == '+';
  Decimal out;
  if (detail::read_short_decimal(text, p + (has_sign ? 1 : 0), sign == '-', out)) [[likely]]
    return out;
  return detail::read_any_decimal(text, position);
}

/// Digits without a sign and a point. `ok` is false where there are none or more than 18; `end` is behind them.
struct Digits {
  std::uint64_t value = 0;
  std::size_t end = 0;
  bool ok = false;
};

/// The digits that begin at `position` of the text.
inline Digits read_digits(std::string_view text, std::size_t position) {
  std::uint64_t bytes;
  if (std::endian::native == std::endian::little && detail::read_eight(text, text.data() + position, bytes)) {
    const std::uint64_t values = detail::digit_values(bytes), other = detail::first_other(values);
    const int count = std::countr_zero(other) / 8;
    if (count == 0) return {.end = position};
    if (other != 0) return {detail::number_of(values, count), position + static_cast<std::size_t>(count), true};
  }
  Digits out{.end = position};
  constexpr std::size_t most = 18;
  for (; out.end < text.size() && static_cast<unsigned char>(text[out.end] - '0') < 10; ++out.end)
    if (out.end - position < most) out.value = out.value * 10 + static_cast<unsigned char>(text[out.end] - '0');
  out.ok = out.end > position && out.end - position <= most;
  return out;
}

}  // namespace ig
