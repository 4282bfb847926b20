#include "run/case_dialect.hpp"

#include <algorithm>
#include <pugixml.hpp>
#include <stdexcept>

namespace isogloss {

namespace {

std::vector<Attribute> attributes(const pugi::xml_node& node, const Location& where) {
  std::vector<Attribute> out;
  for (const pugi::xml_attribute& a : node.attributes()) out.push_back({a.name(), a.value(), where});
  return out;
}

Stage stage_of(const ig_syntax& syntax) {
  if (syntax.inspects != 0) return Stage::inspection;
  if (syntax.look_ahead != 0) return Stage::post_logic;
  return syntax.scan != nullptr ? Stage::parsing : Stage::logic;
}

ChainElement element_of(const ig_syntax& syntax, const Location& where) {
  return {stage_of(syntax), syntax.id, syntax.id, {}, true, where};
}

bool has_plugin(const Dialect& dialect, std::string_view name) {
  return std::any_of(dialect.plugins.begin(), dialect.plugins.end(),
                     [&](const PluginReference& p) { return p.name == name; });
}

}  // namespace

std::optional<CaseDependencies> read_case_dependencies(const std::string& xml, const std::string& syntax,
                                                       const Location& where, DiagnosticSink& sink) {
  CaseDependencies out;
  if (xml.find_first_not_of(" \t\r\n") == std::string::npos) return out;
  pugi::xml_document document;
  const pugi::xml_parse_result parsed =
      document.load_buffer(xml.data(), xml.size(), pugi::parse_default | pugi::parse_fragment);
  if (!parsed) {
    sink.add(host_diagnostic("IG-0503", where, {std::string("the dependencies are no XML: ") + parsed.description()}));
    return std::nullopt;
  }
  pugi::xml_node parent = document;
  if (const pugi::xml_node wrapper = document.child("Dependencies")) parent = wrapper;
  for (const pugi::xml_node& node : parent.children()) {
    if (node.type() != pugi::node_element) continue;
    const std::string name = node.name();
    if (name == syntax) {
      out.options = attributes(node, where);
    } else if (name == "Settings") {
      for (const pugi::xml_attribute& a : node.attributes()) out.settings[a.name()] = a.value();
    } else {
      DependencyElement element{name, name, attributes(node, where), {}, {}, where};
      for (const pugi::xml_node& row : node.children())
        if (row.type() == pugi::node_element) element.rows.push_back({row.name(), attributes(row, where), where});
      out.dependencies.push_back(std::move(element));
    }
  }
  return out;
}

Dialect surround(const ig_syntax& syntax, const ig_plugin& plugin, const Surroundings& around,
                 const CaseDependencies& own, const Location& where, std::string& alias, Library& library) {
  Dialect d;
  if (around.dialect) {
    d = *around.dialect;
    d.initial.clear();
    if (!around.is_named) {
      // The default surroundings must not hinder a plugin that is being written.
      std::erase_if(d.plugins, [&](const PluginReference& p) { return library.find(p.name) == nullptr; });
      std::erase_if(d.chain, [&](const ChainElement& e) { return library.syntax(e.syntax) == nullptr; });
      std::erase_if(d.dependencies, [&](const DependencyElement& e) { return library.dependency(e.id) == nullptr; });
    }
  } else {
    d.name = plugin.name;
    for (std::uint32_t i = 0; i < plugin.syntax_count; ++i) d.chain.push_back(element_of(*plugin.syntaxes[i], where));
  }
  if (!has_plugin(d, plugin.name)) d.plugins.push_back({plugin.name, where});

  const auto named = [&](const ChainElement& e) { return e.alias == alias; };
  const auto same = [&](const ChainElement& e) { return e.syntax == syntax.id; };
  auto at = std::find_if(d.chain.begin(), d.chain.end(), named);
  if (at == d.chain.end()) at = std::find_if(d.chain.begin(), d.chain.end(), same);
  if (at == d.chain.end()) at = d.chain.insert(d.chain.end(), element_of(syntax, where));
  if (!around.is_named) at->options.clear();
  for (const Attribute& option : own.options) {
    std::erase_if(at->options, [&](const Attribute& a) { return a.name == option.name; });
    at->options.push_back(option);
  }
  alias = at->alias;
  std::stable_sort(d.chain.begin(), d.chain.end(),
                   [](const ChainElement& a, const ChainElement& b) { return a.stage < b.stage; });

  std::vector<DependencyElement> dependencies = own.dependencies;
  for (const DependencyElement& e : own.dependencies) {
    const ig_plugin* owner = nullptr;
    if (library.dependency(e.id, &owner) != nullptr && !has_plugin(d, owner->name))
      d.plugins.push_back({owner->name, where});
  }
  for (const DependencyElement& inherited : d.dependencies) {
    const bool replaced = std::any_of(own.dependencies.begin(), own.dependencies.end(),
                                      [&](const DependencyElement& e) { return e.alias == inherited.alias; });
    if (!replaced) dependencies.push_back(inherited);
  }
  d.dependencies = std::move(dependencies);
  return d;
}

}  // namespace isogloss
