// A row, a circle, a grid and a list of positions. A row and a grid begin at the end that is nearest to the tool.
#include "cycles/hole_pattern.hpp"

#include <algorithm>
#include <cmath>

#include <isogloss/cnc/hole_layout.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/units.hpp>

namespace siemens {

using namespace ig::cnc;

namespace {

constexpr double most_holes = 999;
constexpr std::size_t most_of_grid = 9999;

Turn hole_direction(double degrees) {
  return {std::cos(degrees * radians_per_degree), std::sin(degrees * radians_per_degree)};
}

Point2 rounded_hole(const Point2& p) { return {rounded(p.u), rounded(p.v)}; }

double way_between(const Point2& from, const Point2& to) { return std::hypot(to.u - from.u, to.v - from.v); }

}  // namespace

std::optional<std::vector<ig::Vec3>> HolePattern::take(ig::Block& b, const PlaneAxes& plane,
                                                       const ig::Vec3& from) const {
  const std::size_t i = find(b);
  if (i >= calls_.size()) return std::nullopt;
  Call call{&calls_[i], {}};
  calls_[i].take(b, call.values);
  std::vector<ig::Vec3> out;
  if (!is_executed(b, call)) return out;
  for (const Point2& p : points(b, call, {from[plane.first], from[plane.second]})) {
    ig::Vec3& hole = out.emplace_back(from);
    hole[plane.first] = p.u;
    hole[plane.second] = p.v;
  }
  for (const ig::Vec3& p : out)
    if (!(std::fabs(p.x) < 1e9 && std::fabs(p.y) < 1e9 && std::fabs(p.z) < 1e9)) {
      b.report(ig::diag("SIE-0105"), call.where(), call.fields->name());
      return std::vector<ig::Vec3>{};
    }
  return out;
}

void HolePattern::refuse(ig::Block& b) const {
  const CycleFields& fields = calls_[find(b)];
  b.report(ig::diag("SIE-0271"), ig::Where::word(fields.code().code(0)), fields.name());
  CycleFields::Values unused;
  fields.take(b, unused);
}

bool HolePattern::is_executed(ig::Block& b, const Call& call) {
  const auto refuse = [&](std::string_view what) {
    b.report(ig::diag("SIE-0273"), call.where(), call.fields->name(), what);
    return false;
  };
  if (call["HIDE"] != 0) return refuse("hidden positions are");
  if (call.fields->name() == "CYCLE801" && std::fmod(call["VARI"], 10) != 0) return refuse("a frame of holes is");
  if (call["ANG1"] != 0 || call["ANG2"] != 0) return refuse("a grid with shear is");
  if (call.fields->name() != "CYCLE802") return true;
  for (const std::string_view mask : {"XA", "YA"})
    for (double digits = call[mask]; digits >= 1; digits = std::floor(digits / 10))
      if (std::fmod(digits, 10) != 1) return refuse("a position relative to the previous one is");
  return true;
}

std::size_t HolePattern::count(ig::Block& b, const Call& call, std::string_view parameter) {
  const double n = call[parameter];
  if (n >= 1 && n <= most_holes && n == std::floor(n)) return static_cast<std::size_t>(n);
  b.report(ig::diag("SIE-0272"), call.where(), call.fields->name(), n, most_holes);
  return 0;
}

HolePattern::Points HolePattern::points(ig::Block& b, const Call& call, const Point2& from) {
  const std::string_view name = call.fields->name();
  if (name == "HOLES1") return row(b, call, from);
  if (name == "HOLES2") return circle(b, call);
  return name == "CYCLE801" ? grid(b, call, from) : list(b, call);
}

HolePattern::Points HolePattern::row(ig::Block& b, const Call& call, const Point2& from) {
  Points out;
  const std::size_t n = count(b, call, "NUM");
  const Turn along = hole_direction(call["STA1"]);
  for (std::size_t k = 0; k < n; ++k) {
    const double way = call["FDIS"] + static_cast<double>(k) * call["DBH"];
    out.push_back(rounded_hole(hole_towards({call["SPCA"], call["SPCO"]}, way, along)));
  }
  if (n > 0 && way_between(from, out.back()) < way_between(from, out.front())) std::reverse(out.begin(), out.end());
  return out;
}

HolePattern::Points HolePattern::circle(ig::Block& b, const Call& call) {
  Points out;
  const std::size_t n = count(b, call, "NUM");
  const double step = call["INDA"] != 0 ? call["INDA"] : 360 / static_cast<double>(std::max<std::size_t>(n, 1));
  for (std::size_t k = 0; k < n; ++k) {
    const Turn turn = hole_direction(call["STA1"] + static_cast<double>(k) * step);
    out.push_back(rounded_hole(hole_towards({call["CPA"], call["CPO"]}, call["RAD"], turn)));
  }
  return out;
}

HolePattern::Points HolePattern::grid(ig::Block& b, const Call& call, const Point2& from) {
  const std::size_t columns = count(b, call, "NUM1"), rows = count(b, call, "NUM2");
  if (columns == 0 || rows == 0) return {};
  if (columns * rows > most_of_grid) {
    b.report(ig::diag("SIE-0272"), call.where(), call.fields->name(), static_cast<double>(columns * rows),
             static_cast<double>(most_of_grid));
    return {};
  }
  const Turn turn = hole_direction(call["STA"]);
  const HoleGrid holes{{call["SPCA"], call["SPCO"]}, turn, turn, call["DIS1"], call["DIS2"]};
  const auto walk = [&](bool far_column, bool far_row) {
    Points way;
    for (std::size_t j = 0; j < rows; ++j)
      for (std::size_t i = 0; i < columns; ++i) {
        const std::size_t column = alternating_column(far_column ? j + 1 : j, i, columns);
        way.push_back(rounded_hole(holes.at(column, far_row ? rows - 1 - j : j)));
      }
    return way;
  };
  Points nearest;
  for (const bool far_row : {false, true})
    for (const bool far_column : {false, true})
      if (Points way = walk(far_column, far_row);
          nearest.empty() || way_between(from, way.front()) < way_between(from, nearest.front()))
        nearest = std::move(way);
  return nearest;
}

HolePattern::Points HolePattern::list(ig::Block& b, const Call& call) {
  Points out;
  for (std::size_t i = call.fields->index_of("X0"); i + 1 < call.fields->index_of("VARI"); i += 2)
    if (call.values[i] && call.values[i + 1]) out.push_back(rounded_hole({*call.values[i], *call.values[i + 1]}));
  if (out.empty()) b.report(ig::diag("SIE-0272"), call.where(), call.fields->name(), 0.0, 9.0);
  return out;
}

}  // namespace siemens
