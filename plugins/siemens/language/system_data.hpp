/// System variables whose value is in the document or in a table: the position, the tool and its offsets, the settable
/// frames, the codes in force. Values that a program writes to frames and offsets go into the tables of this run.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <isogloss_tool.h>

#include <isogloss/cnc/further_axes.hpp>
#include <isogloss/cnc/rotary_offset.hpp>
#include <isogloss/cnc/units.hpp>
#include <isogloss/sdk.hpp>

#include "frames/assigned_frame.hpp"
#include "frames/frame_value.hpp"
#include "motion/measured_point.hpp"

namespace siemens {

using namespace ig::cnc;

/// The result of an assignment to a system variable.
enum class Written { no, taken, without_effect };

class SystemData {
 public:
  /// The parts of $P_UIFR[1,X,TR]: $P_UIFR, 1, X, TR.
  struct Name {
    std::string_view base;
    std::array<std::string_view, 3> index;
    std::size_t count = 0;

    explicit Name(std::string_view text);
    /// The index `i` as a whole number; nothing where it is none.
    std::optional<std::int64_t> number(std::size_t i) const;
  };

  /// The value in the program's unit; nothing where the variable is not known.
  std::optional<double> read(const ig::Block& b, std::string_view text) const;

  /// The code that puts the frame $P_UIFR[n] in force.
  static std::optional<std::uint32_t> code_of(std::string_view text);
  /// True for variables that write() may accept.
  static bool takes(std::string_view text);
  Written write(const ig::Block& b, std::string_view text, std::optional<double> value) const;

  /// $P_UIFR[n] and similar frames as a whole; nothing where the name is none of them.
  std::optional<FrameValue> frame(const ig::Block& b, std::string_view text) const;
  /// Writes the whole frame; false where the name is none that can be written, or the table cannot keep the value.
  bool write_whole(const ig::Block& b, std::string_view text, const FrameValue& frame) const;
  /// The programmable frame with another value of $P_PFRAME[X,TR]; nothing where it has no such value.
  std::optional<FrameValue> changed_programmed(const ig::Block& b, std::string_view text, double value) const;

 private:
  static constexpr std::int64_t edge_step = 100;

  /// mm per unit of the system's lengths, which are inches under G700.
  double unit(const ig::Block& b) const { return b.is(unit_term_, g700_) ? mm_per_inch : 1; }
  /// 0 to 5 for X Y Z A B C; npos for other names.
  static std::size_t axis_of(std::string_view name) {
    return name.size() == 1 ? std::string_view("XYZABC").find(name[0]) : std::string_view::npos;
  }

  /// $AA_IW[X], $AA_IM[X], $P_EP[X]: the position at the end of the block before.
  std::optional<double> position(const ig::Block& b, const Name& name) const;
  /// $AA_MW[X], $AA_MM[X], $AC_MEA[1]: what MEAS= has measured.
  std::optional<double> measured(const ig::Block& b, const Name& name) const;

  // ---- system_frames.cpp: the rows of the table of work offsets

  std::optional<std::string> frame_of(const ig::Block& b, const Name& name) const;
  std::optional<double> part_of_frame(const ig::Block& b, const Name& name, const std::string& frame) const;
  Written write_frame(const ig::Block& b, const Name& name, const std::string& frame, double value) const;
  Written write_shape(const ig::Block& b, const std::string& frame, ShapePart part, std::size_t axis,
                      double value) const;
  /// $P_PFRAME, as the block has assigned it, or as it is in force.
  std::optional<FrameValue> programmed(const ig::Block& b) const;
  std::optional<double> part_of_programmed(const ig::Block& b, const Name& name) const;

  // ---- Tools

  /// The table column that $TC_DP3[t,d], $P_AD[3], $P_TOOLL[1] or $P_TOOLR names.
  static std::optional<std::uint32_t> column_of(const Name& name);
  std::optional<std::int64_t> offset_row(const ig::Block& b, const Name& name) const;
  std::optional<double> offset(const ig::Block& b, std::int64_t row, std::optional<std::uint32_t> column) const;
  std::optional<double> plain(const ig::Block& b, std::string_view name) const;

  // ---- Codes in force

  double offset_number(const ig::Block& b) const;
  /// $P_GG[n]: the number of the code in its group, from the list of G groups.
  std::optional<double> group(const ig::Block& b, std::int64_t group) const;

  RotaryOffsetSection turned_{"CoordinateOffset", ig::read}, programmable_{"ProgrammableFrame", ig::read};
  std::array<ig::In<double>, 6> machine_{ig::In<double>{"MachineCoordinate.X"}, ig::In<double>{"MachineCoordinate.Y"},
                                         ig::In<double>{"MachineCoordinate.Z"}, ig::In<double>{"MachineCoordinate.A"},
                                         ig::In<double>{"MachineCoordinate.B"}, ig::In<double>{"MachineCoordinate.C"}};
  std::array<ig::In<double>, 3> program_{ig::In<double>{"ProgramXyz.X"}, ig::In<double>{"ProgramXyz.Y"},
                                         ig::In<double>{"ProgramXyz.Z"}};
  FurtherAxisPositions further_axes_{ig::read};
  AxisNames axes_;
  ig::In<std::int64_t> tool_{"ToolChange.SpindleToolId"};
  ig::In<std::int64_t> next_tool_{"ToolChange.ToolId"};
  ig::In<std::int64_t> row_{"ToolHeightCompensation.OffsetId"};
  ig::Field<std::int64_t> edge_{
      "ToolHeightCompensation.Edge", ig::read, {ig::Life::modal, "", "D: the cutting edge in force; 0: none."}};
  ig::In<double> length_{"ToolHeightCompensation.Offset_mm"};
  ig::In<double> feed_{"Feedrate.FeedrateValue"};
  ig::Name g93_{"G93"};
  ig::In<double> speed_{"SpindleSpeed.SpindleSpeed_rpm"};
  ig::In<ig::Symbol> direction_{"SpindleSpeed.Direction"};
  ig::In<ig::Symbol> offset_id_{"CoordinateOffset.CoordinateId"};
  ig::In<ig::Symbol> motion_{"MotionState.Term"};
  ig::In<ig::Symbol> plane_{"PlaneSelect.Term"};
  ig::In<ig::Symbol> compensation_{"RadiusCompensation.Term"};
  ig::In<ig::Symbol> unit_term_{"Unit.Term"};
  ig::In<ig::Symbol> positioning_{"PositioningMode.Term"};
  ig::In<ig::Symbol> feed_mode_{"Feedrate.Term"};
  ig::Transform frame_{"ProgrammableFrame", ig::read};
  AssignedFrame assigned_{ig::read};
  MeasuredPoint measured_{ig::read};
  ig::Name g700_{"G700"}, cw_{"CW"}, ccw_{"CCW"};
  ig::Service<ig_work_offset_1> offsets_{"isogloss.work-offset/1", ig::Need::optional, "Read and written as frames."};
  ShapeTable shapes_;
  ig::Service<ig_tool_offset_1> tools_{"isogloss.tool-offset/1", ig::Need::optional, "Read and written as $TC_DP."};
};

}  // namespace siemens
