/// Which programs a batch runs.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "session.hpp"

namespace isogloss::cli::batch {

struct ProgramPlaces {
  std::vector<std::string> places;            ///< programs, folders with all that is below them, and lists
  std::string list;                           ///< a file with a path in each line; "-": standard input; empty: none
  std::vector<std::string> include, exclude;  ///< patterns of the shell for the path below the folder, or its last part
  std::string results;                        ///< a folder that is not looked into
  bool are_strangers = false;                 ///< a file of `places` names no others: that is for `list` alone
};

struct ProgramList {
  std::vector<std::string> programs;  ///< sorted by name, each once
  std::uint64_t left_out = 0;         ///< entries of the folders that are no programs
  bool has_folders = false;
  std::set<std::string> used_patterns;  ///< of --include and --exclude
};

/// Files and folders whose names begin with a dot, XML files, files with NUL bytes at their head, links, pipes and the
/// like are no programs. A folder that cannot be read is reported, and the others are; so is a pattern that fits
/// nothing. Empty, and reported, when a place does not exist, nothing is left, or there is no folder for the patterns.
std::optional<ProgramList> list_programs(const ProgramPlaces& wanted, Session& session);

/// Part `number` of `count`, counted from 1: the programs are dealt out by their names, so every part knows its own.
std::vector<std::string> part_of(const std::vector<std::string>& programs, std::uint64_t number, std::uint64_t count);

}  // namespace isogloss::cli::batch
