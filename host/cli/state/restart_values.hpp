/// What the rows of a preamble ask: fields of the state, what is computed from them, and how a value is written.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "state/program_point.hpp"

namespace isogloss::cli {

/// The fields of a state by their paths: names without quotes, numbers as JSON.
using StateFields = std::map<std::string, std::string, std::less<>>;

/// Do the conditions hold? "PATH" is there, "!PATH" is not, "PATH=A|B", "PATH!=A", "PATH=@OTHER" as the field OTHER,
/// "PATH>0" and "PATH<0"; numbers by value; A* is a text that begins with A.
bool holds(std::string_view when, const StateFields& state);

/// The values that a row may name: fields of the state, and besides them LINE, PROGRAM, ClearLevel.X .Y .Z, "Last G60
/// G64" for the last one of these codes, and of each frame that shifts, turns, scales and mirrors Frame.SOURCE.X .Y .Z
/// .RX .RY .RZ .SX .SY .SZ .MX .MY .MZ. ProgramXyz holds only axes whose position the program has given;
/// MachinePlace.X .Y .Z those that it has sent to a place of the machine, Reference.X .Y .Z, which are 0, those at the
/// reference point. ProgramXyz.InXY and so on are 1 where one of the two axes is there.
/// ToolChange.SpindleToolName and .ToolName are the names by which the program has called these tools.
class RestartValues {
 public:
  RestartValues(const ProgramPoint& point, const ProgramLines& lines, const Layout& layout);
  const StateFields& state() const { return state_; }

  /// A value for BlockTemplate::fill(). Formats, separated by blanks: "n" has no needless decimal point, "+" a sign,
  /// "length" is in the unit of the program, "*10" times ten, "behind TEXT" what follows TEXT in it, "blocks" the
  /// blocks of the program that have set the value, or the values that begin so: PATH.*; "parts" each with its further
  /// parts, ProgramLines::parts()
  bool operator()(std::string_view name, std::string_view format, std::string& out) const;

 private:
  bool write_number(std::string_view name, std::string_view format, double value, std::string& out) const;
  bool write_blocks(std::string_view name, std::string_view format, std::string& out) const;

  const ProgramPoint& point_;
  const ProgramLines& lines_;
  const Layout& layout_;
  StateFields state_;
  bool is_inch_ = false;
};

}  // namespace isogloss::cli
