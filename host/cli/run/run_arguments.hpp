/// What `isogloss run` was asked for.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "canonical_text.hpp"
#include "isogloss/engine/exporter.hpp"
#include "program_options.hpp"
#include "reproducer.hpp"
#include "run/run_budgets.hpp"
#include "sandbox/untrusted.hpp"
#include "table_saver.hpp"

namespace isogloss::cli {

struct RunArguments {
  CommonOptions common;
  ProgramOptions program;
  std::vector<std::string> programs;
  std::string emit, format = "jsonl", output;
  bool summary = false, header = false, exact = false, zero_moves = false, checked = false, call_all = false,
       json = false;
  ReproducerRequest reproducer;
  RunBudgets budgets;
  std::uint64_t scan_ahead = 20'000;
  UntrustedOptions untrusted;
  std::vector<std::string> save_table;
  std::vector<TableRequest> tables_to_save;
  CanonicalRequest canonical;
  /// Takes the summary of each program, where it is not to be written.
  std::function<void(const std::string& program, const std::string& dialect, const Summary& summary)> takes_summary;
};

}  // namespace isogloss::cli
