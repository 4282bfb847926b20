#include "run/run_budgets.hpp"

#include <unistd.h>

#include <fstream>

namespace isogloss::cli {

namespace {

/// Resident memory of the process; 0 where the system does not tell it.
std::uint64_t resident_mib() {
  std::uint64_t size = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> size >> resident;
  return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) >> 20;
}

}  // namespace

void RunBudgets::add_to(CommandLine& line) {
  line.option("--max-output", output_bytes, "Stop after this much output").type_name("BYTES").shows_default();
  line.option("--max-memory", memory_mib, "Stop when the run needs more memory").type_name("MIB").shows_default();
  line.option("--max-diagnostics", diagnostics, "Stop after N diagnostics, checked every 65536 blocks")
      .type_name("N")
      .shows_default();
}

bool RunBudgets::hold(const std::string& program, Session& session) const {
  if (session.diagnostics().limit_reached()) return false;  // which the end of the run reports
  if (session.diagnostics().number() > diagnostics) {
    session.report("IG-0454", {program}, {std::to_string(session.diagnostics().number())});
    return false;
  }
  if (resident_mib() > memory_mib) {
    session.report("IG-0453", {program}, {std::to_string(memory_mib)});
    return false;
  }
  return true;
}

}  // namespace isogloss::cli
