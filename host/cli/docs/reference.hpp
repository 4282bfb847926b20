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

struct ShownMachine {
  std::string name, title, file;
  std::string dialect;     ///< on which the machine stands
  bool is_tables = false;  ///< holds tables alone
  bool is_whole = false;   ///< all of it was read, and it links
  std::string axis_table;  ///< the dependency that names the axes
  Json axes = Json::array(), tables = Json::array(), programs = Json::array(), lacks = Json::array();
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
  std::vector<ShownMachine> machines;
  std::map<std::string, Code, ByNumber> codes;
};

/// Loads all plugins and links all dialects and machines; what keeps one of them from linking is reported.
Reference collect(Session& session);

/// The tables with the source of each row, the axes, and the programs of a machine.
ShownMachine show_machine(const FoundMachine& found, Session& session);

/// The texts of a list of names.
std::vector<std::string> texts(const Json& list);
/// "" where the key is absent.
std::string text_of(const Json& object, const char* key);

}  // namespace isogloss::cli::docs
