/// The way of a block's point from the program to the machine, one row for each function that changes it.
#pragma once

#include <string>

#include "explain/facts.hpp"

namespace isogloss::cli {

/// A function of the program on the way to the machine: a transform, or a part of one.
struct LadderRow {
  std::string name;  ///< "G55", "AROT", "work offset"
  std::string does;  ///< "adds X-161.8", "turns 30° about Z": lengths in mm, or in inch where the program is in inch
  std::string source, writer;
  ProgramLine since;
  std::array<double, 16> matrix{};
  std::array<double, 3> point{};  ///< behind it
  bool is_moving = false;         ///< with the rotary axes
};
std::vector<LadderRow> ladder_rows(const Facts& facts, double unit_mm);
/// Empty where the block has no point.
std::string ladder_text(const Facts& facts);

/// X, Y and Z in the unit of the program, in columns.
std::string point_columns(const std::array<double, 3>& point, const Facts& facts);
/// Cuts what is too long for one line, between characters.
std::string cut(std::string_view text, std::size_t size);

}  // namespace isogloss::cli
