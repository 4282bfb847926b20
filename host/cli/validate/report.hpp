/// What `validate` writes: for people, for programs, for continuous integration.
#pragma once

#include "validate/child.hpp"

namespace isogloss::cli {

struct PluginOutcome {
  std::string file;
  std::vector<Outcome> checks;
};

std::string as_text(const std::vector<PluginOutcome>& plugins, const ValidateOptions& options);
/// {"Isogloss": 1, "Seed": 1, "Plugins": [{"File", "Checks": [{"Name", "Level", "Result", "Seconds", "Findings"}]}]}; a
/// check may have "Reason" (skipped), "FurtherFindings" and "Remarks", too.
std::string as_json(const std::vector<PluginOutcome>& plugins, const ValidateOptions& options);
/// One testsuite for each plugin, one testcase for each check; a failed note is no failure.
std::string as_junit(const std::vector<PluginOutcome>& plugins);
/// SARIF 2.1.0: each check is a rule, each finding a result at the file of the plugin.
std::string as_sarif(const std::vector<PluginOutcome>& plugins);

}  // namespace isogloss::cli
