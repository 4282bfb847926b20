/// Where a run stops: lines, conditions that become true, diagnostics. A table never changes once the run has it.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dap/expression.hpp"

namespace isogloss::dap {

/// "5": the fifth time alone; ">= 5", "> 5", "< 5", "<= 5"; "% 5": every fifth time.
class HitCondition {
 public:
  /// Or a sentence that says what is wrong.
  static std::variant<HitCondition, std::string> parse(std::string_view text);
  bool holds(std::uint64_t hits) const;

 private:
  enum class Kind : std::uint8_t { equal, at_least, more, at_most, less, every } kind_ = Kind::equal;
  std::uint64_t number_ = 1;
};

/// "tool at Z{Z}": text with expressions in braces; {{ and }} are braces.
class LogMessage {
 public:
  static std::variant<LogMessage, std::string> parse(std::string_view text, const Layout& layout);
  std::string fill(const Scene& scene, const VariableSource& variables) const;

 private:
  struct Piece {
    std::string text;
    std::optional<Expression> expression;
  };
  std::vector<Piece> pieces_;
};

struct Breakpoint {
  int id = 0;
  std::optional<Expression> condition;
  std::optional<HitCondition> hits;
  std::optional<LogMessage> log;  ///< instead of a stop
};

/// A condition alone: the run stops when it becomes true.
struct LogicBreakpoint {
  int id = 0;
  Expression expression;
  std::optional<Expression> condition;
  std::optional<HitCondition> hits;
};

struct BreakpointTable {
  /// By file, as canonical paths, and line.
  std::map<std::string, std::map<std::uint32_t, std::vector<Breakpoint>>> lines;
  std::vector<LogicBreakpoint> logic;
  bool stops_at_errors = false, stops_at_warnings = false;
};

/// The path by which files are compared.
std::string canonical_path(const std::string& path);

}  // namespace isogloss::dap
