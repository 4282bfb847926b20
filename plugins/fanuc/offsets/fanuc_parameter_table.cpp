// The parameters of a Fanuc control that change the meaning of a program, by their numbers. Values are as on the
// parameter page of the control; this file knows their units and bits.
#include <cmath>

#include <isogloss/cnc/parameter_services.hpp>

namespace fanuc {

using namespace ig::cnc;

namespace {

constexpr std::string_view rotary_type = "1006", rollover_bits = "1008", increment_system = "1013", reset = "1202",
                           feed_bits = "1403", revolution_feed_bits = "1405", rapid_rate = "1420",
                           decimal_point = "3401", arc_tolerance = "3410", cycle_bits = "5101",
                           high_speed_peck = "5114", peck = "5115", shift_axis = "5148",
                           boring_return_override = "5149", tapping_bits = "5200", extraction_override = "5211",
                           peck_tapping = "5213", coordinate_bits = "5400", rotation_angle = "5410",
                           scaling_factor = "5411", overrun = "5440", call_bits = "6001";

constexpr const char* shipped_parameters[] = {
    "1013|Value=0",    "1202|Value=0",  "1240|X=0|Y=0|Z=0", "1420|X=24000|Y=24000|Z=24000",
    "3401|Value=0",    "3410|Value=10", "5101|Value=0",     "5114|Value=1000",
    "5115|Value=1000", "5200|Value=0",  "5213|Value=1000",  "5400|Value=128",
    "5410|Value=0"};

using Unit = ParameterUnit;
using Scope = ParameterScope;
constexpr auto named_parameters =
    with_axis_parameters({{rotary_type, "axis type", Unit::none, Scope::axes},
                          {rollover_bits, "rollover of a rotary axis", Unit::none, Scope::axes},
                          {increment_system, "increment system"},
                          {reset, "reset bits"},
                          {feed_bits, "feed bits"},
                          {revolution_feed_bits, "F per revolution without a decimal point"},
                          {decimal_point, "numbers without a decimal point"},
                          {arc_tolerance, "arc radius tolerance", Unit::increments},
                          {cycle_bits, "canned cycle bits"},
                          {high_speed_peck, "high-speed peck retraction", Unit::increments},
                          {peck, "peck clearance", Unit::increments},
                          {shift_axis, "shift direction of boring", Unit::none, Scope::axes},
                          {boring_return_override, "return override of boring", Unit::percent},
                          {tapping_bits, "tapping bits"},
                          {extraction_override, "extraction override of tapping", Unit::percent},
                          {peck_tapping, "peck tapping retraction", Unit::increments},
                          {coordinate_bits, "rotation and scaling bits"},
                          {rotation_angle, "rotation angle", Unit::increments_of_angle},
                          {scaling_factor, "scaling factor"},
                          {overrun, "overrun of G60", Unit::increments, Scope::axes},
                          {call_bits, "call bits"}});

/// Parameters whose values are codes that call a program each.
struct Calls {
  char letter;
  int first_parameter, count, first_program;
};
constexpr std::array calls{Calls{'G', 6050, 10, 9010}, Calls{'M', 6071, 9, 9001}, Calls{'M', 6080, 10, 9020}};

bool is_call(std::string_view parameter) {
  return std::any_of(calls.begin(), calls.end(), [&](const Calls& c) {
    for (int i = 0; i < c.count; ++i)
      if (parameter == std::to_string(c.first_parameter + i)) return true;
    return false;
  });
}

struct FanucParameterTable {
  static constexpr auto spec =
      ig::dependency("FanucParameterTable", "Parameters of a Fanuc control, by number and axis.")
          .rows("Parameter", "number")
          .provides("isogloss.number-format/1", "isogloss.canned-cycle/1", "isogloss.motion/1",
                    "isogloss.machine-axis/1", "isogloss.coordinate-system/1", "isogloss.code-call/1",
                    "isogloss.control-parameter/1", IG_ROW_MEANING_SERVICE)
          .ships(shipped_parameters);

  ParameterColumns columns;
  ig::Table table;

  static std::string row_fault(std::string_view row) {
    const bool is_number =
        !row.empty() && row[0] != '0' && row.find_first_not_of("0123456789") == std::string_view::npos;
    return is_number ? "" : "its rows are the numbers of parameters";
  }

