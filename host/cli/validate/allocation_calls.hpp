/// Functions in place of malloc() and its kin, for checks that follow the memory of one library.
#pragma once

#include <cstddef>
#include <filesystem>
#include <mutex>
#include <optional>
#include <unordered_map>

namespace isogloss::cli {

/// The functions of the system themselves: where everyone's calls are redirected, the command's own are, too.
struct SystemAllocation {
  void* (*allocate)(std::size_t);
  void* (*resize)(void*, std::size_t);
  void (*give_back)(void*);
  void (*remove)(void*);  ///< operator delete
  std::size_t (*usable_size)(void*);
};
const SystemAllocation& system_allocation();

/// What stands in their place.
struct AllocationCalls {
  void* (*allocate)(std::size_t);       ///< of the library
  void* (*resize)(void*, std::size_t);  ///< of the library: realloc()
  void* (*resize_of_others)(void*, std::size_t);
  /// Everyone's free() and operator delete: what one library has allocated, another may give back.
  void (*give_back)(void*);
  void (*remove)(void*);
  std::size_t (*usable_size)(void*);
};
/// calloc() and operator new of the library take from `allocate`, which gives zeros. Nothing is undone, so it belongs
/// into the process of a check.
void redirect_allocation(const AllocationCalls& calls, const std::filesystem::path& library);

/// Pieces of memory with their sizes. What the list itself allocates and gives back does not come back to it, and it
/// may be asked on every thread.
class PieceList {
 public:
  void add(const void* piece, std::size_t size) {
    if (const Use use(*this); use.is_first()) sizes_[piece] = size;
  }
  /// Its size, if it was there, and then it is no longer.
  std::optional<std::size_t> take(const void* piece);
  std::optional<std::size_t> size_of(const void* piece) const;
  /// Calls `look` with each piece and its size.
  template <class Look>
  void for_each(Look&& look) const {
    if (const Use use(*this); use.is_first())
      for (const auto& [piece, size] : sizes_) look(piece, size);
  }

 private:
  /// On a thread that uses the list already, nothing is done.
  class Use {
   public:
    explicit Use(const PieceList& list) : is_first_(!is_in_use) {
      if (is_first_) lock_ = std::unique_lock(list.mutex_);
      is_in_use = true;
    }
    ~Use() {
      if (is_first_) is_in_use = false;
    }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    bool is_first() const { return is_first_; }

   private:
    static inline thread_local bool is_in_use = false;
    bool is_first_;
    std::unique_lock<std::mutex> lock_;
  };

  mutable std::mutex mutex_;
  std::unordered_map<const void*, std::size_t> sizes_;
};

}  // namespace isogloss::cli
