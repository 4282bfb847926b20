/// G16 and G15: the first axis word of the plane is a radius, the second an angle, counter-clockwise from the first
/// axis. Both words are rewritten in place, to positions under G90 and to distances under G91, so that no later syntax
/// has to know of G16. Fanuc manual, "Polar coordinate command".
#include <cmath>
#include <numbers>

#include <isogloss/cnc/canned_cycle.hpp>
#include <isogloss/cnc/degrees.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/scale_and_mirror.hpp>
#include <isogloss/cnc/units.hpp>

#include "reading/geometry_words.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

enum class IncrementalRadius { from_pole, from_position };

struct PolarCoordinate {
  static constexpr auto spec =
      ig::syntax("PolarCoordinateSyntax", "G16/G15 polar coordinate command.")
          .after("UnitModeSyntax", "PlaneSelectSyntax", "PositioningModeSyntax", "ToolHeightOffsetSyntax",
                 "IsoLocalCoordinateOffsetSyntax", "IsoCoordinateOffsetSyntax")
          .before("ScalingSyntax", "ProgrammableMirrorSyntax", "CannedCycleResolveSyntax", "IncrementalResolveSyntax",
                  "ProgramXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0384", "an arc under G16 needs R, because its centre would be read as a length"),
      ig::diagnostic(
          IG_ERROR, "ISO-0385",
          "these repeated holes lie on a straight line, because the radius counts from the tool: program each hole"),
  };

  ig::Codes codes_{"G15", "G16"};
  ig::InWhile<ig::Symbol> term_{"PolarCoordinate.Term", "G16", ig::write};
  ig::Xyz pole_{"PolarCoordinate.Pole", ig::read | ig::write};
  ig::Out<double> radius_{"PolarCoordinate.Radius"};
  ig::Out<double> angle_{"PolarCoordinate.Angle_deg"};
  ig::Out<double> turn_{"PolarCoordinate.Turn_deg"};
  ig::In<ig::Symbol> system_{"Unit.System"};
  ig::Name inch_{"Inch"};
  GeometryWords words_;
  CycleCalls repeated_{"K[1] L[1]", ig::read};
  ig::Word l_{"Parsing.L", ig::read, ""};
  PlaneInForce plane_;
  DistanceMode distance_;
  LastProgramXyz last_;
  ScaleAndMirror scale_and_mirror_;
  ig::Choice<IncrementalRadius> incremental_radius_{
      "incremental-radius", "from-pole|from-position", "from-pole",
      "The start of a radius under G91: the pole, or the tool position, which becomes the pole."};

  ig::Status build(ig::Block& b) {
    bool changed = false;
    if (const auto code = b.take(codes_)) {
      changed = true;
      if (*code == 0)
        end(b);
      else
        begin(b);
    }
    if (b.has(term_)) changed |= resolve(b);
    return changed ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  void end(ig::Block& b) const {
    b.erase(term_);
    for (std::size_t axis = 0; axis < 3; ++axis) b.erase(pole_.id(axis));
    b.erase(radius_);
    b.erase(angle_);
  }

  /// The position of the tool as the program would write it.
  ig::Vec3 position(ig::Block& b) const { return scale_and_mirror_.programmed(b, last_(b)); }

  void begin(ig::Block& b) const {
    const PlaneAxes plane = plane_(b);
    const ig::Vec3 tool = position(b);
    const ig::Vec3 pole = distance_.is_incremental(b) ? tool : ig::Vec3{};
    const double u = tool[plane.first] - pole[plane.first], v = tool[plane.second] - pole[plane.second];
    b.set(term_, codes_.name(1));
    b.set(pole_, pole);
    b.set(radius_, rounded(std::sqrt(u * u + v * v)));
    b.set(angle_, rounded(std::atan2(v, u) * degrees_per_radian));
  }

  bool resolve(ig::Block& b) const {
    words_.report_untouched(b, codes_.name(1));
    const auto here = words_.find(b);
    if (!here) return false;
    const PlaneAxes plane = plane_(b);
    const ig_field first = here->axes[plane.first], second = here->axes[plane.second];
    if (!here->is_cycle) report_center(b, plane);
    const auto radius_word = GeometryWords::get(b, first), angle_word = GeometryWords::get(b, second);
    if (!radius_word && !angle_word) return false;

    const bool incremental = distance_.is_incremental(b);
    const ig::Vec3 tool = incremental ? position(b) : ig::Vec3{};
    if (incremental && radius_word && incremental_radius_ == IncrementalRadius::from_position) b.set(pole_, tool);
    const double radius = radius_word.value_or(b.get_or(radius_, 0.0));
    const double before = b.get_or(angle_, 0.0);
    const double angle = angle_word ? turned(incremental ? before : 0, *angle_word / words_per_degree(b)) : before;
    b.set(radius_, radius);
    b.set(angle_, angle);
    if (incremental && here->is_cycle) repeat(b, radius_word.has_value(), angle_word ? turned(angle, -before) : 0);

    const ig::Vec3 pole = b.get(pole_).or_else({});
    write(b, first, pole[plane.first] + radius * cosine(angle) - tool[plane.first]);
    write(b, second, pole[plane.second] + radius * sine(angle) - tool[plane.second]);
    return true;
  }

  /// UnitModeSyntax has converted the angle of an inch block as if it were a length.
  double words_per_degree(const ig::Block& b) const { return b.is(system_, inch_) ? mm_per_inch : 1; }

  static double turned(double from, double by) { return rounded(std::remainder(from + std::fmod(by, 360), 360)); }

  static void write(ig::Block& b, ig_field word, double value) {
    const ig_value v{.number = rounded(value)};
    ig_value old;
    if (b.get(word, old))
      b.rewrite(word, v);
    else
      b.set(word, v);
  }

  /// The centre of an arc, given from its start, is not possible together with radius and angle.
  void report_center(ig::Block& b, const PlaneAxes& plane) const {
    for (const std::size_t axis : {plane.first, plane.second})
      if (const ig_field center = words_.centers()[axis]; GeometryWords::get(b, center)) {
        b.report(ig::diag("ISO-0384"), ig::Where::word(center));
        return;
      }
  }

  /// K or L: each hole is rotated by the angle from the hole before.
  void repeat(ig::Block& b, bool has_radius, double turn) const {
    const auto row = b.find(repeated_);
    for (const ig_field word :
         {row ? repeated_.word(*row, 'K') : words_.centers()[2], row ? repeated_.word(*row, 'L') : l_.id()}) {
      const auto count = GeometryWords::get(b, word);
      if (!count) continue;
      if (!(*count > 1) || *count != std::floor(*count)) return;
      if (has_radius && incremental_radius_ == IncrementalRadius::from_position) {
        b.report(ig::diag("ISO-0385"), ig::Where::word(word));
        return;
      }
      b.set(turn_, turn);
      b.set(angle_, turned(b.get_or(angle_, 0.0), turn * (std::fmin(*count, most_repeats) - 1)));
      return;
    }
  }
};

const ig::Register<PolarCoordinate> polar_coordinate_syntax;

}  // namespace
}  // namespace iso
