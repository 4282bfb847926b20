// The fields' values before the first block, as the dialect gives them.
#include <cmath>

#include "dialect/options.hpp"
#include "link/link_steps.hpp"

namespace isogloss {

void set_initial_state(Linking& linking, const FieldDrafts& drafts) {
  for (const InitialField& initial : linking.out.dialect.initial) {
    const std::optional<ig_field> f = linking.out.layout.find(drafts.canonical(initial.path));
    if (!f) {
      std::vector<std::string> names;
      for (const FieldInfo& info : linking.out.layout.fields) names.push_back(info.path);
      linking.report("IG-0214", initial.where, {initial.path}, did_you_mean(nearest_name(initial.path, names)));
      continue;
    }
    const FieldInfo& info = linking.out.layout.fields[*f];
    ig_value v{};
    const std::optional<double> number = parse_number(initial.value);
    bool ok = true;
    if (info.type == IG_NUMBER) {
      ok = number.has_value();
      v.number = number.value_or(0);
    } else if (info.type == IG_INTEGER) {
      constexpr double largest = 9007199254740992.0;  // beyond it a double skips integers
      ok = number.has_value() && std::abs(*number) <= largest && *number == std::trunc(*number);
      v.integer = ok ? static_cast<std::int64_t>(*number) : 0;
    } else if (info.type == IG_BOOLEAN) {
      ok = initial.value == "true" || initial.value == "false";
      v.integer = initial.value == "true" ? 1 : 0;
    } else if (info.type == IG_SYMBOL) {
      v.symbol = linking.out.symbols.intern(initial.value);
    } else {
      ok = false;
    }
    if (ok)
      linking.out.initial.emplace_back(*f, v);
    else
      linking.report("IG-0215", initial.where, {initial.value, type_name(info.type), initial.path});
  }
}

}  // namespace isogloss
