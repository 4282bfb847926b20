/// What expressions read and assignments write: the stored variables, and the variables of the control, which stand for
/// positions, modal codes, offsets and clocks.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <isogloss/cnc/units.hpp>
#include <isogloss/cnc/work_offset_id.hpp>
#include <isogloss/sdk.hpp>

#include "macro/expression.hpp"
#include "macro/macro_frame.hpp"
#include "macro/passed_code_mark.hpp"

namespace fanuc {

using namespace ig::cnc;

/// O1234 is 1234; a name in brackets is no number.
inline std::optional<double> program_number(std::string_view name) {
  const ig::Decimal number = name.size() > 1 && name[0] == 'O' ? ig::read_decimal(name, 1) : ig::Decimal{};
  return number.ok ? std::optional(number.value) : std::nullopt;
}

/// A member of each syntax that evaluates.
class MacroEnvironment : public MacroFrame {
 public:
  const ExpressionRules& rules() const { return store().settings.rules; }

  /// What an expression of this block reads: for evaluate() and its like.
  class Reader final : public VariableSource {
   public:
    Reader(const MacroEnvironment& environment, ig::Block& b) : environment_(environment), block_(b) {}
    Fault read(std::uint32_t number, MacroValue& out) const override { return environment_.read(block_, number, out); }
    Fault parameter(std::uint32_t number, std::uint32_t axis, MacroValue& out) const override {
      return environment_.read_parameter(block_, number, axis, out);
    }

   private:
    const MacroEnvironment& environment_;
    ig::Block& block_;
  };
  Reader reader(ig::Block& b) const { return {*this, b}; }

  /// Of the variables of the control that were read since the last forget_signals().
  struct Signals {
    std::uint32_t last = 0;    ///< a signal of the machine whose state is not known here; 0: none was read
    bool others_also = false;  ///< one that may change by itself
  };
  void forget_signals() const { signals_ = {}; }
  const Signals& signals() const { return signals_; }

  /// The block shows what it read.
  Fault read(ig::Block& b, std::uint32_t number, MacroValue& out) const;

  /// What an assignment did.
  enum class Written { done, no_variable, read_only, no_row };
  Written write(ig::Block& b, std::uint32_t number, const MacroValue& value);

  /// Reports why an expression has no value.
  void report(ig::Block& b, const Outcome& o, std::string_view text) const;

  /// #[11000+#1] says nothing of which variable it is: its number stands behind it.
  static std::string name_of(std::string_view written, std::uint32_t number);

  bool has_deep_brackets(const Outcome& o) const { return o.depth > store().settings.nesting; }
  void warn_of_depth(ig::Block& b, const Outcome& o, std::size_t begin, std::size_t end) const {
    b.report(ig::diag("FAN-0117"), ig::Where::columns(begin, end), static_cast<double>(o.depth),
             static_cast<double>(store().settings.nesting));
  }

 private:
  static ig::DiagnosticCode diagnostic_of(Fault fault);

  // ---- macro_environment.cpp: where the variables of the control stand

  Fault read_system(ig::Block& b, std::uint32_t n, MacroValue& out) const;
  static bool is_signal_of_machine(std::uint32_t n) { return within(n, 1000, 1199); }

  /// Axis 1 to 3 are X Y Z, then the rotary axes that the machine has; 0: a parameter for the whole control.
  Fault read_parameter(const ig::Block& b, std::uint32_t number, std::uint32_t axis, MacroValue& out) const;

  static bool within(std::uint32_t n, std::uint32_t first, std::uint32_t last) { return n >= first && n <= last; }

  Fault system_value(ig::Block& b, std::uint32_t n, double& out) const;

  /// The ranges that controls use for what no program can know.
  static bool is_of_control(std::uint32_t n);

  Written write_system(ig::Block& b, std::uint32_t n, double value);

  void report_assumed(ig::Block& b, std::uint32_t n) const;
  void report_signal(ig::Block& b, std::uint32_t n) const;  // that the program writes
  /// Adds the number to the sorted ones; false where it is one of them.
  static bool is_first(std::vector<std::uint32_t>& seen, std::uint32_t n);

