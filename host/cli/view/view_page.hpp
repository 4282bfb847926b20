/// The page: everything that it shows stands in it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "path_run.hpp"

namespace isogloss::cli::viewing {

struct PageOptions {
  std::uint32_t explained_lines = 2'000;  ///< a program with more lines is not explained in the page
  std::optional<std::uint64_t> version;   ///< of a page that a server shows: it asks for explanations, and reloads
};

/// A program in one dialect or two.
struct Viewed {
  std::unique_ptr<KeptProgram> program;
  std::vector<std::unique_ptr<PathRun>> runs;
  std::vector<PathDifference> differences;
  std::vector<std::string> files;  ///< the main program first
};

std::string make_page(const Viewed& viewed, const PageOptions& options, Session& session);

/// What the browser must not do with a page, as the header Content-Security-Policy has it.
std::string security_policy(bool is_served);

}  // namespace isogloss::cli::viewing
