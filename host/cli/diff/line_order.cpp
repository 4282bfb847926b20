// Lines of two programs side by side. Equal beginnings and ends first; then lines whose text stands once on each side
// (patience); then, in what is left between them, the longest common subsequence where the product of both is small.
// What does not match is tried again by a looser reading of the lines: a changed line then stands beside its old form.
#include "diff/line_order.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_map>

namespace isogloss::cli::parting {

namespace {

constexpr std::uint32_t unmatched = 0xffffffffu;

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::uint32_t hash_of_text(std::string_view text) {
  const std::uint64_t h = std::hash<std::string_view>{}(text);
  return static_cast<std::uint32_t>(h ^ (h >> 32));
}

LineText line_text(std::string_view line, std::string& shape) {
  while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  std::string_view rest = line;
  std::size_t first = 0;
  while (first < line.size() && !is_blank(line[first])) ++first;
  if (first < line.size() && is_digit(line[first - 1])) rest.remove_prefix(first);
  shape.clear();
  for (const char c : line)
    if (!is_digit(c) && c != '.' && c != '-') shape += c;
  return {{hash_of_text(line), hash_of_text(rest), hash_of_text(shape)}};
}

struct Range {
  std::uint32_t a, a_end, b, b_end;
  bool is_empty() const { return a == a_end || b == b_end; }
};

class Matcher {
 public:
  Matcher(const std::vector<LineText>& a, const std::vector<LineText>& b) : a_(a), b_(b), match_(a.size(), unmatched) {}

  std::vector<std::uint32_t> match() {
    std::vector<Range> open{{0, static_cast<std::uint32_t>(a_.size()), 0, static_cast<std::uint32_t>(b_.size())}};
    for (level_ = 0; level_ < 3; ++level_) {
      left_.clear();
      for (const Range& range : open) match(range, 0);
      open.swap(left_);
    }
    for (const Range& r : open)  // lines that were written anew, as many as there were
      if (r.a_end - r.a == r.b_end - r.b)
        for (std::uint32_t i = r.a; i < r.a_end; ++i) match_[i] = r.b + (i - r.a);
    return std::move(match_);
  }

 private:
  bool same(std::uint32_t i, std::uint32_t j) const { return a_[i].hash[level_] == b_[j].hash[level_]; }

  void match(Range r, int depth) {
    while (!r.is_empty() && same(r.a, r.b)) match_[r.a++] = r.b++;
    while (!r.is_empty() && same(r.a_end - 1, r.b_end - 1)) match_[--r.a_end] = --r.b_end;
    if (r.is_empty()) return;
    constexpr int deepest = 24;
    const std::vector<std::pair<std::uint32_t, std::uint32_t>> anchors =
        depth < deepest ? unique_lines(r) : std::vector<std::pair<std::uint32_t, std::uint32_t>>{};
    if (anchors.empty()) return match_small(r);
    Range before = r;
    for (const auto& [i, j] : anchors) {
      before.a_end = i;
      before.b_end = j;
      match_between(before, depth);
      match_[i] = j;
      before.a = i + 1;
      before.b = j + 1;
    }
    before.a_end = r.a_end;
    before.b_end = r.b_end;
    match_between(before, depth);
  }
  void match_between(const Range& r, int depth) {
    if (!r.is_empty()) match(r, depth + 1);
  }

  /// Lines that stand once on each side, as many of them as stand in one order on both.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> unique_lines(const Range& r) const {
    struct Seen {
      std::uint32_t a = 0, b = 0, line_a = 0, line_b = 0;
    };
    std::unordered_map<std::uint32_t, Seen> seen;
    for (std::uint32_t i = r.a; i < r.a_end; ++i) {
      Seen& s = seen[a_[i].hash[level_]];
      ++s.a;
      s.line_a = i;
    }
    for (std::uint32_t j = r.b; j < r.b_end; ++j)
      if (const auto found = seen.find(b_[j].hash[level_]); found != seen.end()) {
        ++found->second.b;
        found->second.line_b = j;
      }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (const auto& [hash, s] : seen)
      if (s.a == 1 && s.b == 1) pairs.emplace_back(s.line_a, s.line_b);
    std::sort(pairs.begin(), pairs.end());
    return longest_rise(pairs);
  }

