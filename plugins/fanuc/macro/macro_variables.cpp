// The variables that macro programs write, and values that the user gives to variables of the control. The table holds
// given and permanent values; the present values are in arrays, because loops read them millions of times.
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

#include <isogloss/rows.hpp>
#include <isogloss/sdk.hpp>

#include "macro/macro_store.hpp"

namespace fanuc {
namespace {

enum class ArcRange { full, half };
enum class Conditions { comparison, any_value };
enum class Modulus { whole, real };
enum class RadiusVariables { none, from_2401 };
enum class FirstOffset { external, local };
enum class RepeatedCall { arguments, kept };
enum class Group12 { macro_call, work_offset };

struct MacroVariables final : MacroStore::Keeper {
  static constexpr auto spec =
      ig::dependency("MacroVariables",
                     "Variables of custom macro B: common, permanent, and those of the control that are given.")
          .rows("Variable", "number")
          .provides(macro_store_service);

  ig::TextOption common{"common", "100-199", "Numbers of the common variables: null when a program starts."};
  ig::TextOption permanent{"permanent", "500-999", "Numbers of the permanent variables: kept when the power is off."};
  ig::TextOption assumed{"assumed-zero", "1000-1035 1100-1135 3003-3008 3901-3902",
                         "Variables of the control that are assumed to be 0, with a warning, until the table or the "
                         "program sets them."};
  ig::Choice<ArcRange> arcs{"arc-functions", "0-to-360|-180-to-180", "0-to-360",
                            "Range of the angles that ASIN and ATAN[]/[] return."};
  ig::Choice<Conditions> conditions{"conditions", "comparison|any-value", "comparison",
                                    "Whether a condition must compare two values, or any number other than 0 holds and "
                                    "a comparison is the number 1 or 0."};
  ig::Choice<Modulus> modulus{"mod", "whole|real", "whole", "Whether MOD rounds its operands to whole numbers."};
  ig::Choice<ToolVariables> tool_variables{
      "tool-variables", "wear-first|series-15|geometry-first", "wear-first",
      "wear-first: #2001 and #10001 are the wear of length 1, #2201 and #11001 its "
      "geometry; geometry-first: the other way round, with radii from #2401 and "
      "without #10001; series-15: the other way round."};
  ig::Choice<RadiusVariables> radius_variables{
      "radius-variables", "none|from-2401", "none",
      "Whether #2401 to #2800 are radii of tools, or only work offsets from #2500."};
  ig::Choice<FirstOffset> first_offset{"first-offset", "external|local", "external",
                                       "Whether #5201 and up are the external offset or the shift of G52."};
  ig::IntegerOption tool_in_spindle{
      "tool-in-spindle", "0", {0, 99'999}, "Number of the variable that reads the tool in the spindle; 0: none."};
  ig::IntegerOption spindle_speed{
      "spindle-speed", "0", {0, 99'999}, "Number of the variable that reads the speed of the spindle; 0: none."};
  ig::Choice<Group12> group_12{
      "group-12", "macro-call|work-offset", "macro-call",
      "Whether #4012 reads 66 or 67 (macro call), or the work offset in force, as #4014 does."};
  ig::IntegerOption other_names{"other-names",
                                "0",
                                {0, 99'999},
                                "Distance to a second number of each variable (10000: #10100 is #100); 0: none."};
  ig::Choice<RepeatedCall> repeated_call{
      "repeated-call", "arguments|kept", "arguments",
      "Local variables from the second call of G65 L on: the arguments again, or what the "
      "call before left in them."};
  ig::IntegerOption nesting{"nesting", "5", {1, 64}, "How deep the control lets brackets nest."};
  ig::NumberOption clock_step{"clock-step",
                              "100",
                              {0, 1e9},
                              "ms",
                              "How far #3001 and #3002 advance each time they are read, so that waiting loops end."};
  ig::Column value{"Value", nullptr, "", {}, "The variable's value; none: null."};
  ig::Column is_null{"Null", nullptr, "", {0, 1}, "1: the variable is null, whatever Value holds."};
  ig::Table table;
  ig::RowNames names;
  MacroStore store;

  MacroVariables() {
    store.define(read(common.text(), "common"), read(permanent.text(), "permanent"));
    store.alias(static_cast<std::uint32_t>(other_names));
    store.settings.repeats_keep_locals = repeated_call == RepeatedCall::kept;
    store.assume(read(assumed.text(), "assumed-zero"));
    store.settings.rules.arcs_are_signed = arcs == ArcRange::half;
    store.settings.rules.truth_is_number = conditions == Conditions::any_value;
    store.settings.rules.whole_modulus = modulus == Modulus::whole;
    store.settings.tools = tool_variables;
    store.settings.radii_from_2401 =
        radius_variables == RadiusVariables::from_2401 || tool_variables == ToolVariables::geometry_first;
    store.settings.local_in_5201 = first_offset == FirstOffset::local;
    store.settings.tool_variable = static_cast<std::uint32_t>(tool_in_spindle);
    store.settings.speed_variable = static_cast<std::uint32_t>(spindle_speed);
    store.settings.offset_in_12 = group_12 == Group12::work_offset;
    store.settings.nesting = static_cast<std::uint32_t>(nesting);
    store.settings.clock_step_ms = clock_step;
    for (const std::string& name : names) load(name);
    store.keep_in(this);
  }

  const void* service(std::string_view id) const { return id == macro_store_service ? &store : nullptr; }

  void keep(std::uint32_t number, double written) override {
    std::array<char, 12> digits{};
    const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    const std::string_view row(digits.data(), static_cast<std::size_t>(end - digits.data()));
    const bool null = std::isnan(written);
    if (!null) table.set_value(row, value, written);
    if (null || table.value(row, is_null)) table.set_value(row, is_null, null ? 1 : 0);
  }

 private:
  static NumberRanges read(std::string_view text, const char* option) {
    auto ranges = NumberRanges::read(text);
    if (!ranges) throw std::runtime_error(std::string(option) + " needs numbers and ranges such as 100-199 500");
    return *ranges;
  }

  void load(const std::string& name) {
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (error != std::errc{} || end != name.data() + name.size() || number <= last_local || number > 999'999)
      throw std::runtime_error("a Variable has the number '" + name + "': numbers go from 34 to 999999");
    const auto given = table.value(name, value);
    if (!given || table.value(name, is_null).value_or(0) != 0) return;
    if (!store.set(number, *given)) store.give(number, *given);
    store.came_from(number, name);
  }
};

const ig::Register<MacroVariables> macro_variables;

}  // namespace
}  // namespace fanuc
