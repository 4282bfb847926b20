/// What the host and its plugins report about a program, a dialect or a plugin.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace isogloss {

enum class Severity : std::uint8_t { note = 1, warning = 2, error = 3 };

/// A place in a file. Lines and columns count from 1, columns in bytes; 0 is unknown.
struct Location {
  std::string file;
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

struct Diagnostic {
  Severity severity = Severity::error;
  std::string code;     ///< "ISO-0301"; never reused
  std::string message;  ///< one sentence, without place and severity
  Location where;
  std::uint32_t end_column = 0;  ///< one past the last column; 0: unknown
  std::string hint;              ///< how to correct it; may be empty
};

/// Receives diagnostics in the order in which they arise. Called on the thread that runs.
class DiagnosticSink {
 public:
  virtual ~DiagnosticSink() = default;
  virtual void add(Diagnostic diagnostic) = 0;
};

/// Keeps them.
class DiagnosticList : public DiagnosticSink {
 public:
  void add(Diagnostic diagnostic) override { all.push_back(std::move(diagnostic)); }
  bool has_errors() const;
  std::vector<Diagnostic> all;
};

/// A row of a table of diagnostics: the host's own (host_diagnostics()), or a plugin's.
struct DiagnosticInfo {
  Severity severity;
  std::string_view code;
  std::string_view text;  ///< with {0} {1} … for the arguments
  std::string_view explanation;
  std::string_view example;
};

/// The host's own table, ordered by code.
const std::vector<DiagnosticInfo>& host_diagnostics();

/// A diagnostic of the host's table; `code` must be in it.
Diagnostic host_diagnostic(std::string_view code, Location where, std::initializer_list<std::string> arguments,
                           std::string hint = {});

/// Puts the arguments into the text's {0} {1} …
std::string fill_in(std::string_view text, const std::vector<std::string>& arguments);

/// The nearest of `names` to a misspelt one, for a hint; empty when none is near.
std::string nearest_name(std::string_view name, const std::vector<std::string>& names);
/// "a, b and 3 more": the names with commas, and of a long list the number of the others.
std::string listed(const std::vector<std::string>& names, std::size_t most);

std::string_view to_string(Severity severity);

}  // namespace isogloss
