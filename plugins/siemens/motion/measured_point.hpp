/// What MEAS= has measured, as $AC_MEA, $AA_MW and $AA_MM read it.
#pragma once

#include <array>
#include <optional>

#include <isogloss/sdk.hpp>

namespace siemens {

/// A member of the syntax that measures, and of those that read what was measured.
class MeasuredPoint {
 public:
  explicit MeasuredPoint(ig::Access access)
      : probe_{"MeasuredPoint.Probe",
               access,
               {ig::Life::modal, "", "The probe that MEAS= has named last; 0: it has not touched."}},
        program_{coordinate("MeasuredPoint.ProgramX", access, "mm"), coordinate("MeasuredPoint.ProgramY", access, "mm"),
                 coordinate("MeasuredPoint.ProgramZ", access, "mm")},
        machine_{coordinate("MeasuredPoint.X", access, "mm"),  coordinate("MeasuredPoint.Y", access, "mm"),
                 coordinate("MeasuredPoint.Z", access, "mm"),  coordinate("MeasuredPoint.A", access, "deg"),
                 coordinate("MeasuredPoint.B", access, "deg"), coordinate("MeasuredPoint.C", access, "deg")} {}

  using Coordinate = ig::Field<double>;

  /// X Y Z of the program, in the workpiece.
  const Coordinate& program(std::size_t axis) const { return program_[axis]; }
  /// X Y Z A B C of the machine.
  const Coordinate& machine(std::size_t axis) const { return machine_[axis]; }
  const ig::Field<std::int64_t>& probe() const { return probe_; }

 private:
  static Coordinate coordinate(const char* path, ig::Access access, const char* unit) {
    return {path, access, {ig::Life::modal, unit, "Where the probe has touched."}};
  }

  ig::Field<std::int64_t> probe_;
  std::array<Coordinate, 3> program_;
  std::array<Coordinate, 6> machine_;
};

}  // namespace siemens
