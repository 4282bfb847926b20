/// The path functions of Klartext, and which of them begins a block.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace heidenhain {

enum class PathFunction : std::size_t { L, LP, LN, C, CC, CR, CT, CP, CTP, RND, CHF, APPR, DEP };

inline constexpr std::array<std::string_view, 13> path_function_names{"L",  "LP",  "LN",  "C",   "CC",   "CR", "CT",
                                                                      "CP", "CTP", "RND", "CHF", "APPR", "DEP"};

constexpr std::string_view name_of(PathFunction f) { return path_function_names[static_cast<std::size_t>(f)]; }

/// A function, and the position where its words begin.
struct FoundPathFunction {
  PathFunction function;
  std::size_t end;
};

/// What path_function_at() finds where the block does not begin with L and a blank.
std::optional<FoundPathFunction> any_path_function_at(std::string_view text, std::size_t position);

/// The function of the block whose first word is at `position`, a byte offset; nothing where the block is not a path
/// block. A block that begins with an axis or an M function is read as L, from `position` on.
inline std::optional<FoundPathFunction> path_function_at(std::string_view text, std::size_t position) {
  const bool is_line = text.size() - position > 1 && text[position] == 'L' && text[position + 1] == ' ';  // most blocks
  if (is_line) return FoundPathFunction{PathFunction::L, position + 1};
  return any_path_function_at(text, position);
}

}  // namespace heidenhain
