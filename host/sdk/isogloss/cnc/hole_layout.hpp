/// Where the holes of the usual patterns lie in the plane: along a line, on a circle, in the rows of a grid. Lengths in
/// mm. Nothing here reports or rounds: the caller checks the numbers of holes.
#pragma once

#include <cstddef>

#include "isogloss/cnc/arc.hpp"
#include "isogloss/cnc/tilt_transform.hpp"

namespace ig::cnc {

/// The hole at that distance from `from` in the direction `turn`: of a circle about `from`, or of a line.
constexpr Point2 hole_towards(const Point2& from, double distance, const Turn& turn) {
  return {from.u + distance * turn.cos, from.v + distance * turn.sin};
}

/// Rows of holes with equal steps. A row runs in the direction `along` from the first axis; the columns run in the
/// direction `across` from the second axis. Both are the same unless the grid is sheared.
struct HoleGrid {
  Point2 origin;  ///< column 0 of row 0
  Turn along, across;
  double column_step, row_step;

  constexpr Point2 at(std::size_t column, std::size_t row) const {
    const double u = column_step * static_cast<double>(column), v = row_step * static_cast<double>(row);
    return {origin.u + along.cos * u - across.sin * v, origin.v + along.sin * u + across.cos * v};
  }
};

/// The column of the hole that comes as number `place` in its row, counted from 0: rows run in alternating direction,
/// so that the tool does not go back to the beginning of the next one.
constexpr std::size_t alternating_column(std::size_t row, std::size_t place, std::size_t columns) {
  return row % 2 == 0 ? place : columns - 1 - place;
}

}  // namespace ig::cnc
