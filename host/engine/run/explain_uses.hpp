/// What the block at work has read, written and examined so far: variables and conditions.
#pragma once

#include "isogloss/engine/explain.hpp"
#include "run/variable_log.hpp"

namespace isogloss {

class BlockUses {
 public:
  /// What earlier blocks have used is forgotten.
  void begin(std::uint64_t block) {
    if (block != block_) variables_.clear(), written_.clear(), conditions_.clear();
    block_ = block;
  }
  /// What the block reads is looked up before it writes: a variable that counts itself up was written earlier.
  void read(const Chain& chain, const VariableLog& log, std::string_view name, std::uint64_t scope,
            const ig_argument* value) {
    if (find(variables_, name) == variables_.end() && variables_.size() < most)
      variables_.push_back(log.read(chain, name, scope, value));
  }
  void write(std::string_view name, const ig_argument* value) {
    if (const auto known = find(written_, name); known != written_.end())
      known->value = VariableLog::value_of(value);
    else if (written_.size() < most)
      written_.push_back({std::string(name), VariableLog::value_of(value), "", {}, ""});
  }
  void examine(std::string_view text, std::uint32_t outcome) {
    ExplainedCondition condition{std::string(text), outcome == IG_CONDITION_HOLDS, outcome == IG_CONDITION_TELLS};
    const bool is_known = !conditions_.empty() && conditions_.back() == condition;
    if (!is_known && conditions_.size() < most) conditions_.push_back(std::move(condition));
  }
  void give_to(ExplainedBlock& block, std::uint64_t number) const {
    if (number != block_) return;
    block.variables = variables_;
    block.written = written_;
    block.conditions = conditions_;
  }

 private:
  static constexpr std::size_t most = 1'000;
  using List = std::vector<ExplainedVariable>;
  static List::iterator find(List& list, std::string_view name) {
    return std::find_if(list.begin(), list.end(), [&](const ExplainedVariable& v) { return v.name == name; });
  }
  std::uint64_t block_ = 0;
  List variables_, written_;
  std::vector<ExplainedCondition> conditions_;
};

}  // namespace isogloss
