/// Variables of a Haas that are its offsets, as its own lists of variables hold them: #2001 to #2800 of the tools,
/// #5201 to #5326 of the work offsets (Haas operator's manual, "System variables").
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace fanuc {

/// A cell of a table, and what the variable counts.
struct HaasRegister {
  const char *table, *column;
  std::string row;
  bool is_length, is_radius;
};

inline std::optional<HaasRegister> haas_register(std::int64_t variable) {
  constexpr std::int64_t first_tool = 2001, tools = 200, first_work = 5201, step = 20;
  static constexpr std::array<const char*, 4> of_tool{"H", "HWear", "D", "DWear"};
  static constexpr std::array<const char*, 7> work{"EXT", "G54", "G55", "G56", "G57", "G58", "G59"};
  static constexpr std::array<const char*, 6> axes{"X", "Y", "Z", "A", "B", "C"};
  if (variable >= first_tool && variable < first_tool + tools * static_cast<std::int64_t>(of_tool.size())) {
    const std::int64_t place = variable - first_tool;
    const auto column = static_cast<std::size_t>(place / tools);
    return HaasRegister{"ToolOffsetTable", of_tool[column], std::to_string(place % tools + 1), true, column >= 2};
  }
  if (variable < first_work) return std::nullopt;
  const auto offset = static_cast<std::size_t>((variable - first_work) / step);
  const auto axis = static_cast<std::size_t>((variable - first_work) % step);
  if (offset >= work.size() || axis >= axes.size()) return std::nullopt;
  return HaasRegister{"IsoCoordinateTable", axes[axis], work[offset], axis < 3, false};
}

}  // namespace fanuc