  Fault clock(std::uint32_t n, double& out) const;

  static Fault calendar(std::uint32_t n, double& out);

  // ---- modal_variables.cpp

  /// G54.1P12 is 54.1; `otherwise` where no code is in force.
  double code(const ig::Block& b, const ig::Field<ig::Symbol>& field, double otherwise) const;

  Fault modal(const ig::Block& b, std::uint32_t n, double& out) const;

  double work_offset_code(const ig::Block& b) const;
  double modal_call() const;

  /// Of the block before; where it has none, the last one is not kept here.
  Fault passed(const ig::Block& b, PassedCodes::Which which, double& out) const;

  /// The name by which the program was called; the main program has the number that it begins with.
  Fault program_in_force(const ig::Block& b, double& out) const;

  double additional_set(const ig::Block& b) const;

  bool is_inch(const ig::Block& b) const { return b.is(system_, inch_); }
  double in_program_unit(const ig::Block& b, double mm) const { return is_inch(b) ? mm / mm_per_inch : mm; }

  // ---- position_variables.cpp

  /// Axis 4 and on are the rotary axes that the machine has, in the order A, B, C.
  static constexpr std::size_t no_axis = 9;
  std::size_t axis_of(const ig::Block& b, std::uint32_t index) const;

  enum Group : std::uint32_t { block_end = 0, machine = 1, work = 2, skip = 3, tool_length = 4 };

  Fault position(const ig::Block& b, std::uint32_t group, std::uint32_t index, double& out) const;

  ig::Vec3 program_xyz(const ig::Block& b) const { return b.get(program_xyz_).or_else({}); }

  /// The gauge point in the work coordinate system: the machine position without the offsets of the workpiece.
  double work_position(const ig::Block& b, std::size_t axis) const;

  // ---- offset_variables.cpp

  struct OffsetCell {
    bool exists = false;
    std::uint32_t axis = 0;
    WorkOffsetId id = WorkOffsetId::basic(0);
  };

  bool is_local_shift(std::uint32_t n) const { return store().settings.local_in_5201 && within(n, 5201, 5206); }
  Fault local_shift(const ig::Block& b, std::uint32_t index, double& out) const;

  /// #5201 the external offset, #5221 G54 …, twenty to a set; #7001 and #14001 G54.1 P1 …; #2501, #2601, #2701 by axes.
  OffsetCell offset_cell(std::uint32_t n) const;

  Fault read_offset(const ig::Block& b, const OffsetCell& cell, double& out) const;

  /// The offset of one axis, 0 to 5; nothing where the table has none.
  std::optional<double> offset_of(const OffsetCell& cell, std::size_t axis) const;

  struct ToolCell {
    std::uint32_t row = 0;  ///< 0: none
    std::uint32_t column = 0;
  };
  /// Columns of the tool offset service: 0 length, 1 its wear, 2 radius, 3 its wear.
  ToolCell tool_cell(std::uint32_t n) const;

  Fault read_tool(const ig::Block& b, const ToolCell& cell, double& out) const;

  Written write_offset(ig::Block& b, const OffsetCell& cell, double value);

  mutable std::vector<std::uint32_t> assumed_, written_;
  mutable Signals signals_;

