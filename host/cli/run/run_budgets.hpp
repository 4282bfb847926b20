/// The resources that a run may use.
#pragma once

#include <cstdint>
#include <string>

#include "session.hpp"

namespace isogloss::cli {

struct RunBudgets {
  std::uint64_t output_bytes = std::uint64_t{1} << 34;
  std::uint64_t memory_mib = 4096;
  std::uint64_t diagnostics = 1'000'000;

  void add_to(CommandLine& line);
  /// False when memory, errors or diagnostics are used up.
  bool hold(const std::string& program, Session& session) const;
};

}  // namespace isogloss::cli
