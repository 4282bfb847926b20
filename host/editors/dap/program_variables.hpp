/// The variables that a run has read or written so far, as the program writes their names.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "dap/expression.hpp"
#include "isogloss_provenance.h"

namespace isogloss::dap {

struct VariableUse {
  std::string name;
  std::uint64_t scope = 0;
  Value value{};
  bool is_write = false;
};

class ProgramVariables : public VariableSource {
 public:
  struct Variable {
    std::string name;
    std::uint64_t scope = 0;  ///< 0: one for the whole program; otherwise of a call
    std::uint64_t call = 0;   ///< that has used it last (NextBlock::call)
    std::uint64_t used = 0;   ///< rises with each use
    Value value{};
  };

  /// A local variable is looked for in this call first.
  void enter(std::uint64_t call) { call_ = call; }
  void note(const VariableUse& use, std::uint64_t call);
  /// In the call that runs, or where it was used last.
  Value value_of(std::string_view name) const override;
  const Variable* find(std::string_view name) const;
  /// By name; of a call: its own, else those of the whole program.
  std::vector<const Variable*> of_program() const;
  std::vector<const Variable*> of_call(std::uint64_t call) const;
  void clear() { all_.clear(); }

  /// Further names cost no memory: they are not listed.
  static constexpr std::size_t most = 100'000;

 private:
  struct Less {
    using is_transparent = void;
    bool operator()(const std::pair<std::string, std::uint64_t>& a,
                    const std::pair<std::string, std::uint64_t>& b) const;
    bool operator()(const std::pair<std::string, std::uint64_t>& a, std::string_view b) const;
    bool operator()(std::string_view a, const std::pair<std::string, std::uint64_t>& b) const;
  };
  std::map<std::pair<std::string, std::uint64_t>, Variable, Less> all_;
  std::uint64_t call_ = 0, uses_ = 0;
};

Value value_of_argument(const ig_argument* value);

}  // namespace isogloss::dap
