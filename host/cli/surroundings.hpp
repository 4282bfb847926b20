/// What apply and case put around a syntax.
#pragma once

#include "isogloss/engine/cases.hpp"
#include "session.hpp"

namespace isogloss::cli {

struct SurroundingOptions {
  std::string dialect, machine;

  void add_to(CommandLine& line);
  /// Loads every plugin; empty, and reported, when a dialect was named and cannot be read.
  std::optional<Surroundings> make(Session& session) const;
};

}  // namespace isogloss::cli
