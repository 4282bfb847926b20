/// What `run --emit canonical` takes: in whose words, which coordinates, how fine.
#pragma once

#include "isogloss/engine/canonical.hpp"
#include "isogloss/engine/chain.hpp"
#include "session.hpp"

namespace isogloss::cli {

struct CanonicalRequest {
  std::string frame = "machine", tolerance = "0.001";
  ProgramText text;
  double tolerance_mm = 0.001;

  void add_to(CommandLine& line);
  /// Reads the words of the ISO dialect, with the rows that the user gives; false, and reported, where an option is
  /// wrong or there are none.
  bool prepare(const std::string& format, const ChainSettings& settings, Session& session);
  static ChainSettings own_words(const LinkedDialect& words, const ChainSettings& settings);
  CanonicalOptions options(bool exact, bool zero_moves) const;
};

}  // namespace isogloss::cli
