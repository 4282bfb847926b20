/// Checks the travel of the machine's axes: every position of a block, the extremes of arcs, and the curve that the
/// machine follows while rotary axes turn about the tip, against the limits that the machine declares. On a machine
/// without limits the syntax is idle.
#include <bit>
#include <boost/math/tools/minima.hpp>

#include <isogloss/cnc/arc.hpp>
#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/rotary_words.hpp>
#include <isogloss/cnc/tool_kinematics.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct TravelCheck {
  static constexpr auto spec = ig::syntax("TravelCheckSyntax", "Reports positions outside the travel of an axis.")
                                   .after("McXyzSyntax", "McAbcCyclicPathSyntax", "LinearMotionSyntax",
                                          "ReturnFromReferenceSyntax", "ReferenceReturnSyntax", "ReferenceCheckSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0403", "{0} would go to {1}, beyond the end of its travel at {2}"),
  };

  static constexpr std::string_view names = "XYZABC";
  using Axes = std::array<ig_field, names.size()>;

  /// What the check needs of one step of a compound motion: the machine's axes, the program point, the arc.
  struct Step {
    enum : std::uint32_t { program = 6, center = 9, sense = 12, form = 13, size = 14 };
    std::array<ig_field, size> ids{};
    Step() {
      const auto put = [&](std::uint32_t first, std::string_view letters, const char* section) {
        for (std::size_t i = 0; i < letters.size(); ++i)
          ids[first + i] =
              ig::Field<double>(std::string("CompoundMotion.Items[].") + section + letters[i], ig::read).id();
      };
      put(0, names, "MachineCoordinate.");
      put(program, "XYZ", "ProgramXyz.");
      put(center, "XYZ", "MotionEvent.ArcCenter.");
      ids[sense] = ig::Field<bool>("CompoundMotion.Items[].MotionEvent.IsCcw", ig::read).id();
      ids[form] = ig::Field<ig::Symbol>("CompoundMotion.Items[].MotionEvent.Form", ig::read).id();
    }
    static bool has_point(std::uint32_t mask, std::uint32_t first) { return (mask >> first & 7u) == 7u; }
    static ig::Vec3 point(const ig_value* v, std::uint32_t first) {
      return {v[first].number, v[first + 1].number, v[first + 2].number};
    }
  };
  struct Arc {
    ig::Vec3 start, end, center;
    bool is_ccw = false;
  };
  struct Place {
    ig::Vec3 xyz;
    Angles angles{};
  };
  Axes position_ = each("MachineCoordinate.", ig::read | ig::wake);
  Step step_;
  ig::Xyz program_{"ProgramXyz", ig::read};
  ig::Xyz center_{"MotionEvent.ArcCenter", ig::read | ig::wake};
  ig::In<bool> is_ccw_{"MotionEvent.IsCcw"};
  LastProgramXyz last_;
  PlaneInForce plane_;
  ig::In<ig::Symbol> form_{"MotionEvent.Form"};
  ig::Name led_{"ClLinear"};
  ig::Xyz here_{"MachineCoordinate", ig::read};
  ig::Xyz here_before_{"MachineCoordinate", ig::previous};
  RotaryPosition rotary_{ig::read};
  RotaryPosition rotary_before_{ig::previous};
  ig::In<double> length_{"ToolHeightCompensation.Offset_mm"};
  ToolKinematics kinematics_;
  /// A bit for each axis that has been reported, until it is back inside. It is not a field of the block, because the
  /// blocks in the look-ahead window began before this one was checked.
  std::uint32_t outside_ = 0;
  ig::Service<ig_machine_axis_1> machine_{"isogloss.machine-axis/1", ig::Need::optional, "The limits."};
  std::array<AngleRange, names.size()> travel_;
  std::uint32_t limited_ = 0;  // a bit for each axis

  TravelCheck() {
    for (std::size_t axis = 0; machine_ && axis < names.size(); ++axis) {
      AngleRange travel;
      if (machine_->travel(machine_->self, names[axis], &travel.minimum, &travel.maximum) == 0) continue;
      travel_[axis] = travel;
      limited_ |= 1u << axis;
    }
    if (limited_ == 0) ig::stay_idle();
  }

  ig::Status restart(ig::Block&) {
    outside_ = 0;
    return ig::Status::unchanged;
  }

  ig::Status build(ig::Block& b) {
    outside_ = check_steps(b, outside_);
    if ((limited_ & 7u) != 0) outside_ = check_between(b, outside_);
    outside_ = check_end(b, outside_);
    return ig::Status::unchanged;
  }

 private:
  static std::size_t axis_of(std::uint32_t lowest_bit_of) {
    return static_cast<std::size_t>(std::countr_zero(lowest_bit_of));
  }

  /// Checks the position at the end of the block.
  std::uint32_t check_end(ig::Block& b, std::uint32_t outside) const {
    const bool is_arc = b.get(center_).complete();
    for (std::uint32_t rest = limited_; rest != 0; rest &= rest - 1) {
      const std::size_t axis = axis_of(rest);
      ig_value v;
      const bool is_named = b.is_fresh(position_[axis]) || (is_arc && axis < 3);  // a full circle ends where it began
      if (is_named && b.get(position_[axis], v)) outside = check_axis(b, axis, v.number, outside);
    }
    return outside;
  }

  /// Checks X, Y and Z between the ends of the move.
  std::uint32_t check_between(ig::Block& b, std::uint32_t outside) const {
    const ig::PartialVec3 center = b.get(center_);
    if (center.complete()) {
      const ig::Vec3 start = last_(b);
      outside = check_arc(b, {start, b.get(program_).or_else(start), center.value, b.get_or(is_ccw_, false)}, outside);
    }
    if (!kinematics_ || !b.is(form_, led_)) return outside;
    const ig::PartialVec3 from = b.get(here_before_), to = b.get(here_);
    if (!from.complete() || !to.complete()) return outside;
    const Angles angles = rotary_before_.get(b).or_else({});
    return check_curve(b, {from.value, angles}, {to.value, rotary_.get(b).or_else(angles)}, outside);
  }

  std::uint32_t check_steps(ig::Block& b, std::uint32_t outside) const {
    const std::uint32_t steps = b.count(step_.ids[0]);
    std::optional<ig::Vec3> here;
    const ig::PartialVec3 begin = steps != 0 ? b.get(here_before_) : ig::PartialVec3{};
    Place before{begin.value, steps != 0 ? rotary_before_.get(b).or_else({}) : Angles{}};
    bool is_known = begin.complete() && bool(kinematics_);
    for (std::uint32_t step = 0; step < steps; ++step) {
      ig_value at[Step::size];
      const std::uint32_t known = b.record(step, step_.ids.data(), Step::size, at);
      if (Step::has_point(known, Step::center) && Step::has_point(known, Step::program))
        outside = check_arc(b,
                            {here ? *here : last_(b), Step::point(at, Step::program), Step::point(at, Step::center),
                             (known >> Step::sense & 1u) != 0 && at[Step::sense].integer != 0},
                            outside);
      if (Step::has_point(known, Step::program)) here = Step::point(at, Step::program);
      if (Step::has_point(known, 0)) {
        Place there{Step::point(at, 0), before.angles};
        for (std::size_t axis = 0; axis < 3; ++axis)
          if ((known >> (3 + axis) & 1u) != 0) there.angles[axis] = at[3 + axis].number;
        const bool is_led =
            (known >> Step::form & 1u) != 0 && at[Step::form].symbol == static_cast<ig::Symbol>(led_).id;
        if (is_known && is_led && (limited_ & 7u) != 0) outside = check_curve(b, before, there, outside);
        before = there;
        is_known = bool(kinematics_);
      }
      outside = check(b, known, at, outside);
    }
    return outside;
  }

  /// Checks the extremes of an arc in machine coordinates; its ends are checked separately.
  std::uint32_t check_arc(ig::Block& b, const Arc& arc, std::uint32_t outside) const {
    const PlaneAxes plane = plane_(b);
    const auto along = [&](std::size_t axis) {
      ig::Vec3 one = arc.center;
      one[axis] += 1;
      return b.to_machine(one);
    };
    const auto center = b.to_machine(arc.center), u = along(plane.first), v = along(plane.second),
               w = along(plane.tool);
    if (!center || !u || !v || !w) return outside;
    const Point2 start{arc.start[plane.first], arc.start[plane.second]},
        end{arc.end[plane.first], arc.end[plane.second]}, middle{arc.center[plane.first], arc.center[plane.second]};
    const double rise = arc.end[plane.tool] - arc.start[plane.tool];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if ((limited_ >> axis & 1u) == 0) continue;
      const double c = (*center)[axis];
      const ArcCoordinate coordinate{c + (arc.start[plane.tool] - arc.center[plane.tool]) * ((*w)[axis] - c),
                                     (*u)[axis] - c, (*v)[axis] - c, rise * ((*w)[axis] - c)};
      visit_turning_points(coordinate, start, end, middle, arc.is_ccw,
                           [&](double position) { outside = pass(b, axis, position, outside); });
    }
    return outside;
  }

  /// Checks a position between the ends of a move. Only the end point may clear the report.
  std::uint32_t pass(ig::Block& b, std::size_t axis, double position, std::uint32_t outside) const {
    return (limited_ >> axis & 1u) != 0 ? outside | check_axis(b, axis, position, outside) : outside;
  }

  struct Extreme {
    double value = 0;
    double part = 0;  // of the way
  };
  /// The extreme between the looks beside the one that is farthest out. Between two looks, 2 degrees apart, an axis
  /// goes at most 0.15 mm farther for each metre of its distance from the rotary axis, so it is sought only near a
  /// limit.
  template <class Point>
  double extreme(const Point& point, std::size_t axis, const Extreme& seen, double sign, double step) const {
    constexpr double near = 1;
    constexpr int bits = 24;  // of the place, whose error acts on the value with its square
    const double limit = sign > 0 ? travel_[axis].maximum : travel_[axis].minimum;
    if ((limited_ >> axis & 1u) == 0 || sign * (limit - seen.value) > near) return seen.value;
    double best = seen.value;
    const auto value = [&](double part) {
      const auto at = point(part);
      const double out = at ? (*at)[axis] : seen.value;
      if (sign * out > sign * best) best = out;
      return -sign * out;
    };
    std::uintmax_t tries = 40;
    boost::math::tools::brent_find_minima(value, std::fmax(0, seen.part - step), std::fmin(1, seen.part + step), bits,
                                          tries);
    return best;
  }

  /// Checks samples every few degrees: the tip goes straight in the workpiece while the angles change evenly.
  std::uint32_t check_curve(ig::Block& b, const Place& begin, const Place& end, std::uint32_t outside) const {
    double widest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      widest = std::fmax(widest, std::fabs(end.angles[axis] - begin.angles[axis]));
    constexpr double look_deg = 2, most_looks = 360;
    if (!(widest > look_deg)) return outside;
    const double looks = std::fmin(std::ceil(widest / look_deg), most_looks);
    const ToolTip tool{kinematics_, b.get_or(length_, 0.0)};
    const auto first = tool.in_workpiece(begin.xyz, begin.angles), last = tool.in_workpiece(end.xyz, end.angles);
    if (!first || !last) return outside;
    const auto point = [&](double part) {
      Angles angles = begin.angles;
      for (std::size_t axis = 0; axis < 3; ++axis) angles[axis] += part * (end.angles[axis] - begin.angles[axis]);
      return tool.machine_point(*first + part * (*last - *first), angles);
    };
    std::array<Extreme, 3> low, high;
    for (std::size_t axis = 0; axis < 3; ++axis) low[axis] = high[axis] = {begin.xyz[axis], 0};
    const auto look_at = [&](const ig::Vec3& at, double part) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (at[axis] < low[axis].value) low[axis] = {at[axis], part};
        if (at[axis] > high[axis].value) high[axis] = {at[axis], part};
      }
    };
    for (double look = 1; look < looks; ++look)
      if (const auto at = point(look / looks)) look_at(*at, look / looks);
    look_at(end.xyz, 1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      outside = pass(b, axis, extreme(point, axis, low[axis], -1, 1 / looks), outside);
      outside = pass(b, axis, extreme(point, axis, high[axis], 1, 1 / looks), outside);
    }
    return outside;
  }

  /// Returns the axes that are outside after this position; an axis that it does not name keeps its bit.
  std::uint32_t check(ig::Block& b, std::uint32_t named, const ig_value* at, std::uint32_t outside) const {
    for (std::uint32_t rest = named & limited_; rest != 0; rest &= rest - 1)
      outside = check_axis(b, axis_of(rest), at[axis_of(rest)].number, outside);
    return outside;
  }
  std::uint32_t check_axis(ig::Block& b, std::size_t axis, double position, std::uint32_t outside) const {
    const std::uint32_t bit = 1u << axis;
    const AngleRange& travel = travel_[axis];
    if (travel.holds(position)) return outside & ~bit;
    if ((outside & bit) == 0)
      b.report(ig::diag("ISO-0403"), ig::Where::block(), names.substr(axis, 1), position,
               position > travel.maximum ? travel.maximum : travel.minimum);
    return outside | bit;
  }

  static Axes each(std::string_view section, ig::Access access) {
    Axes ids{};
    for (std::size_t axis = 0; axis < names.size(); ++axis)
      ids[axis] = ig::Field<double>(std::string(section) + names[axis], access).id();
    return ids;
  }
};

const ig::Register<TravelCheck> travel_check_syntax;

}  // namespace
}  // namespace iso
