/// What the server borrows from the command: dialects, machines, and how a block is put into words.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isogloss/engine/explain.hpp"
#include "lsp/settings.hpp"

namespace isogloss::editors {

/// How a program is run: shared by requests, never changed.
struct Setup {
  std::shared_ptr<const LinkedDialect> linked;
  RunOptions options;
  std::string dialect;  ///< name of the dialect or machine
  std::string why;      ///< "from the text of the program"; empty: the user has named it
};

/// A code or word of a dialect with one syntax that acts on it.
struct CodeInfo {
  std::string code;
  bool is_code = false;  ///< a code; else a word
  std::string syntax;    ///< alias
  std::string unit;
  std::vector<std::string> words;  ///< of a code that has words of its own
};

/// One thread at a time.
class Toolbox {
 public:
  virtual ~Toolbox() = default;
  /// Null, and reported, when something is wrong.
  virtual std::shared_ptr<const Setup> setup(const std::string& path, std::string_view text, const Settings& settings,
                                             DiagnosticSink& sink) = 0;
  /// Dialects and machines are read anew when they are asked for next.
  virtual void forget_dialects() = 0;
  /// The block in one sentence. `text` is the present text of the file `path`.
  virtual std::string sentence(const ExplainedBlock& block, const std::string& path, const std::string& text) = 0;
  virtual std::string why_no_block(const ExplainReach& reach, const ExplainTarget& target, const std::string& path) = 0;
  /// In the order in which a list shows them.
  virtual std::vector<CodeInfo> codes(const LinkedDialect& linked) = 0;
  /// Null when nobody declares this code of a diagnostic.
  virtual const DiagnosticInfo* diagnostic(const std::string& code) = 0;
  /// What `isogloss lint` reports about a file of a dialect or a machine with this text.
  virtual std::vector<Diagnostic> lint(const std::string& path, const std::string& text) = 0;
  /// With all plugins.
  virtual const Library& library() = 0;
};

}  // namespace isogloss::editors
