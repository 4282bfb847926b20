/// Where X, Y, Z or R of a Haas cycle lies: a position, or under G91 a way from where the tool is.
#pragma once

#include "program_xyz_util.hpp"
#include "scale_and_mirror.hpp"

namespace fanuc {

class HaasCycleTarget {
 public:
  double operator()(const ig::Block& b, std::size_t axis, double from, std::optional<double> word) const {
    if (!word) return from;
    const iso::AxisMap map = scale_and_mirror_.axis(b, axis);
    return iso::rounded(distance_.is_incremental(b) ? from + map.factor * *word : map.position(*word));
  }
  bool is_incremental(const ig::Block& b) const { return distance_.is_incremental(b); }

 private:
  iso::DistanceMode distance_;
  iso::ScaleAndMirror scale_and_mirror_;
};

}  // namespace fanuc
