/// Dialects, machines and words for blocks, as the other commands have them, for the language server.
#pragma once

#include <map>
#include <optional>

#include "known_codes.hpp"
#include "lsp/toolbox.hpp"
#include "session.hpp"

namespace isogloss::cli {

class CommandToolbox : public editors::Toolbox {
 public:
  explicit CommandToolbox(Session& session) : session_(session) {}

  std::shared_ptr<const editors::Setup> setup(const std::string& path, std::string_view text,
                                              const editors::Settings& settings, DiagnosticSink& sink) override;
  void forget_dialects() override;
  std::string sentence(const ExplainedBlock& block, const std::string& path, const std::string& text) override;
  std::string why_no_block(const ExplainReach& reach, const ExplainTarget& target, const std::string& path) override;
  std::vector<editors::CodeInfo> codes(const LinkedDialect& linked) override;
  const DiagnosticInfo* diagnostic(const std::string& code) override;
  std::vector<Diagnostic> lint(const std::string& path, const std::string& text) override;
  const Library& library() override;

 private:
  std::shared_ptr<const LinkedDialect> link(const std::string& dialect, const RunOptions& options,
                                            DiagnosticSink& sink);

  Session& session_;
  std::optional<editors::Settings> linked_for_;
  std::map<std::string, std::shared_ptr<const LinkedDialect>> linked_;  // by name or file
  std::map<const LinkedDialect*, std::vector<editors::CodeInfo>> codes_;
  std::map<std::string, DiagnosticInfo, std::less<>> diagnostics_;
};

}  // namespace isogloss::cli
