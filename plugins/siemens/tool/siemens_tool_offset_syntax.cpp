/// D: the cutting edge of the tool that is in force. Its length lies along the tool axis between the programmed point
/// and the machine; its radius is used by G41 and G42. After a tool change D1 is in force.
#include <string>

#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/tool_kinematics.hpp>
#include <isogloss/cnc/whole_number.hpp>
#include <isogloss/sdk.hpp>

#include "tool/edge_row.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

enum class AfterChange { d1, d0, kept };

struct SiemensToolOffset {
  static constexpr auto spec =
      ig::syntax("SiemensToolOffsetSyntax", "D: length and radius of the cutting edge in force.")
          .after("SiemensUnitSyntax", "PlaneSelectSyntax", "ToolChangeSyntax", "G53p1RotaryPositionSyntax")
          .before("SiemensCoordinateOffsetSyntax", "RadiusCompensationSyntax", "ProgramXyzSyntax", "McXyzSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0231",
                     "D{0} is not a cutting edge, so the offset does not change: program D0 to D99"),
      ig::diagnostic(IG_WARNING, "SIE-0233",
                     "tool {0}, edge D{1}: the tool table has no row {2}, so length and radius 0 are assumed"),
  };

  ig::Word d_{"Parsing.D", ig::wake, ""};
  ig::Codes planes_{{"G17", "G18", "G19"}, ig::read | ig::wake};
  ig::In<std::int64_t> spindle_tool_{"ToolChange.SpindleToolId"};
  ig::In<bool> is_change_{"ToolChange.IsChange", ig::wake};
  ig::Out<std::int64_t> edge_{"ToolHeightCompensation.Edge",
                              {ig::Life::modal, "", "D: the cutting edge in force; 0: none."}};
  ig::Out<ig::Symbol> term_{"ToolHeightCompensation.Term"};
  ig::Out<std::int64_t> offset_id_{"ToolHeightCompensation.OffsetId"};
  ig::Out<double> offset_{"ToolHeightCompensation.Offset_mm"};
  ig::Out<std::int64_t> radius_id_{"RadiusCompensation.OffsetId"};
  ig::Signal radius_changed_{"ToolHeightCompensation.~TableChanged", ig::write};  // under G41 and G42 it is read again
  ig::Xyz orientation_{"ToolOrientation", ig::read | ig::wake};
  ig::Transform tilt_{"TiltTransform", ig::read | ig::wake};
  ig::Transform frame_{"ToolHeightCompensation"};
  ig::Service<ig_tool_offset_1> table_{"isogloss.tool-offset/1", ig::Need::optional, "Lengths and radii."};
  ig::IntegerOption step_{"edge-step",
                          "100",
                          {1, 100'000},
                          "Rows of the table between two edges of a tool: D1 of tool 5 is row 5, D2 is row 5 + this."};
  ig::Choice<AfterChange> after_change_{"after-change", "D1|D0|kept", "D1", "The edge in force after a tool change."};
  PlaneInForce plane_;
  ToolCenterMode mode_;
  ig::Word h_{"Parsing.H", ig::write, ""};
  ig::Name d0_{"D0"};

  ig::Status restart(ig::Block& b) {
    b.set_translation(frame_, {});
    return ig::Status::changed;
  }

  ig::Status build(ig::Block& b) {
    auto d = b.take(d_);
    const auto where = d ? ig::Where::word(d_.id()) : ig::Where::block();
    if (!d && b.is_fresh(is_change_) && after_change_ != AfterChange::kept)
      d = after_change_ == AfterChange::d1 ? 1 : 0;
    const bool leads_tip = mode_.is_on(b);
    const bool turned = b.is_fresh(orientation_) || b.is_fresh(tilt_) || b.find(planes_);
    if (d) {
      const auto edge = whole_number(*d);
      if (!edge || *edge > 99) {
        b.report(ig::diag("SIE-0231"), where, *d);
        return ig::Status::changed;
      }
      put_in_force(b, *edge, where);
    } else if (turned && !leads_tip && b.get_or(edge_, std::int64_t{0}) != 0) {
      apply(b, b.get_or(offset_, 0.0));
    }
    return ig::Status::changed;
  }

 private:
  void put_in_force(ig::Block& b, std::int64_t edge, ig::Where where) const {
    const auto tool = b.get(spindle_tool_);
    b.set(edge_, edge);
    if (edge == 0) {
      set_radius(b, 0);
      if (mode_.is_on(b)) return b.set(h_, 0.0);
      b.set(term_, d0_);
      b.set(offset_id_, std::int64_t{0});
      b.set(offset_, 0.0);
      apply(b, 0);
      return;
    }
    const std::int64_t row = edge_row(table_, tool.value_or(0), edge, step_);
    const auto known = tool.value_or(0) != 0 ? tool_dimension(table_, row, ToolDimension::length) : std::nullopt;
    if (!known && tool.value_or(0) != 0)
      b.report(ig::diag("SIE-0233"), where, static_cast<double>(*tool), static_cast<double>(edge),
               edge == 1 ? std::to_string(row) : std::to_string(*tool) + "." + std::to_string(edge));
    const double length = known.value_or(0);
    set_radius(b, row);
    if (mode_.is_on(b)) return b.set(h_, static_cast<double>(known ? row : 0));
    b.set(term_, b.symbol("D" + std::to_string(edge)));
    b.set(offset_id_, row);
    b.set(offset_, length);
    apply(b, length);
  }

  void set_radius(ig::Block& b, std::int64_t row) const {
    if (b.get_or(radius_id_, std::int64_t{-1}) != row) b.raise(radius_changed_);
    b.set(radius_id_, row);
  }

  void apply(ig::Block& b, double length) const {
    ig::Vec3 axis;
    axis[plane_(b).tool] = 1;
    const ig::PartialVec3 orientation = b.get(orientation_);
    b.set_translation(frame_, length * (orientation.complete() ? orientation.value : axis));
  }
};

const ig::Register<SiemensToolOffset> siemens_tool_offset_syntax;

}  // namespace
}  // namespace siemens
