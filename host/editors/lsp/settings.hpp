/// What the client configures, by initializationOptions or as the section "isogloss" of its configuration.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "protocol/framing.hpp"

namespace isogloss::editors {

struct Settings {
  // As the options of `isogloss run` of the same names.
  std::string dialect, machine, offsets, tools, variables, block_skip, program;
  std::vector<std::string> set, subprograms;
  bool optional_stop = false;

  bool shows_machine = true;       ///< inlay hints: machine coordinates
  bool shows_modal = true;         ///< inlay hints: motion code and feed that the line does not program
  bool formats_words = true;       ///< formatting: one blank between words
  bool formats_numbers = false;    ///< formatting: block numbers anew
  std::uint32_t number_step = 10;  ///< from block number to block number
  std::uint32_t budget_ms = 2000;  ///< for one run of a program
  std::uint32_t most_diagnostics = 1000;

  bool operator==(const Settings&) const = default;
};

/// The settings with what `json` changes. Each fault is a sentence in `faults`, and keeps the value that was there.
Settings with(Settings settings, const Json& json, std::vector<std::string>& faults);

}  // namespace isogloss::editors
