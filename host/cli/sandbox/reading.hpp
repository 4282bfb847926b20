/// Reading of a process, confined to files and folders by Landlock.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace isogloss::cli::sandbox {

/// From now on this process opens only these, what is below them, and what the libraries of the system need. An empty
/// text where that is so, or the kernel has no Landlock; else what went wrong.
std::string confine_reading(const std::vector<std::string>& readable);

/// Whether the system can confine reading to folders.
bool can_confine_reading();

/// For the process that watches: Landlock refuses a file that lies elsewhere, but tells nobody.
class ReadablePlaces {
 public:
  /// What `process` may read that has called confine_reading(readable).
  ReadablePlaces(const std::vector<std::string>& readable, pid_t process);
  /// The file that such a call of open asks for, where it exists and lies elsewhere; else empty. `folder` is the
  /// descriptor that a relative path begins at.
  std::string elsewhere(int folder, const std::string& path) const;

 private:
  pid_t process_;
  std::vector<std::filesystem::path> places_;
};

}  // namespace isogloss::cli::sandbox
