// The parts of the dialect: its plugins, and in them the syntaxes and dependencies that the dialect names.
#include <algorithm>

#include "dialect/row_checks.hpp"
#include "link/link_steps.hpp"

namespace isogloss {

namespace {

void find_syntax(Linking& linking, const ChainElement& element) {
  LinkedSyntax s(element);
  s.syntax = linking.library.syntax(element.syntax, &s.plugin);
  if (s.syntax == nullptr || !is_named(linking.out.dialect, *s.plugin)) {
    linking.report("IG-0202", element.where, {element.syntax}, cure(linking, element.syntax, syntax_names));
    return;
  }
  s.options =
      read_options(linking, element.alias, element.where, {s.syntax->options, s.syntax->option_count}, element.options);
  if (s.syntax->look_ahead > 0 && element.stage != Stage::post_logic && linking.mode == LinkMode::whole)
    linking.report("IG-0221", element.where, {element.alias});
  if (s.syntax->inspects != 0 && element.stage != Stage::inspection && linking.mode == LinkMode::whole)
    linking.report("IG-0223", element.where, {element.alias});
  linking.out.chain.push_back(std::move(s));
}

void find_dependency(Linking& linking, const DependencyElement& element) {
  LinkedDependency d(element);
  d.dependency = linking.library.dependency(element.id, &d.plugin);
  if (d.dependency == nullptr || !is_named(linking.out.dialect, *d.plugin)) {
    linking.report("IG-0203", element.where, {element.id}, cure(linking, element.id, dependency_names));
    return;
  }
  d.options = read_options(linking, element.alias, element.where, {d.dependency->options, d.dependency->option_count},
                           element.options);
  for (Diagnostic& fault : check_rows(*d.dependency, element.alias, element.rows)) linking.add(std::move(fault));
  linking.out.dependencies.push_back(std::move(d));
}

std::vector<std::string> declared_codes(const Library& library) {
  std::vector<std::string> codes;
  for (const DiagnosticInfo& info : host_diagnostics()) codes.emplace_back(info.code);
  for (const LoadedPlugin& p : library.plugins())
    for (std::uint32_t i = 0; i < p.plugin->diagnostic_count; ++i) codes.emplace_back(p.plugin->diagnostics[i].code);
  return codes;
}

/// An importer of any plugin may report what the dialect gives a severity.
void find_severities(Linking& linking) {
  if (linking.out.dialect.severities.empty()) return;
  std::vector<std::string> codes = declared_codes(linking.library);
  const auto is_known = [&](const std::string& code) {
    return std::find(codes.begin(), codes.end(), code) != codes.end();
  };
  for (const auto& [code, given] : linking.out.dialect.severities) {
    if (is_known(code)) continue;
    linking.library.load_all();
    codes = declared_codes(linking.library);
    if (!is_known(code)) linking.report("IG-0235", given.where, {code}, did_you_mean(nearest_name(code, codes)));
  }
}

}  // namespace

void find_parts(Linking& linking) {
  for (const PluginReference& p : linking.out.dialect.plugins)
    if (!linking.library.load(p.name, p.where, linking.sink)) linking.has_failed = true;
  if (linking.out.dialect.chain.size() > longest_chain)
    linking.report("IG-0216", {linking.out.dialect.file.string(), 0, 0},
                   {std::to_string(linking.out.dialect.chain.size()), std::to_string(longest_chain)});
  for (const ChainElement& element : linking.out.dialect.chain) find_syntax(linking, element);
  for (const DependencyElement& element : linking.out.dialect.dependencies) find_dependency(linking, element);
  find_severities(linking);
  const auto count_before = [&](Stage stage) {
    return static_cast<std::uint32_t>(std::count_if(linking.out.chain.begin(), linking.out.chain.end(),
                                                    [&](const LinkedSyntax& s) { return s.element.stage < stage; }));
  };
  linking.out.post_logic_begin = count_before(Stage::post_logic);
  linking.out.inspection_begin = count_before(Stage::inspection);
}

}  // namespace isogloss