  ig::In<ig::Symbol> motion_{"MotionState.Term"}, plane_{"PlaneSelect.Term"}, positioning_{"PositioningMode.Term"},
      feed_mode_{"Feedrate.Term"}, unit_{"Unit.Term"}, system_{"Unit.System"}, radius_term_{"RadiusCompensation.Term"},
      length_term_{"ToolHeightCompensation.Term"}, cycle_{"CannedCycle.Term"}, return_mode_{"CannedCycle.ReturnMode"},
      scaling_{"Scaling.Term"}, surface_speed_{"SpindleSpeed.Term"}, work_offset_{"CoordinateOffset.CoordinateId"},
      path_mode_{"PathMode.Term"}, tilt_{"TiltTransform.Term"}, polar_{"PolarCoordinate.Term"},
      mirror_{"MirrorImage.Term"};
  ig::In<ig::Symbol> work_offset_code_{"CoordinateOffset.Term", ig::read, {ig::Life::modal, "", ""}};
  ig::In<double> feed_{"Feedrate.FeedrateValue"}, speed_{"SpindleSpeed.SpindleSpeed_rpm"},
      length_{"ToolHeightCompensation.Offset_mm"};
  ig::In<std::int64_t> tool_{"ToolChange.ToolId"}, length_row_{"ToolHeightCompensation.OffsetId"},
      radius_row_{"RadiusCompensation.OffsetId"};
  PassedCodeMark passed_;
  ig::Xyz program_xyz_{"ProgramXyz", ig::read}, machine_xyz_{"MachineCoordinate", ig::read};
  std::array<ig::In<double>, 3> rotary_{ig::In<double>{"MachineCoordinate.A"}, ig::In<double>{"MachineCoordinate.B"},
                                        ig::In<double>{"MachineCoordinate.C"}};
  static constexpr ig::About rotary_offset_about{ig::Life::modal, "deg",
                                                 "What is added to a programmed angle of the axis."};
  std::array<ig::In<double>, 3> rotary_offset_{ig::In<double>{"RotaryOffset.A", ig::read, rotary_offset_about},
                                               ig::In<double>{"RotaryOffset.B", ig::read, rotary_offset_about},
                                               ig::In<double>{"RotaryOffset.C", ig::read, rotary_offset_about}};
  std::array<ig::In<double>, 3> work_origin_{ig::In<double>{"CoordinateOffset.Offset_X"},
                                             ig::In<double>{"CoordinateOffset.Offset_Y"},
                                             ig::In<double>{"CoordinateOffset.Offset_Z"}};
  std::array<ig::In<double>, 3> local_origin_{ig::In<double>{"LocalCoordinateOffset.Offset_X"},
                                              ig::In<double>{"LocalCoordinateOffset.Offset_Y"},
                                              ig::In<double>{"LocalCoordinateOffset.Offset_Z"}};
  std::array<ig::In<double>, 3> shift_{ig::In<double>{"WorkCoordinateShift.Offset_X"},
                                       ig::In<double>{"WorkCoordinateShift.Offset_Y"},
                                       ig::In<double>{"WorkCoordinateShift.Offset_Z"}};
  static constexpr ig::About dynamic_offset_about{ig::Life::modal, "mm", ""};
  std::array<ig::In<double>, 3> dynamic_offset_{
      ig::In<double>{"DynamicWorkOffset.Offset_X", ig::read, dynamic_offset_about},
      ig::In<double>{"DynamicWorkOffset.Offset_Y", ig::read, dynamic_offset_about},
      ig::In<double>{"DynamicWorkOffset.Offset_Z", ig::read, dynamic_offset_about}};
  std::array<ig_field, 2> read_{
      ig::detail::declare_field({{"Vars.Read[].Variable"},
                                 IG_NUMBER,
                                 ig::write,
                                 {ig::Life::block, "", "Number of a variable that the block read."}}),
      ig::detail::declare_field(
          {{"Vars.Read[].Value"}, IG_NUMBER, ig::write, {ig::Life::block, "", "Its value; absent: null."}})};
  ig::Signal offsets_changed_{"CoordinateOffset.~TableChanged", ig::write};
  ig::Signal tools_changed_{"ToolHeightCompensation.~TableChanged", ig::write};
  ig::Service<ig_work_offset_1> offsets_{"isogloss.work-offset/1", ig::Need::optional, "#5201 and on."};
  ig::Service<ig_tool_offset_1> tools_{"isogloss.tool-offset/1", ig::Need::optional, "#2001 and on."};
  ig::Config parameters_{"isogloss.control-parameter/1", ig::Need::optional, "PRM[]: parameters of the control."};
  ig::Service<ig_machine_axis_1> machine_{"isogloss.machine-axis/1", ig::Need::optional, "The rotary axes there are."};
  ig::AnsweredRows rows_{macro_store_service};
  ig::Name inch_{"Inch"};
};

}  // namespace fanuc
