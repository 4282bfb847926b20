/// Services from a table of parameters: isogloss.config/1 from functions of the table, and the axes of a table that
/// keeps them under Fanuc's numbers: 1240 to 1243 are the reference positions, 1320 and 1321 the stored stroke limits
/// (mm or degrees). The table itself answers for the rapid rate and the rollover.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "isogloss/provenance.hpp"
#include "isogloss/sdk.hpp"

namespace ig::cnc {

/// The columns of a table of machine parameters.
struct ParameterColumns {
  Column value{"Value", nullptr, "", {}, "The parameter, where it has one value for the whole control."};
  std::array<Column, 6> axes{Column{"X", nullptr, "", {}, "The parameter of the X axis."},
                             Column{"Y", nullptr, "", {}, "The parameter of the Y axis."},
                             Column{"Z", nullptr, "", {}, "The parameter of the Z axis."},
                             Column{"A", nullptr, "", {}, "The parameter of the A axis."},
                             Column{"B", nullptr, "", {}, "The parameter of the B axis."},
                             Column{"C", nullptr, "", {}, "The parameter of the C axis."}};
};

/// How the number of a parameter counts.
enum class ParameterUnit : std::uint8_t {
  none,        ///< a choice, bits, or the number of something
  increments,  ///< least input increments, of mm
  increments_of_angle,
  mm,
  axis,  ///< mm, or degrees of a rotary axis
  rate,  ///< mm/min, or degrees/min of a rotary axis
  degrees,
  percent,
  rpm
};

/// Which columns of a parameter count: one value for the whole control, or one for each axis.
enum class ParameterScope : std::uint8_t { control, axes };

/// What a parameter is called in an explanation. What has the same effect on two controls has the same title.
struct NamedParameter {
  std::string_view number, title;
  ParameterUnit unit = ParameterUnit::none;
  ParameterScope scope = ParameterScope::control;
};

/// The parameters of axes under Fanuc's numbers.
inline constexpr std::array<NamedParameter, 7> axis_parameters{
    {{"1240", "first reference position", ParameterUnit::axis, ParameterScope::axes},
     {"1241", "second reference position", ParameterUnit::axis, ParameterScope::axes},
     {"1242", "third reference position", ParameterUnit::axis, ParameterScope::axes},
     {"1243", "fourth reference position", ParameterUnit::axis, ParameterScope::axes},
     {"1320", "upper travel limit", ParameterUnit::axis, ParameterScope::axes},
     {"1321", "lower travel limit", ParameterUnit::axis, ParameterScope::axes},
     {"1420", "rapid rate", ParameterUnit::rate, ParameterScope::axes}}};

/// These and the axis_parameters.
template <std::size_t N>
constexpr std::array<NamedParameter, N + axis_parameters.size()> with_axis_parameters(const NamedParameter (&own)[N]) {
  std::array<NamedParameter, N + axis_parameters.size()> out;
  std::copy(axis_parameters.begin(), axis_parameters.end(), std::copy(own, own + N, out.begin()));
  return out;
}

/// `increment` in mm; nothing where the number is not among the parameters, or has no use for the column.
inline std::optional<RowMeaning> meaning_of_parameter(std::span<const NamedParameter> parameters,
                                                      std::string_view number, std::string_view column,
                                                      double increment, std::string_view prefix = {}) {
  const bool is_rotary = column == "A" || column == "B" || column == "C";
  for (const NamedParameter& p : parameters) {
    if (p.number != number) continue;
    if ((p.scope == ParameterScope::control) != (column == "Value")) return std::nullopt;
    RowMeaning out{p.title, "", 1, prefix};
    switch (p.unit) {
      case ParameterUnit::none: break;
      case ParameterUnit::increments:
      case ParameterUnit::increments_of_angle:
        out.unit = p.unit == ParameterUnit::increments && !is_rotary ? "mm" : "deg";
        out.scale = increment;
        break;
      case ParameterUnit::mm: out.unit = "mm"; break;
      case ParameterUnit::axis: out.unit = is_rotary ? "deg" : "mm"; break;
      case ParameterUnit::rate: out.unit = is_rotary ? "deg/min" : "mm/min"; break;
      case ParameterUnit::degrees: out.unit = "deg"; break;
      case ParameterUnit::percent: out.unit = "%"; break;
      case ParameterUnit::rpm: out.unit = "rpm"; break;
    }
    return out;
  }
  return std::nullopt;
}

/// `Table` is the dependency that holds the parameters; the services keep a pointer to it and live as long as it does.
template <class Table>
struct ParameterServices {
  using Answer = std::optional<double>;
  using Mode = std::optional<std::uint32_t>;

