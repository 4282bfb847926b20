/// Reads the numbers of variables that a dialect lists.
#include "macro/number_ranges.hpp"

#include <charconv>

namespace fanuc {
namespace {

/// Removes the number at the beginning of the text; false where none stands there.
bool remove_number(std::string_view& text, std::uint32_t& out) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (error != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

}  // namespace

std::optional<NumberRanges> NumberRanges::read(std::string_view text) {
  NumberRanges out;
  while (true) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    if (text.empty()) return out;
    Range range{};
    if (!remove_number(text, range.first)) return std::nullopt;
    range.last = range.first;
    if (!text.empty() && text.front() == '-') {
      text.remove_prefix(1);
      if (!remove_number(text, range.last)) return std::nullopt;
    }
    if (range.last < range.first || range.last > 999'999 || (!text.empty() && text.front() != ' ')) return std::nullopt;
    out.ranges_.push_back(range);
  }
}

}  // namespace fanuc
