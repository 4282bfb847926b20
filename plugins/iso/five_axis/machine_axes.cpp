// The machine's axes: which exist, where home and the reference positions are, the travel and the rapid rate of each,
// and how the rotary axes turn.
#include <cmath>
#include <stdexcept>

#include <isogloss/rows.hpp>
#include <isogloss/sdk.hpp>

namespace iso {
namespace {

constexpr const char* shipped_axes[] = {"X|Home=0", "Y|Home=0", "Z|Home=0"};

struct MachineAxes {
  static constexpr auto spec = ig::dependency("MachineAxes", "The axes of the machine, in machine coordinates.")
                                   .rows("Axis", "name")
                                   .provides("isogloss.machine-axis/1")
                                   .ships(shipped_axes);

  ig::Column home_position{"Home", "0", "mm, deg", {}, "Position of the axis before the first block."};
  std::array<ig::Column, 4> references{
      ig::Column{"Reference1", "0", "mm, deg", {}, "First reference position (G28)."},
      ig::Column{"Reference2", nullptr, "mm, deg", {}, "Second reference position (G30, G30 P2)."},
      ig::Column{"Reference3", nullptr, "mm, deg", {}, "Third reference position (G30 P3)."},
      ig::Column{"Reference4", nullptr, "mm, deg", {}, "Fourth reference position (G30 P4)."}};
  ig::Column minimum{"Minimum", nullptr, "mm, deg", {}, "Lower end of the travel."};
  ig::Column maximum{"Maximum", nullptr, "mm, deg", {}, "Upper end of the travel."};
  ig::Column rapid_rate{"RapidRate", nullptr, "mm/min, deg/min", {0, HUGE_VAL}, "Speed of a rapid."};
  ig::Column rollover_mode{"Rollover",
                           nullptr,
                           "",
                           {0, 2},
                           "How a rotary axis turns: 0 linear count, 1 shortest way, 2 the sign is the direction."};
  ig::Table table;
  ig::RowNames rows;

  MachineAxes() {
    for (const std::string& name : rows)
      if (name.size() != 1 || std::string_view("XYZABC").find(name) == std::string_view::npos)
        throw std::runtime_error("axis '" + name + "': its name is X, Y, Z, A, B or C");
  }

  const void* service(std::string_view id) const { return id == "isogloss.machine-axis/1" ? &axes : nullptr; }

 private:
  std::int32_t answer(char axis, const ig::Column& column, double* out) const {
    const auto value = table.value({&axis, 1}, column);
    if (value) *out = *value;
    return value ? 1 : 0;
  }

  static std::int32_t home(void* self, char axis, double* position) {
    const auto& m = *static_cast<const MachineAxes*>(self);
    return m.answer(axis, m.home_position, position);
  }
  static std::int32_t reference(void* self, char axis, std::uint32_t which, double* position) {
    const auto& m = *static_cast<const MachineAxes*>(self);
    return which >= 1 && which <= 4 ? m.answer(axis, m.references[which - 1], position) : 0;
  }
  static std::int32_t travel(void* self, char axis, double* low, double* high) {
    const auto& m = *static_cast<const MachineAxes*>(self);
    *low = -HUGE_VAL;
    *high = HUGE_VAL;
    const bool any = (m.answer(axis, m.minimum, low) | m.answer(axis, m.maximum, high)) != 0;
    return any && *low <= *high ? 1 : 0;
  }
  static std::int32_t rollover(void* self, char axis, std::uint32_t* mode) {
    const auto& m = *static_cast<const MachineAxes*>(self);
    double known = 0;
    if (std::string_view("ABC").find(axis) == std::string_view::npos || home(self, axis, &known) == 0) return 0;
    double low = 0, high = 0;
    const bool is_limited = travel(self, axis, &low, &high) != 0;
    *mode = static_cast<std::uint32_t>(m.table.value({&axis, 1}, m.rollover_mode).value_or(is_limited ? 0 : 1));
    return 1;
  }
  static std::int32_t rapid(void* self, char axis, double* per_second) {
    const auto& m = *static_cast<const MachineAxes*>(self);
    if (m.answer(axis, m.rapid_rate, per_second) == 0) return 0;
    *per_second /= 60;
    return 1;
  }

  ig_machine_axis_1 axes{sizeof(ig_machine_axis_1), 0, this, &home, &reference, &travel, &rapid, &rollover};
};

const ig::Register<MachineAxes> machine_axes;

}  // namespace
}  // namespace iso
