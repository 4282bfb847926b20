/// Follows fields of the block document through a run: each block that changes one of them.
#pragma once

#include <functional>
#include <string>

#include "isogloss/engine/runner.hpp"

namespace isogloss {

/// One change of one field. The views are alive until the call returns.
struct FollowedChange {
  std::string_view file;
  std::uint32_t line = 0;     ///< from 1; 0: before the first block
  std::string_view text;      ///< of the block
  std::string_view path;      ///< "Feedrate.FeedrateValue"
  std::string before, after;  ///< JSON text; empty: absent
  std::string_view writer;    ///< syntax, by alias; empty: the dialect's initial state, or nobody: the value has ended
};

/// The fields at this path and below it that can be followed: values and transforms, no words, no lists.
std::vector<ig_field> fields_to_follow(const Layout& layout, std::string_view path);

/// Runs the program at full speed. Modal values are told when they change, values of one block in each block that has
/// them. `told` returns false to end the run.
RunResult follow(const LinkedDialect& linked, Source& source, const std::string& name,
                 const std::vector<ig_field>& fields, const std::function<bool(const FollowedChange&)>& told,
                 const RunOptions& options, DiagnosticSink& sink);

}  // namespace isogloss
