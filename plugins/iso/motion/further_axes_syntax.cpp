// Axes beside X Y Z A B C that the machine's table declares: U, Q1, a second C2, the spindle as an axis SP1. Their
// words move them to positions of the machine, by the work offset, G52 and G92 where the dialect has them; the syntaxes
// of other codes give an order. No motion carries these axes, but the document does, so nothing is lost silently.
#include <cmath>

#include <isogloss/cnc/further_axes.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/units.hpp>

#include "motion/further_axis_order.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct FurtherAxes {
  static constexpr auto spec =
      ig::syntax("FurtherAxesSyntax", "Positions of axes beside X Y Z A B C.")
          .after("UnitModeSyntax", "PositioningModeSyntax", "FurtherAxisWordSyntax", "ProgrammableDataInputSyntax",
                 "IsoLocalCoordinateOffsetSyntax", "IsoCoordinateOffsetSyntax", "WorkCoordinateShiftSyntax",
                 "MachineCoordSelectSyntax", "ReturnFromReferenceSyntax", "ReferenceReturnSyntax",
                 "ReferenceCheckSyntax")
          .before("TravelCheckSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(
          IG_NOTE, "ISO-0577",
          "{0} moves in FurtherAxes of the block document alone: motions carry X Y Z A B C and no other axis"),
      ig::diagnostic(IG_ERROR, "ISO-0578", "{0} would go to {1}, beyond the end of its travel at {2}"),
      ig::diagnostic(IG_ERROR, "ISO-0579",
                     "the position of {0} would be no number, so {0} does not move: check the value"),
      ig::diagnostic(IG_ERROR, "ISO-0591",
                     "G29 {0} under G91 is not executed: the intermediate position of {0} is not kept, so program G90"),
      ig::diagnostic(IG_ERROR, "ISO-0592",
                     "{0} beside G10 is not executed, because the table has no such value: remove the word"),
  };

  FurtherAxisWords words_{ig::take | ig::wake, ig::read};
  FurtherAxisPositions positions_{ig::read | ig::write};
  std::vector<ig::Signal> told_ = per_axis<ig::Signal>("~Told", ig::Life::modal);
  std::vector<ig::Field<double>> local_ = per_axis<ig::Field<double>>("Local", of_g52);
  std::vector<ig::Field<double>> shift_ = per_axis<ig::Field<double>>("Shift", of_g92);
  enum Order : std::size_t { r1, r2, r3, r4, g10, g27, g29, g52, g53, g92, g92_1, nothing, no_order };
  std::array<FurtherAxisOrder, no_order> orders_{heard("R1"),  heard("R2"),  heard("R3"),    heard("R4"),
                                                 heard("G10"), heard("G27"), heard("G29"),   heard("G52"),
                                                 heard("G53"), heard("G92"), heard("G92.1"), heard("Nothing")};
  NamesFurtherAxes names_axes_;
  FurtherAxisOrder no_position_{"NoPosition", ig::read};
  ig::Signal local_ends_{"FurtherAxes.~LocalEnds", ig::read | ig::wake};
  ig::Signal moved_{"FurtherAxes.~Moved", ig::read | ig::write};
  ig::Signal shift_ends_{"FurtherAxes.~ShiftEnds", ig::read};
  ig::In<ig::Symbol> row_{"FurtherAxes.Row"};
  ig::In<ig::Symbol> system_{"Unit.System"}, work_offset_{"CoordinateOffset.CoordinateId"};
  ig::Service<FurtherOffsetTable> offsets_{further_offset_service, ig::Need::optional, "Origins of U, V and W."};
  DistanceMode distance_;
  AxisNames axes_;
  ig::NumberOption tolerance_{"tolerance", "0.001", {0, 1000}, "mm, deg", "G27: how far from the reference position."};
  ig::Name inch_{"Inch"}, ac_{"AC"}, ic_{"IC"}, dc_{"DC"}, acn_{"ACN"};

  FurtherAxes() {
    if (!exists(first_further_axis)) ig::stay_idle();
  }

  ig::Status restart(ig::Block& b) const {
    for (std::uint32_t axis = first_further_axis; exists(axis); ++axis) {
      b.set(positions_.name(axis), b.symbol(axes_.name(axis)));
      b.set(positions_.position(axis), axes_.position(axis, IG_AXIS_HOME).value_or(0));
    }
    return exists(first_further_axis) ? ig::Status::changed : ig::Status::unchanged;
  }

  ig::Status build(ig::Block& b) const {
    std::size_t order = 0;
    while (order < no_order && !orders_[order].is_given(b)) ++order;
    const bool names_axes = names_axes_(b);
    for (std::uint32_t axis = first_further_axis; exists(axis); ++axis) {
      if (b.is_raised(local_ends_)) set(b, local_, axis, 0);
      ig_value word;
      const ig_field field = words_.word(axis).id();
      const bool is_named = b.take_many(&field, 1, &word) != 0;
      if (order == no_order) {
        if (is_named && !no_position_.is_given(b)) go(b, axis, target(b, axis, in_mm(b, axis, word.number)));
      } else if (is_named || (!names_axes && is_for_all(order))) {
        execute(b, axis, static_cast<Order>(order), is_named ? in_mm(b, axis, word.number) : 0);
      }
    }
    return ig::Status::changed;
  }

 private:
  static constexpr ig::About of_g52{ig::Life::modal, "mm, deg", "Origin of the local coordinate system (G52)."};
  static constexpr ig::About of_g92{ig::Life::modal, "mm, deg", "Shift of all work coordinate systems (G92)."};
  template <class Member, class About>
  static std::vector<Member> per_axis(const char* name, About about) {
    std::vector<Member> out;
    for (std::uint32_t i = 1; i <= most_further_axes; ++i)
      out.emplace_back(std::string("FurtherAxes.") + name + std::to_string(i), ig::read | ig::write, about);
    return out;
  }

  /// G28 and G30 on some controls, and G92.1.
  static bool is_for_all(std::size_t order) { return order <= r4 || order == g92_1; }

  bool exists(std::uint32_t axis) const { return is_further_axis(axis) && !axes_.name(axis).empty(); }
  ig::Where where(std::uint32_t axis) const { return ig::Where::word(words_.word(axis).id()); }
  static FurtherAxisOrder heard(const std::string& name) { return FurtherAxisOrder(name, ig::read | ig::wake); }
  double in_mm(const ig::Block& b, std::uint32_t axis, double word) const {
    return !axes_.is_rotary(axis) && b.is(system_, inch_) ? word * mm_per_inch : word;
  }

  // ---- where it goes

  double target(const ig::Block& b, std::uint32_t axis, double word) const {
    const double from = b.get_or(positions_.position(axis), 0.0);
    const ig::Symbol mode = b.get_or(words_.mode(axis), ig::Symbol{});
    if (mode == ic_ || (mode == ig::Symbol{} && distance_.is_incremental(b))) return from + word;
    const double to = in_machine(b, axis, word);
    if (mode == ig::Symbol{} || mode == ac_) return to;
    double turn = std::fmod(to - from, 360);
    if (turn < 0) turn += 360;
    if (mode == acn_ && turn > 0) turn -= 360;
    if (mode == dc_ && turn > 180) turn -= 360;
    return from + turn;
  }

  /// Of a position of the program.
  double in_machine(const ig::Block& b, std::uint32_t axis, double position) const {
    return rounded(position + work_origin(b, axis) + value(b, local_, axis) + value(b, shift_, axis));
  }
  double work_origin(const ig::Block& b, std::uint32_t axis) const {
    return origin(b.text(b.get_or(work_offset_, ig::Symbol{})), axis).value_or(0) + origin("EXT", axis).value_or(0);
  }
  std::optional<double> origin(std::string_view row, std::uint32_t axis) const {
    double out = 0;
    if (!offsets_ || offsets_->get(offsets_->self, ig::to_text(row), ig::to_text(axes_.name(axis)), &out) == 0)
      return std::nullopt;
    return out;
  }

  void go(ig::Block& b, std::uint32_t axis, double to) const {
    const std::string_view name = axes_.name(axis);
    if (!std::isfinite(to)) return b.report(ig::diag("ISO-0579"), where(axis), name);
    b.set(positions_.name(axis), b.symbol(name));
    b.set(positions_.position(axis), to);
    b.raise(moved_);
    const auto travel = axes_.travel(axis);
    if (travel && (to < travel->minimum || to > travel->maximum))
      b.report(ig::diag("ISO-0578"), where(axis), name, to, to > travel->maximum ? travel->maximum : travel->minimum);
    const ig::Signal& told = told_[axis - first_further_axis];
    if (b.is_raised(told)) return;
    b.report(ig::diag("ISO-0577"), where(axis), name);
    b.raise(told);
  }

  // ---- orders

  void execute(ig::Block& b, std::uint32_t axis, Order order, double word) const {
    switch (order) {
      case r1:
      case r2:
      case r3:
      case r4:
        if (b.is_raised(shift_ends_)) set(b, shift_, axis, 0);
        return go(b, axis, reference(b, axis, static_cast<std::uint32_t>(order) + 1));
      case g10: return write_origin(b, axis, word);
      case g27: return check_reference(b, axis, word);
      case g29:
        if (!distance_.is_incremental(b)) return go(b, axis, in_machine(b, axis, word));
        return b.report(ig::diag("ISO-0591"), where(axis), axes_.name(axis));
      case g52: return set(b, local_, axis, word);
      case g53: return go(b, axis, word);
      case g92: return set_position(b, axis, word);
      case g92_1:
        if (word != 0) b.report(ig::diag("ISO-0366"), where(axis), axes_.name(axis), word);
        set(b, local_, axis, 0);
        return set(b, shift_, axis, 0);
      default: return;
    }
  }

  /// G92 ends the local coordinate system of the axis, and its present position gets the coordinate of the word.
  void set_position(ig::Block& b, std::uint32_t axis, double word) const {
    const double shift = rounded(b.get_or(positions_.position(axis), 0.0) - word - work_origin(b, axis));
    if (!std::isfinite(shift)) return b.report(ig::diag("ISO-0369"), where(axis), std::string_view("G92"));
    set(b, local_, axis, 0);
    set(b, shift_, axis, shift);
  }

  double reference(ig::Block& b, std::uint32_t axis, std::uint32_t which) const {
    if (const auto known = axes_.position(axis, IG_AXIS_REFERENCE_1 + which - 1)) return *known;
    b.report(ig::diag("ISO-0341"), where(axis), double(which), axes_.name(axis));
    return 0;
  }

  void check_reference(ig::Block& b, std::uint32_t axis, double word) const {
    const double to = target(b, axis, word), wanted = reference(b, axis, 1);
    go(b, axis, to);
    if (std::fabs(to - wanted) <= tolerance_) return;
    b.report(ig::diag("ISO-0382"), where(axis), axes_.name(axis), to, wanted);
    b.alarm();
  }

  /// G10 L2 and L20 write U, V and W; an axis with a longer name has no column.
  void write_origin(ig::Block& b, std::uint32_t axis, double word) const {
    const std::string_view row = b.text(b.get_or(row_, ig::Symbol{}));
    const auto old = origin(row, axis);
    const double to = old.value_or(0) * (distance_.is_incremental(b) ? 1 : 0) + word;
    if (!old || offsets_->set(offsets_->self, ig::to_text(row), ig::to_text(axes_.name(axis)), to) == 0)
      b.report(ig::diag("ISO-0592"), where(axis), axes_.name(axis));
  }

  static double value(const ig::Block& b, const std::vector<ig::Field<double>>& of, std::uint32_t axis) {
    return b.get_or(of[axis - first_further_axis], 0.0);
  }
  static void set(ig::Block& b, const std::vector<ig::Field<double>>& of, std::uint32_t axis, double to) {
    if (to != value(b, of, axis)) b.set(of[axis - first_further_axis], to);
  }
};

const ig::Register<FurtherAxes> further_axes_syntax;

}  // namespace
}  // namespace iso
