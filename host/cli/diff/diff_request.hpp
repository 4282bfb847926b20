/// What `isogloss diff` was asked to compare.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "diff/motions.hpp"
#include "program_options.hpp"
#include "sandbox/untrusted.hpp"

namespace isogloss::cli::parting {

struct DiffRequest {
  CommonOptions common;
  ProgramOptions program;
  std::vector<std::string> programs;
  std::array<std::string, 2> dialects, machines;
  std::array<std::vector<std::string>, 2> sets;
  std::string against, tolerance_text, page;
  std::vector<std::string> ignored;
  bool motions = false, all = false, json = false;
  UntrustedOptions untrusted;

  void add_to(CommandLine& line);
  UntrustedWork untrusted_work() const;
  /// Which programs stand on which side; false, and reported, where that cannot be said.
  bool read_operands(Session& session);
  /// Empty, and reported, where the text of --tolerance is none.
  std::optional<Tolerance> read_tolerance(Session& session) const;

 protected:
  std::string second_;  // the program of side b; empty: that of side a

 private:
  bool has_sides() const;
};

}  // namespace isogloss::cli::parting
