#include "validate/check.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace isogloss::cli {

std::span<const Check> all_checks() {
  using enum Level;
  static constexpr std::array checks{
      Check{"loads", must, "the library loads three times, and each time its entry answers", check_loads},
      Check{"descriptor", must, "the descriptor is complete and consistent, ids and codes are well-formed and unique",
            check_descriptor},
      Check{"exports", must, "the entry is the only exported symbol", check_exports},
      Check{"unloads", should, "the library leaves the memory when it is closed", check_unloads},
      Check{"load-time", should, "loading takes at most 50 ms", check_load_time},
      Check{"documented", should, "syntaxes have a page with a case; fields, options and diagnostics are explained",
            check_documented},
      Check{"prefix", should, "no other installed plugin has codes with the plugin's prefix", check_prefix},
      Check{"cases", must, "all cases of the pages hold", check_cases},
      Check{"declarations", must, "a syntax touches only fields that it declares, in cases and in full blocks",
            check_declarations},
      Check{"unused-fields", note, "each field declared as written or taken is written or taken in a case",
            check_unused},
      Check{"unchanged", must, "a build that answers unchanged changed nothing, and its status is one of the contract",
            check_unchanged},
      Check{"empty-block", must, "an empty block does no harm", check_empty_block},
      Check{"absent-fields", must, "each declared field may be absent, one at a time", check_absent_fields},
      Check{"extreme-values", must, "NaN, infinity, 1e308 and huge texts in declared fields do no harm",
            check_extreme_values},
      Check{"options", must, "options work at their bounds, and beyond them are refused", check_options},
      Check{"same-result", must, "a block gives the same result twice", check_same_result},
      Check{"restart", must, "a second run of one chain gives what the first gave", check_restart},
      Check{"two-chains", must, "two chains at once do not influence each other", check_two_chains},
      Check{"threads", must, "chains on two threads do not influence each other", check_threads},
      Check{"without-services", must, "without a service, a syntax refuses with a reason or works",
            check_without_services},
      Check{"older-host", must, "the plugin works with a host of minor version 0", check_older_host},
      Check{"newer-host", must, "the plugin works with a host of a newer minor version", check_newer_host},
      Check{"random-blocks", must, "random blocks do no harm and keep the contract", check_random_blocks},
      Check{"time", should, "one block costs one syntax no more than the budget", check_time}};
  return checks;
}

std::string_view to_string(Level level) {
  return level == Level::must ? "must" : level == Level::should ? "should" : "note";
}

void Examination::find(std::string where, std::string what) {
  ++findings_;
  tell_({std::move(where), std::move(what)});
}

void Examination::attempt(std::string_view what) {
  if (room_ == 0) return;
  const std::size_t size = std::min(what.size(), room_ - 1);
  std::memcpy(attempt_, what.data(), size);
  attempt_[size] = '\0';
}

}  // namespace isogloss::cli
