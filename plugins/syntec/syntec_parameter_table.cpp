// The parameters of a Syntec control that change the meaning of a program, by their numbers. Values are as on the
// parameter page of the control; this file knows their units.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <isogloss/cnc/parameter_services.hpp>
#include <isogloss/rows.hpp>

#include "macro/macro_environment.hpp"

namespace syntec {

using namespace ig::cnc;

namespace {

constexpr std::string_view control_precision = "17", axis_type = "1006", axis_name = "1020", rapid_rate = "1420",
                           t_macro = "3215", decimal_point = "3241", spindle_limit = "3741", peck_retract = "4002",
                           compensation_type = "5003";
constexpr std::string_view axis_letters = "XYZABC";

constexpr const char* shipped[] = {"17|Value=2",   "1240|X=0|Y=0|Z=0", "1420|X=24000|Y=24000|Z=24000",
                                   "3241|Value=0", "3741|Value=0",     "4002|Value=1000",
                                   "5003|Value=0"};

using Unit = ParameterUnit;
using Scope = ParameterScope;
constexpr auto named_parameters = with_axis_parameters({{control_precision, "increment system"},
                                                        {axis_type, "axis type", Unit::none, Scope::axes},
                                                        {axis_name, "axis name", Unit::none, Scope::axes},
                                                        {t_macro, "call of the T macro"},
                                                        {decimal_point, "numbers without a decimal point"},
                                                        {spindle_limit, "highest spindle speed", Unit::rpm},
                                                        {peck_retract, "peck clearance", Unit::increments},
                                                        {compensation_type, "start-up of radius compensation"}});

struct SyntecParameterTable {
  static constexpr auto spec =
      ig::dependency("SyntecParameterTable", "Parameters of a Syntec control, by number.")
          .rows("Parameter", "number")
          .provides("isogloss.number-format/1", "isogloss.canned-cycle/1", "isogloss.motion/1",
                    "isogloss.machine-axis/1", "isogloss.code-call/1", parameter_service, IG_ROW_MEANING_SERVICE)
          .ships(shipped);

  enum class PeckUnit { blu, micron };
  ig::Choice<PeckUnit> peck_unit{
      "pr4002-unit", "blu|micron", "blu",
      "The unit of Pr4002: the basic length unit, which is a micron where Pr17 is 2, or always "
      "the micron."};
  ParameterColumns columns;
  ig::Table table;
  ig::RowNames rows;

  SyntecParameterTable() {
    for (const std::string& row : rows) check(row);
  }

  const void* service(std::string_view id) const {
    if (id == parameter_service) return &parameters_;
    const void* const meanings = meanings_.find(id);
    return meanings != nullptr ? meanings : services.find(id);
  }

 private:
  using Answer = std::optional<double>;

  /// Rejects a value that the parameter cannot have; it would be ignored silently otherwise.
  void check(const std::string& row) const {
    const auto refuse = [&row](const std::string& why) { throw std::runtime_error("parameter '" + row + "': " + why); };
    if (row.empty() || row.find_first_not_of("0123456789") != std::string::npos)
      refuse("its name is the number of a parameter");
    const bool of_axes = row == axis_type || row == axis_name || row == rapid_rate || row == "1320" || row == "1321" ||
                         (row.size() == 4 && row.starts_with("124") && row[3] <= '3');
    const Answer one = number(row);
    if (of_axes && one) refuse("each axis has its own value: X, Y, Z, A, B, C, not Value");
    for (std::size_t i = 0; i < columns.axes.size(); ++i)
      if (const Answer of_one = table.value(row, columns.axes[i])) {
        if (is_known(row))
          refuse("it has one value for the whole control: Value, not " + std::string(1, axis_letters[i]));
        if (row == rapid_rate && *of_one < 0) refuse("a rapid rate is 0 or more");
      }
    if (row == control_precision && one && *one != 1 && *one != 2 && *one != 3) refuse("it is 1, 2 or 3");
    if ((row == peck_retract || row == spindle_limit) && one && *one < 0) refuse("it is 0 or more");
  }
  /// The parameters that this table uses and that exist once for the whole control.
  static bool is_known(std::string_view row) {
    constexpr std::array ones{control_precision, t_macro,      decimal_point,
                              spindle_limit,     peck_retract, compensation_type};
    return registers_code(row) || std::find(ones.begin(), ones.end(), row) != ones.end();
  }
  /// Pr3601 to Pr3610 and Pr3701 to Pr3710.
  static bool registers_code(std::string_view row) {
    const bool is_early = row.size() == 4 && (row.starts_with("360") || row.starts_with("370")) && row[3] != '0';
    return is_early || row == "3610" || row == "3710";
  }

  Answer number(std::string_view parameter) const { return table.value(parameter, columns.value); }

  /// The axis of a column: X, Y, Z, A, B, C, unless Pr1020 gives it another name.
  char name_of(std::size_t column) const {
    const double code = table.value(axis_name, columns.axes[column]).value_or(0);
    for (std::size_t i = 0; i < axis_letters.size(); ++i)
      if (code == axis_letters[i] || code == 100.0 * static_cast<double>(i + 1)) return axis_letters[i];
    return axis_letters[column];
  }
  /// Where two columns name the same axis, the first one is used.
  Answer of_axis(std::string_view parameter, char axis) const {
    for (std::size_t column = 0; column < columns.axes.size(); ++column)
      if (name_of(column) == axis) return table.value(parameter, columns.axes[column]);
    return std::nullopt;
  }

