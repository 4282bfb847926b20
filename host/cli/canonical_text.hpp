/// What `run --emit canonical` takes: in whose words, which coordinates, how fine.
#pragma once

#include "isogloss/engine/canonical.hpp"
#include "session.hpp"

namespace isogloss::cli {

struct CanonicalRequest {
  std::string frame = "machine", tolerance = "0.001";
  ProgramText text;
  double tolerance_mm = 0.001;

  void add_to(CommandLine& line);
  /// Reads the words of the ISO dialect; false, and reported, where an option is wrong or there are none.
  bool prepare(const std::string& format, Session& session);
  CanonicalOptions options(bool exact, bool zero_moves) const;
};

}  // namespace isogloss::cli