  /// The service isogloss.config/1; `question` answers a name with its number, or with nothing.
  template <Answer (Table::*question)(std::string_view) const>
  static ig_config_1 config(Table* table) {
    return {sizeof(ig_config_1), 0, table, &ask<question>};
  }

  /// The service isogloss.machine-axis/1. `of_axis` answers a parameter number for an axis, `rapid` gives mm/min or
  /// degrees/min, `rollover` a mode of ig_machine_axis_1::rollover; each gives nothing where the value is not known.
  template <Answer (Table::*of_axis)(std::string_view, char) const, Answer (Table::*rapid)(char) const,
            Mode (Table::*rollover)(char) const>
  static ig_machine_axis_1 machine_axes(Table* table) {
    return {sizeof(ig_machine_axis_1),
            0,
            table,
            &home<of_axis>,
            &reference<of_axis>,
            &travel<of_axis>,
            &rapid_rate<rapid>,
            &mode<rollover>};
  }

 private:
  static const Table& self_of(void* self) { return *static_cast<const Table*>(self); }
  static std::int32_t write(Answer answer, double* out) {
    if (answer) *out = *answer;
    return answer ? 1 : 0;
  }

  template <Answer (Table::*question)(std::string_view) const>
  static std::int32_t ask(void* self, ig_text name, double* out) {
    return write((self_of(self).*question)(to_view(name)), out);
  }
  /// Home is the first reference position.
  template <Answer (Table::*of_axis)(std::string_view, char) const>
  static std::int32_t home(void* self, char axis, double* position) {
    return reference<of_axis>(self, axis, 1, position);
  }
  template <Answer (Table::*of_axis)(std::string_view, char) const>
  static std::int32_t reference(void* self, char axis, std::uint32_t which, double* position) {
    static constexpr std::string_view numbers[] = {"1240", "1241", "1242", "1243"};
    return which >= 1 && which <= 4 ? write((self_of(self).*of_axis)(numbers[which - 1], axis), position) : 0;
  }
  template <Answer (Table::*of_axis)(std::string_view, char) const>
  static std::int32_t travel(void* self, char axis, double* low, double* high) {
    const Answer from = (self_of(self).*of_axis)("1321", axis), to = (self_of(self).*of_axis)("1320", axis);
    return from && to && *from <= *to ? write(from, low) & write(to, high) : 0;  // limits in the wrong order: no limits
  }
  template <Answer (Table::*rapid)(char) const>
  static std::int32_t rapid_rate(void* self, char axis, double* per_second) {
    const Answer per_minute = (self_of(self).*rapid)(axis);
    return per_minute ? write(*per_minute / 60, per_second) : 0;
  }
  template <Mode (Table::*rollover)(char) const>
  static std::int32_t mode(void* self, char axis, std::uint32_t* out) {
    const Mode answer = (self_of(self).*rollover)(axis);
    if (answer) *out = *answer;
    return answer ? 1 : 0;
  }
};

/// The services that every table of machine parameters provides. The members of `Table`, which declares
/// this class its friend: number_format_of, cycle_of, motion_of and program_of_code answer names; of_axis, rapid_of and
/// rollover_of answer for the axes.
template <class Table>
class MachineParameterServices {
 public:
  explicit MachineParameterServices(Table* table)
      : number_format_(Services::template config<&Table::number_format_of>(table)),
        cycles_(Services::template config<&Table::cycle_of>(table)),
        motion_(Services::template config<&Table::motion_of>(table)),
        code_calls_(Services::template config<&Table::program_of_code>(table)),
        axes_(Services::template machine_axes<&Table::of_axis, &Table::rapid_of, &Table::rollover_of>(table)) {}

  /// The service with this id; null for any other.
  const void* find(std::string_view id) const {
    if (id == "isogloss.number-format/1") return &number_format_;
    if (id == "isogloss.canned-cycle/1") return &cycles_;
    if (id == "isogloss.motion/1") return &motion_;
    if (id == "isogloss.code-call/1") return &code_calls_;
    return id == "isogloss.machine-axis/1" ? &axes_ : nullptr;
  }

 private:
  using Services = ParameterServices<Table>;
  ig_config_1 number_format_, cycles_, motion_, code_calls_;
  ig_machine_axis_1 axes_;
};

}  // namespace ig::cnc
