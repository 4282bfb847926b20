/// Memory that one library has allocated itself, from now on.
#pragma once

#include <filesystem>
#include <set>

namespace isogloss::cli {

/// Watches the library's own calls of malloc(), operator new and their kin. One at a time.
class OwnMemory {
 public:
  explicit OwnMemory(const std::filesystem::path& library);
  ~OwnMemory();
  OwnMemory(const OwnMemory&) = delete;
  OwnMemory& operator=(const OwnMemory&) = delete;

  bool contains(const void* begin) const;
};

}  // namespace isogloss::cli
