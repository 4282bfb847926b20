/// Everything that is documented, as `list`, `inspect` and `dialect --graph` collect it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "catalogue.hpp"
#include "session.hpp"

namespace isogloss::cli::docs {

enum class PartKind { syntax, dependency, importer };

struct Part {
  PartKind kind;
  std::string id, plugin;
  Json declaration;
  std::string page, cases;  ///< Markdown of the plugin; empty where there is none
};

/// What a dialect makes of one syntax.
struct Instance {
  std::string dialect, alias, syntax;
  Json link;  ///< as describe_link()
};

struct ShownDialect {
  std::string name;
  Json declaration;
  bool is_linked = false;  ///< otherwise what follows is empty
  Json chain, services, codes;
  std::vector<Instance> instances;
};

/// One syntax that answers a code, and the dialects in which it does.
struct CodeAnswer {
  std::string syntax;
  std::vector<std::string> dialects;
};

struct Code {
  bool is_word = false;  ///< "F", where a code is "G83"
  std::vector<CodeAnswer> answers;
};

struct Reference {
  Json plugins = Json::array(), fields = Json::array(), diagnostics = Json::array();
  std::vector<Part> parts;
  std::vector<ShownDialect> dialects;
  std::map<std::string, Code, ByNumber> codes;
};

/// Loads all plugins and links all dialects; what keeps a dialect from linking is reported.
Reference collect(Session& session);

/// The texts of a list of names.
std::vector<std::string> texts(const Json& list);
/// "" where the key is absent.
std::string text_of(const Json& object, const char* key);

}  // namespace isogloss::cli::docs
