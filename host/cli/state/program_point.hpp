/// What is in force where a run comes to a line: the state of the block before it, variables, tables, and what a
/// restart there needs to know.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <isogloss_flow.h>

#include "isogloss/engine/explain.hpp"
#include "state/axis_places.hpp"
#include "state/clear_level.hpp"
#include "state/program_lines.hpp"
#include "state/seen_codes.hpp"
#include "state/tool_names.hpp"
#include "state/variables_at.hpp"

namespace isogloss::cli {

struct ProgramPoint {
  ExplainedBlock block;                           ///< the first one of the line
  std::uint64_t blocks_before = 0;                ///< of the run, in whatever file
  std::vector<VariableAt> variables;              ///< that the run has assigned, as they are now
  std::vector<DependencyElement> changed_tables;  ///< rows that the run has changed
  ClearLevel::Point clear_level;                  ///< from where a rapid need not end in material
  ClearLevel::Point place;                        ///< program coordinates, where ProgramXyz is of an earlier frame
  AxisPlaces::Places places{};                    ///< who has given the position of each axis
  ToolNames tools;                                ///< that the run has called by name
  SeenCodes codes;                                ///< that the run has executed
  std::vector<std::uint32_t> lines_before;  ///< of the main program, run once and in this order; the last ones alone
};

/// Runs the program, named `name`, up to the target; empty when the run does not come there, and `reach` tells why.
/// `lines` learns which lines of it hold one block together.
std::optional<ProgramPoint> find_point(const LinkedDialect& linked, const std::string& text, const std::string& name,
                                       const ExplainTarget& target, const RunOptions& options, DiagnosticSink& sink,
                                       ExplainReach& reach, ProgramLines* lines = nullptr);

/// Counts blocks as they are finished, and knows variables and tables when the one at the line comes. Then the run goes
/// on, since what it still reads shows which variables a restart needs.
class PointFinder : public Exporter {
 public:
  PointFinder(std::uint32_t line, std::string file, ProgramLines* lines);
  /// Listens to the chain from its start on.
  void listen(Chain& chain);
  void begin(Document& initial, const SymbolTable& symbols) override;
  bool block(Document& document, const SymbolTable& symbols) override;
  bool end() override { return true; }

  /// Gives what has been found to `out`, once the run has ended.
  void tell(ProgramPoint& out);

 private:
  using Rows = std::map<std::string, std::map<std::string, std::string>>;  // row, column, text
  static Rows rows_of(const DependencyTable& table);
  bool is_at_line(const BlockSource& source) const;
  void notice(const BlockSource& source);
  void find_changes();
  void note_line(const BlockSource& source);

  std::uint32_t line_;
  std::string file_, main_file_;
  ProgramLines* lines_;
  Chain* chain_ = nullptr;
  const ig_flow_1* flow_ = nullptr;
  bool is_found_ = false;
  std::uint64_t blocks_before_ = 0;
  VariablesAt variables_;
  ClearLevel clear_level_;
  AxisPlaces axis_places_;
  ToolNames tools_;
  SeenCodes codes_;
  std::vector<DependencyElement> changed_tables_;
  std::map<std::uint32_t, std::uint32_t> times_;  // that a line of the main program was run
  std::vector<std::uint32_t> order_;
  std::map<std::string, Rows> before_;
};

}  // namespace isogloss::cli
