// The Q parameters of a run: values from the table, and values that the program writes. They are kept in arrays,
// because loops read them millions of times.
#include <charconv>
#include <stdexcept>
#include <string>

#include <isogloss/rows.hpp>
#include <isogloss/sdk.hpp>

#include "language/q_store.hpp"

namespace heidenhain {
namespace {

struct QParameters {
  static constexpr auto spec = ig::dependency("QParameters", "Q parameters that have a value when a program starts.")
                                   .rows("Q", "number")
                                   .provides(q_store_service);

  ig::Column value{"Value", nullptr, "", {}, "The value at the start; none: the parameter is not defined."};
  ig::Table table;
  ig::RowNames names;
  QStore store;

  QParameters() {
    for (const std::string& name : names) {
      std::uint32_t number = 0;
      const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
      if (error != std::errc{} || end != name.data() + name.size() || number >= QStore::q_count)
        throw std::runtime_error("'" + name + "' is not the number of a Q parameter: 0 to 1999");
      if (const auto given = table.value(name, value)) store.give(number, *given, name);
    }
  }

  const void* service(std::string_view id) const { return id == q_store_service ? &store : nullptr; }
};

const ig::Register<QParameters> q_parameters;

}  // namespace
}  // namespace heidenhain
