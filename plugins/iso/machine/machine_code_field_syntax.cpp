/// Codes of the machine's builder that set fields of the block, as the table MachineCodes says. Only the fields of the
/// options can be set: those whose value alone is the state, so no position and no frame falls behind them.
#include <cmath>
#include <map>
#include <string>

#include <isogloss/cnc/feed.hpp>
#include <isogloss/cnc/machine_codes.hpp>

#include "machine/row_fields.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

struct MachineCodeField {
  static constexpr auto spec = ig::syntax("MachineCodeFieldSyntax", "Codes of the machine's builder that set fields.")
                                   .after("FeedrateSyntax", "SpindleSpeedSyntax", "CoolantSyntax", "PathModeSyntax",
                                          "PathSmoothingSyntax", "HaasCoolantSyntax")
                                   .before("ToolChangeSyntax", "DwellSyntax", "CannedCycleResolveSyntax",
                                           "CircularMotionSyntax", "LinearMotionSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0602",
                     "{0} is not set to {1} as the row of its code demands, because the number {2}: it is unchanged"),
  };

  MachineCodes machine_;
  FeedInForce feed_{ig::read | ig::write};
  ig::Fields numbers_{"numbers",
                      "Feedrate.FeedrateValue SpindleSpeed.SpindleSpeed_rpm SpindleSpeed.Limit_rpm "
                      "PathMode.Tolerance_mm PathSmoothing.Level Dwell.Time",
                      ig::write, "The numbers that rows may set."};
  ig::Fields integers_{"integers", "ToolChange.ToolId", ig::write, "The whole numbers that rows may set.", IG_INTEGER};
  ig::Fields names_{"names", "SpindleSpeed.Direction Coolant.Mode", ig::write, "The names that rows may set.",
                    IG_SYMBOL};
  ig::Fields switches_{"switches", "PathSmoothing.IsEnabled", ig::write, "What rows may set to true or false.",
                       IG_BOOLEAN};
  ig::TextField fields_{
      "MachineCode.Fields",
      ig::read | ig::wake,
      {ig::Life::block, "", "The fields that rows of MachineCodes set in this block, and their values."}};
  ig::Call g04_{{"G04"}, "", ig::read};
  struct Target {
    ig_field field;
    ig_type type;
  };
  std::map<std::string, Target, std::less<>> targets_;

  MachineCodeField() {
    if (!machine_.holds_any()) {
      ig::stay_idle();
      return;
    }
    const auto add = [this](const ig::Fields& fields, ig_type type) {
      for (std::size_t i = 0; i < fields.size(); ++i) targets_[std::string(fields.path(i))] = {fields.id(i), type};
    };
    add(numbers_, IG_NUMBER);
    add(integers_, IG_INTEGER);
    add(names_, IG_SYMBOL);
    add(switches_, IG_BOOLEAN);
  }

  ig::Status build(ig::Block& b) const {
    // Rows set other fields, so the text stays as it is.
    for_each_assignment(b.text(fields_), [&](std::string_view path, std::string_view value) {
      if (const auto target = targets_.find(path); target != targets_.end()) set(b, path, target->second, value);
    });
    return ig::Status::changed;
  }

 private:
  void set(ig::Block& b, std::string_view path, const Target& to, std::string_view value) const {
    if (to.type == IG_SYMBOL) return b.set(to.field, ig_value{.symbol = b.symbol(value).id});
    if (to.type == IG_BOOLEAN) return b.set(to.field, ig_value{.integer = value == "true" ? 1 : 0});
    const double number = ig::read_decimal(value, 0).value;
    std::string_view fault = fault_of_number(path, number);
    constexpr double largest = 9007199254740992.0;  // beyond it a double skips integers
    if (to.type == IG_INTEGER && (number != std::trunc(number) || std::fabs(number) > largest)) fault = "is not whole";
    if (path == "Dwell.Time" && b.find(g04_)) fault = "stands beside G04, whose time counts";
    if (!fault.empty()) return b.report(ig::diag("ISO-0602"), ig::Where::block(), path, number, fault);
    if (to.type == IG_INTEGER) return b.set(to.field, ig_value{.integer = static_cast<std::int64_t>(number)});
    if (path == "Feedrate.FeedrateValue") return feed_.resolve(b, number);
    b.set(to.field, number);
  }
};

const ig::Register<MachineCodeField> machine_code_field_syntax;

}  // namespace
}  // namespace iso
