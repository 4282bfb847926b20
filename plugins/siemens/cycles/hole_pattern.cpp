// A row, a circle, a grid and a list of positions. A row and a grid begin at the end that is nearest to the tool.
#include "cycles/hole_pattern.hpp"

#include <algorithm>
#include <array>
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

std::optional<std::span<const ig::Vec3>> HolePattern::take(ig::Block& b, const PlaneAxes& plane, const ig::Vec3& from) {
  const std::size_t i = find(b);
  if (i >= calls_.size()) return std::nullopt;
  Call call{&calls_[i], {}};
  calls_[i].take(b, call.values);
  take_words(b, call);
  points_.clear();
  holes_.clear();
  if (!is_executed(b, call)) return holes_;
  points(b, call, {from[plane.first], from[plane.second]}, points_);
  for (const Point2& p : points_) {
    ig::Vec3& hole = holes_.emplace_back(from);
    hole[plane.first] = p.u;
    hole[plane.second] = p.v;
  }
  for (const ig::Vec3& p : holes_)
    if (!(std::fabs(p.x) < 1e9 && std::fabs(p.y) < 1e9 && std::fabs(p.z) < 1e9)) {
      b.report(ig::diag("SIE-0105"), call.where(), call.fields->name());
      holes_.clear();
      break;
    }
  return holes_;
}

void HolePattern::refuse(ig::Block& b) const {
  const CycleFields& fields = calls_[find(b)];
  b.report(ig::diag("SIE-0271"), ig::Where::word(fields.code().code(0)), fields.name());
  CycleFields::Values unused;
  fields.take(b, unused);
}

void HolePattern::take_words(ig::Block& b, const Call& call) const {
  constexpr std::array<std::string_view, 3> names{"X", "Y", "Z"};
  const std::uint32_t named = b.take(words_).mask;
  for (std::size_t axis = 0; axis < names.size(); ++axis)
    if ((named >> axis & 1u) != 0)
      b.report(ig::diag("SIE-0280"), ig::Where::word(words_.id(axis)), names[axis], call.fields->name());
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

void HolePattern::points(ig::Block& b, const Call& call, const Point2& from, Points& out) {
  const std::string_view name = call.fields->name();
  if (name == "HOLES1") return row(b, call, from, out);
  if (name == "HOLES2") return circle(b, call, out);
  return name == "CYCLE801" ? grid(b, call, from, out) : list(b, call, out);
}

void HolePattern::row(ig::Block& b, const Call& call, const Point2& from, Points& out) {
  const std::size_t n = count(b, call, "NUM");
  const Turn along = hole_direction(call["STA1"]);
  for (std::size_t k = 0; k < n; ++k) {
    const double way = call["FDIS"] + static_cast<double>(k) * call["DBH"];
    out.push_back(rounded_hole(hole_towards({call["SPCA"], call["SPCO"]}, way, along)));
  }
  if (n > 0 && way_between(from, out.back()) < way_between(from, out.front())) std::reverse(out.begin(), out.end());
}

void HolePattern::circle(ig::Block& b, const Call& call, Points& out) {
  const std::size_t n = count(b, call, "NUM");
  const double step = call["INDA"] != 0 ? call["INDA"] : 360 / static_cast<double>(std::max<std::size_t>(n, 1));
  for (std::size_t k = 0; k < n; ++k) {
    const Turn turn = hole_direction(call["STA1"] + static_cast<double>(k) * step);
    out.push_back(rounded_hole(hole_towards({call["CPA"], call["CPO"]}, call["RAD"], turn)));
  }
}

void HolePattern::grid(ig::Block& b, const Call& call, const Point2& from, Points& out) {
  const std::size_t columns = count(b, call, "NUM1"), rows = count(b, call, "NUM2");
  if (columns == 0 || rows == 0) return;
  if (columns * rows > most_of_grid) {
    b.report(ig::diag("SIE-0272"), call.where(), call.fields->name(), static_cast<double>(columns * rows),
             static_cast<double>(most_of_grid));
    return;
  }
  const Turn turn = hole_direction(call["STA"]);
  const HoleGrid holes{{call["SPCA"], call["SPCO"]}, turn, turn, call["DIS1"], call["DIS2"]};
  struct Corner {
    bool far_column, far_row;
  };
  const auto hole = [&](const Corner& first, std::size_t j, std::size_t i) {
    const std::size_t column = alternating_column(first.far_column ? j + 1 : j, i, columns);
    return rounded_hole(holes.at(column, first.far_row ? rows - 1 - j : j));
  };
  Corner nearest{false, false};
  for (const Corner& other : {Corner{true, false}, Corner{false, true}, Corner{true, true}})
    if (way_between(from, hole(other, 0, 0)) < way_between(from, hole(nearest, 0, 0))) nearest = other;
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) out.push_back(hole(nearest, j, i));
}

void HolePattern::list(ig::Block& b, const Call& call, Points& out) {
  for (std::size_t i = call.fields->index_of("X0"); i + 1 < call.fields->index_of("VARI"); i += 2)
    if (call.values[i] && call.values[i + 1]) out.push_back(rounded_hole({*call.values[i], *call.values[i + 1]}));
  if (out.empty()) b.report(ig::diag("SIE-0272"), call.where(), call.fields->name(), 0.0, 9.0);
}

}  // namespace siemens
