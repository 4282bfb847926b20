/// Names of work offsets as the tables have them: "EXT", "G54" to "G59.9", "G54.1P12". Allocates nothing.
#pragma once

#include <array>
#include <charconv>
#include <string_view>

#include "isogloss/cnc/whole_number.hpp"

namespace ig::cnc {

/// The name that a P number means; text() is empty where the number names no work offset.
class WorkOffsetId {
 public:
  /// P of G10 L2: 0 is the external offset, 1 to 6 are G54 to G59.
  static WorkOffsetId basic(double p) {
    static constexpr std::array<std::string_view, 7> names{"EXT", "G54", "G55", "G56", "G57", "G58", "G59"};
    const auto n = whole_number(p);
    return WorkOffsetId(n && *n < 7 ? names[static_cast<std::size_t>(*n)] : "");
  }

  /// P of G54.1 and of G10 L20: a whole number from 1.
  static WorkOffsetId additional(double p) {
    const auto n = whole_number(p);
    if (!n || *n == 0) return WorkOffsetId("");
    WorkOffsetId id("G54.1P");
    char* const first = id.buffer_.data() + id.size_;
    id.size_ = static_cast<std::size_t>(std::to_chars(first, id.buffer_.data() + id.buffer_.size(), *n).ptr -
                                        id.buffer_.data());
    return id;
  }

  /// P where one number covers all work offsets: 0 is the external offset, 1 to 6 are G54 to G59, 7 to 15 are G59.1 to
  /// G59.9, 16 and above are G54.1 P16 and above.
  static WorkOffsetId of_all(double p) {
    static constexpr std::array<std::string_view, 9> further{"G59.1", "G59.2", "G59.3", "G59.4", "G59.5",
                                                             "G59.6", "G59.7", "G59.8", "G59.9"};
    const auto n = whole_number(p);
    if (!n || *n < 7) return basic(p);
    return *n < 16 ? WorkOffsetId(further[static_cast<std::size_t>(*n - 7)]) : additional(p);
  }

  std::string_view text() const { return {buffer_.data(), size_}; }

 private:
  explicit WorkOffsetId(std::string_view text) : size_(text.copy(buffer_.data(), buffer_.size())) {}

  std::array<char, 24> buffer_{};
  std::size_t size_;
};

}  // namespace ig::cnc
