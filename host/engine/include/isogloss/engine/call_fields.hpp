/// Calls of a syntax name the same fields block after block: what was found out about them is remembered.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

#include "isogloss.h"

namespace isogloss {

/// For comparing ids of fields four at once.
using FourFields [[gnu::vector_size(4 * sizeof(ig_field))]] = ig_field;
inline FourFields four_fields(const ig_field* first) {
  FourFields out;
  std::memcpy(&out, first, sizeof out);
  return out;
}
inline bool is_zero(const FourFields& ids) {
  std::uint64_t halves[2];
  std::memcpy(halves, &ids, sizeof halves);
  return (halves[0] | halves[1]) == 0;
}

/// Are they the same ids? Few of them, four at once: a call of memcmp() would take longer.
inline bool are_same(const ig_field* some, const ig_field* others, std::uint32_t count) {
  if (count < 4) {
    ig_field differences = 0;
    for (std::uint32_t i = 0; i < count; ++i) differences |= some[i] ^ others[i];
    return differences == 0;
  }
  FourFields differences = four_fields(some) ^ four_fields(others);
  for (std::uint32_t i = 4; i + 4 < count; i += 4) differences |= four_fields(some + i) ^ four_fields(others + i);
  const std::uint32_t last = count - 4;  // some of these are compared twice
  return is_zero(differences | (four_fields(some + last) ^ four_fields(others + last)));
}

/// What was found out about the fields of a call, by the place where they stand; other fields may stand there later.
/// Each place has a home, which others may share: those are kept in three further ways. A copy of a block begins
/// without.
template <class Found>
class FoundByPlace {
 public:
  static constexpr std::size_t ways = 4;
  static constexpr int home_bits = 10;  // so many that few of the places that every block uses share a home

  FoundByPlace() = default;
  FoundByPlace(const FoundByPlace&) {}
  FoundByPlace& operator=(const FoundByPlace&) { return *this; }

  /// Places whose homes differ in the lower two bits alone share their ways.
  static std::size_t home(const ig_field* fields) {
    constexpr std::uint64_t mixes = 0x9e37'79b9'7f4a'7c15;  // all bits of an address into the upper ones
    return reinterpret_cast<std::uintptr_t>(fields) * mixes >> (64 - home_bits);
  }
  /// What is kept at its home: of these fields or of others. Where it is of others, beside() tells more.
  Found& at(const ig_field* fields) {
    std::uint8_t& number = numbers_[home(fields)];
    if (number == none) [[unlikely]]
      number = add();
    return found_[number];
  }
  /// For fields that at() does not give: what was found out about them, or what to write it into; the caller tells by
  /// is(). The newest gets its home for itself: it is the one that is likely to come again.
  Found& beside(const ig_field* fields, std::uint32_t count) {
    const std::size_t own = home(fields);
    std::size_t free = own;
    for (std::size_t way = 1; way < ways; ++way) {
      const std::uint8_t number = numbers_[own ^ way];
      if (number == none)
        free = own ^ way;
      else if (found_[number].is(fields, count))
        return found_[number];
    }
    if (free != own && found_[numbers_[own]].is_known()) {
      numbers_[free] = numbers_[own];
      numbers_[own] = add();
    }
    return found_[numbers_[own]];
  }

 private:
  [[gnu::cold, gnu::noinline]] std::uint8_t add() {
    if (found_.size() < most) found_.emplace_back();
    return static_cast<std::uint8_t>(next_++ % most);
  }

  static constexpr std::uint8_t none = 0xff;
  static constexpr std::uint32_t most = 128;
  std::array<std::uint8_t, std::size_t{1} << home_bits> numbers_ = [] {
    std::array<std::uint8_t, std::size_t{1} << home_bits> out;
    out.fill(none);
    return out;
  }();
  std::uint32_t next_ = 0;
  std::vector<Found> found_;
};

/// The fields of one call whose bits lie in one word, as those of one code mostly do.
struct FieldGroup {
  static constexpr std::uint32_t least_fields = 4, most_fields = 16;
  std::uint32_t count = 0;  ///< 0: none was found yet
  std::uint32_t word = 0;
  std::uint64_t mask = 0;  ///< their bits; 0: they do not lie in one word, or one of them stands there twice
  std::array<ig_field, most_fields> fields{};
  std::array<std::uint8_t, 64> index{};  ///< of a field among these, by its bit

  bool is_known() const { return count != 0; }
  bool is(const ig_field* wanted, std::uint32_t wanted_count) const {
    return count == wanted_count && are_same(fields.data(), wanted, wanted_count);
  }
};

/// The fields of one call, which have been found to lie in one list.
struct RecordShape {
  static constexpr std::uint32_t most_fields = 16, none = ~0u;
  std::uint32_t count = none;  ///< more fields than most_fields are not remembered
  std::uint32_t list = 0;
  std::uint64_t mask = 0;  ///< a bit for each field of the record
  std::array<ig_field, most_fields> fields{};

  bool is_known() const { return count != none; }
  bool is(const ig_field* wanted, std::uint32_t wanted_count) const {
    return count == wanted_count && count <= most_fields && are_same(fields.data(), wanted, wanted_count);
  }
};

}  // namespace isogloss
