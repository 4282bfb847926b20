/// Two short sequences side by side, in their order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace isogloss::cli::parting {

/// Elements that belong together; -1: only on the other side.
struct Match {
  int a = -1, b = -1;
};

/// The pairs with the greatest sum of weight(i, j), which is 0 where two elements cannot be a pair. As many elements on
/// both sides, or too many for it, are paired one by one.
template <class Weight>
std::vector<Match> match_in_order(int n, int m, const Weight& weight) {
  std::vector<Match> out;
  constexpr int most = 400;
  if (n == m || n > most || m > most) {
    for (int i = 0; i < std::max(n, m); ++i) out.push_back({i < n ? i : -1, i < m ? i : -1});
    return out;
  }
  const auto at = [row = static_cast<std::size_t>(m) + 1](int i, int j) {
    return static_cast<std::size_t>(i) * row + static_cast<std::size_t>(j);
  };
  std::vector<int> best(at(n + 1, 0)), weights(best.size());
  for (int i = n; i-- > 0;)
    for (int j = m; j-- > 0;) {
      const int w = weights[at(i, j)] = weight(i, j);
      best[at(i, j)] = std::max({best[at(i + 1, j)], best[at(i, j + 1)], w > 0 ? best[at(i + 1, j + 1)] + w : 0});
    }
  int i = 0, j = 0;
  while (i < n && j < m) {
    const int w = weights[at(i, j)];
    if (w > 0 && best[at(i, j)] == best[at(i + 1, j + 1)] + w)
      out.push_back({i++, j++});
    else if (best[at(i + 1, j)] >= best[at(i, j + 1)])
      out.push_back({i++, -1});
    else
      out.push_back({-1, j++});
  }
  while (i < n) out.push_back({i++, -1});
  while (j < m) out.push_back({-1, j++});
  return out;
}

}  // namespace isogloss::cli::parting
