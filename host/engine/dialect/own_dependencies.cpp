// Dependencies that a dialect lacks, such as the kinematics of one machine, come from the user's own tables.
#include "isogloss/engine/own_dependencies.hpp"

#include <algorithm>

namespace isogloss {
namespace {

std::vector<std::string> names(const Dialect& dialect, const Library& library) {
  std::vector<std::string> out;
  for (const DependencyElement& e : dialect.dependencies) out.push_back(e.alias);
  for (const LoadedPlugin& p : library.plugins())
    for (std::uint32_t i = 0; i < p.plugin->dependency_count; ++i) out.emplace_back(p.plugin->dependencies[i]->id);
  return out;
}

}  // namespace

bool add_plugin_of(const DependencyElement& element, Dialect& dialect, Library& library, DiagnosticSink& sink) {
  const ig_plugin* owner = nullptr;
  if (library.find_dependency(element.id, &owner) == nullptr) {
    const std::string near = nearest_name(element.id, names(dialect, library));
    sink.add(host_diagnostic("IG-0415", element.where, {element.id}, near.empty() ? "" : "did you mean " + near + "?"));
    return false;
  }
  const auto is_owner = [&](const PluginReference& p) { return p.name == owner->name; };
  if (std::none_of(dialect.plugins.begin(), dialect.plugins.end(), is_owner))
    dialect.plugins.push_back({owner->name, element.where});
  return true;
}

bool add_missing(const std::vector<DependencyElement>& own, Dialect& dialect, Library& library, DiagnosticSink& sink) {
  bool sound = true;
  for (const DependencyElement& element : own) {
    const bool has =
        std::any_of(dialect.dependencies.begin(), dialect.dependencies.end(),
                    [&](const DependencyElement& e) { return e.alias == element.alias || e.id == element.id; });
    if (has) continue;
    if (!add_plugin_of(element, dialect, library, sink)) {
      sound = false;
      continue;
    }
    dialect.dependencies.push_back(element);
  }
  return sound;
}

}  // namespace isogloss
