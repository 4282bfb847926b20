// Cycle 208, bore milling: from the centre out on a half circle, down on a helix, one circle at the bottom, back to the
// centre. A tool as wide as the hole goes straight down.
#include <numbers>

#include <isogloss/cnc/arc.hpp>
#include <isogloss/cnc/tool_dimension.hpp>
#include <isogloss/cnc/tool_steps.hpp>

#include "cycles/hole_cycle.hpp"
#include "cycles/hole_spindle.hpp"
#include "frames/scaling.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextBoreMilling {
  static constexpr auto spec = hole_cycle("KlartextBoreMillingSyntax", "Cycle 208 bore milling where it is called.");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "HEI-0184",
                     "cycle {0}: tool {1} has no radius in the tool table, so its centre runs along the wall"),
      ig::diagnostic(IG_ERROR, "HEI-0185", "cycle {0} is not executed: {1}"),
  };

  HoleCycle cycle_{{208, "CYCL208"}};
  HoleSpindle spindle_;
  ToolSteps steps_;
  ig::In<std::int64_t> tool_{"ToolHeightCompensation.OffsetId"};
  ig::In<double> delta_{"RadiusCompensation.Delta_mm"};
  ig::Service<ig_tool_offset_1> table_{"isogloss.tool-offset/1", ig::Need::optional, "The radius of the tool."};
  ScalingInForce scaling_;
  ig::In<ig::Symbol> feed_on_arcs_{"RadiusCompensation.FeedOnArcs",
                                   ig::read,
                                   {ig::Life::modal, "", "Center, Contour or ContourInside: where F holds on an arc."}};
  ig::Signal said_{"CycleDefinition.~Said", ig::read | ig::write, ig::Life::modal};

  ig::Status build(ig::Block& b) { return cycle_.run(b, *this); }

  std::optional<double> prepare(ig::Block& b, HoleRun& c) {
    const auto diameter = cycle_.needed(b, c, 335), infeed = cycle_.needed(b, c, 334);
    if (!diameter || !infeed || !cycle_.drills(b, c)) return std::nullopt;
    const double overlap = cycle_.get_or(b, 370, 0), hole = std::fabs(*diameter);
    const double tool = radius_of_tool(b) / scaling_.factor(b);
    radius_ = hole / 2 - tool;
    if (radius_ < -same_point_mm) return refuse(b, "the tool is wider than the hole");
    if (tool > 0 && overlap > 0 && radius_ > overlap * tool + same_point_mm) {
      b.report(ig::diag("HEI-0178"), ig::Where::block(), 208.0, std::string_view("Q370"), overlap);
      return std::nullopt;
    }
    // A core remains in the middle, unless a hole is there already.
    if (tool > 0 && cycle_.get_or(b, 342, 0) == 0 && hole > 4 * tool + same_point_mm)
      return refuse(b, "the hole is wider than two diameters of the tool, and Q342 is 0");
    if (radius_ < same_point_mm) radius_ = 0;
    turns_ = std::fabs(c.safe - c.bottom) / std::fabs(*infeed);
    if (radius_ > 0 && *infeed == 0) {
      b.report(ig::diag("HEI-0166"), ig::Where::block(), 208.0, std::string_view("Q334"), *infeed);
      return std::nullopt;
    }
    return radius_ > 0 ? turns_ + 8 : 4;
  }

  void machine(ig::Block& b, HoleRun& c) const {
    if (radius_ == 0)
      cycle_.feed_to(b, c, c.bottom, c.feed);
    else
      mill(b, c);
    cycle_.rapid_to(b, c, c.safe);
    cycle_.leave(b, c);
  }

 private:
  double radius_ = 0, turns_ = 0;  // path of the tool's centre in this block

  static std::optional<double> refuse(ig::Block& b, std::string_view why) {
    b.report(ig::diag("HEI-0185"), ig::Where::block(), 208.0, why);
    b.alarm();
    return std::nullopt;
  }

  double radius_of_tool(ig::Block& b) const {
    const std::int64_t tool = b.get_or(tool_, std::int64_t{0});
    const auto known = tool > 0 ? tool_dimension(table_, tool, ToolDimension::radius) : std::nullopt;
    const double radius = known.value_or(0) + b.get_or(delta_, 0.0);
    if (known && radius > 0 && std::isfinite(radius)) return radius;
    if (!b.is_raised(said_)) b.report(ig::diag("HEI-0184"), ig::Where::block(), 208.0, static_cast<double>(tool));
    b.raise(said_);
    return 0;
  }

  /// A point of the helix, at `turned` turns from its start.
  ig::Vec3 on_circle(const HoleRun& c, double level, double turned, double sense) const {
    const double angle = (turned - std::floor(turned)) * 2 * std::numbers::pi * sense;
    ig::Vec3 p = c.at(level);
    p[c.plane.first] = rounded(p[c.plane.first] + radius_ * std::cos(angle));
    p[c.plane.second] = rounded(p[c.plane.second] + radius_ * std::sin(angle));
    return p;
  }

  void mill(ig::Block& b, HoleRun& c) const {
    const bool is_climb = cycle_.get_or(b, 351, 1) >= 0, is_ccw = is_climb != spindle_.turns_ccw(b);
    const double sense = is_ccw ? 1 : -1;
    const double at_wall = b.has(feed_on_arcs_) ? radius_ / (std::fabs(cycle_.get_or(b, 335, 0)) / 2) : 1;
    ToolSteps::Manner feed{false, c.feed, 0};
    ig::Vec3 middle = c.at(c.safe);
    middle[c.plane.first] = rounded(middle[c.plane.first] + radius_ / 2);
    steps_.arc(b, on_circle(c, c.safe, 0, sense), middle, is_ccw, feed);
    feed.feed_mmds = c.feed * at_wall;
    const double whole = std::round(turns_);
    const bool is_whole = std::fabs(turns_ - whole) < 1e-9;
    const double turned = is_whole ? whole : turns_;
    feed.more_circles = static_cast<std::int64_t>(is_whole ? whole - 1 : std::floor(turns_));
    const ig::Vec3 end = on_circle(c, c.bottom, turned, sense);
    steps_.arc(b, end, c.at(c.safe), is_ccw, feed);
    feed.more_circles = 0;
    steps_.arc(b, end, c.at(c.bottom), is_ccw, feed);
    cycle_.feed_to(b, c, c.bottom, c.feed);
  }
};

const ig::Register<KlartextBoreMilling> klartext_bore_milling_syntax;

}  // namespace
}  // namespace heidenhain
