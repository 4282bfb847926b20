/// G70, G71 and G72: holes on a circle, on an arc or along a line, drilled with the canned cycle in force or with that
/// of the block. This syntax turns the pattern into the first hole, the number of holes and the step from hole to hole;
/// the cycle does the rest.
#include <cmath>
#include <numbers>

#include <isogloss/cnc/canned_cycle.hpp>
#include <isogloss/cnc/cycle_in_force.hpp>
#include <isogloss/cnc/units.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct HolePattern {
  static constexpr auto spec =
      ig::syntax("HolePatternSyntax", "G70, G71 and G72: holes on a circle, an arc, a line.")
          .after("ParameterizedFlagSyntax", "UnitModeSyntax", "PlaneSelectSyntax", "PositioningModeSyntax",
                 "IsoCoordinateOffsetSyntax", "IsoLocalCoordinateOffsetSyntax", "ToolHeightOffsetSyntax")
          .before("CannedCycleResolveSyntax", "IncrementalResolveSyntax", "ProgramXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0355",
                     "{0} without a canned cycle: nothing is drilled, so program the cycle first"),
      ig::diagnostic(IG_ERROR, "ISO-0357", "{0}: {1}{2} is not a valid number of holes, so nothing is drilled"),
      ig::diagnostic(IG_ERROR, "ISO-0358", "{0} without {1}: nothing is drilled"),
  };

  enum Row : std::size_t { circle, arc, line };
  ig::Call patterns_{{"G70", "G71", "G72"}, "I J[deg] K[deg] L[1]", ig::take | ig::wake, hole_pattern_kind};
  CycleCalls cycles_{"X Y Z L[1]", ig::read | ig::write};
  ig::Xyz words_{"Parsing", ig::read | ig::write};
  ig::Word l_{"Parsing.L", ig::write, ""};
  CycleInForce cycle_;
  ig::Out<ig::Symbol> term_{"HolePattern.Term"};
  ig::Xyz center_{"HolePattern.Center", ig::write};
  ig::Out<double> turn_{"HolePattern.Turn_deg"};
  ig::Xyz step_{"HolePattern.Step", ig::write};
  PlaneInForce plane_;
  DistanceMode distance_;
  LastProgramXyz last_;

  ig::Status build(ig::Block& b) {
    const auto row = b.find(patterns_);
    if (!row) return ig::Status::unchanged;
    const ig_field code = patterns_.code(*row);
    const auto words = *b.take(patterns_);
    const ig::Symbol name = patterns_.name(*row);
    const auto called = b.find(cycles_);
    if (!called && !cycle_.is_on(b)) {
      b.report(ig::diag("ISO-0355"), ig::Where::word(code), b.text(name));
      return ig::Status::changed;
    }
    const auto count = number_of_holes(b, code, name, words['L']);
    if (const auto missing = missing_word(*row, words); !missing.empty())
      b.report(ig::diag("ISO-0358"), ig::Where::word(code), b.text(name), missing);
    else if (count)
      lay_out(b, *row, called, words['I'].value_or(0), words['J'].value_or(0), words['K'].value_or(0), *count);
    return ig::Status::changed;
  }

 private:
  /// The first missing word among those that the pattern needs; L is checked separately.
  template <class Words>
  static std::string_view missing_word(std::size_t row, const Words& words) {
    if (!words['L']) return "L";
    if (!words['I']) return "I";
    return row == arc && !words['K'] ? "K" : "";
  }

  static std::optional<double> number_of_holes(ig::Block& b, ig_field code, ig::Symbol name, std::optional<double> l) {
    if (!l) return std::nullopt;
    if (*l >= 1 && *l <= most_repeats && *l == std::floor(*l)) return l;
    b.report(ig::diag("ISO-0357"), ig::Where::word(code), b.text(name), std::string_view("L"), *l);
    return std::nullopt;
  }

  /// X and Y of the block are the centre, or the first hole of a line; a missing one is the position of the tool.
  void lay_out(ig::Block& b, std::size_t row, std::optional<std::size_t> called, double i, double j, double k,
               double count) const {
    const PlaneAxes plane = plane_(b);
    const bool incremental = distance_.is_incremental(b);
    const ig_field* const fields = called ? cycles_.row(*called) : words_.ids();
    const ig::Vec3 tool = last_(b);
    ig::Vec3 base = tool;
    for (const std::size_t axis : {plane.first, plane.second}) {
      ig_value v;
      if (!b.get(fields[axis], v)) continue;
      base[axis] = incremental ? tool[axis] + v.number : v.number;
    }
    const auto at = [&](double length, double angle) {
      ig::Vec3 out;
      const double d = std::remainder(angle, 360) * radians_per_degree;
      out[plane.first] = rounded(length * std::cos(d));
      out[plane.second] = rounded(length * std::sin(d));
      return out;
    };
    ig::Vec3 first = base;
    b.set(term_, patterns_.name(row));
    if (row == line) {
      b.set(step_, at(i, j));
    } else {
      first = base + at(std::fabs(i), j);
      b.set(center_, base);
      b.set(turn_, row == arc ? k : std::copysign(360 / count, i));
    }
    for (const std::size_t axis : {plane.first, plane.second})
      put(b, fields[axis], rounded(incremental ? first[axis] - tool[axis] : first[axis]));
    put(b, called ? cycles_.word(static_cast<std::uint32_t>(*called), 'L') : l_.id(), count);
  }

  static void put(ig::Block& b, ig_field field, double value) {
    const ig_value v{.number = value};
    ig_value old;
    if (b.get(field, old))
      b.rewrite(field, v);
    else
      b.set(field, v);
  }
};

const ig::Register<HolePattern> hole_pattern_syntax;

}  // namespace
}  // namespace iso
