/// Diagnostics as JSON in the results of commands, with the keys of `--diagnostics json`.
#pragma once

#include "catalogue.hpp"

namespace isogloss::cli {

Json describe(const Diagnostic& diagnostic);

/// Keeps a copy of what it hands on.
class CopyingSink : public DiagnosticSink {
 public:
  explicit CopyingSink(DiagnosticSink& sink) : sink_(sink) {}
  void add(Diagnostic diagnostic) override {
    copies.push_back(describe(diagnostic));
    sink_.add(std::move(diagnostic));
  }
  Json copies = Json::array();

 private:
  DiagnosticSink& sink_;
};

}  // namespace isogloss::cli
