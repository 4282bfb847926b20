/// HOLES1, HOLES2, CYCLE801 and CYCLE802: the positions at which the cycle kept by MCALL drills.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/units.hpp>
#include <isogloss/sdk.hpp>

#include "cycles/cycle_signatures.hpp"

namespace siemens {

using namespace ig::cnc;

class HolePattern {
 public:
  explicit HolePattern(ig::Access access) {
    for (const CycleSignature& s : pattern_signatures) calls_.emplace_back(s, access);
  }

  bool stands_in(const ig::Block& b) const { return find(b) < calls_.size(); }

  /// The positions in the plane, from the nearest end of the pattern. Nothing where the block holds no pattern; an
  /// empty list where the pattern is not executed, which is reported.
  std::optional<std::vector<ig::Vec3>> take(ig::Block& b, const PlaneAxes& plane, const ig::Vec3& from) const {
    const std::size_t i = find(b);
    if (i >= calls_.size()) return std::nullopt;
    Call call{&calls_[i], {}};
    take_words(b, call);
    Positions out{plane, from, {}};
    if (is_executed(b, call)) place(b, call, out);
    for (const ig::Vec3& p : out.holes)
      if (!(std::fabs(p.x) < 1e9 && std::fabs(p.y) < 1e9 && std::fabs(p.z) < 1e9)) {
        b.report(ig::diag("SIE-0105"), call.where(), call.fields->name());
        return std::vector<ig::Vec3>{};
      }
    return std::move(out.holes);
  }

  /// Reports a pattern at which no cycle drills.
  void refuse(ig::Block& b) const {
    const std::size_t i = find(b);
    Call call{&calls_[i], {}};
    b.report(ig::diag("SIE-0271"), call.where(), call.fields->name());
    take_words(b, call);
  }

 private:
  struct Call {
    const CycleFields* fields;
    std::array<std::optional<double>, CycleFields::most> values;

    double operator[](std::string_view parameter) const { return values[fields->index_of(parameter)].value_or(0); }
    ig::Where where() const { return ig::Where::word(fields->code().code(0)); }
  };
  struct Positions {
    PlaneAxes plane;
    ig::Vec3 from;
    std::vector<ig::Vec3> holes;

    void add(double u, double v) {
      ig::Vec3 hole = from;
      hole[plane.first] = rounded(u);
      hole[plane.second] = rounded(v);
      holes.push_back(hole);
    }
    double way_to(const ig::Vec3& hole) const {
      return std::hypot(hole[plane.first] - from[plane.first], hole[plane.second] - from[plane.second]);
    }
  };

  std::size_t find(const ig::Block& b) const {
    std::size_t i = 0;
    while (i < calls_.size() && !b.find(calls_[i].code())) ++i;
    return i;
  }
  static void take_words(ig::Block& b, Call& call) {
    std::uint32_t found = 0;
    b.take_code(call.fields->code().codes(), 1, &found);
    for (std::size_t i = 0; i < call.fields->size(); ++i) {
      ig_value v;
      if (b.take(call.fields->field(i).id(), v)) call.values[i] = v.number;
    }
  }

  static bool is_executed(ig::Block& b, const Call& call) {
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

  /// A number of holes; 0 where the control would refuse it.
  static std::size_t count(ig::Block& b, const Call& call, std::string_view parameter) {
    const double n = call[parameter];
    if (n >= 1 && n <= most && n == std::floor(n)) return static_cast<std::size_t>(n);
    b.report(ig::diag("SIE-0272"), call.where(), call.fields->name(), n, most);
    return 0;
  }

  static void place(ig::Block& b, const Call& call, Positions& out) {
    const std::string_view name = call.fields->name();
    if (name == "HOLES1") {
      const std::size_t n = count(b, call, "NUM");
      const double u = std::cos(call["STA1"] * radians_per_degree), v = std::sin(call["STA1"] * radians_per_degree);
      for (std::size_t k = 0; k < n; ++k) {
        const double way = call["FDIS"] + static_cast<double>(k) * call["DBH"];
        out.add(call["SPCA"] + way * u, call["SPCO"] + way * v);
      }
      if (n > 0 && out.way_to(out.holes.back()) < out.way_to(out.holes.front()))
        std::reverse(out.holes.begin(), out.holes.end());
    } else if (name == "HOLES2") {
      const std::size_t n = count(b, call, "NUM");
      const double step = call["INDA"] != 0 ? call["INDA"] : 360 / static_cast<double>(std::max<std::size_t>(n, 1));
      for (std::size_t k = 0; k < n; ++k) {
        const double angle = (call["STA1"] + static_cast<double>(k) * step) * radians_per_degree;
        out.add(call["CPA"] + call["RAD"] * std::cos(angle), call["CPO"] + call["RAD"] * std::sin(angle));
      }
    } else if (name == "CYCLE801") {
      grid(b, call, out);
    } else {
      for (std::size_t i = call.fields->index_of("X0"); i + 1 < call.fields->index_of("VARI"); i += 2)
        if (call.values[i] && call.values[i + 1]) out.add(*call.values[i], *call.values[i + 1]);
      if (out.holes.empty()) b.report(ig::diag("SIE-0272"), call.where(), name, 0.0, 9.0);
    }
  }

  /// Row by row, in alternating direction, from the nearest corner.
  static void grid(ig::Block& b, const Call& call, Positions& out) {
    const std::size_t columns = count(b, call, "NUM1"), rows = count(b, call, "NUM2");
    if (columns == 0 || rows == 0) return;
    if (columns * rows > most_of_grid) {
      b.report(ig::diag("SIE-0272"), call.where(), call.fields->name(), static_cast<double>(columns * rows),
               static_cast<double>(most_of_grid));
      return;
    }
    const double c = std::cos(call["STA"] * radians_per_degree), s = std::sin(call["STA"] * radians_per_degree);
    const auto walk = [&](bool far_column, bool far_row) {
      Positions all{out.plane, out.from, {}};
      for (std::size_t j = 0; j < rows; ++j)
        for (std::size_t i = 0; i < columns; ++i) {
          const std::size_t column = (j % 2 == 1) == far_column ? i : columns - 1 - i;
          const double u = static_cast<double>(column) * call["DIS1"];
          const double v = static_cast<double>(far_row ? rows - 1 - j : j) * call["DIS2"];
          all.add(call["SPCA"] + u * c - v * s, call["SPCO"] + u * s + v * c);
        }
      return all;
    };
    for (const bool far_row : {false, true})
      for (const bool far_column : {false, true})
        if (Positions way = walk(far_column, far_row);
            out.holes.empty() || way.way_to(way.holes.front()) < out.way_to(out.holes.front()))
          out = std::move(way);
  }

  static constexpr double most = 999;
  static constexpr std::size_t most_of_grid = 9999;
  std::vector<CycleFields> calls_;
};

}  // namespace siemens
