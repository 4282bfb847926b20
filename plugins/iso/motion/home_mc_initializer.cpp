// The position of the machine before the first block: home, on every axis that the machine has. Without a machine
// description that is machine zero on X, Y and Z.
#include <isogloss/cnc/rotary_axis.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

struct HomeMcInitializer {
  static constexpr auto spec = ig::syntax("HomeMcInitializer", "Starts the machine at its home position.");

  ig::Service<ig_machine_axis_1> axes{"isogloss.machine-axis/1", ig::Need::optional, "Knows the home position."};
  std::array<ig::Out<double>, 6> coordinates{
      ig::Out<double>{"MachineCoordinate.X"}, ig::Out<double>{"MachineCoordinate.Y"},
      ig::Out<double>{"MachineCoordinate.Z"}, ig::Out<double>{"MachineCoordinate.A"},
      ig::Out<double>{"MachineCoordinate.B"}, ig::Out<double>{"MachineCoordinate.C"}};
  RotaryAxes rotary;

  ig::Status restart(ig::Block& b) const {
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      const bool is_there = i < 3 || rotary.has(i - 3);
      double position = 0;
      if (axes) axes->home(axes->self, "XYZABC"[i], &position);
      if (is_there) b.set(coordinates[i], position);
    }
    return ig::Status::changed;
  }

  /// A block without a position, as in a case of a page, starts at home.
  ig::Status build(ig::Block& b) const { return b.has(coordinates[0]) ? ig::Status::unchanged : restart(b); }
};

const ig::Register<HomeMcInitializer> home_mc_initializer;

}  // namespace
}  // namespace iso
