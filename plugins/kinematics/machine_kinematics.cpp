// Reads once where the rotary axes of the machine are and how they turn; the geometry is in rotary_machine.hpp.
#include <isogloss/rows.hpp>
#include <isogloss/sdk.hpp>
#include <stdexcept>

#include "rotary_machine.hpp"

namespace kinematics {
namespace {

constexpr std::string_view letters = "ABC";

struct MachineKinematics {
  static constexpr auto spec =
      ig::dependency("MachineKinematics", "The rotary axes of the machine: place, direction and pivot.")
          .rows("Axis", "name")
          .provides("isogloss.machine-kinematics/1");

  ig::Column place{"Place", nullptr, "", {}, "table: the axis turns the workpiece; head: it turns the tool.", true};
  ig::Column order{
      "Order", nullptr, "", {1, 2}, "Where there are two axes: 1 is the one nearer the machine's base, 2 the other."};
  std::array<ig::Column, 3> direction{
      ig::Column{"X", nullptr, "", {-1e6, 1e6}, "Direction of the axis; default: A is along X."},
      ig::Column{"Y", nullptr, "", {-1e6, 1e6}, "Direction of the axis; default: B is along Y."},
      ig::Column{"Z", nullptr, "", {-1e6, 1e6}, "Direction of the axis; default: C is along Z."}};
  std::array<ig::Column, 3> pivot_point{
      ig::Column{"PivotX", "0", "mm", {-1e6, 1e6}, "A point on the axis."},
      ig::Column{"PivotY", "0", "mm", {-1e6, 1e6}, "Table: in machine coordinates, all rotary axes at zero."},
      ig::Column{"PivotZ", "0", "mm", {-1e6, 1e6}, "Head: from the gauge point, all rotary axes at zero."}};
  ig::Column sign{"Sign",
                  "1",
                  "",
                  {-1, 1},
                  "1: positive turns the tool right-handed relative to the workpiece; -1: the other way."};
  ig::Column zero{
      "Zero", "0", "deg", {-360, 360}, "The angle that the machine shows where the axis is geometrically at zero."};
  ig::Table table;
  ig::RowNames rows;

  MachineKinematics() {
    std::array<double, 2> orders{};
    for (const std::string& name : rows) {
      const std::size_t letter = letters.find(name);
      if (name.size() != 1 || letter == std::string_view::npos) fail(name, "its name is A, B or C");
      if (machine.count() == 2)
        throw std::runtime_error("it has rows for A, B and C, and a machine has at most two rotary axes");
      orders[machine.count()] = table.value(name, order).value_or(0);
      machine.add(read_axis(letter, name));
    }
    if (machine.count() == 2) put_in_order(orders);
    machine.prepare();
  }

  const void* service(std::string_view id) const {
    return machine.count() > 0 && id == "isogloss.machine-kinematics/1" ? &answers : nullptr;
  }

 private:
  [[noreturn]] static void fail(std::string_view axis, const std::string& why) {
    throw std::runtime_error("axis " + std::string(axis) + ": " + why);
  }

  RotaryAxis read_axis(std::size_t letter, std::string_view name) const {
    RotaryAxis axis;
    axis.letter = letter;
    const std::string_view where = table.text(name, place);
    if (where != "table" && where != "head") fail(name, "Place is table or head, not '" + std::string(where) + "'");
    axis.place = where == "table" ? Place::table : Place::head;
    axis.direction = read_direction(letter, name);
    for (int i = 0; i < 3; ++i) axis.point[i] = table.value(name, pivot_point[static_cast<std::size_t>(i)]).value_or(0);
    axis.sign = table.value(name, sign).value_or(1);
    if (std::fabs(axis.sign) != 1) fail(name, "Sign is 1 or -1");
    axis.zero = table.value(name, zero).value_or(0);
    return axis;
  }

  /// The direction of an axis; by default that of its letter.
  Vector read_direction(std::size_t letter, std::string_view name) const {
    Vector out = Vector::Zero();
    bool is_given = false;
    for (std::size_t i = 0; i < direction.size(); ++i) {
      const std::optional<double> value = table.value(name, direction[i]);
      is_given = is_given || value;
      out[static_cast<int>(i)] = value.value_or(0);
    }
    if (!is_given) return Vector::Unit(static_cast<int>(letter));
    const double longest = out.cwiseAbs().maxCoeff();
    if (longest < 1e-6) fail(name, "its direction X Y Z is zero");
    // Divided by the largest component first: the square of a small number would lose digits.
    return (out / longest).normalized();
  }

