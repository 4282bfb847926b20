/// Memory of the heap to which static variables of a plugin lead, with its bytes at one moment.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isogloss::cli {

class ReachableMemory {
 public:
  /// From these variables on, over a few pointers. Only memory of malloc() that `is_owned` counts, and only where the C
  /// library lays it out as glibc does: elsewhere nothing is reachable.
  ReachableMemory(std::span<const std::string_view> variables, const std::function<bool(const void*)>& is_owned);
  /// Its pieces, whole.
  std::vector<std::string_view> pieces() const;
  /// Is a byte of it another one now?
  bool has_changed() const;

 private:
  struct Piece {
    std::string_view memory;
    std::string bytes;
  };
  std::vector<Piece> pieces_;
};

}  // namespace isogloss::cli
