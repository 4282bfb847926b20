#include "validate/check.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace isogloss::cli {

std::span<const Check> all_checks() {
  using enum Level;
  using Options = std::span<const std::string_view>;
  static constexpr std::string_view names_of_seed[] = {"--seed"}, names_of_time[] = {"--seed", "--budget"},
                                    names_of_random_blocks[] = {"--seed", "--blocks", "--random-limit"};
  static constexpr Options no_option, with_seed = names_of_seed, of_time = names_of_time,
                                      of_random_blocks = names_of_random_blocks;
  static constexpr std::array checks{
      Check{"loads", must, "the library loads three times, and each time its entry answers",
            "Return the same static descriptor from ig_plugin_v1() each time, and let nothing else happen at loading.",
            no_option, check_loads},
      Check{"descriptor", must, "the descriptor is complete and consistent, ids and codes are well-formed and unique",
            "Correct the member of the descriptor that the finding names; host/abi/conventions.md has the forms of "
            "names.",
            no_option, check_descriptor},
      Check{"exports", must, "the entry is the only exported symbol",
            "Build with isogloss_add_plugin(), or with hidden visibility and a version script that names the entry "
            "alone.",
            no_option, check_exports},
      Check{"unloads", should, "the library leaves the memory when it is closed",
            "Build with -fno-gnu-unique and without -z nodelete; end threads and unregister handlers.", no_option,
            check_unloads},
      Check{"load-time", should, "loading takes at most 50 ms",
            "Move work from initializers and from the entry into create().", no_option, check_load_time, true},
      Check{"documented", should, "syntaxes have a page with a case; fields, options and diagnostics are explained",
            "Write the page, the case or the sentence that the finding names.", no_option, check_documented},
      Check{"prefix", should, "no other installed plugin has codes with the plugin's prefix",
            "Choose a prefix of your own for the codes of the plugin's diagnostics.", no_option, check_prefix},
      Check{"cases", must, "all cases of the pages hold",
            "Run `isogloss case PAGE.md` and correct the syntax or the page.", no_option, check_cases},
      Check{"declarations", must, "a syntax touches only fields that it declares, in cases and in full blocks",
            "Declare the field with the access that the syntax needs, or leave it alone.", no_option,
            check_declarations},
      Check{"unused-fields", note, "each field declared as written or taken is written or taken in a case",
            "Write a case in which the syntax writes or takes the field, or remove the declaration.", no_option,
            check_unused},
      Check{"unread-fields", note, "each field declared as read is read in a case, a full or a random block",
            "Remove the declaration, or write a case in which the syntax reads the field.", with_seed, check_unread},
      Check{"changed", note, "a build that answers changed has written, taken or reported something",
            "Return IG_UNCHANGED when the syntax did nothing: other checks and hosts rely on the status.", with_seed,
            check_changed},
      Check{"unchanged", must, "a build that answers unchanged changed nothing, and its status is one of the contract",
            "Return IG_CHANGED whenever the syntax wrote or took something, also when it reported an error.", no_option,
            check_unchanged},
      Check{"empty-block", must, "an empty block does no harm",
            "Look at what get() and take() answer before the value is used.", no_option, check_empty_block},
      Check{"absent-fields", must, "each declared field may be absent, one at a time",
            "Look at what get() answers for this field before its value is used.", no_option, check_absent_fields},
      Check{"absent-answers", must, "what *out holds after the answer 0 is not used",
            "Look at the answer of get(), take() and their kin, and give *out a meaning only where it is 1.", with_seed,
            check_absent_answers},
      Check{"extreme-values", must, "NaN, infinity, 1e308, huge texts and texts that are not UTF-8 do no harm",
            "Compare the value with its bounds before it becomes an index, a size or a number of repeats.", no_option,
            check_extreme_values},
      Check{"finite-results", note, "no field gets NaN or infinity, also where a word is 1e308",
            "Compare the word with its bounds, and report a diagnostic instead of a result.", no_option,
            check_finite_results},
      Check{"overruns", must, "a block makes the plugin write nowhere beside the memory that it has allocated",
            "Compare an index with both of its bounds, also one that came from a number too large for its type.",
            with_seed, check_overruns},
      Check{"texts", must, "a text is read to its end and no further, and not after the call",
            "A text of the host is not terminated and is gone after the call: use its size, and copy what is kept.",
            with_seed, check_texts},
      Check{"scan", must, "a scanner stays in the text, whatever follows the byte at which it is asked",
            "Compare the position with the size before each byte, and declare the words that the scanner writes.",
            no_option, check_scan},
      Check{
          "scan-ahead", must,
          "what a scanner finds ahead of the block's turn, on another instance, is what it would find in it",
          "Ask is_in_turn() before the scanner keeps something for build() or does something outside the block, or do "
          "not declare that it may be asked ahead.",
          with_seed, check_scan_ahead},
      Check{"borrowed", must, "what a call lends (block, functions, ids, texts) is not used after the call",
            "Use the block and the host of the present call; copy ids, options and texts in create().", with_seed,
            check_borrowed},
      Check{"options", must, "options work at their bounds, between them and together, and are refused beyond them",
            "Give the option the bounds that the syntax needs, and declare what it touches under each value.",
            with_seed, check_options},
      Check{"same-result", must, "a block gives the same result twice",
            "Keep state in *self and forget it in restart(); use no globals, no clock and no random numbers.",
            no_option, check_same_result},
      Check{"elsewhere", must, "locale, folder, environment, clock and place in memory change no result",
            "Read and write numbers without the locale (from_chars, to_chars); use no clock, environment or address.",
            no_option, check_elsewhere},
      Check{"restart", must, "a second run of one chain gives what the first gave",
            "Let restart() forget everything that a run leaves in *self, also after a block with an error.", with_seed,
            check_restart},
      Check{"two-chains", must, "two chains do not influence each other, also with other options and other ids",
            "Keep what the syntax needs in *self, never in globals or static variables.", with_seed, check_two_chains},
      Check{"statics", must, "a build writes to no static variable, nor to what one points to",
            "Keep what the syntax needs in *self, never in globals or static variables.", with_seed, check_statics},
      Check{"threads", must, "chains on two threads do not influence each other",
            "Keep what the syntax needs in *self, never in globals or static variables.", no_option, check_threads},
      Check{"importers", must, "foreign, empty, huge, cut and damaged files and option bounds do an importer no harm",
            "Look at the size of the text and at each value before it becomes a row; refuse a file with a reason.",
            with_seed, check_importers},
      Check{"tables", must, "options and cells at their bounds and odd questions do a dependency no harm",
            "Refuse in row_fault() what means nothing, and answer 0 where a service has no answer.", no_option,
            check_tables},
      Check{"without-services", must, "without a service, a syntax refuses with a reason or works",
            "Declare the service as required, or test the answer of service() for NULL.", with_seed,
            check_without_services},
      Check{"older-host", must, "the plugin works with a host of minor version 0",
            "Compare struct_size of the host's table with the member before a function newer than 1.0 is called.",
            no_option, check_older_host},
      Check{"newer-host", must, "the plugin works with a host of a newer minor version",
            "Accept a table that is larger, and flags that are unknown.", no_option, check_newer_host},
      Check{"random-blocks", must, "random blocks do no harm and keep the contract",
            "The finding shows the smallest block that fails: give it to `isogloss apply SYNTAX`.", of_random_blocks,
            check_random_blocks},
      Check{"memory", must, "memory does not grow with the number of blocks, and a destroyed chain leaves none behind",
            "Free in destroy() what create() allocated, and keep nothing for each block.", with_seed, check_memory},
      Check{"allocations", should, "a build allocates nothing once it has seen its blocks",
            "Keep buffers in *self and let them grow in the first blocks; pass texts on as views.", with_seed,
            check_allocations},
      Check{"leaves-nothing", must, "no thread, process or open file is left when the chains are destroyed",
            "A syntax starts no thread and no process; what create() opens, destroy() closes.", with_seed,
            check_leaves_nothing},
      Check{"end", must, "the process ends by itself after the plugin was at work",
            "Register nothing with atexit(), and let static objects need nothing that is gone.", with_seed, check_end},
      Check{"process-state", must,
            "locale, environment, rounding, signals, limits and folder of the process stay as they were",
            "Read and write numbers without the locale; link without -ffast-math, which changes the processor's mode.",
            with_seed, check_process_state},
      Check{"input-output", must, "a build asks the system for nothing; nothing goes to standard output",
            "Report a diagnostic in place of a print; read files in create(); use no lock, clock or random number.",
            with_seed, check_input_output},
      Check{"waits", must, "a build does not wait: no sleep, no lock, no file",
            "Read files in create(), and let build() work with what *self holds.", with_seed, check_waits, true},
      Check{"time", should,
            "one block costs no more than the budget, 1 us for each random field and record, and 3 us for each "
            "diagnostic",
            "Prepare in create() what does not depend on the block; --budget sets the limit.", of_time, check_time,
            true}};
  return checks;
}

std::string_view to_string(Level level) {
  return level == Level::must ? "must" : level == Level::should ? "should" : "note";
}

bool has_use_for(const Check& check, std::string_view option) {
  return std::find(check.options.begin(), check.options.end(), option) != check.options.end();
}

void Examination::find(std::string where, std::string what) {
  ++findings_;
  listener_.find({std::move(where), std::move(what)});
}

void Examination::attempt(std::string_view what) {
  if (attempt_ != nullptr) attempt_->write(what);
}

}  // namespace isogloss::cli
