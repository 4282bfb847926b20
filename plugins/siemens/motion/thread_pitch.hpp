/// The pitch of a thread in the parameters of CYCLE84 and CYCLE840: as a metric size (MPIT), or as a number (PIT) in
/// the unit of PITA. Its sign is the hand of the thread.
#pragma once

#include <cmath>

#include <isogloss/cnc/units.hpp>
#include <numbers>
#include <optional>

namespace siemens {

using namespace ig::cnc;

/// The coarse pitch of M3 to M48 in mm; 0 for a size that the series does not have.
constexpr double coarse_pitch_mm(double size) {
  struct Row {
    double size, pitch;
  };
  constexpr Row rows[] = {{3, 0.5},  {4, 0.7},   {5, 0.8},  {6, 1},  {7, 1},    {8, 1.25}, {9, 1.25}, {10, 1.5},
                          {11, 1.5}, {12, 1.75}, {14, 2},   {16, 2}, {18, 2.5}, {20, 2.5}, {22, 2.5}, {24, 3},
                          {27, 3},   {30, 3.5},  {33, 3.5}, {36, 4}, {39, 4},   {42, 4.5}, {45, 4.5}, {48, 5}};
  for (const Row& row : rows)
    if (row.size == size) return row.pitch;
  return 0;
}

/// The pitch in mm per turn. `inch`: the unit of PIT under PITA 0.
inline double pitch_mm(double pit, double pita, bool inch) {
  if (pita == 2) return pit == 0 ? 0 : mm_per_inch / pit;  // threads per inch
  if (pita == 3 || (pita == 0 && inch)) return pit * mm_per_inch;
  if (pita == 4) return pit * std::numbers::pi;  // module
  return pit;
}

/// The pitch; nothing where the call gives none, or two that differ.
inline std::optional<double> thread_pitch(double mpit, double pit, double pita, bool inch) {
  const double by_size = std::copysign(coarse_pitch_mm(std::fabs(mpit)), mpit), by_number = pitch_mm(pit, pita, inch);
  if (mpit != 0 && by_size == 0) return std::nullopt;
  if (mpit == 0 && pit == 0) return std::nullopt;
  if (mpit != 0 && pit != 0 && std::fabs(by_size - by_number) > 1e-6) return std::nullopt;
  return pit != 0 ? by_number : by_size;
}

}  // namespace siemens
