// R parameters, and values that the user gives to variables of the machine: global user data (GUD), machine and setting
// data.
#include <stdexcept>
#include <string>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/rows.hpp>
#include <isogloss/sdk.hpp>

#include "language/variable_store.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensVariables {
  static constexpr auto spec =
      ig::dependency("SiemensVariables", "R parameters, and values that the user gives for data of the machine.")
          .rows("Variable", "name")
          .provides(variable_service);

  ig::IntegerOption r_parameters{"r-parameters", "1000", {1, 32'535}, "How many R parameters there are, from R0."};
  ig::IntegerOption most_variables{"most-variables",
                                   "100000",
                                   {1, 10'000'000},
                                   "Variables that one program may have; each element of an array counts as one."};
  ig::Column value{"Value", "0", "", {}, "The value when the program starts."};
  ig::Table table;
  ig::RowNames names;
  VariableStore store;

  SiemensVariables() {
    store.most_names = static_cast<std::size_t>(most_variables);
    store.set_r_count(static_cast<std::size_t>(r_parameters));
    for (const std::string& name : names) load(name);
  }

  const void* service(std::string_view id) const { return id == variable_service ? &store : nullptr; }

 private:
  void load(const std::string& written) {
    std::string name = written;
    for (char& c : name) c = to_upper(c);
    const double given = table.value(written, value).value_or(0);
    const bool is_r = name.size() > 1 && name[0] == 'R' && skip_digits(name, 1) == name.size();
    if (!is_r) return store.give(std::move(name), given);
    VariableStore::RParameter* const r = name.size() < 8 ? store.r(std::stoul(name.substr(1))) : nullptr;
    if (r == nullptr)
      throw std::runtime_error(name + " is not an R parameter: the option r-parameters says how many there are");
    *r = {given, true};
  }
};

const ig::Register<SiemensVariables> siemens_variables;

}  // namespace
}  // namespace siemens
