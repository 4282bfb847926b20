/// Memory of the heap to which static variables of a plugin lead, with its bytes at one moment.
#pragma once

#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isogloss::cli {

/// Where pieces of malloc()'s memory begin that are in use at present. For a process that lives as short as a check:
/// what malloc() keeps for its next small pieces is taken, so that it does not count as in use, and never given back.
/// Empty where the C library lays its memory out in another way than glibc.
std::set<const void*> pieces_in_use();

class ReachableMemory {
 public:
  /// Does the word point to this piece, or does it look so by chance?
  using IsPointer = std::function<bool(const void* piece, const char* word)>;
  /// From these variables on, over a few pointers. Only memory of malloc(), and only where the C library lays it out as
  /// glibc does: elsewhere nothing is reachable.
  ReachableMemory(std::span<const std::string_view> variables, const IsPointer& is_pointer);
  /// Its pieces, whole.
  std::vector<std::string_view> pieces() const;
  /// The variable from which a piece is reached that has another byte now; null: none has.
  const char* changed_from() const;

 private:
  struct Piece {
    std::string_view memory;
    const char* variable;
    std::string bytes{};
  };
  std::vector<Piece> pieces_;
};

}  // namespace isogloss::cli
