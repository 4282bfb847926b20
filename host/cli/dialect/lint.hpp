/// The checks of `isogloss lint`, for whoever shows them.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "session.hpp"

namespace isogloss::cli {

struct Linted {
  std::optional<Dialect> dialect;         ///< empty: it could not be read
  std::unique_ptr<LinkedDialect> linked;  ///< null: it could not be linked
  bool starts = false;                    ///< each syntax and each table accepts what the dialect gives it
};

/// Reads, links and starts the dialect or machine; everything that is wrong or has no effect goes to `sink`.
Linted lint_dialect(const std::string& name, Session& session, DiagnosticSink& sink);

}  // namespace isogloss::cli
