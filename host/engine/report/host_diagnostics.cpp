// The host's own diagnostics. Codes are never reused.
#include "report/diagnostic_tables.hpp"

namespace isogloss {

const std::vector<DiagnosticInfo>& host_diagnostics() {
  static const std::vector<DiagnosticInfo> table = [] {
    std::vector<DiagnosticInfo> all = dialect_diagnostics();
    for (const auto part : {link_diagnostics, run_diagnostics}) {
      const std::vector<DiagnosticInfo> rows = part();
      all.insert(all.end(), rows.begin(), rows.end());
    }
    return all;
  }();
  return table;
}

}  // namespace isogloss
