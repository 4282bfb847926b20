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

/// What was found out about the fields of a call, by the place where they stand; other fields may stand there later, or
/// may share what a place has. A copy of a block begins without.
template <class Found>
class FoundByPlace {
 public:
  FoundByPlace() = default;
  FoundByPlace(const FoundByPlace&) {}
  FoundByPlace& operator=(const FoundByPlace&) { return *this; }
  Found& at(const ig_field* fields) {
    constexpr std::uint64_t mixes = 0x9e37'79b9'7f4a'7c15;  // all bits of an address into the upper ones
    std::uint8_t& number = numbers_[reinterpret_cast<std::uintptr_t>(fields) * mixes >> 56];
    if (number == none) [[unlikely]]
      number = add();
    return found_[number];
  }

 private:
  [[gnu::cold, gnu::noinline]] std::uint8_t add() {
    if (found_.size() < most) found_.emplace_back();
    return static_cast<std::uint8_t>(next_++ % most);
  }

  static constexpr std::uint8_t none = 0xff;
  static constexpr std::uint32_t most = 64;
  std::array<std::uint8_t, 256> numbers_ = [] {
    std::array<std::uint8_t, 256> out;
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

  bool is(const ig_field* wanted, std::uint32_t wanted_count) const {
    return count == wanted_count && count <= most_fields && are_same(fields.data(), wanted, wanted_count);
  }
};

}  // namespace isogloss