  const void* service(std::string_view id) const {
    if (id == "isogloss.coordinate-system/1") return &coordinate_system;
    if (id == "isogloss.control-parameter/1") return &parameters;
    if (const void* const meanings = meanings_.find(id)) return meanings;
    return services.find(id);
  }

 private:
  using Answer = std::optional<double>;

  Answer number(std::string_view parameter) const { return table.value(parameter, columns.value); }
  bool bit(std::string_view parameter, unsigned index) const {
    return (static_cast<std::uint32_t>(number(parameter).value_or(0)) >> index & 1u) != 0;
  }
  Answer of_axis(std::string_view parameter, char axis) const {
    const std::size_t column = std::string_view("XYZABC").find(axis);
    return column == std::string_view::npos ? std::nullopt : table.value(parameter, columns.axes[column]);
  }

  /// The least input increment in mm. Parameter 1013: bit 0 is IS-A, bit 1 IS-C, neither bit IS-B.
  double increment() const { return bit(increment_system, 0) ? 0.01 : bit(increment_system, 1) ? 0.0001 : 0.001; }
  Answer in_increments(std::string_view parameter) const { return from_increments(number(parameter)); }
  Answer from_increments(Answer count) const {
    return count ? Answer(*count / std::round(1 / increment())) : std::nullopt;
  }
  /// An override of 0, as in a parameter that was never set, means 100 %.
  Answer percent(std::string_view parameter) const {
    const double override = number(parameter).value_or(0);
    return override > 0 ? override : 100;
  }

  /// Parameter 5400 bit 7 SCR: the unit of P under G51.
  double scaling_unit() const { return bit(coordinate_bits, 7) ? 0.001 : 0.00001; }

  Answer number_format_of(std::string_view name) const {
    if (name == "CalculatorDecimalPoint") return bit(decimal_point, 0) ? 1 : 0;
    if (name == "LengthIncrement_mm" || name == "AngleIncrement_deg") return increment();
    if (name == "LengthIncrement_inch") return increment() / 10;
    if (name == "FeedIncrement_mm") return bit(feed_bits, 0) ? 0.001 : 1;
    if (name == "FeedIncrement_inch") return bit(feed_bits, 0) ? 0.00001 : 0.01;
    if (name == "RevolutionFeedIncrement_mm") return bit(revolution_feed_bits, 1) ? 0.001 : 0.01;
    if (name == "RevolutionFeedIncrement_inch") return bit(revolution_feed_bits, 1) ? 0.00001 : 0.0001;
    return std::nullopt;
  }
  Answer cycle_of(std::string_view name) const {
    if (name == "PeckRetractionDistance_mm") return in_increments(peck);
    if (name == "HighSpeedPeckRetraction_mm") return in_increments(high_speed_peck);
    if (name == "BoringReturnOverride_percent") return percent(boring_return_override);
    if (name == "ShiftDirectionX") return shift_direction('X', {2, 3});
    if (name == "ShiftDirectionY") return shift_direction('Y', {3, 1});
    if (name == "ShiftDirectionZ") return shift_direction('Z', {1, 2});
    if (name == "TappingSpindleStop") return bit(cycle_bits, 6) ? 0 : 1;
    if (name == "RigidTapping") return bit(tapping_bits, 0) ? 1 : 0;
    if (name == "PeckTappingToR") return bit(tapping_bits, 5) ? 1 : 0;
    if (name == "PeckTappingRetraction_mm") return in_increments(peck_tapping);
    if (name == "TappingExtractionOverride_percent")
      return bit(tapping_bits, 4) ? number(extraction_override) : std::nullopt;
    return std::nullopt;
  }

  /// Parameter 5148 of the boring axis is the signed number of an axis. Where it is not set, 5101 applies: bit 4 is the
  /// opposite direction, bit 5 the second axis of the plane.
  Answer shift_direction(char boring_axis, std::array<double, 2> plane) const {
    if (const Answer axis = of_axis(shift_axis, boring_axis); axis && *axis != 0) return axis;
    const double axis = plane[bit(cycle_bits, 5) ? 1 : 0];
    return bit(cycle_bits, 4) ? -axis : axis;
  }
  Answer motion_of(std::string_view name) const {
    for (const char axis : {'X', 'Y', 'Z'})
      if (name == std::string("UnidirectionalOverrun") + axis + "_mm") return from_increments(of_axis(overrun, axis));
    if (name == "ScalingUnit") return scaling_unit();
    if (name == "ScalingFactor") {
      const Answer count = number(scaling_factor);
      return count && *count > 0 ? Answer(*count * scaling_unit()) : std::nullopt;
    }
    if (name == "HelixFeedAlongPath") return bit(feed_bits, 5) ? 1 : 0;
    return name == "ArcRadiusTolerance_mm" ? in_increments(arc_tolerance) : std::nullopt;
  }

