/// G45 to G48: the distances of one block become longer or shorter by the radius of D, once or twice. The words are
/// rewritten in place, so that no later syntax has to know of it. Fanuc manual, "Tool offset (G45 to G48)".
#include <array>
#include <cmath>

#include <isogloss/cnc/cycle_in_force.hpp>
#include <isogloss/cnc/motion_event.hpp>
#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/tool_dimension.hpp>
#include <isogloss/cnc/whole_number.hpp>
#include <isogloss/sdk.hpp>

namespace fanuc {

using namespace ig::cnc;

namespace {

struct FanucToolOffset {
  static constexpr auto spec =
      ig::syntax("FanucToolOffsetSyntax", "G45 to G48 lengthen or shorten the moves of their block by the offset of D.")
          .after("UnitModeSyntax", "PlaneSelectSyntax", "PositioningModeSyntax", "ToolHeightOffsetSyntax",
                 "IsoLocalCoordinateOffsetSyntax", "IsoCoordinateOffsetSyntax")
          .before("PolarCoordinateSyntax", "CannedCycleResolveSyntax", "IncrementalResolveSyntax", "ProgramXyzSyntax",
                  "RadiusCompensationSyntax", "NotExecutedSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "FAN-0220", "{0} is not executed: {1}; the block moves without the tool offset"),
      ig::diagnostic(IG_WARNING, "FAN-0221", "{0} is ignored: a canned cycle is in force; write it before the cycle"),
      ig::diagnostic(IG_WARNING, "FAN-0222",
                     "{0}: the radius of D{1} is 0 in the tool table, so the offset changes nothing"),
      ig::diagnostic(IG_ERROR, "FAN-0223",
                     "{0} offsets only quarter and three-quarter circles with I J K: this arc is executed without "
                     "offset"),
  };

  ig::Call codes_{{"G45", "G46", "G47", "G48"}, "X Y Z D[]"};
  ig::Xyz axes_{"Parsing", ig::read | ig::write};
  ig::Word d_{"Parsing.D", ig::read | ig::write, ""};
  ig::Word i_{"Parsing.I", ig::read | ig::write}, j_{"Parsing.J", ig::read | ig::write},
      k_{"Parsing.K", ig::read | ig::write}, r_{"Parsing.R", ig::read};
  std::array<ig::Word, 3> rotary_{ig::Word{"Parsing.A", ig::read, "deg"}, ig::Word{"Parsing.B", ig::read, "deg"},
                                  ig::Word{"Parsing.C", ig::read, "deg"}};
  ig::In<std::int64_t> offset_id_{"RadiusCompensation.OffsetId"};
  ig::In<ig::Symbol> compensation_{"RadiusCompensation.Term"};
  CycleInForce cycle_;
  ig::In<ig::Symbol> polar_{"PolarCoordinate.Term"}, scaling_{"Scaling.Term"}, mirror_{"MirrorImage.Term"};
  ig::In<ig::Symbol> rotation_{"TiltTransform.Term"};
  ig::Codes motions_{{"G00", "G01", "G02", "G03", "G33"}, ig::read};
  ig::Codes further_{{"G16", "G51", "G51.1", "G53", "G68"}, ig::read};
  ig::Codes sides_{{"G41", "G42"}, ig::read};
  ig::In<ig::Symbol> motion_{"MotionState.Term"};
  ig::Name g02_{"G02"}, g03_{"G03"}, g40_{"G40"}, g68_{"G68"};
  ig::Service<ig_tool_offset_1> table_{"isogloss.tool-offset/1", ig::Need::required, "Radius geometry and wear."};
  PlaneInForce plane_;
  DistanceMode distance_;
  LastProgramXyz last_;

  ig::Status build(ig::Block& b) const {
    const auto row = b.find(codes_);
    if (!row) return ig::Status::unchanged;
    const ig_field code = codes_.code(*row);
    b.take_code(&code, 1);
    for (std::size_t axis = 0; axis < 3; ++axis) hand_over(b, codes_.word(*row, "XYZ"[axis]), axes_.id(axis));
    hand_over(b, codes_.word(*row, 'D'), d_.id());

    const ig::Where where = ig::Where::word(code);
    const std::string_view name = b.text(codes_.name(*row));
    if (cycle_.is_on(b)) {
      b.report(ig::diag("FAN-0221"), where, name);
    } else if (const std::string_view why = refusal(b); !why.empty()) {
      b.report(ig::diag("FAN-0220"), where, name, why);
    } else if (const auto offset = offset_of(b, where, name)) {
      constexpr std::array<double, 4> factors{1, -1, 2, -2};
      apply(b, where, name, factors[*row] * *offset);
    }
    return ig::Status::changed;
  }

