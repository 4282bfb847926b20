/// Numbers of variables as a dialect lists them: "100-199 500".
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace fanuc {

/// The ranges may stand in any order.
class NumberRanges {
 public:
  struct Range {
    std::uint32_t first, last;
  };
  /// Nothing where the text is not a list of ranges.
  static std::optional<NumberRanges> read(std::string_view text);

  bool holds(std::uint32_t number) const {
    return std::any_of(ranges_.begin(), ranges_.end(),
                       [&](const Range& r) { return number >= r.first && number <= r.last; });
  }
  const std::vector<Range>& all() const { return ranges_; }

 private:
  std::vector<Range> ranges_;
};

}  // namespace fanuc
