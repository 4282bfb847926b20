// The settings of a Haas control that change what a program means, by their numbers.
#include <algorithm>

#include <isogloss/cnc/parameter_services.hpp>

namespace fanuc {

using namespace ig::cnc;

namespace {

constexpr std::string_view scaling = "71", rotation = "72", rotation_adds = "73";
constexpr std::string_view dimensioning = "9", tap_retract_speed = "130";
constexpr std::string_view delta_z = "22", shift_direction = "27", retract_above_r = "52", default_to_float = "162";

constexpr const char* shipped_settings[] = {"9|Value=0",  "22|Value=0.508", "27|Value=1",
                                            "52|Value=0", "130|Value=1",    "162|Value=0"};

using Unit = ParameterUnit;
constexpr NamedParameter named_settings[] = {{dimensioning, "unit at the start"},
                                             {delta_z, "peck clearance", Unit::mm},
                                             {shift_direction, "shift direction of boring"},
                                             {retract_above_r, "retract above R", Unit::mm},
                                             {scaling, "scaling factor"},
                                             {rotation, "rotation angle", Unit::degrees},
                                             {rotation_adds, "incremental rotation"},
                                             {tap_retract_speed, "tapping retract speed"},
                                             {default_to_float, "numbers without a decimal point"}};

struct HaasSettings {
  static constexpr auto spec = ig::dependency("HaasSettings", "Settings of a Haas control, by number.")
                                   .rows("Setting", "number")
                                   .provides("isogloss.number-format/1", "isogloss.canned-cycle/1", "isogloss.motion/1",
                                             "isogloss.coordinate-system/1", IG_ROW_MEANING_SERVICE)
                                   .ships(shipped_settings);

  ig::Column value{"Value", nullptr, "", {}, "The value of the setting: mm, or the number of a choice."};
  ig::Table table;

  /// Accepts settings that this table does not use as well: the whole page of a machine may be given.
  static std::string row_fault(std::string_view row) {
    const bool is_number =
        !row.empty() && row[0] != '0' && row.find_first_not_of("0123456789") == std::string_view::npos;
    return is_number ? "" : "its rows are the numbers of settings";
  }

  const void* service(std::string_view id) const {
    if (id == "isogloss.number-format/1") return &number_format;
    if (id == "isogloss.motion/1") return &motion;
    if (id == "isogloss.coordinate-system/1") return &coordinate_system;
    if (const void* const meanings = meanings_.find(id)) return meanings;
    return id == "isogloss.canned-cycle/1" ? &cycles : nullptr;
  }

 private:
  using Answer = std::optional<double>;

  Answer length(std::string_view setting) const {
    const Answer mm = table.value(setting, value);
    return mm && *mm >= 0 ? mm : std::nullopt;
  }
  bool is_on(std::string_view setting) const { return table.value(setting, value).value_or(0) != 0; }

  Answer number_format_of(std::string_view name) const {
    if (name == "CalculatorDecimalPoint") return is_on(default_to_float) ? 1 : 0;
    if (name == "StartsInInch") return is_on(dimensioning) ? 1 : 0;
    if (name == "LengthIncrement_mm" || name == "AngleIncrement_deg") return 0.001;
    return name == "LengthIncrement_inch" ? Answer(0.0001) : std::nullopt;
  }
  Answer cycle_of(std::string_view name) const {
    if (name == "PeckRetractionDistance_mm" || name == "HighSpeedPeckRetraction_mm") return length(delta_z);
    if (name == "PeckClearanceAboveR_mm") return length(retract_above_r);
    if (name == "TappingExtractionOverride_percent") return tap_speed();
    if (name == "ShiftDirectionX") return shift({2, 3});
    if (name == "ShiftDirectionY") return shift({3, 1});
    if (name == "ShiftDirectionZ") return shift({1, 2});
    return std::nullopt;
  }
  Answer motion_of(std::string_view name) const {
    if (name == "ArcRadiusTolerance_mm") return 0.01;
    const Answer factor = name == "ScalingFactor" ? table.value(scaling, value) : std::nullopt;
    return factor && *factor > 0 ? factor : std::nullopt;
  }
  Answer coordinate_system_of(std::string_view name) const {
    if (name == "RotationAngle_deg") return table.value(rotation, value);
    return name == "RotationIsIncremental" ? Answer(is_on(rotation_adds) ? 1 : 0) : std::nullopt;
  }
  /// 0 and 1 mean the speed of the infeed.
  Answer tap_speed() const {
    const double times = table.value(tap_retract_speed, value).value_or(1);
    return times >= 0 && times <= 9 ? std::max(1.0, times) * 100 : Answer{};
  }
  /// 1 X+, 2 X-, 3 Y+, 4 Y- of the plane, as a signed number of an axis.
  Answer shift(std::array<double, 2> plane) const {
    const double choice = table.value(shift_direction, value).value_or(1);
    const double axis = plane[choice > 2 ? 1 : 0];
    return choice == 2 || choice == 4 ? -axis : axis;
  }

  static std::optional<ig::RowMeaning> meaning_of(std::string_view row, std::string_view column) {
    return meaning_of_parameter(named_settings, row, column, 0.001, "setting ");
  }

  friend class ig::RowMeanings<HaasSettings>;
  ig::RowMeanings<HaasSettings> meanings_{this};
  using Services = ParameterServices<HaasSettings>;
  ig_config_1 number_format = Services::config<&HaasSettings::number_format_of>(this);
  ig_config_1 motion = Services::config<&HaasSettings::motion_of>(this);
  ig_config_1 coordinate_system = Services::config<&HaasSettings::coordinate_system_of>(this);
  ig_config_1 cycles = Services::config<&HaasSettings::cycle_of>(this);
};

const ig::Register<HaasSettings> haas_settings;

}  // namespace
}  // namespace fanuc
