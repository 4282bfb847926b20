// Answers where no controller's table does: retracts of the peck cycles, the tolerance of arcs. A dialect that brings a
// parameter table of its own lists that one first.
#include <isogloss/sdk.hpp>

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
                        "G83: clearance above the depth reached, to which the next peck rapids down."};
  ig::NumberOption high_speed_peck{
      "HighSpeedPeckRetraction_mm", "5", {0, HUGE_VAL}, "mm", "G73: retract after each peck."};
  ig::NumberOption arc_tolerance{"ArcRadiusTolerance_mm",
                                 "0.01",
                                 {0, HUGE_VAL},
                                 "mm",
                                 "Difference of an arc's radii at start and end that is no error; 0: not checked."};

  const void* service(std::string_view id) const {
    if (id == "isogloss.canned-cycle/1") return &cycles;
    return id == "isogloss.motion/1" ? &motion : nullptr;
  }

 private:
  static std::int32_t cycle_number(void* self, ig_text name, double* out) {
    const auto& config = *static_cast<const FallbackConfig*>(self);
    const std::string_view wanted = ig::to_view(name);
    if (wanted == "PeckRetractionDistance_mm") return answer(config.peck, out);
    return wanted == "HighSpeedPeckRetraction_mm" ? answer(config.high_speed_peck, out) : 0;
  }
  static std::int32_t motion_number(void* self, ig_text name, double* out) {
    const auto& config = *static_cast<const FallbackConfig*>(self);
    return ig::to_view(name) == "ArcRadiusTolerance_mm" ? answer(config.arc_tolerance, out) : 0;
  }
  static std::int32_t answer(double value, double* out) {
    *out = value;
    return 1;
  }

  ig_config_1 cycles{sizeof(ig_config_1), 0, this, &cycle_number};
  ig_config_1 motion{sizeof(ig_config_1), 0, this, &motion_number};
};

const ig::Register<FallbackConfig> registered;

}  // namespace
}  // namespace iso
