/// The dialect in which one syntax runs alone: the surroundings, with what a case gives of its own.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "isogloss/engine/cases.hpp"

namespace isogloss {

/// The XML beside a case, as text.
struct CaseDependencies {
  std::vector<Attribute> options;
  std::vector<DependencyElement> dependencies;
  std::map<std::string, std::string, std::less<>> settings;
};

/// Nothing, and reported, when the text is not XML. `where` becomes the place of all of it.
std::optional<CaseDependencies> read_case_dependencies(const std::string& xml, const std::string& syntax,
                                                       const Location& where, DiagnosticSink& sink);

/// The dialect around one syntax. `alias` becomes the place to look for it in the chain.
Dialect surround(const ig_syntax& syntax, const ig_plugin& plugin, const Surroundings& around,
                 const CaseDependencies& own, const Location& where, std::string& alias, Library& library);

}  // namespace isogloss
