// Where two paths of one program part: block by block, the n-th pass over a line with the n-th of the other.
#include <fmt/format.h>

#include <cmath>
#include <unordered_map>

#include "tool_path.hpp"

namespace isogloss::cli {

namespace {

/// Moves of one line that follow each other.
struct Passage {
  std::size_t begin = 0, end = 0;
  bool is_met = false;
};

class Passages {
 public:
  explicit Passages(const ToolPath& path) {
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= path.moves.size(); ++i) {
      const PathMove& m = path.moves[begin];
      if (i < path.moves.size() && path.moves[i].line == m.line && path.moves[i].file == m.file) continue;
      by_line_[path.files[m.file]][m.line].push_back(all.size());
      all.push_back({begin, i});
      begin = i;
    }
  }
  /// The next one of this line; null: there is none.
  Passage* next(const std::string& file, std::uint32_t line) {
    const auto lines = by_line_.find(file);
    if (lines == by_line_.end()) return nullptr;
    const auto found = lines->second.find(line);
    if (found == lines->second.end()) return nullptr;
    std::size_t& passes = passes_[&found->second];
    return passes < found->second.size() ? &all[found->second[passes++]] : nullptr;
  }
  std::vector<Passage> all;

 private:
  std::unordered_map<std::string, std::unordered_map<std::uint32_t, std::vector<std::size_t>>> by_line_;
  std::unordered_map<const std::vector<std::size_t>*, std::size_t> passes_;
};

std::string_view kind_name(PathMove::Kind kind) {
  static constexpr std::string_view names[] = {"rapid", "feed", "arc", "dwell"};
  return names[static_cast<std::size_t>(kind)];
}

/// What differs between two moves; empty: nothing does.
std::string what_differs(const ToolPath& a, std::size_t in_a, const ToolPath& b, std::size_t in_b) {
  const PathMove &one = a.moves[in_a], &other = b.moves[in_b];
  if (one.kind != other.kind) return fmt::format("{} / {}", kind_name(one.kind), kind_name(other.kind));
  std::string out;
  for (std::size_t i = 0; i < 6; ++i) {
    const float x = a.ends[in_a][i], y = b.ends[in_b][i];
    constexpr float tolerance = 0.001F, of_float = 1e-6F;
    if (std::abs(x - y) <= tolerance + of_float * std::abs(x)) continue;
    out += fmt::format("{}{} {:.3f} / {:.3f}", out.empty() ? "" : ", ", "XYZABC"[i], x, y);
  }
  constexpr float per_minute = 60, part = 1e-5F;
  if (std::abs(one.feed_mm_s - other.feed_mm_s) > part * one.feed_mm_s)
    out += fmt::format("{}F {:.6g} / {:.6g}", out.empty() ? "" : ", ", one.feed_mm_s * per_minute,
                       other.feed_mm_s * per_minute);
  if (one.kind == PathMove::Kind::dwell && one.seconds != other.seconds)
    out += fmt::format("dwell {:.3f} s / {:.3f} s", one.seconds, other.seconds);
  return out;
}

/// Compares two passages move by move; returns what differs first.
std::string compare_passages(ToolPath& a, const Passage& in_a, ToolPath& b, const Passage* in_b) {
  std::string first;
  const std::size_t in_other = in_b == nullptr ? 0 : in_b->end - in_b->begin, moves = in_a.end - in_a.begin;
  for (std::size_t i = 0; i < std::max(moves, in_other); ++i) {
    std::string what;
    if (i < moves && i < in_other)
      what = what_differs(a, in_a.begin + i, b, in_b->begin + i);
    else
      what = fmt::format("{} moves / {} moves", moves, in_other);
    if (what.empty()) continue;
    if (i < moves) a.moves[in_a.begin + i].differs = true;
    if (i < in_other) b.moves[in_b->begin + i].differs = true;
    if (first.empty()) first = std::move(what);
  }
  return first;
}

}  // namespace

std::vector<PathDifference> mark_differences(ToolPath& a, ToolPath& b, std::size_t most) {
  std::vector<PathDifference> out;
  const auto keep = [&](const ToolPath& path, const Passage& at, std::string what) {
    const PathMove& m = path.moves[at.begin];
    if (!what.empty() && out.size() < most) out.push_back({path.files[m.file], m.line, std::move(what)});
  };
  const Passages of_a(a);
  Passages of_b(b);
  for (const Passage& passage : of_a.all) {
    const PathMove& m = a.moves[passage.begin];
    Passage* const other = of_b.next(a.files[m.file], m.line);
    if (other != nullptr) other->is_met = true;
    keep(a, passage, compare_passages(a, passage, b, other));
  }
  for (const Passage& passage : of_b.all) {
    if (passage.is_met) continue;
    for (std::size_t i = passage.begin; i < passage.end; ++i) b.moves[i].differs = true;
    keep(b, passage, fmt::format("0 moves / {} moves", passage.end - passage.begin));
  }
  return out;
}

}  // namespace isogloss::cli
