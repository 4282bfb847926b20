/// Data of the control that FN 18 reads and FN 17 writes: the tool, its table, datum and positions. mm and degrees.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include <isogloss_tool.h>

#include <isogloss/cnc/plane.hpp>
#include <isogloss/cnc/program_xyz.hpp>
#include <isogloss/cnc/scale_and_mirror.hpp>
#include <isogloss/cnc/whole_number.hpp>

#include "frames/rotary_datum.hpp"
#include "language/program_unit.hpp"
#include "tool/step_row.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// A member of the syntax that reads them.
class SystemData {
 public:
  struct Request {
    double id = 0, number = 0;
    std::optional<double> index{};
  };

  /// The datum in the program's unit; nothing where it is not known here.
  std::optional<double> read(ig::Block& b, const Request& r) const {
    const bool is_of_axis = r.index && *r.index >= 1 && *r.index <= 6 && *r.index == std::floor(*r.index);
    const std::size_t axis = is_of_axis ? static_cast<std::size_t>(*r.index) - 1 : 0;
    const auto is = [&](double id, double number) { return r.id == id && r.number == number; };
    if (is(20, 1) || is(60, 1)) return static_cast<double>(b.get_or(tool_, std::int64_t{0}) % IG_TOOL_INDEX_STEP);
    if (is(20, 3) || is(60, 2)) return static_cast<double>(plane_(b).tool);
    if (is(20, 4) || is(60, 3)) return b.get_or(speed_, 0.0);
    if (is(60, 4)) return in_unit(b, b.get_or(length_delta_, 0.0));
    if (is(60, 5)) return in_unit(b, b.get_or(radius_delta_, 0.0));
    if (r.id == 50) return of_table(b, r);
    if (!is_of_axis) return std::nullopt;
    if (is(220, 2)) return axis < 3 ? in_unit(b, shift(b, axis)) : turned_.shift(b)[axis - 3];
    if (is(230, 2) || is(230, 3)) return end_of_travel(b, axis, r.number == 3);
    if (axis > 2 && is(240, 1)) return b.get(angles_[axis - 3]);
    if (axis > 2 && is(270, 1)) {
      const auto angle = b.get(angles_[axis - 3]);
      return angle ? std::optional(*angle - turned_.get(b)[axis - 3]) : std::nullopt;
    }
    if (is(240, 1)) {
      const auto position = b.get(machine_[axis]);
      return position ? std::optional(in_unit(b, *position)) : std::nullopt;
    }
    if (!is(270, 1)) return std::nullopt;
    ig::Vec3 here = last_(b);
    if (b.has(mirror_term_)) here = rounded(mirror_.programmed(b, here));
    return in_unit(b, here[axis]);
  }

  /// Writes a length of the table of tools, in the program's unit; false where it is not known here. It counts from the
  /// next tool call on.
  bool write(const ig::Block& b, const Request& r, double value) const {
    const auto of_tool = cell(b, r);
    const double mm = value * unit_.in_mm(b);
    return of_tool && std::isfinite(mm) && table_->set(table_->self, of_tool->row, of_tool->column, mm) != 0;
  }

 private:
  double in_unit(const ig::Block& b, double mm) const { return mm / unit_.in_mm(b); }

  /// A software limit, which the machine has where its axes have a travel.
  std::optional<double> end_of_travel(const ig::Block& b, std::size_t axis, bool is_upper) const {
    double low = 0, high = 0;
    if (!axes_ || axes_->travel(axes_->self, "XYZABC"[axis], &low, &high) == 0) return std::nullopt;
    const double end = is_upper ? high : low;
    if (!std::isfinite(end)) return std::nullopt;
    return axis < 3 ? in_unit(b, end) : end;
  }

