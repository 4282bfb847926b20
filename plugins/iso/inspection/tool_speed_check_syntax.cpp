/// Reports a speed of the spindle that is above the highest speed of the tool in it. The speed stays as programmed.
#include <isogloss_tool.h>

#include <isogloss/sdk.hpp>

namespace iso {
namespace {

struct ToolSpeedCheck {
  static constexpr auto spec = ig::syntax("ToolSpeedCheckSyntax", "Reports a speed above the highest one of the tool.")
                                   .after("SpindleSpeedSyntax", "ToolChangeSyntax", "KlartextToolCallSyntax",
                                          "ToolHeightOffsetSyntax", "SiemensToolOffsetSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_WARNING, "ISO-0584",
                     "{0} rpm is above {1} rpm, the highest speed of tool {2} in the tool table: check S"),
  };

  ig::In<double> speed_{"SpindleSpeed.SpindleSpeed_rpm", ig::wake};
  ig::In<std::int64_t> tool_{"ToolChange.SpindleToolId", ig::wake};
  ig::In<std::int64_t> row_{"ToolHeightCompensation.OffsetId", ig::wake};
  ig::Service<ig_tool_offset_1> tools_{"isogloss.tool-offset/1", ig::Need::optional, "The highest speed of each tool."};

  ToolSpeedCheck() {
    if (!tools_) ig::stay_idle();
  }

  ig::Status build(ig::Block& b) const {
    const double speed = b.get_or(speed_, 0.0);
    if (!b.is_fresh(speed_) && !b.is_fresh(tool_) && !b.is_fresh(row_)) return ig::Status::unchanged;
    const std::int64_t tool = b.get_or(tool_, std::int64_t{0}), row = b.get_or(row_, std::int64_t{0});
    // A step of the tool, row 5.1, may have a speed of its own.
    double highest = row > IG_TOOL_INDEX_STEP && row % IG_TOOL_INDEX_STEP == tool ? highest_of(row) : 0;
    if (highest <= 0) highest = highest_of(tool);
    if (highest > 0 && speed > highest)
      b.report(ig::diag("ISO-0584"), ig::Where::block(), speed, highest, static_cast<double>(tool));
    return ig::Status::unchanged;
  }

 private:
  double highest_of(std::int64_t row) const {
    double rpm = 0;
    return tools_->get(tools_->self, row, IG_TOOL_MAXIMUM_SPEED, &rpm) != 0 ? rpm : 0;
  }
};

const ig::Register<ToolSpeedCheck> tool_speed_check_syntax;

}  // namespace
}  // namespace iso
