/// One syntax or importer by itself: `apply`, and the cases of a page, which are documentation that runs.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isogloss/engine/dialect.hpp"
#include "isogloss/engine/library.hpp"
#include "isogloss/engine/linker.hpp"

namespace isogloss {

/// A piece of a page, with the line at which it begins.
struct Fence {
  std::string text;
  std::uint32_t line = 0;
};

/// A case: one build of the syntax must turn `before` into `after`; or the importer must make `tables` of `file`.
struct Case {
  std::string heading;
  std::uint32_t line = 0;
  std::optional<Fence> previous;      ///< JSON: the whole block before
  std::optional<Fence> ahead;         ///< JSON: executed blocks after it, a list
  std::optional<Fence> dependencies;  ///< XML: dependencies, the syntax's own element with options, <Settings …/>;
                                      ///< of an importer: rows that the machine's own file has
  std::optional<Fence>
      diagnostics;  ///< the codes that must be reported, exactly; absent: none. Of an importer each with line:column
  bool accepts_any_code = false;  ///< "#Diagnostics: any": any codes are accepted
  /// JSON; both are there in a syntax's case that was read without a fault. A null in `after`: that value or section
  /// was there before the build and is gone.
  std::optional<Fence> before, after;

  std::string file_name;          ///< of an importer's case: "#File: TOOL.T"
  std::optional<Fence> file;      ///< its text
  std::optional<Fence> options;   ///< name=value of the importer, one a line
  std::optional<Fence> tables;    ///< XML: the elements of the dependencies that it must make
  std::optional<Fence> unused;    ///< a line for each part that it does not read, "3:20 column LAST_USE"; absent: none
  std::optional<Fence> written;   ///< the file that is written from those tables; absent: not tried
  std::optional<Fence> left_out;  ///< a line for each part that has no place in that file, "column Name"; absent: none
};

struct Page {
  std::string syntax;  ///< its title
  std::vector<Case> cases;
};

/// Reads a page; `file` names it in diagnostics.
Page read_page(std::string_view text, const std::string& file, DiagnosticSink& sink);

/// The surroundings of a syntax that runs alone.
struct Surroundings {
  /// Gives vocabulary and dependencies; without one the plugin's own syntaxes are the vocabulary.
  std::optional<Dialect> dialect;
  /// True when the user named the dialect: then it gives the options, too, and must link as it is.
  bool is_named = false;
  std::map<std::string, std::string, std::less<>> settings;
};

/// The input of one build.
struct Application {
  std::string syntax;  ///< id or alias
  std::string before;  ///< JSON
  std::optional<std::string> previous;
  std::string dependencies;  ///< XML, may be empty
  Location where;            ///< of `before`, and of the others where their own places are not known
  /// JSON, a list: the values written in each of the executed blocks that follow.
  std::optional<std::string> ahead = std::nullopt;
  /// Values or sections that must be there before the build, each by its keys from the outermost: CannedCycle, R. Their
  /// sections are shown after it, whoever wrote them.
  std::vector<std::vector<std::string>> erased = {};
  Location previous_at = {}, ahead_at = {}, dependencies_at = {};
};

/// Runs one build; the document after it as JSON (architecture: what is shown), two blanks of indentation. Empty, and
/// reported, when it could not run. All plugins that are needed must be in the library.
std::optional<std::string> apply(const Application& application, const Surroundings& surroundings, Library& library,
                                 DiagnosticSink& sink);

/// A syntax whose chain is linked, to be built alone.
struct LinkedAlone {
  std::unique_ptr<LinkedDialect> linked;  ///< null, and reported, when it could not be linked
  std::uint32_t position = 0;             ///< of the syntax in the chain
};

/// Links the chain in which apply() runs a syntax; `dependencies` is the XML beside a case, and may be empty.
LinkedAlone link_alone(const ig_syntax& syntax, const ig_plugin& plugin, const Surroundings& surroundings,
                       const std::string& dependencies, Library& library, DiagnosticSink& sink);

/// Of a case that does not hold: the first paths that differ, each shortened; or all of them, and the whole document.
enum class CaseDetail : std::uint8_t { first_paths, whole };

/// Empty when the case holds, else what differs, for people.
std::string run_case(const Page& page, const Case& one, const std::string& file, const Surroundings& surroundings,
                     Library& library, CaseDetail detail = CaseDetail::first_paths);

}  // namespace isogloss