  void put_in_order(const std::array<double, 2>& orders) {
    const std::string both = {letters[machine.axis(0).letter], ',', ' ', letters[machine.axis(1).letter]};
    if (orders[0] + orders[1] != 3 || orders[0] == orders[1])
      throw std::runtime_error("axes " + both +
                               ": one has Order=\"1\", nearer the machine's base, the other Order=\"2\"");
    if (machine.axis(0).direction.cross(machine.axis(1).direction).norm() < 1e-3)
      throw std::runtime_error("axes " + both + " are parallel");
    if (orders[0] == 1) return;
    const RotaryMachine written = machine;
    machine = {};
    machine.add(written.axis(1));
    machine.add(written.axis(0));
  }

  static const RotaryMachine& machine_of(void* self) { return static_cast<const MachineKinematics*>(self)->machine; }
  /// False when the angle of an axis that the machine has is not finite.
  static bool read_angles(const RotaryMachine& machine, const double* angles, Angles& out) {
    out = {};
    for (std::size_t i = 0; i < machine.count(); ++i) {
      const std::size_t letter = machine.axis(i).letter;
      if (!std::isfinite(angles[letter])) return false;
      out[letter] = angles[letter];
    }
    return true;
  }

  static std::uint32_t axes(void* self, char names[2]) {
    const RotaryMachine& machine = machine_of(self);
    for (std::size_t i = 0; i < machine.count(); ++i) names[i] = letters[machine.axis(i).letter];
    return static_cast<std::uint32_t>(machine.count());
  }

  static std::int32_t tool_axis(void* self, const double angles[3], double out[3]) {
    const RotaryMachine& machine = machine_of(self);
    Angles at;
    if (!read_angles(machine, angles, at)) return 0;
    const Vector& t = machine.pose(at).tool_axis;
    for (int i = 0; i < 3; ++i) out[i] = t[i];
    return 1;
  }

  static std::int32_t pivot(void* self, const double angles[3], double out[16]) {
    const RotaryMachine& machine = machine_of(self);
    Angles at;
    if (!read_angles(machine, angles, at)) return 0;
    const Pose& pose = machine.pose(at);
    // The document has row vectors, so its matrix is the transpose.
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) out[4 * row + column] = pose.rotation(column, row);
      out[4 * row + 3] = 0;
      out[12 + row] = pose.translation[row];
    }
    out[15] = 1;
    return 1;
  }

  static std::uint32_t solve(void* self, const double wanted[3], const double present[3], ig_rotary_solution out[2]) {
    const RotaryMachine& machine = machine_of(self);
    Vector direction(wanted[0], wanted[1], wanted[2]);
    const double longest = direction.cwiseAbs().maxCoeff();
    Angles at;
    if (!direction.allFinite() || longest == 0 || !read_angles(machine, present, at)) return 0;
    // Normalised in two steps, because the length of a huge vector would overflow.
    direction = (direction / longest).normalized().eval();
    std::array<Solution, 2> found;
    const std::uint32_t n = machine.solve(direction, {present[0], present[1], present[2]}, found);
    for (std::uint32_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < 3; ++k) out[i].angles[k] = found[i].angles[k];
      out[i].free = found[i].free;
      out[i].reserved = 0;
    }
    return n;
  }

  static std::int32_t axis_speeds(void* self, const double angles[3], const double turning[3], const double tip[3],
                                  double length, const double tip_speed[3], double out[3]) {
    const RotaryMachine& machine = machine_of(self);
    Angles at, turns;
    if (!read_angles(machine, angles, at) || !read_angles(machine, turning, turns)) return 0;
    const Vector speeds =
        machine.axis_speeds(at, turns, {tip[0], tip[1], tip[2]}, length, {tip_speed[0], tip_speed[1], tip_speed[2]});
    if (!speeds.allFinite()) return 0;
    for (int i = 0; i < 3; ++i) out[i] = speeds[i];
    return 1;
  }

  RotaryMachine machine;
  ig_machine_kinematics_1 answers{
      sizeof(ig_machine_kinematics_1), 0, this, &axes, &tool_axis, &pivot, &solve, &axis_speeds};
};

const ig::Register<MachineKinematics> machine_kinematics;

}  // namespace
}  // namespace kinematics
