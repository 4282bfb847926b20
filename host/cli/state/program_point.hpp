/// What is in force where a run comes to a line: the state of the block before it, variables, and changed tables.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "isogloss/engine/explain.hpp"

namespace isogloss::cli {

struct ProgramPoint {
  ExplainedBlock block;                                     ///< the first one of the line
  std::uint64_t blocks_before = 0;                          ///< of the run, in whatever file
  std::map<std::int64_t, std::optional<double>> variables;  ///< that the run has assigned, as they are now; empty: null
  std::vector<DependencyElement> changed_tables;            ///< rows that the run has changed
};

/// Runs the program, named `name`, up to the target; empty when the run does not come there, and `reach` tells why.
std::optional<ProgramPoint> find_point(const LinkedDialect& linked, const std::string& text, const std::string& name,
                                       const ExplainTarget& target, const RunOptions& options, DiagnosticSink& sink,
                                       ExplainReach& reach);

/// Counts blocks as they are finished, and knows variables and tables when the one at the line comes.
class PointFinder : public Exporter {
 public:
  PointFinder(std::uint32_t line, std::string file) : line_(line), file_(std::move(file)) {}
  void begin(Document& initial, const SymbolTable& symbols) override;
  bool block(Document& document, const SymbolTable& symbols) override;
  bool end() override { return true; }

  std::uint64_t blocks_before = 0;
  bool is_found = false;
  std::map<std::int64_t, std::optional<double>> variables;
  std::vector<DependencyElement> changed_tables;

 private:
  using Rows = std::map<std::string, std::map<std::string, std::string>>;  // row, column, text
  static Rows rows_of(const DependencyTable& table);
  void find_changes();

  std::uint32_t line_;
  std::string file_;
  Chain* chain_ = nullptr;
  ig_field variable_ = IG_NO_FIELD, value_ = IG_NO_FIELD;
  std::map<std::string, Rows> before_;
};

}  // namespace isogloss::cli
