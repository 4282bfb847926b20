// Hints for parts that a dialect lacks: which plugin has them, which one answers.
#include <algorithm>

#include <fmt/format.h>

#include "dialect/options.hpp"
#include "link/link_steps.hpp"

namespace isogloss {

namespace {

std::string of_plugin(const ig_plugin& plugin) {
  return fmt::format("{0} has it: <Plugins> <Plugin name=\"{0}\"/> </Plugins>", plugin.name);
}

std::string of_unnamed_plugin(const Linking& linking, const ig_plugin& plugin) {
  return is_named(linking.out.dialect, plugin) ? "" : fmt::format(" of the plugin {}", plugin.name);
}

}  // namespace

bool is_named(const Dialect& dialect, const ig_plugin& plugin) {
  const auto& names = dialect.plugins;
  return std::any_of(names.begin(), names.end(), [&](const PluginReference& p) { return p.name == plugin.name; });
}

std::vector<std::string> syntax_names(const ig_plugin& plugin) {
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i < plugin.syntax_count; ++i) names.emplace_back(plugin.syntaxes[i]->id);
  return names;
}

std::vector<std::string> dependency_names(const ig_plugin& plugin) {
  std::vector<std::string> names;
  for (std::uint32_t i = 0; i < plugin.dependency_count; ++i) names.emplace_back(plugin.dependencies[i]->id);
  return names;
}

std::string cure(const Linking& linking, const std::string& name,
                 std::vector<std::string> (*names_of)(const ig_plugin&)) {
  linking.library.load_all();
  std::vector<std::string> own;
  std::vector<std::string> others;
  for (const LoadedPlugin& p : linking.library.plugins()) {
    const bool is_own = is_named(linking.out.dialect, *p.plugin);
    for (std::string& other : names_of(*p.plugin)) {
      if (!is_own && other == name) return "the plugin " + of_plugin(*p.plugin);
      (is_own ? own : others).push_back(std::move(other));
    }
  }
  if (const std::string near = nearest_name(name, own); !near.empty()) return did_you_mean(near);
  const std::string near = nearest_name(name, others);
  for (const LoadedPlugin& p : linking.library.plugins())
    for (const std::string& other : names_of(*p.plugin))
      if (!near.empty() && other == near)
        return fmt::format("did you mean {}? The plugin {}", near, of_plugin(*p.plugin));
  return {};
}

std::string providers(const Linking& linking, std::string_view service) {
  linking.library.load_all();
  std::string out;
  for (const LoadedPlugin& p : linking.library.plugins())
    for (std::uint32_t i = 0; i < p.plugin->dependency_count; ++i)
      for (const char* const* id = p.plugin->dependencies[i]->provides; id != nullptr && *id != nullptr; ++id)
        if (service == *id)
          out += fmt::format("{}<{}/>{}", out.empty() ? "add " : " or ", p.plugin->dependencies[i]->id,
                             of_unnamed_plugin(linking, *p.plugin));
  return out.empty() ? out : out + " to <Dependencies>";
}

std::string writers(const Linking& linking, std::string_view path) {
  linking.library.load_all();
  std::string out;
  for (const LoadedPlugin& p : linking.library.plugins())
    for (std::uint32_t i = 0; i < p.plugin->syntax_count; ++i) {
      const ig_syntax& s = *p.plugin->syntaxes[i];
      for (std::uint32_t f = 0; f < s.field_count; ++f)
        if ((s.fields[f].access & IG_WRITE) != 0 && path == s.fields[f].path) {
          out += fmt::format("{}{}{}", out.empty() ? "add " : " or ", s.id, of_unnamed_plugin(linking, *p.plugin));
          break;
        }
    }
  return out.empty() ? out : out + ", or give the field an initial value";
}

}  // namespace isogloss
