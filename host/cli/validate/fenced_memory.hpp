/// Memory that one library allocates, with bytes before and behind each piece that nobody may write to.
#pragma once

#include <filesystem>
#include <string>

namespace isogloss::cli {

/// Stands before the library's own calls of malloc(), operator new and their kin. One at a time, and nothing is undone:
/// it belongs into the process of a check.
class FencedMemory {
 public:
  explicit FencedMemory(const std::filesystem::path& library);
  /// The pieces live on, and so does their list: whoever gives one back needs it.
  ~FencedMemory() = default;
  FencedMemory(const FencedMemory&) = delete;
  FencedMemory& operator=(const FencedMemory&) = delete;

  /// What was written beside a piece since the last call; empty where nothing was. Pieces that were given back since
  /// then count, too.
  std::string damage();
};

}  // namespace isogloss::cli
