/// Work offsets and tool offsets as variables: #5201, #7001 and #14001 and on, #2001 and #10001 and on.
#include "macro/macro_environment.hpp"

#include <cmath>

#include <isogloss/cnc/work_origin.hpp>

namespace fanuc {

using namespace ig::cnc;

Fault MacroEnvironment::local_shift(const ig::Block& b, std::uint32_t index, double& out) const {
  const std::size_t axis = axis_of(b, index);
  if (axis > 2) return Fault::not_known_here;
  out = in_program_unit(b, b.get_or(local_origin_[axis], 0.0));
  return Fault::none;
}

MacroEnvironment::OffsetCell MacroEnvironment::offset_cell(std::uint32_t n) const {
  const auto basic = [](std::uint32_t set, std::uint32_t axis) {
    return OffsetCell{true, axis, WorkOffsetId::basic(set)};
  };
  const auto additional = [](std::uint32_t index) {
    const std::uint32_t set = index / 20 + 1;
    return OffsetCell{true, index % 20, WorkOffsetId::additional(set)};
  };
  if (within(n, 5201, 5340)) return basic((n - 5201) / 20, (n - 5201) % 20);
  if (within(n, 7001, 7960)) return additional(n - 7001);
  if (within(n, 14001, 20000)) return additional(n - 14001);
  const bool has_by_axes = !store().settings.radii_from_2401;
  if (has_by_axes && within(n, 2500, 2799) && n % 100 <= 6) return basic(n % 100, n / 100 - 25);
  return {};
}

Fault MacroEnvironment::read_offset(const ig::Block& b, const OffsetCell& cell, double& out) const {
  const std::size_t axis = axis_of(b, cell.axis);
  const auto offset = axis == no_axis ? std::nullopt : offset_of(cell, axis);
  if (!offset) return Fault::unknown_variable;
  out = axis > 2 ? *offset : in_program_unit(b, *offset);
  return Fault::none;
}

std::optional<double> MacroEnvironment::offset_of(const OffsetCell& cell, std::size_t axis) const {
  return offsets_ ? axis_origin(offsets_, cell.id.text(), axis) : std::nullopt;
}

MacroEnvironment::ToolCell MacroEnvironment::tool_cell(std::uint32_t n) const {
  const MacroSettings& settings = store().settings;
  const std::uint32_t wear_first = settings.tools == ToolVariables::wear_first ? 1 : 0;
  if (settings.tools != ToolVariables::geometry_first && within(n, 10001, 13999) && n % 1000 != 0)
    return {n % 1000, (n / 1000 - 10) ^ wear_first};
  if (within(n, 2001, settings.radii_from_2401 ? 2800 : 2400))
    return {(n - 2001) % 200 + 1, ((n - 2001) / 200) ^ wear_first};
  return {};
}

Fault MacroEnvironment::read_tool(const ig::Block& b, const ToolCell& cell, double& out) const {
  double mm = 0;
  if (!tools_ || tools_->get(tools_->self, cell.row, cell.column, &mm) == 0) return Fault::unknown_variable;
  out = in_program_unit(b, mm);
  return Fault::none;
}

MacroEnvironment::Written MacroEnvironment::write_offset(ig::Block& b, const OffsetCell& cell, double value) {
  const std::size_t axis = axis_of(b, cell.axis);
  if (axis == no_axis) return Written::no_variable;
  const double to = axis < 3 && is_inch(b) ? value * mm_per_inch : value;
  if (!std::isfinite(to) || !offset_of(cell, axis) || !set_axis_origin(offsets_, cell.id.text(), axis, to))
    return Written::no_row;
  b.raise(offsets_changed_);
  return Written::done;
}

}  // namespace fanuc
