/// Writes diagnostics for people (text) and for programs (JSON Lines, SARIF).
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "isogloss/engine/diagnostic.hpp"

namespace isogloss {

enum class DiagnosticStyle : std::uint8_t { text, json, sarif };

struct DiagnosticPolicy {
  DiagnosticStyle style = DiagnosticStyle::text;
  std::uint64_t repeats = 5;  ///< text: how many of one code are written in full, and the first error of each wording;
                              ///< those of one place and wording once, the rest as one line; 0: all
  std::uint64_t maximum_errors = 0;  ///< limit_reached() from then on; 0: no limit
  bool warnings_are_errors = false;
  bool colours = false;  ///< text only
};

/// Writes each diagnostic as it comes; memory does not grow with their number. `write` gets whole lines.
class DiagnosticWriter : public DiagnosticSink {
 public:
  using Write = std::function<void(std::string_view)>;
  DiagnosticWriter(DiagnosticPolicy policy, Write write);
  ~DiagnosticWriter() override;

  void add(Diagnostic diagnostic) override;
  /// Writes how many repeats were left out, and forgets them: at the end of a program.
  void finish_program();
  /// finish_program(), and the end of a SARIF document. Nothing may be added after it.
  void finish();

  struct Count {
    Severity severity = Severity::note;
    std::uint64_t number = 0;
  };
  const std::map<std::string, Count, std::less<>>& by_code() const { return by_code_; }
  std::uint64_t number() const;  ///< of all severities, repeats counted
  std::uint64_t errors() const { return errors_; }
  std::uint64_t warnings() const { return warnings_; }
  bool limit_reached() const { return policy_.maximum_errors != 0 && errors_ >= policy_.maximum_errors; }

 private:
  struct Said {
    std::vector<Diagnostic> written;  // `repeats`, and the first one of each wording
    std::set<std::string> wordings;   // without numbers
    std::uint64_t unsaid = 0;
  };
  bool is_repeat(const Diagnostic& diagnostic);
  void write_text(const Diagnostic& diagnostic);
  void write_json(const Diagnostic& diagnostic);
  void write_sarif(const Diagnostic& diagnostic);

  DiagnosticPolicy policy_;
  Write write_;
  std::map<std::string, Count, std::less<>> by_code_;  // since the beginning
  std::map<std::string, Said, std::less<>> said_;      // in this program
  std::uint64_t errors_ = 0, warnings_ = 0;
  bool sarif_open_ = false, finished_ = false;
};

}  // namespace isogloss
