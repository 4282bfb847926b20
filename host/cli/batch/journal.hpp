/// What a batch has finished, kept while it works: after a kill nothing of it is run again.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "batch/content_hash.hpp"

namespace isogloss::cli::batch {

/// A finished program with all that its result depends on.
struct Finished {
  std::string program;
  std::string surroundings;                   ///< hash of the command, options, dialects, plugins and tables
  std::string content;                        ///< hash of the program
  std::map<std::string, std::string> called;  ///< hashes of the programs that it calls
  std::map<std::string, std::string> places;  ///< hashes of where called programs were looked for
  std::string result;                         ///< JSON
  bool is_failure = false;                    ///< the program was not run to its end, for whatever reason
};

/// A file name as text of JSON, and back: % is written as %25, and in a name that is not UTF-8 each byte such as %E4.
std::string text_of_name(std::string_view name);
std::string name_of_text(std::string_view text);

/// The finished programs of a folder. Each process that works for it appends to a file of its own, a line for each
/// program in one piece: a line that a kill has cut off is not read. Two processes that did the same work have written
/// the same.
class Journal {
 public:
  /// Reads what all processes have written so far; false where there is nothing. Lines and files that cannot be read
  /// are counted.
  bool read(const std::string& folder);
  std::uint64_t damaged_lines() const { return damaged_; }
  /// Makes the folder; an empty text, or the reason why not.
  std::string open(const std::string& folder);
  /// The result as it is kept; null, and the reason, when it cannot be written.
  const Finished* append(const Finished& finished, std::string& error);
  /// False: somebody has removed or replaced the file of this process, and no other process will find its results.
  bool is_kept() const;
  ~Journal();
  Journal() = default;
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// The result of a program whose inputs are as they were, else null. Of several one that is no failure: it has been
  /// run again since.
  const Finished* find(const std::string& program, const std::string& surroundings, FileHashes& hashes) const;

 private:
  void read_file(const std::string& file);

  std::multimap<std::string, Finished> all_;
  std::uint64_t damaged_ = 0;
  std::string name_;  // of the file of this process, once there is something to write
  int descriptor_ = -1;
  std::int64_t size_ = 0;  // of that file
};

}  // namespace isogloss::cli::batch
