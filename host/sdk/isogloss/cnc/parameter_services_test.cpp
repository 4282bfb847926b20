#include "isogloss/cnc/parameter_services.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <string>

using namespace ig::cnc;

namespace {

/// Parameters of the axis X: by number, "rapid" and "rollover".
struct AxisParameters {
  std::map<std::string, double> of_x;
  std::optional<double> number(std::string_view name) const {
    const auto found = of_x.find(std::string(name));
    return found == of_x.end() ? std::nullopt : std::optional(found->second);
  }
  std::optional<double> of_axis(std::string_view name, char axis) const {
    return axis == 'X' ? number(name) : std::nullopt;
  }
  std::optional<double> rapid(char axis) const { return of_axis("rapid", axis); }
  std::optional<std::uint32_t> rollover(char axis) const {
    const auto mode = of_axis("rollover", axis);
    return mode ? std::optional(static_cast<std::uint32_t>(*mode)) : std::nullopt;
  }
};

using AxisServices = ParameterServices<AxisParameters>;

ig_machine_axis_1 machine_axes_of(AxisParameters& parameters) {
  return AxisServices::machine_axes<&AxisParameters::of_axis, &AxisParameters::rapid, &AxisParameters::rollover>(
      &parameters);
}

}  // namespace

TEST_CASE("the service isogloss.config/1 answers the names that the table knows") {
  AxisParameters parameters{{{"5114", 2.5}}};
  const ig_config_1 service = AxisServices::config<&AxisParameters::number>(&parameters);
  double out = -1;
  CHECK(service.number(service.self, ig::to_text("5115"), &out) == 0);
  CHECK(out == -1);
  CHECK(service.number(service.self, ig::to_text("5114"), &out) == 1);
  CHECK(out == 2.5);
}

TEST_CASE("parameters 1240 to 1243 are the four reference positions, and home is the first one") {
  AxisParameters parameters{{{"1240", 10}, {"1241", 20}, {"1243", 40}}};
  const ig_machine_axis_1 service = machine_axes_of(parameters);
  double out = 0;
  CHECK(service.home(service.self, 'X', &out) == 1);
  CHECK(out == 10);
  CHECK(service.reference(service.self, 'X', 2, &out) == 1);
  CHECK(out == 20);
  CHECK(service.reference(service.self, 'X', 4, &out) == 1);
  CHECK(out == 40);
  for (const std::uint32_t unknown : {0u, 3u, 5u}) CHECK(service.reference(service.self, 'X', unknown, &out) == 0);
  CHECK(service.home(service.self, 'Y', &out) == 0);
}

TEST_CASE("the travel is from parameter 1321 to 1320, and none where one is missing or they are in the wrong order") {
  AxisParameters parameters{{{"1321", -500}, {"1320", 300}}};
  const ig_machine_axis_1 service = machine_axes_of(parameters);
  double low = 7, high = 8;
  CHECK(service.travel(service.self, 'X', &low, &high) == 1);
  CHECK(low == -500);
  CHECK(high == 300);
  parameters.of_x["1321"] = 301;
  CHECK(service.travel(service.self, 'X', &low, &high) == 0);
  parameters.of_x.erase("1321");
  CHECK(service.travel(service.self, 'X', &low, &high) == 0);
  CHECK(low == -500);
  CHECK(high == 300);
}

TEST_CASE("a rapid rate per minute becomes one per second") {
  AxisParameters parameters{{{"rapid", 6000}}};
  const ig_machine_axis_1 service = machine_axes_of(parameters);
  double per_second = 0;
  CHECK(service.rapid_rate(service.self, 'X', &per_second) == 1);
  CHECK(per_second == 100);
  CHECK(service.rapid_rate(service.self, 'Y', &per_second) == 0);
}

TEST_CASE("the rollover of an axis is the mode that the table gives") {
  AxisParameters parameters{{{"rollover", 2}}};
  const ig_machine_axis_1 service = machine_axes_of(parameters);
  std::uint32_t mode = 9;
  CHECK(service.rollover(service.self, 'Y', &mode) == 0);
  CHECK(mode == 9);
  CHECK(service.rollover(service.self, 'X', &mode) == 1);
  CHECK(mode == 2);
}

TEST_CASE("a table of machine parameters provides five services from its members") {
  struct Parameters {
    double answer = 7;
    std::optional<double> number_format_of(std::string_view) const { return 1; }
    std::optional<double> cycle_of(std::string_view) const { return 2; }
    std::optional<double> motion_of(std::string_view) const { return 3; }
    std::optional<double> program_of_code(std::string_view) const { return 4; }
    std::optional<double> of_axis(std::string_view, char) const { return answer; }
    std::optional<double> rapid_of(char) const { return {}; }
    std::optional<std::uint32_t> rollover_of(char) const { return {}; }
  };
  Parameters parameters;
  const MachineParameterServices<Parameters> services(&parameters);
  double wanted = 1;
  for (const char* id :
       {"isogloss.number-format/1", "isogloss.canned-cycle/1", "isogloss.motion/1", "isogloss.code-call/1"}) {
    const auto* service = static_cast<const ig_config_1*>(services.find(id));
    REQUIRE(service != nullptr);
    double out = 0;
    CHECK(service->number(service->self, ig::to_text("any"), &out) == 1);
    CHECK(out == wanted++);
  }
  const auto* axes = static_cast<const ig_machine_axis_1*>(services.find("isogloss.machine-axis/1"));
  REQUIRE(axes != nullptr);
  double home = 0;
  CHECK(axes->home(axes->self, 'X', &home) == 1);
  CHECK(home == 7);
  CHECK(services.find("isogloss.work-offset/1") == nullptr);
}
