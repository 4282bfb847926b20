/// What all results of a batch depend on, besides the programs themselves.
#pragma once

#include "batch/batch_arguments.hpp"
#include "batch/content_hash.hpp"

namespace isogloss::cli::batch {

struct Surroundings {
  std::string hash;
  std::map<std::string, std::string> files;  ///< and the hash of each
};

/// Whether a chain is made as well, which alone tells what the tables do not take. A plugin may crash or hang there: it
/// must not do so in the process that watches over a batch.
enum class Trial : std::uint8_t { none, of_chain };

/// One hash of the command, the options that change a result, the tables, and the dialect with its plugins; of all
/// dialects and plugins that are found where each program's dialect is guessed. Empty, and reported, when the dialect
/// or a table cannot be read: no program could run.
std::optional<Surroundings> surroundings_of(const BatchArguments& arguments, FileHashes& hashes, Session& session,
                                            Trial trial = Trial::none);

}  // namespace isogloss::cli::batch
