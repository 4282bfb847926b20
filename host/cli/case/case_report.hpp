/// What came out of the cases of pages, for people, for programs and for build servers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "diagnostic_json.hpp"

namespace isogloss::cli {

struct CaseOutcome {
  std::string heading;
  std::uint32_t line;
  std::string difference;  ///< empty: the case holds
  double seconds;
};

struct CasePage {
  std::string file, syntax;
  Json faults;  ///< diagnostics of the page itself
  std::vector<CaseOutcome> cases;
};

std::string cases_as_text(const std::vector<CasePage>& pages);
/// schemas/case.schema.json
std::string cases_as_json(const std::vector<CasePage>& pages);
/// A test suite for each page; a fault of the page is an error of the suite.
std::string cases_as_junit(const std::vector<CasePage>& pages);

}  // namespace isogloss::cli