 private:
  static void hand_over(ig::Block& b, ig_field from, ig_field to) {
    ig_value unused;
    if (b.get(from, unused)) b.move(from, to);
  }

  static std::optional<double> get(const ig::Block& b, ig_field word) {
    ig_value v;
    return b.get(word, v) ? std::optional(v.number) : std::nullopt;
  }

  bool is_arc(const ig::Block& b) const {
    if (const auto code = b.find(motions_)) return motions_.name(*code) == g02_ || motions_.name(*code) == g03_;
    return b.is(motion_, g02_) || b.is(motion_, g03_);
  }

  /// The reason why the offset is not executed: a case that the manual forbids or does not describe.
  std::string_view refusal(const ig::Block& b) const {
    if (b.find(sides_) || (b.has(compensation_) && !b.is(compensation_, g40_)))
      return "the control forbids it under cutter radius compensation";
    if (b.find(further_) || b.has_any(polar_, scaling_) || b.has(mirror_))
      return "the manual does not say what it does with G16, G51, G51.1 or G53";
    for (const ig::Word& word : rotary_)
      if (get(b, word.id())) return "an offset of a rotary axis is not executed";
    return {};
  }

  /// The radius of D, geometry and wear; D stays in force.
  std::optional<double> offset_of(ig::Block& b, ig::Where where, std::string_view name) const {
    const auto d = get(b, d_.id());
    const auto id = d ? whole_number(*d) : b.get(offset_id_);
    if (!id) {
      b.report(ig::diag("FAN-0220"), where, name, std::string_view("no D names an offset"));
      return std::nullopt;
    }
    if (*id == 0) return 0;
    const double offset = tool_dimension(table_, *id, ToolDimension::radius).value_or(0);
    if (offset == 0) b.report(ig::diag("FAN-0222"), where, name, static_cast<double>(*id));
    return offset;
  }

  void apply(ig::Block& b, ig::Where where, std::string_view name, double by) const {
    std::array<std::optional<double>, 3> ways;
    if (!get(b, axes_.id(0)) && !get(b, axes_.id(1)) && !get(b, axes_.id(2)))
      b.report(ig::diag("FAN-0220"), where, name, std::string_view("its block names no axis"));
    const bool is_incremental = distance_.is_incremental(b);
    const ig::Vec3 from = is_incremental ? ig::Vec3{} : last_(b);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (const auto word = get(b, axes_.id(axis)))
        if (is_incremental || *word != from[axis]) ways[axis] = *word - from[axis];
    if (is_arc(b) && !widen_arc(b, where, name, ways, by)) return;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (ways[axis]) rewrite(b, axes_.id(axis), from[axis] + *ways[axis] + std::copysign(1.0, *ways[axis]) * by);
  }

  static void rewrite(ig::Block& b, ig_field word, double value) { b.rewrite(word, rounded(value)); }

  /// The centre is moved with the ends of a quarter or of three quarters of a circle; other arcs cannot be offset so.
  bool widen_arc(ig::Block& b, ig::Where where, std::string_view name, const std::array<std::optional<double>, 3>& ways,
                 double by) const {
    constexpr double tolerance = 0.01;  // mm
    const PlaneAxes plane = plane_(b);
    const std::array<ig_field, 3> centers{i_.id(), j_.id(), k_.id()};
    const double u = get(b, centers[plane.first]).value_or(0), v = get(b, centers[plane.second]).value_or(0);
    const double radius = std::fabs(u) + std::fabs(v);
    const auto fits = [&](std::size_t axis) {
      return ways[axis] && std::fabs(std::fabs(*ways[axis]) - radius) <= tolerance;
    };
    if ((u == 0) == (v == 0) || b.is(rotation_, g68_) || get(b, r_.id()) || !fits(plane.first) || !fits(plane.second) ||
        !(radius + by > tolerance)) {
      b.report(ig::diag("FAN-0223"), where, name);
      return false;
    }
    const std::size_t axis = u != 0 ? plane.first : plane.second;
    rewrite(b, centers[axis], u + v + std::copysign(1.0, u + v) * by);
    return true;
  }
};

const ig::Register<FanucToolOffset> fanuc_tool_offset_syntax;

}  // namespace
}  // namespace fanuc
