/// #5001 to #5100, and the axes that an index names.
#include "macro/macro_environment.hpp"

namespace fanuc {

using namespace ig::cnc;

std::size_t MacroEnvironment::axis_of(const ig::Block& b, std::uint32_t index) const {
  if (index < 3) return index;
  for (std::size_t axis = 3; axis < 6; ++axis) {
    double home = 0;
    const bool exists =
        b.has(rotary_[axis - 3]) || (machine_ && machine_->home(machine_->self, "XYZABC"[axis], &home) != 0);
    if (exists && index-- == 3) return axis;
  }
  return no_axis;
}

Fault MacroEnvironment::position(const ig::Block& b, std::uint32_t group, std::uint32_t index, double& out) const {
  const std::size_t axis = axis_of(b, index);
  if (axis == no_axis) return index < 6 && axis_of(b, 3) == no_axis ? Fault::not_known_here : Fault::unknown_variable;
  if (axis > 2) {
    const double angle = b.get_or(rotary_[axis - 3], 0.0);
    out = group == tool_length ? 0 : group == machine ? angle : angle - b.get_or(rotary_offset_[axis - 3], 0.0);
    return Fault::none;
  }
  switch (group) {
    case machine: out = b.get(machine_xyz_).value[axis]; break;
    case work: out = work_position(b, axis); break;
    case tool_length: out = axis == 2 ? b.get_or(length_, 0.0) : 0; break;
    default: out = program_xyz(b)[axis];
  }
  out = in_program_unit(b, out);
  return Fault::none;
}

double MacroEnvironment::work_position(const ig::Block& b, std::size_t axis) const {
  const ig::PartialVec3 position = b.get(machine_xyz_);
  if (!position.has(axis)) return program_xyz(b)[axis];
  return position.value[axis] - b.get_or(work_origin_[axis], 0.0) - b.get_or(local_origin_[axis], 0.0) -
         b.get_or(shift_[axis], 0.0) - b.get_or(dynamic_offset_[axis], 0.0);
}

}  // namespace fanuc
