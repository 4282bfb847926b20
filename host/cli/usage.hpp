/// What a command accepts, as data: manual pages and the completion of command lines are made from it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"

namespace isogloss::cli {

/// One option or operand of a command.
struct UsageItem {
  std::vector<std::string> names;  ///< "-d", "--dialect"; of an operand the word that stands for it: "PROGRAM"
  std::string value;               ///< what stands for the value: "DIALECT", "N"; empty for a flag
  std::vector<std::string> words;  ///< the only values that are accepted; empty: any
  std::string description, group, default_value;
  bool is_required = false, is_repeatable = false;
};

struct Usage {
  std::string name, description, example;
  std::vector<UsageItem> options, operands;
};

/// The usage of a command, which does nothing else.
Usage usage_of(const Command& command);

/// An option of all commands, which may stand before the command's name as well.
struct CommonOption {
  std::string_view name, value, summary;
};
inline constexpr CommonOption common_options[] = {
    {"--help", "", "what the command does, with an example"},
    {"--plugins", "DIR", "look for plugins there first (repeatable; then ISOGLOSS_PLUGIN_PATH, then the installation)"},
    {"--dialects", "DIR",
     "look for dialects there first (repeatable; then ISOGLOSS_DIALECT_PATH, then the installation)"},
    {"--machines", "DIR",
     "look for machines there first (repeatable; then ISOGLOSS_MACHINES, the user's configuration and beside the "
     "dialects)"},
    {"--version", "", "version of the host, of the contract and of the plugins"},
};

}  // namespace isogloss::cli
