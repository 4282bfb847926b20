// Options of the parts, typed.
#include <algorithm>

#include "dialect/options.hpp"
#include "link/link_steps.hpp"

namespace isogloss {

namespace {

std::string similar_choice(const ig_option_decl& option, const std::string& value) {
  if (option.type != IG_OPTION_CHOICE) return {};
  std::vector<std::string> choices;
  for (std::string_view rest = option.choices; !rest.empty();) {
    const std::size_t bar = std::min(rest.find('|'), rest.size());
    choices.emplace_back(rest.substr(0, bar));
    rest.remove_prefix(std::min(bar + 1, rest.size()));
  }
  return did_you_mean(nearest_name(value, choices));
}

std::string all_options(const std::vector<std::string>& names) {
  std::string out = names.empty() ? "it has no options" : "its options are ";
  for (const std::string& name : names) out += (&name == &names.front() ? "" : ", ") + name;
  return out;
}

}  // namespace

std::vector<OptionValue> read_options(const OptionFault& report, const std::string& owner, const Location& where,
                                      std::span<const ig_option_decl> declared, const std::vector<Attribute>& given) {
  std::vector<OptionValue> values(declared.size());
  std::vector<bool> is_given(declared.size());
  for (const Attribute& a : given) {
    const auto option =
        std::find_if(declared.begin(), declared.end(), [&](const ig_option_decl& o) { return a.name == o.name; });
    if (option == declared.end()) {
      std::vector<std::string> names;
      for (const ig_option_decl& o : declared) names.emplace_back(o.name);
      const std::string near = did_you_mean(nearest_name(a.name, names));
      report("IG-0204", a.where, {owner, a.name}, near.empty() ? all_options(names) : near);
      continue;
    }
    const auto number = static_cast<std::size_t>(option - declared.begin());
    is_given[number] = true;
    if (std::optional<OptionValue> v = parse_option(*option, a.value))
      values[number] = std::move(*v);
    else
      report("IG-0205", a.where, {a.name, owner, describe_option(*option), a.value}, similar_choice(*option, a.value));
  }
  for (std::size_t i = 0; i < declared.size(); ++i) {
    if (is_given[i]) continue;
    if (declared[i].fallback == nullptr)
      report("IG-0213", where, {owner, declared[i].name}, {});
    else if (std::optional<OptionValue> v = parse_option(declared[i], declared[i].fallback))
      values[i] = std::move(*v);
  }
  return values;
}

std::vector<OptionValue> read_options(Linking& linking, const std::string& owner, const Location& where,
                                      std::span<const ig_option_decl> declared, const std::vector<Attribute>& given) {
  const auto report = [&](std::string_view code, const Location& at, std::initializer_list<std::string> arguments,
                          const std::string& hint) { linking.report(code, at, arguments, hint); };
  return read_options(report, owner, where, declared, given);
}

}  // namespace isogloss
