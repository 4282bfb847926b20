/// The folder of a reference: made anew each time, and never one that holds something else.
#pragma once

#include <map>
#include <string>

#include "session.hpp"

namespace isogloss::cli::docs {

class DocsFolder {
 public:
  explicit DocsFolder(std::string folder) : folder_(std::move(folder)) {}

  /// True when the folder is not there, is empty, or was made by this command; otherwise reported.
  bool is_ours(Session& session) const;
  /// Writes the files, and removes those of an earlier reference that are no longer part of it; false, and reported,
  /// when one cannot be written.
  bool write(const std::map<std::string, std::string>& files, Session& session) const;

 private:
  std::string folder_;
};

}  // namespace isogloss::cli::docs
