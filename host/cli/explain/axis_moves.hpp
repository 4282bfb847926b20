/// Which axes of the program the machine moves in a block, and which merely read another value, because an offset, a
/// tool length or a frame has changed while the machine stands still.
#pragma once

#include <array>
#include <string>

#include "explain/facts.hpp"

namespace isogloss::cli {

enum class AxisChange : std::uint8_t { none, moves, reads_anew };

/// By axis X Y Z of the program.
std::array<AxisChange, 3> axis_changes(const Facts& facts);
/// Where the machine stood before the block, as program coordinates of the frame that is in force behind it, mm; empty:
/// not known.
std::optional<std::array<double, 3>> start_of_block(const Facts& facts);
/// "Z now reads 49.97, because G55 adds Z-0.03; the machine stands still in Z"; empty where no axis reads anew.
std::string reading_clause(const Facts& facts);

}  // namespace isogloss::cli
