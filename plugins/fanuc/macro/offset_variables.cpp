/// Work offsets and tool offsets as variables: #5201, #7001 and #14001 and on, #2001 and #10001 and on.
#include "macro/macro_environment.hpp"

#include <cmath>

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
  double offset[3];
  if (axis == no_axis || !get_offset(cell, axis, offset)) return Fault::unknown_variable;
  out = axis > 2 ? offset[axis - 3] : in_program_unit(b, offset[axis]);
  return Fault::none;
}

bool MacroEnvironment::get_offset(const OffsetCell& cell, std::size_t axis, double (&offset)[3]) const {
  const ig_text id = ig::to_text(cell.id.text());
  if (!offsets_ || (axis > 2 && !has_rotary_offsets())) return false;
  return (axis > 2 ? offsets_->get_rotary : offsets_->get)(offsets_->self, id, offset) != 0;
}

bool MacroEnvironment::has_rotary_offsets() const {
  const ig_work_offset_1& table = *offsets_.operator->();
  constexpr std::size_t with_rotary = offsetof(ig_work_offset_1, set_rotary) + sizeof table.set_rotary;
  return table.struct_size >= with_rotary && table.get_rotary != nullptr && table.set_rotary != nullptr;
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
  const bool is_rotary = axis > 2;
  const double to = !is_rotary && is_inch(b) ? value * mm_per_inch : value;
  double offset[3];
  if (!std::isfinite(to) || !get_offset(cell, axis, offset)) return Written::no_row;
  offset[axis % 3] = to;
  const ig_text id = ig::to_text(cell.id.text());
  if ((is_rotary ? offsets_->set_rotary : offsets_->set)(offsets_->self, id, offset) == 0) return Written::no_row;
  b.raise(offsets_changed_);
  return Written::done;
}

}  // namespace fanuc