  static std::vector<std::pair<std::uint32_t, std::uint32_t>> longest_rise(
      const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs) {
    std::vector<std::uint32_t> tops, before(pairs.size(), unmatched);
    for (std::uint32_t p = 0; p < pairs.size(); ++p) {
      const auto top = std::lower_bound(tops.begin(), tops.end(), pairs[p].second,
                                        [&](std::uint32_t t, std::uint32_t j) { return pairs[t].second < j; });
      if (top != tops.begin()) before[p] = *(top - 1);
      if (top == tops.end())
        tops.push_back(p);
      else
        *top = p;
    }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
    for (std::uint32_t p = tops.empty() ? unmatched : tops.back(); p != unmatched; p = before[p])
      out.push_back(pairs[p]);
    std::reverse(out.begin(), out.end());
    return out;
  }

  /// The longest common subsequence; a range that is too large for it is left to the next reading of the lines.
  void match_small(const Range& r) {
    constexpr std::uint64_t most = 250'000;
    const std::uint32_t n = r.a_end - r.a, m = r.b_end - r.b;
    if (std::uint64_t{n} * m > most) return left_.push_back(r);
    const std::size_t width = m + 1;
    std::vector<std::uint32_t> longest((n + 1) * width);
    for (std::uint32_t i = n; i-- > 0;)
      for (std::uint32_t j = m; j-- > 0;)
        longest[i * width + j] = same(r.a + i, r.b + j)
                                     ? longest[(i + 1) * width + j + 1] + 1
                                     : std::max(longest[(i + 1) * width + j], longest[i * width + j + 1]);
    Range gap{r.a, r.a, r.b, r.b};
    std::uint32_t i = 0, j = 0;
    const auto close_gap = [&] {
      gap.a_end = r.a + i;
      gap.b_end = r.b + j;
      if (!gap.is_empty()) left_.push_back(gap);
    };
    while (i < n && j < m) {
      if (same(r.a + i, r.b + j)) {
        close_gap();
        match_[r.a + i] = r.b + j;
        gap = {r.a + ++i, 0, r.b + ++j, 0};
      } else if (longest[(i + 1) * width + j] >= longest[i * width + j + 1]) {
        ++i;
      } else {
        ++j;
      }
    }
    i = n;
    j = m;
    close_gap();
  }

  const std::vector<LineText>&a_, &b_;
  std::vector<std::uint32_t> match_;
  std::size_t level_ = 0;
  std::vector<Range> left_;
};

}  // namespace

std::vector<LineText> read_lines(Source& source) {
  std::vector<LineText> out;
  std::string line, shape;
  char before = '\0', buffer[1 << 16];
  while (const std::size_t n = source.read(buffer, sizeof buffer))
    for (std::size_t i = 0; i < n; ++i) {
      const char c = buffer[i];
      const bool is_half_end = before == '\r' && c == '\n';
      before = c;
      if (is_half_end) continue;
      if (c != '\n' && c != '\r') {
        line += c;
        continue;
      }
      out.push_back(line_text(line, shape));
      line.clear();
    }
  if (!line.empty()) out.push_back(line_text(line, shape));
  return out;
}

LineOrder::LineOrder(const std::vector<LineText>& a, const std::vector<LineText>& b) {
  const std::vector<std::uint32_t> match = Matcher(a, b).match();
  ranks_[0].reserve(a.size());
  ranks_[1].reserve(b.size());
  std::uint32_t rank = 1;
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    while (match[i] != unmatched && ranks_[1].size() < match[i]) ranks_[1].push_back(rank++);
    if (match[i] != unmatched) ranks_[1].push_back(rank);
    ranks_[0].push_back(rank++);
  }
  while (ranks_[1].size() < b.size()) ranks_[1].push_back(rank++);
  end_ = rank;
}

}  // namespace isogloss::cli::parting
