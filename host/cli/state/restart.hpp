/// The preamble of a restart at a line, or at the nearest line before it that can be restored.
#pragma once

#include "session.hpp"
#include "state/preamble.hpp"
#include "state/restart_check.hpp"

namespace isogloss::cli {

class Restart {
 public:
  /// All of them must live as long as this does.
  Restart(Session& session, const LinkedDialect& linked, const std::string& text, const std::string& path,
          const ProgramLines& lines, const RunOptions& options);

  /// The blocks that restore the state at the point, proved by running them with the rest; nothing where none do: then
  /// the session has reported why.
  std::optional<std::string> write(const ProgramPoint& point, bool takes_nearest);
  /// Where the rest begins.
  std::uint32_t line() const { return line_; }

 private:
  struct Trial {
    std::string preamble;
    std::vector<Diagnostic> faults;  ///< errors: it does not restore; warnings and notes: it does
    bool is_good() const;
  };
  Trial attempt(const ProgramPoint& point) const;
  std::string set_by(const ProgramLine& line) const;
  std::string cause_of_difference(const std::vector<StateDifference>& differences) const;
  void add_outcome(const RestartCheck& check, const ProgramPoint& point, Trial& out) const;
  /// The dialect says of fields that begin so that they only tell of the past.
  bool is_past(std::string_view path, const StateFields& state) const;
  std::optional<std::string> write_nearest(const ProgramPoint& point);

  Session& session_;
  const LinkedDialect& linked_;
  const std::string& text_;
  const std::string& path_;
  const ProgramLines& lines_;
  const RunOptions& options_;
  ProgramText words_;
  std::uint32_t line_ = 0;
};

}  // namespace isogloss::cli
