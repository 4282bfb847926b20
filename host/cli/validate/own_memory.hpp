/// Memory that one library has allocated itself, from now on.
#pragma once

#include <filesystem>

namespace isogloss::cli {

/// Watches the library's own calls of malloc(), operator new and their kin, which give zeros, and everyone's of free().
/// One at a time, and nothing is undone: it belongs into the process of a check.
class OwnMemory {
 public:
  explicit OwnMemory(const std::filesystem::path& library);
  OwnMemory(const OwnMemory&) = delete;
  OwnMemory& operator=(const OwnMemory&) = delete;

  /// A piece that it has allocated before.
  void add(const void* begin);
  bool contains(const void* begin) const;
};

}  // namespace isogloss::cli
