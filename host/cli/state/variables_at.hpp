/// The variables of a program at a line: what it has assigned before, and which of them it reads behind.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <isogloss.h>

#include "isogloss/engine/document.hpp"
#include "isogloss/engine/explain.hpp"

namespace isogloss::cli {

struct VariableAt {
  std::string name;       ///< as a program writes it: "#101", "R5", "QS1"
  std::string value;      ///< JSON text; empty: it has none
  ProgramLine first;      ///< assigned it first: where a language defines variables, the definition
  ProgramLine last;       ///< assigned it last
  bool is_local = false;  ///< of the main program alone
  bool is_read = false;   ///< by the run behind the line, before it is assigned again
};

/// Follows a run. Local variables of called programs are not kept: they end with the call.
class VariablesAt {
 public:
  void use(const BlockSource& where, bool is_write, std::string_view name, std::uint64_t scope, bool is_called,
           const ig_argument* value);
  /// The run has come to the line.
  void pass() {
    is_behind_ = true;
    open_ = known_.size();
  }
  bool is_behind() const { return is_behind_; }
  /// Behind the line, and of each variable the run has shown whether it is read.
  bool is_decided() const { return is_behind_ && open_ == 0; }
  /// By their names, numbers in them by value.
  std::vector<VariableAt> all() const;

 private:
  struct Known {
    VariableAt at;
    bool is_decided = false;
  };
  static constexpr std::size_t most_variables = 100'000;
  bool is_behind_ = false;
  std::size_t open_ = 0;
  std::map<std::string, Known, std::less<>> known_;
};

}  // namespace isogloss::cli
