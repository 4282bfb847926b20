/// How the tool reaches the first point of a contour under radius compensation and leaves the last one: along a
/// straight line that continues the contour, along its normal, or on a tangential arc (iTNC 530 user's manual,
/// "Approaching and departing a contour"). Lengths and radii belong to the path of the tool's centre, in mm; angles in
/// degrees, feeds in mm/s.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "isogloss/cnc/units.hpp"
#include "isogloss/sdk.hpp"

#include "isogloss/cnc/arc.hpp"
#include "isogloss/cnc/contour_move.hpp"

namespace ig::cnc {

/// The section ContourApproach of the block that starts compensation. A member of the syntaxes that write the section
/// or read it. set() writes it, get() gives nothing where the block has none.
class ContourApproach {
 public:
  enum class Shape { line, normal, arc, line_and_arc };
  struct Way {
    Shape shape = Shape::line;
    double length = 0, radius = 0, angle_deg = 0;
    bool is_rapid = false;  ///< rapid up to `begin` of the path
    std::optional<double> feed_mmds{};
  };

  explicit ContourApproach(Access access)
      : shape_("ContourApproach.Shape", access, {Life::block, "", "Line, Normal, Arc or LineAndArc."}),
        length_("ContourApproach.Length_mm", access, {Life::block, "mm", ""}),
        radius_("ContourApproach.Radius_mm", access,
                {Life::block, "mm", "Positive: the arc lies on the side of the tool."}),
        angle_("ContourApproach.Angle_deg", access, {Life::block, "deg", ""}),
        is_rapid_("ContourApproach.IsRapid", access, {Life::block, "", "Up to where the way begins."}),
        feed_("ContourApproach.Feedrate_mmds", access, {Life::block, "mm/s", "Up to where the way begins."}) {}

  void set(Block& b, const Way& way) const {
    b.set(shape_, Symbol(names_[static_cast<std::size_t>(way.shape)]));
    b.set(length_, way.length);
    b.set(radius_, way.radius);
    b.set(angle_, way.angle_deg);
    if (way.is_rapid) b.set(is_rapid_, true);
    if (way.feed_mmds) b.set(feed_, *way.feed_mmds);
  }
  std::optional<Way> get(const Block& b) const {
    const auto shape = b.get(shape_);
    if (!shape) return std::nullopt;
    Way way;
    for (std::size_t i = 0; i < names_.size(); ++i)
      if (*shape == names_[i]) way.shape = static_cast<Shape>(i);
    way.length = b.get_or(length_, 0.0);
    way.radius = b.get_or(radius_, 0.0);
    way.angle_deg = b.get_or(angle_, 0.0);
    way.is_rapid = b.get_or(is_rapid_, false);
    way.feed_mmds = b.get(feed_);
    return way;
  }

  /// The approach to `end`, the contour's first point: `along` is the unit direction in which the contour continues,
  /// `side` the unit normal that points to the tool's side.
  struct Path {
    Point2 begin;
    std::optional<Point2> center{};  ///< set when the path is an arc
    bool is_ccw = false;
  };
  /// The path that the tool follows after a move from `from` to `begin`. Nothing for Shape::line_and_arc where `from`
  /// lies inside the circle, so that no line touches it.
  static std::optional<Path> path(const Way& way, const Point2& from, const Point2& end, const Point2& along,
                                  const Point2& side) {
    if (way.shape == Shape::line) return Path{{end.u - way.length * along.u, end.v - way.length * along.v}};
    if (way.shape == Shape::normal) return Path{{end.u + way.length * side.u, end.v + way.length * side.v}};
    const double radius = way.shape == Shape::arc ? way.radius : std::fabs(way.radius);
    const Point2 center{end.u + radius * side.u, end.v + radius * side.v};
    const bool is_ccw = (along.u * side.v - along.v * side.u > 0) == (radius > 0);
    if (way.shape == Shape::arc)
      return Path{turned(end, center, is_ccw ? -way.angle_deg : way.angle_deg), center, is_ccw};
    const auto begin = touching(from, center, std::fabs(radius), is_ccw);
    if (!begin) return std::nullopt;
    return Path{*begin, center, is_ccw};
  }

  static Point2 turned(const Point2& p, const Point2& center, double degrees) {
    const double angle = degrees * radians_per_degree, c = std::cos(angle), s = std::sin(angle);
    const double u = p.u - center.u, v = p.v - center.v;
    return {center.u + c * u - s * v, center.v + s * u + c * v};
  }
  /// The point where a line from `from` touches the circle so that the tool continues round it in the given sense;
  /// nothing where `from` lies on or inside the circle.
  static std::optional<Point2> touching(const Point2& from, const Point2& center, double radius, bool is_ccw) {
    const Point2 way{center.u - from.u, center.v - from.v};
    const double distance = way.length();
    if (!(distance > radius + same_point_mm)) return std::nullopt;
    const double length = std::sqrt(distance * distance - radius * radius);
    const double sine = (is_ccw ? -1 : 1) * radius / distance, cosine = length / distance;
    const Point2 unit{way.u / distance, way.v / distance};
    return Point2{from.u + length * (cosine * unit.u - sine * unit.v),
                  from.v + length * (sine * unit.u + cosine * unit.v)};
  }

 private:
  Field<Symbol> shape_;
  Field<double> length_, radius_, angle_;
  Field<bool> is_rapid_;
  Field<double> feed_;
  std::array<Name, 4> names_{Name{"Line"}, Name{"Normal"}, Name{"Arc"}, Name{"LineAndArc"}};
};

/// The section ContourDeparture: the tangential arc on which the tool's centre leaves the contour; from its end the
/// move of the block goes straight to its own end point. Program coordinates, mm. get() gives nothing where the block
/// has no departure.
class ContourDeparture {
 public:
  explicit ContourDeparture(Access access)
      : center_("ContourDeparture.Center", access, {Life::block, "mm", "Of the arc."}),
        end_("ContourDeparture.ArcEnd", access, {Life::block, "mm", "Where the arc ends."}),
        is_ccw_("ContourDeparture.IsCcw", access, {Life::block, "", ""}) {}

  struct Arc {
    Vec3 center, end;
    bool is_ccw = false;
  };
  void set(Block& b, const Arc& arc) const {
    b.set(center_, arc.center);
    b.set(end_, arc.end);
    b.set(is_ccw_, arc.is_ccw);
  }
  std::optional<Arc> get(const Block& b) const {
    const PartialVec3 center = b.get(center_), end = b.get(end_);
    if (!center.complete() || !end.complete()) return std::nullopt;
    return Arc{center.value, end.value, b.get_or(is_ccw_, false)};
  }

 private:
  Xyz center_, end_;
  Field<bool> is_ccw_;
};

}  // namespace ig::cnc
