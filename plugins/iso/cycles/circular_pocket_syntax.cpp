/// G12 and G13: a round pocket about the position of the tool, clockwise or counter-clockwise. The tool goes down, out
/// on a half circle, round each circle, and back to the centre on a half circle.
#include <isogloss/cnc/feed.hpp>
#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/scale_and_mirror.hpp>
#include <isogloss/cnc/tool_steps.hpp>
#include <isogloss/cnc/whole_number.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct CircularPocket {
  static constexpr auto spec =
      ig::syntax("CircularPocketSyntax", "G12/G13 circular pocket, clockwise, counter-clockwise.")
          .after("UnitModeSyntax", "PlaneSelectSyntax", "PositioningModeSyntax", "FeedrateSyntax",
                 "IsoCoordinateOffsetSyntax", "ToolHeightOffsetSyntax", "ProgrammableMirrorSyntax")
          .before("IncrementalResolveSyntax", "ProgramXyzSyntax", "McXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(
          IG_ERROR, "ISO-0501", "{0} without {1}: the pocket is not milled",
          "A circular pocket needs I, the radius of its first circle; K, the radius of the last one, needs Q, "
          "the step from circle to circle.",
          "G13 K20. D1 F200"),
      ig::diagnostic(IG_ERROR, "ISO-0502", "{0}: {1}{2} is not a valid length, so the pocket is not milled",
                     "I and Q must be greater than 0, and K must not be less than I.", "G13 I10. K5. Q2. D1 F200"),
      ig::diagnostic(
          IG_ERROR, "ISO-0503",
          "{0}: the tool (radius {1} mm) does not fit into the circle (radius {2} mm): the pocket is not milled",
          "The radius of the first circle must be greater than the radius of the tool. With D0, I is the radius of the "
          "path of the tool centre.",
          "G13 I5. D1 F200 (with a radius of 6 mm in D1)"),
      ig::diagnostic(IG_ERROR, "ISO-0504",
                     "{0} L{1}: the number of passes must be from 1 to 1000, so the pocket is not milled",
                     "L is the number of times that the circles are milled; under G91 each pass goes deeper by Z.",
                     "G13 G91 Z-1. I10. L2.5 D1 F200"),
      ig::diagnostic(IG_ERROR, "ISO-0505",
                     "{0}: {1} circles are too many for one block, so the pocket is not milled: check Q",
                     "A block makes at most 10000 circles, over all its passes.", "G13 I1. K500. Q0.001 D0 F200"),
      ig::diagnostic(IG_ERROR, "ISO-0506", "{0} outside the XY plane: the pocket is not milled, so program G17",
                     "The control mills circular pockets only in the XY plane.", "G18 (then) G13 I10. D1 F200"),
  };

  ig::Call call_{{"G12", "G13"}, "X Y Z I K Q L[1] D[]"};
  /// Q belongs to K: without K, Q is a word that nothing uses.
  ig::Field<double> stray_q_{"Parsing.Q", ig::read | ig::write, {ig::Life::standard, "mm", ""}};
  ig::CompoundMotion motion_;
  ToolSteps steps_;
  ig::Xyz program_{"ProgramXyz", ig::write};
  ig::Out<std::int64_t> offset_id_{"RadiusCompensation.OffsetId"};
  ig::Service<ig_tool_offset_1> table_{"isogloss.tool-offset/1", ig::Need::required, "Radius geometry and wear."};
  ig::BooleanOption diameters_{"holds-diameters", "false", "Whether D of the tool table is a diameter, not a radius."};
  FeedInForce feed_{ig::read};
  DistanceMode distance_;
  PlaneInForce plane_;
  LastProgramXyz last_;
  ScaleAndMirror scale_and_mirror_;

  bool is_zero_reported_ = false;

  ig::Status restart(ig::Block&) {
    is_zero_reported_ = false;
    return ig::Status::unchanged;
  }

  ig::Status build(ig::Block& b) {
    const auto row = b.find(call_);
    if (!row) return ig::Status::unchanged;
    const ig_field code = call_.code(*row);
    if (const ig_field q = call_.word(*row, 'Q'); b.has(q) && !b.has(call_.word(*row, 'K'))) b.move(q, stray_q_.id());
    const auto words = *b.take(call_);
    const ig::Vec3 start = last_(b);
    Pocket pocket;
    pocket.center = start;
    for (std::size_t axis = 0; axis < 2; ++axis) pocket.center[axis] = target(b, axis, start[axis], words);
    pocket.is_ccw = (*row == 1) != scale_and_mirror_.swaps_sense(b, plane_(b));
    if (!describe(b, code, words, pocket)) return ig::Status::changed;
    motion_.begin(b, words.code);
    if (length(pocket.center - start) > 0) motion_.rapid_to(b, pocket.center);
    mill(b, words, pocket);
    return ig::Status::changed;
  }

 private:
  static constexpr double most_circles = 10'000;

  struct Pocket {
    ig::Vec3 center;
    bool is_ccw = true;
    double first = 0, step = 0, last = 0;  ///< radii of the tool's centre, mm
    std::int64_t circles = 1, passes = 1;
  };

  double factor(const ig::Block& b, std::size_t axis) const { return scale_and_mirror_.axis(b, axis).factor; }

  double target(const ig::Block& b, std::size_t axis, double from, const ig::Words& words) const {
    const auto word = words["XYZ"[axis]];
    if (!word) return from;
    const AxisMap map = scale_and_mirror_.axis(b, axis);
    return rounded(distance_.is_incremental(b) ? from + map.factor * *word : map.position(*word));
  }

  /// False, with a diagnostic, where nothing can be milled.
  bool describe(ig::Block& b, ig_field code, const ig::Words& words, Pocket& out) {
    const auto where = ig::Where::word(code);
    const auto name = b.text(words.code);
    const auto i = words['I'], k = words['K'], q = words['Q'];
    if (plane_(b).tool != 2) return refuse(b, ig::diag("ISO-0506"), where, name);
    if (!i || (k && !q)) return refuse(b, ig::diag("ISO-0501"), where, name, i ? "Q" : "I");
    if (!(*i > 0)) return refuse(b, ig::diag("ISO-0502"), where, name, "I", *i);
    if (k && !(*k >= *i)) return refuse(b, ig::diag("ISO-0502"), where, name, "K", *k);
    if (k && !(*q > 0)) return refuse(b, ig::diag("ISO-0502"), where, name, "Q", *q);
    const auto passes = whole_number(words['L'].value_or(1));
    if (!passes || *passes < 1 || *passes > 1000)
      return refuse(b, ig::diag("ISO-0504"), where, name, words['L'].value_or(1));
    const double scale = std::fabs(factor(b, 0)), radius = tool_radius(b, where, words);
    out.first = scale * *i - radius;
    out.last = scale * k.value_or(*i) - radius;
    out.step = scale * q.value_or(0);
    out.passes = *passes;
    if (!(out.first > 0)) return refuse(b, ig::diag("ISO-0503"), where, name, radius, scale * *i);
    constexpr double rounding = 1e-9;
    const double more = k ? std::ceil((out.last - out.first) / out.step - rounding) : 0;
    if (!((more + 1) * static_cast<double>(*passes) <= most_circles))
      return refuse(b, ig::diag("ISO-0505"), where, name, (more + 1) * static_cast<double>(*passes));
    out.circles = static_cast<std::int64_t>(more) + 1;
    return true;
  }

  template <class... Arguments>
  static bool refuse(ig::Block& b, ig::DiagnosticCode diagnostic, ig::Where where, const Arguments&... arguments) {
    b.report(diagnostic, where, arguments...);
    return false;
  }

  double tool_radius(ig::Block& b, ig::Where where, const ig::Words& words) {
    std::int64_t id = b.get_or(offset_id_, std::int64_t{0});
    if (const auto d = words['D']) {
      const auto number = whole_number(*d);
      if (!number) b.report(ig::diag("ISO-0463"), where, *d);
      id = number.value_or(id);
      if (number) b.set(offset_id_, id);
    } else if (!b.has(offset_id_)) {
      b.report(ig::diag("ISO-0461"), where, b.text(words.code));
    }
    double geometry = 0, wear = 0;
    if (id == 0) return 0;
    const bool has_geometry = table_->get(table_->self, id, 2, &geometry) != 0;
    const bool has_wear = table_->get(table_->self, id, 3, &wear) != 0;
    if (!has_geometry && !has_wear) b.report(ig::diag("ISO-0462"), where, static_cast<double>(id));
    const double radius = ((has_geometry ? geometry : 0) + (has_wear ? wear : 0)) / (diameters_ ? 2 : 1);
    if (radius == 0 && (has_geometry || has_wear) && !is_zero_reported_) {
      is_zero_reported_ = true;
      b.report(ig::diag("ISO-0464"), where, static_cast<double>(id));
    }
    return std::isfinite(radius) ? radius : 0;
  }

  void mill(ig::Block& b, const ig::Words& words, Pocket& pocket) const {
    const double mmds = feed_.mmds(b, [&] { return way_of(pocket); });
    if (mmds <= 0) feed_.report_missing(b);
    const ToolSteps::Manner feed{false, mmds > 0 ? std::optional(mmds) : std::nullopt, 0};
    for (std::int64_t pass = 0; pass < pocket.passes; ++pass) {
      const double depth = target(b, 2, pocket.center.z, words);
      if (depth != pocket.center.z) {
        pocket.center.z = depth;
        steps_.line(b, pocket.center, feed);
      }
      const ig::Vec3 center = pocket.center;
      half_circle(b, pocket, pocket.first, true, feed);
      for (std::int64_t k = 0; k < pocket.circles; ++k) {
        const double radius =
            k + 1 < pocket.circles ? pocket.first + static_cast<double>(k) * pocket.step : pocket.last;
        const ig::Vec3 on_circle{rounded(center.x + radius), center.y, center.z};
        if (k > 0) steps_.line(b, on_circle, feed);
        steps_.arc(b, on_circle, center, pocket.is_ccw, feed);
      }
      half_circle(b, pocket, pocket.last, false, feed);
    }
    b.set(program_, pocket.center);
  }

  /// From the centre to the circle, or back.
  void half_circle(ig::Block& b, const Pocket& pocket, double radius, bool is_out,
                   const ToolSteps::Manner& feed) const {
    const ig::Vec3 middle{rounded(pocket.center.x + radius / 2), pocket.center.y, pocket.center.z};
    const ig::Vec3 on_circle{rounded(pocket.center.x + radius), pocket.center.y, pocket.center.z};
    steps_.arc(b, is_out ? on_circle : pocket.center, middle, pocket.is_ccw, feed);
  }

  /// The length of the path in the plane, for G93.
  static double way_of(const Pocket& pocket) {
    constexpr double pi = std::numbers::pi;
    const double between = static_cast<double>(pocket.circles - 1);
    const double circles = pocket.last + between * pocket.first + pocket.step * between * (between - 1) / 2;
    const double pass = pi / 2 * (pocket.first + pocket.last) + 2 * pi * circles + (pocket.last - pocket.first);
    return pass * static_cast<double>(pocket.passes);
  }
};

const ig::Register<CircularPocket> circular_pocket_syntax;

}  // namespace
}  // namespace iso
