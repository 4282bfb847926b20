// Answers of the last resort, where no controller's table gives any: retracts of the peck cycles, the shift of the
// boring cycles, tapping, the tolerance of arcs. A dialect with a parameter table of its own lists that table first.
#include <isogloss/cnc/parameter_services.hpp>

namespace iso {
namespace {

struct FallbackConfig {
  static constexpr auto spec =
      ig::dependency("FallbackConfig", "Settings for dialects without a parameter table of their own.")
          .provides("isogloss.canned-cycle/1", "isogloss.motion/1");

  ig::NumberOption peck{"PeckRetractionDistance_mm",
                        "5",
                        {0, HUGE_VAL},
                        "mm",
                        "G83: clearance above the previous depth, where the rapid of the next peck ends."};
  ig::NumberOption high_speed_peck{"HighSpeedPeckRetraction_mm",
                                   "-1",
                                   {-1, HUGE_VAL},
                                   "mm",
                                   "G73: retract after each peck; -1: as PeckRetractionDistance_mm."};
  ig::IntegerOption shift_x{"ShiftDirectionX",
                            "2",
                            {-3, 3},
                            "G76, G87 along X: axis of the shift, 1 X, 2 Y, 3 Z; negative: opposite direction."};
  ig::IntegerOption shift_y{"ShiftDirectionY", "3", {-3, 3}, "The same for boring along Y."};
  ig::IntegerOption shift_z{"ShiftDirectionZ", "1", {-3, 3}, "The same for boring along Z."};
  ig::BooleanOption rigid_tapping{"RigidTapping", "false", "G74 and G84 are rigid without M29, too."};
  ig::BooleanOption tapping_stop{"TappingSpindleStop", "true",
                                 "G74, G84 with a floating holder: the spindle is stopped before it is reversed."};
  ig::BooleanOption peck_tapping_to_r{"PeckTappingToR", "false",
                                      "Rigid tapping with Q: the tap is withdrawn to the R level after each cut."};
  ig::NumberOption peck_tapping{
      "PeckTappingRetraction_mm", "1", {0, HUGE_VAL}, "mm", "Rigid tapping with Q: retract after each cut."};
  ig::NumberOption extraction{"TappingExtractionOverride_percent",
                              "100",
                              {1, 2000},
                              "%",
                              "Rigid tapping: retract speed divided by the speed into the hole."};
  ig::NumberOption arc_tolerance{"ArcRadiusTolerance_mm",
                                 "0.01",
                                 {0, HUGE_VAL},
                                 "mm",
                                 "Largest permitted difference of an arc's radii at start and end; 0: no check."};

  const void* service(std::string_view id) const {
    if (id == "isogloss.canned-cycle/1") return &cycles;
    return id == "isogloss.motion/1" ? &motion : nullptr;
  }

 private:
  using Answer = std::optional<double>;

  Answer cycle_of(std::string_view name) const {
    if (name == "PeckRetractionDistance_mm") return peck;
    if (name == "HighSpeedPeckRetraction_mm") return high_speed_peck < 0 ? peck : high_speed_peck;
    if (name == "ShiftDirectionX") return whole(shift_x);
    if (name == "ShiftDirectionY") return whole(shift_y);
    if (name == "ShiftDirectionZ") return whole(shift_z);
    if (name == "RigidTapping") return rigid_tapping ? 1 : 0;
    if (name == "TappingSpindleStop") return tapping_stop ? 1 : 0;
    if (name == "PeckTappingToR") return peck_tapping_to_r ? 1 : 0;
    if (name == "PeckTappingRetraction_mm") return peck_tapping;
    return name == "TappingExtractionOverride_percent" ? Answer(extraction) : std::nullopt;
  }
  Answer motion_of(std::string_view name) const {
    return name == "ArcRadiusTolerance_mm" ? Answer(arc_tolerance) : std::nullopt;
  }
  static double whole(std::int64_t value) { return static_cast<double>(value); }

  using Services = ig::cnc::ParameterServices<FallbackConfig>;
  ig_config_1 cycles = Services::config<&FallbackConfig::cycle_of>(this);
  ig_config_1 motion = Services::config<&FallbackConfig::motion_of>(this);
};

const ig::Register<FallbackConfig> fallback_config;

}  // namespace
}  // namespace iso
