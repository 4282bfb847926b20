#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "dialect/order_patch.hpp"

namespace isogloss::cli {

namespace {

std::vector<std::string_view> split_lines(std::string_view text) {
  std::vector<std::string_view> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    out.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return out;
}

struct Change {
  char sign;  // ' ', '-', '+'
  std::string_view line;
};

/// The longest common part stays; what both begin and end with is not compared.
std::vector<Change> changes(const std::vector<std::string_view>& before, const std::vector<std::string_view>& after) {
  std::size_t head = 0, tail = 0;
  const std::size_t shortest = std::min(before.size(), after.size());
  while (head < shortest && before[head] == after[head]) ++head;
  while (tail < shortest - head && before[before.size() - 1 - tail] == after[after.size() - 1 - tail]) ++tail;
  const std::size_t n = before.size() - head - tail, m = after.size() - head - tail;
  std::vector<std::vector<std::uint32_t>> common(n + 1, std::vector<std::uint32_t>(m + 1));
  for (std::size_t i = n; i-- > 0;)
    for (std::size_t j = m; j-- > 0;)
      common[i][j] =
          before[head + i] == after[head + j] ? common[i + 1][j + 1] + 1 : std::max(common[i + 1][j], common[i][j + 1]);
  std::vector<Change> out;
  for (std::size_t i = 0; i < head; ++i) out.push_back({' ', before[i]});
  for (std::size_t i = 0, j = 0; i < n || j < m;) {
    if (i < n && j < m && before[head + i] == after[head + j]) {
      out.push_back({' ', before[head + i]});
      ++i, ++j;
    } else if (j == m || (i < n && common[i + 1][j] >= common[i][j + 1])) {
      out.push_back({'-', before[head + i++]});
    } else {
      out.push_back({'+', after[head + j++]});
    }
  }
  for (std::size_t i = before.size() - tail; i < before.size(); ++i) out.push_back({' ', before[i]});
  return out;
}

std::string hunk(const std::vector<Change>& all, std::size_t begin, std::size_t end) {
  std::size_t old_begin = 1, new_begin = 1, old_count = 0, new_count = 0;
  for (std::size_t i = 0; i < begin; ++i) old_begin += all[i].sign != '+', new_begin += all[i].sign != '-';
  std::string lines;
  for (std::size_t i = begin; i < end; ++i) {
    old_count += all[i].sign != '+';
    new_count += all[i].sign != '-';
    lines += all[i].sign;
    lines += all[i].line;
    if (!all[i].line.ends_with('\n')) lines += "\n\\ No newline at end of file\n";
  }
  return fmt::format("@@ -{},{} +{},{} @@\n", old_begin, old_count, new_begin, new_count) + lines;
}

}  // namespace

std::string unified_diff(const std::string& path, const std::string& before, const std::string& after) {
  constexpr std::size_t context = 3;
  if (before == after) return {};
  const std::vector<Change> all = changes(split_lines(before), split_lines(after));
  std::string out = fmt::format("--- {0}\n+++ {0}\n", path);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].sign == ' ') continue;
    const std::size_t begin = i > context ? i - context : 0;
    std::size_t last = i;  // a change less than two contexts behind the last one belongs to the same hunk
    for (std::size_t k = i; k < all.size() && k <= last + 2 * context; ++k)
      if (all[k].sign != ' ') last = k;
    const std::size_t end = std::min(all.size(), last + context + 1);
    out += hunk(all, begin, end);
    i = end - 1;
  }
  return out;
}

}  // namespace isogloss::cli
