/// The checks of `isogloss validate`: what each has to work with, and what it finds.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isogloss/engine/cases.hpp"
#include "session.hpp"
#include "validate/shared_text.hpp"

namespace isogloss::cli {

using Clock = std::chrono::steady_clock;

enum class Level { must, should, note };

struct ValidateOptions {
  CommonOptions common;
  std::string dialect, pages;
  std::uint64_t seed = 1, blocks = 100'000;                            ///< of the plugin, over all its syntaxes
  std::uint32_t random_limit = 20;                                     ///< s, for the random blocks of the plugin
  std::uint32_t time_limit = 60, memory_limit = 2048, call_limit = 5;  ///< s, MiB, s
  std::uint64_t budget = 10'000;                                       ///< ns for one block of one syntax
};

struct Finding {
  std::string where;  ///< a syntax, an option, a case; may be empty
  std::string what;
};

/// One check at work on one plugin.
class Examination {
 public:
  struct Listener {
    std::function<void(const Finding&)> find;
    std::function<void(const std::string&)> remark;
    std::function<void(const std::string&)> skip;
  };
  /// `attempt` is borrowed; null: nobody reads it.
  Examination(const ValidateOptions& wanted, std::string plugin_file, SharedText* attempt, Listener listener)
      : options(wanted), file(std::move(plugin_file)), listener_(std::move(listener)), attempt_(attempt) {}

  const ValidateOptions& options;
  const std::string file;  ///< of the plugin
  bool may_fork = true;    ///< a part of the check may have a process of its own

  void find(std::string where, std::string what);
  std::size_t findings() const { return findings_; }
  /// How far the check went; beside the findings.
  void remark(const std::string& text) { listener_.remark(text); }
  /// The check cannot look at the plugin, and says so in place of "held".
  void skip(const std::string& why) { listener_.skip(why); }
  /// What the plugin is asked to do next: told with a crash, which ends the check.
  void attempt(std::string_view what);

 private:
  Listener listener_;
  std::size_t findings_ = 0;
  SharedText* attempt_;
};

struct Check {
  std::string_view name;
  Level level;
  std::string_view summary;
  std::string_view help;  ///< what to do when it fails
  /// Those of --seed, --blocks, --random-limit and --budget that change what the check does.
  std::span<const std::string_view> options;
  void (*run)(Examination&);
  bool is_alone = false;  ///< it measures times, which other checks beside it would make longer
};

/// In the order in which they run. When the first one fails, the others cannot run.
std::span<const Check> all_checks();

std::string_view to_string(Level level);

/// Whether the option, one of those that Check::options may name, changes what the check does.
bool has_use_for(const Check& check, std::string_view option);

// loading.cpp
void check_loads(Examination& e);
void check_descriptor(Examination& e);
void check_exports(Examination& e);
void check_unloads(Examination& e);
void check_load_time(Examination& e);
// declared.cpp
void check_documented(Examination& e);
void check_prefix(Examination& e);
void check_unused(Examination& e);
// blocks.cpp
void check_empty_block(Examination& e);
void check_absent_fields(Examination& e);
void check_extreme_values(Examination& e);
void check_finite_results(Examination& e);
void check_declarations(Examination& e);
void check_unchanged(Examination& e);
void check_time(Examination& e);
void check_waits(Examination& e);
// scanning.cpp
void check_scan(Examination& e);
// scanning_ahead.cpp
void check_scan_ahead(Examination& e);
// answers.cpp
void check_absent_answers(Examination& e);
void check_changed(Examination& e);
// importers.cpp
void check_importers(Examination& e);
// tables.cpp
void check_tables(Examination& e);
// reads.cpp
void check_unread(Examination& e);
// overruns.cpp
void check_overruns(Examination& e);
// texts.cpp
void check_texts(Examination& e);
// borrowed.cpp
void check_borrowed(Examination& e);
// elsewhere.cpp
void check_elsewhere(Examination& e);
// input_output.cpp
void check_input_output(Examination& e);
// memory.cpp
void check_allocations(Examination& e);
void check_memory(Examination& e);
// traces_left.cpp
void check_leaves_nothing(Examination& e);
void check_process_state(Examination& e);
void check_end(Examination& e);
// random_blocks.cpp
void check_random_blocks(Examination& e);
// repetition.cpp
void check_same_result(Examination& e);
void check_restart(Examination& e);
void check_two_chains(Examination& e);
void check_threads(Examination& e);
// statics.cpp
void check_statics(Examination& e);
// options.cpp
void check_options(Examination& e);
void check_without_services(Examination& e);
// surroundings.cpp
void check_cases(Examination& e);
void check_older_host(Examination& e);
void check_newer_host(Examination& e);

}  // namespace isogloss::cli
