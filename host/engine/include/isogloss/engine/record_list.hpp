/// The records of a block: the steps of a cycle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "isogloss.h"

namespace isogloss {

struct ListData {
  std::uint32_t stride = 0;
  std::uint32_t count = 0, room = 0;  ///< records
  std::vector<ig_value> values;
  std::vector<std::uint64_t> present;

  ig_value* record(std::size_t index) { return values.data() + index * stride; }
  std::span<const std::uint64_t> masks() const { return {present.data(), count}; }
  std::span<std::uint64_t> masks() { return {present.data(), count}; }
  bool has_room() const { return count < room; }
  void make_room() { make_room(room + room / 2 + 8); }
  void make_room(std::uint32_t records) {
    room = records;
    present.resize(room);
    values.resize(std::size_t{room} * stride);
  }
  /// One more record, for which there is room. What `mask` does not say is present is undefined.
  ig_value* add(std::uint64_t mask) {
    present[count] = mask;
    return record(count++);
  }
  /// The memory stays allocated, up to what a copy of the block may cost.
  void clear() {
    constexpr std::uint32_t most_kept = 128;
    count = 0;
    if (room > most_kept) make_room(most_kept);
  }
};

}  // namespace isogloss
