/// Reading a decimal number as programs write it: "10", "-.5", "+12.", never an exponent, a base or a locale.
#pragma once

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace ig {

struct Decimal {
  double value = 0;
  std::size_t end = 0;  ///< first position after the number; the start itself when there is none
  bool has_point = false;
  bool ok = false;
  std::ptrdiff_t decimals = 0;  ///< digits after the point
};

namespace detail {

/// More digits than two exact factors hold. Too small for a double is 0; false: too large.
inline bool read_long_decimal(const char* first, const char* end, double& value) {
  if (std::from_chars(first, end, value, std::chars_format::fixed).ec == std::errc{}) return true;
  while (first != end && *first == '0') ++first;
  return first == end || *first == '.';
}

}  // namespace detail

/// The number that begins at `position`. A lone sign or point is none, nor is what no double can hold. Exact: the
/// nearest double.
[[gnu::always_inline]] inline Decimal read_decimal(std::string_view text, std::size_t position) {
  static constexpr double powers[] = {1,   1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                      1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
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
    value = static_cast<double>(digits) / powers[decimals];
  } else {
    value = 0;
    out.ok = detail::read_long_decimal(first, p, value);
  }
  out.value = negative ? -value : value;
  return out;
}

}  // namespace ig