  /// The least input increment in mm. Pr17: 1 is 0.01 mm, 2 is 0.001 mm, 3 is 0.0001 mm; the same for degrees, a tenth
  /// of it in inches.
  double increment() const {
    const double precision = number(control_precision).value_or(2);
    return precision == 1 ? 0.01 : precision == 3 ? 0.0001 : 0.001;
  }

  Answer number_format_of(std::string_view name) const {
    if (name == "CalculatorDecimalPoint") return number(decimal_point).value_or(0) != 0 ? 1 : 0;
    if (name == "LengthIncrement_mm" || name == "AngleIncrement_deg") return increment();
    return name == "LengthIncrement_inch" ? Answer(increment() / 10) : std::nullopt;
  }
  /// One distance for G73, G83 and peck tapping.
  Answer cycle_of(std::string_view name) const {
    if (name != "PeckRetractionDistance_mm" && name != "HighSpeedPeckRetraction_mm" &&
        name != "PeckTappingRetraction_mm")
      return std::nullopt;
    const Answer count = number(peck_retract);
    if (!count || *count < 0) return std::nullopt;
    return *count / std::round(1 / peck_increment());
  }
  double peck_increment() const { return peck_unit == PeckUnit::micron ? 0.001 : increment(); }

  std::optional<ig::RowMeaning> meaning_of(std::string_view row, std::string_view column) const {
    if (registers_code(row))
      return column == "Value" ? std::optional(ig::RowMeaning{"code that calls a macro", "", 1, "Pr"}) : std::nullopt;
    return meaning_of_parameter(named_parameters, row, column, peck_increment(), "Pr");
  }
  Answer motion_of(std::string_view name) const {
    if (name == "ArcRadiusTolerance_mm") return 0.01;
    if (name == "RadiusCompensationStartUp")
      return std::fmod(std::floor(number(compensation_type).value_or(0)), 2) == 1 ? 1 : 0;  // bit 0
    const Answer limit = name == "MaximumSpindleSpeed_rpm" ? number(spindle_limit) : std::nullopt;
    return limit && *limit > 0 ? limit : std::nullopt;
  }

  /// The number of the macro that a code calls: G200 to G999 directly; G codes by Pr3701 to Pr3710, M codes by Pr3601
  /// to Pr3610; T where Pr3215 is not 0. G codes of two or more decimals (G68.18) are not for milling; the answer 0
  /// passes them to the syntax that reports them.
  Answer program_of_code(std::string_view code) const {
    if (code == "T") return number(t_macro).value_or(0) != 0 ? Answer(0) : std::nullopt;
    if (code.size() < 2) return std::nullopt;
    const ig::Decimal called = ig::read_decimal(code, 1);
    if (!called.ok || called.end != code.size()) return std::nullopt;
    if (code[0] == 'G' && called.value >= 200 && called.value < 1000) return std::floor(called.value);
    if (code[0] == 'G' && called.decimals > 1) return 0;
    for (int i = 0; i < 10; ++i) {
      if (code[0] == 'M' && called.value > 0 && number(std::to_string(3601 + i)) == called.value) return called.value;
      if (code[0] == 'G' && registered_code(number(std::to_string(3701 + i)).value_or(0)) == called.value)
        return std::floor(called.value);
    }
    return std::nullopt;
  }

  /// Pr3701 to Pr3710 hold the ordinal numbers of the codes that a macro may replace.
  static Answer registered_code(double choice) {
    constexpr std::array codes{0.0, 1.0, 2.0, 3.0, 53.0, 40.0, 41.0, 42.0, 43.0, 44.0, 49.0, 4.0, 2.4, 3.4};
    if (choice == -1) return codes[0];
    for (std::size_t i = 1; i < codes.size(); ++i)
      if (choice == static_cast<double>(i)) return codes[i];
    return std::nullopt;
  }

  /// mm or degrees per minute.
  Answer rapid_of(char axis) const {
    const Answer rate = of_axis(rapid_rate, axis);
    return rate && *rate >= 0 ? rate : std::nullopt;
  }
  /// Pr1006: 1 is type A, the shortest way; 2 type B, in the direction of the sign; with any other value the axis
  /// counts on beyond 360.
  std::optional<std::uint32_t> rollover_of(char axis) const {
    const Answer type =
        std::string_view("ABC").find(axis) == std::string_view::npos ? std::nullopt : of_axis(axis_type, axis);
    if (!type) return std::nullopt;
    return *type == 1 ? 1 : *type == 2 ? 2 : 0;
  }

  /// For macros: any parameter by its number.
  static std::int32_t parameter_of(void* self, ig_text name, double* out) {
    const Answer answer = static_cast<const SyntecParameterTable*>(self)->number(ig::to_view(name));
    if (!answer) return 0;
    *out = *answer;
    return 1;
  }
  ig_config_1 parameters_{sizeof(ig_config_1), 0, this, &parameter_of};

  friend class ig::RowMeanings<SyntecParameterTable>;
  ig::RowMeanings<SyntecParameterTable> meanings_{this};
  friend class ig::cnc::MachineParameterServices<SyntecParameterTable>;
  MachineParameterServices<SyntecParameterTable> services{this};
};

const ig::Register<SyntecParameterTable> syntec_parameter_table;

}  // namespace
}  // namespace syntec