  Answer coordinate_system_of(std::string_view name) const {
    if (name == "RotationAngle_deg") return in_increments(rotation_angle);
    if (name == "RotationIsIncremental") return bit(coordinate_bits, 0) ? 1 : 0;
    return name == "ResetCancelsLocalCoordinate" ? Answer(bit(reset, 3) ? 1 : 0) : std::nullopt;
  }

  /// Parameters 6050 to 6059 are the G codes that call O9010 to O9019; 6080 to 6089 the M codes that call O9020 to
  /// O9029 with arguments; 6071 to 6079 those that call O9001 to O9009 like M98. 0 is not a code. A G code that is
  /// negative in the table makes a modal call, and the answer is the negative number of its program. 6001 bit 5 TCS: T
  /// calls O9000.
  Answer program_of_code(std::string_view code) const {
    if (code == "T") return bit(call_bits, 5) ? Answer(9000) : std::nullopt;
    if (code.size() < 2) return std::nullopt;
    const ig::Decimal called = ig::read_decimal(code, 1);
    if (!called.ok || called.value == 0) return std::nullopt;
    for (const Calls& r : calls)
      for (int i = 0; i < r.count && code[0] == r.letter; ++i) {
        const Answer bound = number(std::to_string(r.first_parameter + i));
        if (bound == called.value) return r.first_program + i;
        if (bound == -called.value && r.letter == 'G') return -(r.first_program + i);
      }
    return std::nullopt;
  }

  /// "1321" or "1321.X": a parameter with the name that its page shows.
  Answer parameter_of(std::string_view name) const {
    const std::size_t point = name.find('.');
    if (point == std::string_view::npos) return number(name);
    return point + 2 == name.size() ? of_axis(name.substr(0, point), name.back()) : std::nullopt;
  }

  /// 1006 bits 0 and 1, ROT and ROS: 01 is a rotary axis of type A, the only one that can roll over. 1008 bit 0 ROA: it
  /// does roll over; bit 1 RAB: in the direction of the command's sign, not by the shortest way.
  std::optional<std::uint32_t> rollover_of(char axis) const {
    if (std::string_view("ABC").find(axis) == std::string_view::npos) return std::nullopt;
    const Answer type = of_axis(rotary_type, axis), bits = of_axis(rollover_bits, axis);
    if (!type && !bits) return std::nullopt;
    const bool is_type_a = (static_cast<std::uint32_t>(type.value_or(1)) & 3u) == 1;
    const auto how = static_cast<std::uint32_t>(bits.value_or(0));
    const bool rolls = is_type_a && (how & 1u) != 0;
    return !rolls ? 0 : (how & 2u) != 0 ? 2 : 1;
  }
  /// mm or degrees per minute.
  Answer rapid_of(char axis) const { return of_axis(rapid_rate, axis); }

  std::optional<ig::RowMeaning> meaning_of(std::string_view row, std::string_view column) const {
    if (is_call(row))
      return column == "Value" ? std::optional(ig::RowMeaning{"code that calls a program", ""}) : std::nullopt;
    auto out = meaning_of_parameter(named_parameters, row, column, increment());
    if (out && row == scaling_factor) out->scale = scaling_unit();
    return out;
  }

  friend class ig::RowMeanings<FanucParameterTable>;
  ig::RowMeanings<FanucParameterTable> meanings_{this};
  friend class ig::cnc::MachineParameterServices<FanucParameterTable>;
  MachineParameterServices<FanucParameterTable> services{this};
  using Services = ParameterServices<FanucParameterTable>;
  ig_config_1 coordinate_system = Services::config<&FanucParameterTable::coordinate_system_of>(this);
  ig_config_1 parameters = Services::config<&FanucParameterTable::parameter_of>(this);
};

const ig::Register<FanucParameterTable> fanuc_parameter_table;

}  // namespace
}  // namespace fanuc
