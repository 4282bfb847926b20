// The variables of macros that the machine gives values: registers of the PLC, common variables, and system variables
// that no program can know. The table holds given values; those that macros write outlive the run where the control
// keeps them.
#include <cmath>
#include <stdexcept>
#include <string>

#include <isogloss/rows.hpp>
#include <isogloss/sdk.hpp>

#include "macro/macro_shared.hpp"

namespace syntec {
namespace {

struct SyntecVariables final : MacroStore::Keeper {
  static constexpr auto spec =
      ig::dependency("SyntecVariables", "Variables of macros that the machine gives values: @1, R100, #1100.")
          .rows("Variable", "name")
          .provides(macro_store_service, macro_scan_service);

  ig::Column value{"Value", nullptr, "", {}, "The variable's value when the run starts."};
  ig::Table table;
  ig::RowNames names;
  MacroStore store;
  MacroScanState scan;

  SyntecVariables() {
    for (const std::string& name : names) {
      const auto given = table.value(name, value);
      const auto variable = variable_of(name);
      if (!variable)
        throw std::runtime_error("a Variable has the name '" + name +
                                 "': it is @1, R100 or #1100, and no local variable (#1 to #400)");
      if (!given) continue;
      if (holds_integers(*variable) && !is_of_32_bits(*given))
        throw std::runtime_error("the Variable '" + name +
                                 "' holds an integer of 32 bits, and its Value is another number");
      if (variable->area == MacroStore::Area::reg || variable->area == MacroStore::Area::number)
        store.write(*variable, MacroValue::of_number(*given));
      else
        store.write(*variable, MacroValue::real(*given));
    }
    store.keep_in(this);
  }

  const void* service(std::string_view id) const {
    return id == macro_store_service ? static_cast<const void*>(&store) : id == macro_scan_service ? &scan : nullptr;
  }

  void keep(const MacroStore::Variable& v, double written) override {
    const bool is_kept = v.area == MacroStore::Area::at ? v.number >= 656 && v.number <= 1999
                                                        : v.area == MacroStore::Area::number && v.number <= 999;
    if (is_kept) table.set_value(name_of(v), value, written);
  }

 private:
  static std::optional<MacroStore::Variable> variable_of(std::string_view name) {
    const ig::Digits digits = name.size() > 1 ? ig::read_digits(name, 1) : ig::Digits{};
    if (!digits.ok || digits.end != name.size() || digits.value == 0) return std::nullopt;
    const auto number = static_cast<double>(digits.value);
    if (name[0] == '@') return at_variable(number);
    if (name[0] == 'R' && number <= last_register)
      return MacroStore::Variable{MacroStore::Area::reg, static_cast<std::uint32_t>(digits.value)};
    if (name[0] == '#' && number > last_local) return hash_variable(number);
    return std::nullopt;
  }
};

const ig::Register<SyntecVariables> syntec_variables;

}  // namespace
}  // namespace syntec
