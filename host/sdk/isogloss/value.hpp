/// Values as the author of a plugin sees them: statuses, names, points. Lengths in mm.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "isogloss.h"

namespace ig {

/// What build() returns: whether it changed the block, or that it failed.
enum class Status : std::int32_t { unchanged = IG_UNCHANGED, changed = IG_CHANGED, failed = IG_FAILED };

/// An interned name. Within one chain, equal names are equal symbols; id 0 is no name.
struct Symbol {
  std::uint64_t id = 0;
  friend constexpr bool operator==(Symbol, Symbol) = default;
};

/// A point or vector in mm; index 0 is X.
struct Vec3 {
  double x = 0, y = 0, z = 0;
  constexpr double& operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr double operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
  friend constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
};

/// Values for some of the three axes: bit 0 of the mask is X.
struct PartialVec3 {
  std::uint32_t mask = 0;
  Vec3 value;
  constexpr bool has(std::size_t axis) const { return (mask >> axis & 1u) != 0; }
  constexpr bool complete() const { return mask == 7u; }
  constexpr Vec3 or_else(const Vec3& other) const {
    if (complete()) return value;
    return {has(0) ? value.x : other.x, has(1) ? value.y : other.y, has(2) ? value.z : other.z};
  }
};

/// Texts cross the boundary as ig_text, which borrows its bytes.
inline ig_text to_text(std::string_view s) { return {s.data(), s.size()}; }
inline std::string_view to_view(ig_text t) { return {t.data, t.size}; }

namespace detail {

template <class T>
struct ValueOf;
template <>
struct ValueOf<double> {
  static constexpr ig_type type = IG_NUMBER;
  static double read(ig_value v) { return v.number; }
  static ig_value write(double n) { return {.number = n}; }
};
template <>
struct ValueOf<std::int64_t> {
  static constexpr ig_type type = IG_INTEGER;
  static std::int64_t read(ig_value v) { return v.integer; }
  static ig_value write(std::int64_t n) {
    ig_value v;
    v.integer = n;
    return v;
  }
};
template <>
struct ValueOf<bool> {
  static constexpr ig_type type = IG_BOOLEAN;
  static bool read(ig_value v) { return v.integer != 0; }
  static ig_value write(bool n) {
    ig_value v;
    v.integer = n ? 1 : 0;
    return v;
  }
};
template <>
struct ValueOf<Symbol> {
  static constexpr ig_type type = IG_SYMBOL;
  static Symbol read(ig_value v) { return {v.symbol}; }
  static ig_value write(Symbol s) {
    ig_value v;
    v.symbol = s.id;
    return v;
  }
};

inline ig_argument argument(double number) { return {0, 0, number, {nullptr, 0}}; }
inline ig_argument argument(std::string_view text) { return {1, 0, 0, to_text(text)}; }

}  // namespace detail

/// The value of a code that is present in a block.
inline const ig_value present = detail::ValueOf<bool>::write(true);

}  // namespace ig
