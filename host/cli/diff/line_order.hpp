/// Which lines of two programs belong together, by their text. 16 bytes are kept for each line; time grows with the
/// number of lines, and with no product of both.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "isogloss/engine/runner.hpp"

namespace isogloss::cli::parting {

/// A line by three readings of it, the strictest first: as it is, without its first word (which may be a number of the
/// line), and without any digits.
struct LineText {
  std::array<std::uint32_t, 3> hash{};
};

/// Lines end as in the run: LF, CR or both.
std::vector<LineText> read_lines(Source& source);

/// One order for the lines of both programs: lines that belong together have the same rank.
class LineOrder {
 public:
  LineOrder(const std::vector<LineText>& a, const std::vector<LineText>& b);
  /// Lines count from 1. Behind the last line follow the ranks behind all others.
  std::uint32_t rank(int side, std::uint32_t line) const {
    const std::vector<std::uint32_t>& ranks = ranks_[static_cast<std::size_t>(side)];
    return line - 1 < ranks.size() ? ranks[line - 1] : end_ + line - static_cast<std::uint32_t>(ranks.size());
  }

 private:
  std::array<std::vector<std::uint32_t>, 2> ranks_;
  std::uint32_t end_ = 0;
};

}  // namespace isogloss::cli::parting