  struct Cell {
    std::int64_t row;
    std::uint32_t column;
  };
  /// The column of the table of tools that NR names, NR1 L, NR2 R, NR3 R2, NR4 DL, NR5 DR, NR6 DR2, of tool IDX or of
  /// the present one.
  std::optional<Cell> cell(const ig::Block& b, const Request& r) const {
    static constexpr std::array<std::uint32_t, 6> columns{IG_TOOL_LENGTH,        IG_TOOL_RADIUS,
                                                          IG_TOOL_CORNER_RADIUS, IG_TOOL_LENGTH_WEAR,
                                                          IG_TOOL_RADIUS_WEAR,   IG_TOOL_CORNER_RADIUS_WEAR};
    const bool is_column =
        r.id == 50 && r.number >= 1 && r.number <= columns.size() && r.number == std::floor(r.number);
    if (!is_column || !table_) return std::nullopt;
    const double tool = r.index.value_or(static_cast<double>(b.get_or(tool_, std::int64_t{0})));
    const auto row = tool == std::floor(tool) ? whole_number(tool) : step_row(tool);
    return row ? std::optional(Cell{*row, columns[static_cast<std::size_t>(r.number) - 1]}) : std::nullopt;
  }
  /// What else the table of tools has: NR9 TIME1, NR10 TIME2, NR11 CUR.TIME, NR13 LCUTS, NR14 ANGLE, NR15 CUT, NR28
  /// NMAX, NR32 T-ANGLE, NR36 TYP (TNC 620). HEIDENHAIN manuals, "FN 18: SYSREAD".
  static std::optional<std::uint32_t> other_column(double number) {
    struct Datum {
      double number;
      std::uint32_t column;
    };
    static constexpr std::array<Datum, 9> data{{{9, IG_TOOL_LIFE},
                                                {10, IG_TOOL_LIFE_AT_CALL},
                                                {11, IG_TOOL_USED_LIFE},
                                                {13, IG_TOOL_CUTTING_LENGTH},
                                                {14, IG_TOOL_PLUNGE_ANGLE},
                                                {15, IG_TOOL_TEETH},
                                                {28, IG_TOOL_MAXIMUM_SPEED},
                                                {32, IG_TOOL_TIP_ANGLE},
                                                {36, IG_TOOL_TYPE}}};
    for (const Datum& datum : data)
      if (datum.number == number) return datum.column;
    return std::nullopt;
  }
  std::optional<double> of_table(const ig::Block& b, const Request& r) const {
    const auto other = other_column(r.number);
    const auto of_tool = cell(b, {r.id, other ? 1 : r.number, r.index});
    const std::uint32_t column = other ? *other : of_tool ? of_tool->column : 0;
    double value = 0;
    if (!of_tool || table_->get(table_->self, of_tool->row, column, &value) == 0) return std::nullopt;
    return !other || column == IG_TOOL_CUTTING_LENGTH ? in_unit(b, value) : value;
  }

  ig::Previous<std::int64_t> tool_{"ToolHeightCompensation.OffsetId"};
  ig::Previous<double> speed_{"SpindleSpeed.SpindleSpeed_rpm"};
  ig::In<double> length_delta_{"ToolHeightCompensation.Delta_mm", ig::read, {ig::Life::modal, "mm", ""}};
  ig::In<double> radius_delta_{"RadiusCompensation.Delta_mm", ig::read, {ig::Life::modal, "mm", ""}};
  /// The shift as programmed: in the plane, along turned axes, or along those of the preset.
  double shift(const ig::Block& b, std::size_t axis) const {
    for (const ig::Xyz* of : {&plane_shift_, &turned_shift_})
      if (const ig::PartialVec3 v = b.get(*of); v.has(axis)) return v.value[axis];
    return b.get_or(shift_[axis], 0.0);
  }

  ig::Xyz plane_shift_{"PlaneFrame", ig::previous, {ig::Life::modal, "mm", ""}};
  ig::Xyz turned_shift_{"DatumShift", ig::previous, {ig::Life::modal, "mm", ""}};
  std::array<ig::Previous<double>, 3> shift_{ig::Previous<double>{"LocalCoordinateOffset.Offset_X"},
                                             ig::Previous<double>{"LocalCoordinateOffset.Offset_Y"},
                                             ig::Previous<double>{"LocalCoordinateOffset.Offset_Z"}};
  std::array<ig::Previous<double>, 3> machine_{ig::Previous<double>{"MachineCoordinate.X"},
                                               ig::Previous<double>{"MachineCoordinate.Y"},
                                               ig::Previous<double>{"MachineCoordinate.Z"}};
  RotaryDatum turned_{ig::previous};
  std::array<ig::Previous<double>, 3> angles_{ig::Previous<double>{"MachineCoordinate.A"},
                                              ig::Previous<double>{"MachineCoordinate.B"},
                                              ig::Previous<double>{"MachineCoordinate.C"}};
  PlaneInForce plane_;
  ProgramUnit unit_;
  ig::In<ig::Symbol> mirror_term_{"MirrorImage.Term"};
  LastProgramXyz last_;
  ScaleAndMirror mirror_;
  ig::Service<ig_machine_axis_1> axes_{"isogloss.machine-axis/1", ig::Need::optional, "The ends of the travel."};
  ig::Service<ig_tool_offset_1> table_{"isogloss.tool-offset/1", ig::Need::optional, "Length and radius of tools."};
};

}  // namespace heidenhain
