/// Helpers of the tests of the kinematics: a machine with two rotary axes, and a program on it.
#pragma once

#include <catch2/catch.hpp>

#include "isogloss/cnc/block_document_test.hpp"
#include "isogloss/cnc/rotary_solver.hpp"
#include "isogloss/cnc/rotary_turns.hpp"

namespace ig::cnc {

/// A machine with a head B, which tilts the tool about its gauge point, and a table C about X10 Y0; or other axes by
/// `names`, of which only C is a table. solve() answers what the test gives.
struct HeadAndTable {
  std::string names = "BC";
  std::vector<ig_rotary_solution> solutions;
  std::optional<AngleRange> travel_of_b;
  ig_machine_kinematics_1 kinematics{};
  ig_machine_axis_1 axes{};

  HeadAndTable() {
    kinematics.struct_size = sizeof kinematics;
    kinematics.self = this;
    kinematics.axes = [](void* self, char* out) {
      const std::string& all = of(self).names;
      std::copy(all.begin(), all.end(), out);
      return static_cast<std::uint32_t>(all.size());
    };
    kinematics.tool_axis = [](void*, const double angles[3], double out[3]) {
      const double b = angles[1] * radians_per_degree, c = angles[2] * radians_per_degree;
      out[0] = std::sin(b) * std::cos(c);
      out[1] = -std::sin(b) * std::sin(c);
      out[2] = std::cos(b);
      return std::int32_t{std::isfinite(b) && std::isfinite(c)};
    };
    kinematics.pivot = [](void*, const double angles[3], double out[16]) {
      const double c = std::cos(angles[2] * radians_per_degree), s = std::sin(angles[2] * radians_per_degree);
      const Mat4 turned{c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 10 - 10 * c, -10 * s, 0, 1};
      std::copy(turned.begin(), turned.end(), out);
      return std::int32_t{std::isfinite(angles[2])};
    };
    kinematics.solve = [](void* self, const double*, const double*, ig_rotary_solution* out) {
      std::copy(of(self).solutions.begin(), of(self).solutions.end(), out);
      return static_cast<std::uint32_t>(of(self).solutions.size());
    };
    axes.struct_size = sizeof axes;
    axes.self = this;
    axes.home = [](void*, char, double*) { return std::int32_t{0}; };
    axes.reference = [](void*, char, std::uint32_t, double*) { return std::int32_t{0}; };
    axes.rapid_rate = [](void*, char, double*) { return std::int32_t{0}; };
    axes.travel = [](void* self, char axis, double* low, double* high) {
      const auto& travel = of(self).travel_of_b;
      if (axis != 'B' || !travel) return std::int32_t{0};
      *low = travel->minimum;
      *high = travel->maximum;
      return std::int32_t{1};
    };
  }
  HeadAndTable(const HeadAndTable&) = delete;
  HeadAndTable& operator=(const HeadAndTable&) = delete;

 private:
  static const HeadAndTable& of(void* self) { return *static_cast<const HeadAndTable*>(self); }
};

/// The members as a syntax has them; set up `machine` before.
struct FiveAxisProgram {
  isogloss_test::BlockDocument document;
  ToolKinematics kinematics;
  RotarySolver solver;
  RotaryTurns turns;
  ig::Block block = document.block();
  explicit FiveAxisProgram(const HeadAndTable& machine)
      : kinematics(asked(machine).member<ToolKinematics>()),
        solver(document.member<RotarySolver>()),
        turns(document.member<RotaryTurns>(ig::read | ig::write, RotaryWordsAre::of_machine)) {}
  isogloss_test::BlockDocument& asked(const HeadAndTable& machine) {
    document.services = {{"isogloss.machine-kinematics/1", &machine.kinematics},
                         {"isogloss.machine-axis/1", &machine.axes}};
    return document;
  }
  RotaryTurn turn() const { return turns.read(block, kinematics); }
};

}  // namespace ig::cnc
