/// The points at which the last defined cycle runs: on a circle or in rows (cycles 220 and 221, which run it at once),
/// or those of PATTERN DEF, for CYCL CALL PAT.
#pragma once

#include <cmath>

#include <isogloss/cnc/hole_layout.hpp>
#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/scale_and_mirror.hpp>
#include <isogloss/cnc/tilt_transform.hpp>

#include "cycles/cycle_parameters.hpp"
#include "language/q_store.hpp"

namespace heidenhain {

using namespace ig::cnc;

inline constexpr std::array pattern_parameters{
    CycleParameter{200, "Q200", "mm", "Set-up clearance of the pattern."},
    CycleParameter{203, "Q203", "mm", "The surface, of the pattern."},
    CycleParameter{204, "Q204", "mm", "Second set-up clearance of the pattern."},
    CycleParameter{216, "Q216", "mm", "Centre of the circle, first axis."},
    CycleParameter{217, "Q217", "mm", "Centre of the circle, second axis."},
    CycleParameter{224, "Q224", "deg", "Angle of the rows."},
    CycleParameter{225, "Q225", "mm", "Starting point, first axis."},
    CycleParameter{226, "Q226", "mm", "Starting point, second axis."},
    CycleParameter{237, "Q237", "mm", "Spacing in a row."},
    CycleParameter{238, "Q238", "mm", "Spacing of the rows."},
    CycleParameter{241, "Q241", "", "Number of points on the circle."},
    CycleParameter{242, "Q242", "", "Points of a row."},
    CycleParameter{243, "Q243", "", "Rows."},
    CycleParameter{244, "Q244", "mm", "Diameter of the circle."},
    CycleParameter{245, "Q245", "deg", "Angle of the first point."},
    CycleParameter{246, "Q246", "deg", "Angle at which the circle ends."},
    CycleParameter{247, "Q247", "deg", "Angle from point to point; 0: as many as there are over the arc."},
    CycleParameter{301, "Q301", "", "1: from point to point at the second set-up clearance."},
    CycleParameter{365, "Q365", "", "1: from point to point along the circle."},
};

using PatternParameters = CycleParameters<pattern_parameters>;

/// A member of the syntaxes that write or read the pattern of a block.
class HolePattern {
 public:
  explicit HolePattern(ig::Access access)
      : number_("KlartextPattern.Number", access,
                {ig::Life::block, "", "220 or 221: the pattern that runs here; 0: that of PATTERN DEF."}),
        parameters_("KlartextPattern.", access, ig::Life::block) {}

  struct Points {
    bool is_pattern = false;
    bool is_high = false;
    const std::vector<PatternPoint>* list = nullptr;  ///< those of PATTERN DEF
    std::int64_t count = 1;
    std::int64_t in_row = 1;
    double angle = 0, step = 0;  ///< of a circle
  };

  std::optional<double> get(const ig::Block& b, std::uint32_t q) const { return parameters_.get(b, q); }
  const PatternParameters& parameters() const { return parameters_; }
  bool is_set(const ig::Block& b) const { return b.has(number_); }
  void set_number(ig::Block& b, std::int64_t number) const { b.set(number_, number); }

  Points operator()(const ig::Block& b, const PlaneAxes&) const {
    Points p;
    const auto number = b.get(number_);
    if (!number) return p;
    p.is_pattern = true;
    if (*number == 0) {
      if (store_) p.list = &store_->pattern;
      p.count = p.list != nullptr ? static_cast<std::int64_t>(p.list->size()) : 0;
      return p;
    }
    p.is_high = get(b, 301).value_or(0) != 0;
    if (*number == 221) {
      p.in_row = whole(get(b, 242).value_or(1));
      p.count = p.in_row * whole(get(b, 243).value_or(1));
      return p;
    }
    p.count = p.in_row = whole(get(b, 241).value_or(1));
    p.angle = get(b, 245).value_or(0);
    p.step = get(b, 247).value_or(0);
    if (p.step != 0 || p.count < 1) return p;
    const double arc = get(b, 246).value_or(360) - p.angle;
    const bool is_whole = std::fabs(std::fabs(arc) - 360) < 1e-9;
    p.step = is_whole ? arc / static_cast<double>(p.count) : arc / static_cast<double>(p.count > 1 ? p.count - 1 : 1);
    return p;
  }

  /// Point `i`, at the tool axis position of `here`; rows run in alternating direction.
  ig::Vec3 point(const ig::Block& b, const Points& p, const PlaneAxes& plane, ig::Vec3 here, std::int64_t i) const {
    const Point2 hole = programmed(b, p, i);
    here[plane.first] = rounded(mirror_.axis(b, plane.first).position(hole.u));
    here[plane.second] = rounded(mirror_.axis(b, plane.second).position(hole.v));
    return here;
  }

 private:
  /// Point `i` as the program gives it, without a mirror image.
  Point2 programmed(const ig::Block& b, const Points& p, std::int64_t i) const {
    const auto value = [&](std::uint32_t q) { return get(b, q).value_or(0); };
    if (p.list != nullptr) {
      const PatternPoint& of_list = (*p.list)[static_cast<std::size_t>(i)];
      return {of_list.first, of_list.second};
    }
    if (b.get_or(number_, std::int64_t{0}) != 221)
      return hole_towards({value(216), value(217)}, value(244) / 2,
                          Turn::by(p.angle + p.step * static_cast<double>(i)));
    const auto row = static_cast<std::size_t>(i / p.in_row), place = static_cast<std::size_t>(i % p.in_row);
    const Turn turn = Turn::by(value(224));
    const HoleGrid grid{{value(225), value(226)}, turn, turn, value(237), value(238)};
    return grid.at(alternating_column(row, place, static_cast<std::size_t>(p.in_row)), row);
  }
  static std::int64_t whole(double n) { return n >= 1 && n <= 1e6 ? static_cast<std::int64_t>(std::round(n)) : 0; }

  ig::Field<std::int64_t> number_;
  PatternParameters parameters_;
  ScaleAndMirror mirror_;
  ig::Service<QStore> store_{q_store_service, ig::Need::optional, "The points of PATTERN DEF."};
};

}  // namespace heidenhain
