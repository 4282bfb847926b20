#include "validate/fenced_memory.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <new>
#include <unordered_map>
#include <utility>

#include "validate/redirection.hpp"

namespace isogloss::cli {

namespace {

constexpr std::size_t fence = 512;  // bytes on either side; what lies farther away is most often nobody's memory
constexpr unsigned char mark = 0xB5;

/// The functions themselves: the command's own calls lead here, too.
struct System {
  void* (*malloc)(std::size_t);
  void* (*realloc)(void*, std::size_t);
  void (*free)(void*);
  void (*remove)(void*);  // operator delete
  std::size_t (*usable_size)(void*);
};
System the_system{};

template <class F>
void find_function(F& function, const char* name) {
  function = reinterpret_cast<F>(dlsym(RTLD_DEFAULT, name));
}

struct Pieces {
  std::mutex mutex;
  std::unordered_map<const void*, std::size_t> sizes;
  std::string damage;
};
Pieces* pieces = nullptr;
// The list of the pieces allocates and gives back memory itself.
thread_local bool is_in_list = false;

class InList {
 public:
  InList() : lock_(pieces->mutex) { is_in_list = true; }
  ~InList() { is_in_list = false; }
  InList(const InList&) = delete;
  InList& operator=(const InList&) = delete;

 private:
  std::lock_guard<std::mutex> lock_;
};

bool has_list() { return pieces != nullptr && !is_in_list; }

void note_damage(const void* piece, std::size_t size) {
  const auto* const begin = static_cast<const unsigned char*>(piece) - fence;
  const auto* const behind = static_cast<const unsigned char*>(piece) + size;
  const auto is_other = [](unsigned char byte) { return byte != mark; };
  if (const auto* const at = std::find_if(begin, begin + fence, is_other); at != begin + fence)
    pieces->damage = fmt::format("{} bytes before a piece of {} bytes", begin + fence - at, size);
  else if (const auto* const after = std::find_if(behind, behind + fence, is_other); after != behind + fence)
    pieces->damage = fmt::format("{} bytes behind the end of a piece of {} bytes", after - behind, size);
}

void* fenced(std::size_t size) {
  if (!has_list() || size > SIZE_MAX - 2 * fence) return the_system.malloc(size);
  auto* const all = static_cast<unsigned char*>(the_system.malloc(size + 2 * fence));
  if (all == nullptr) return nullptr;
  std::memset(all, mark, fence);
  std::memset(all + fence + size, mark, fence);
  const InList at_work;
  pieces->sizes[all + fence] = size;
  return all + fence;
}

/// Takes the piece out of the list: where its memory begins and its size; null: it is none of the list.
void* unfenced(void* piece, std::size_t* size = nullptr) {
  if (!has_list()) return nullptr;
  const InList at_work;
  const auto found = pieces->sizes.find(piece);
  if (found == pieces->sizes.end()) return nullptr;
  note_damage(piece, found->second);
  if (size != nullptr) *size = found->second;
  pieces->sizes.erase(found);
  return static_cast<unsigned char*>(piece) - fence;
}

void give_back(void* piece) {
  void* const begin = unfenced(piece);
  the_system.free(begin != nullptr ? begin : piece);
}
void remove(void* piece) {
  void* const begin = unfenced(piece);
  begin != nullptr ? the_system.free(begin) : the_system.remove(piece);
}
void remove_sized(void* piece, std::size_t) { remove(piece); }

void* fenced_zeros(std::size_t count, std::size_t size) {
  if (size != 0 && count > SIZE_MAX / size) return nullptr;
  void* const out = fenced(count * size);
  if (out != nullptr) std::memset(out, 0, count * size);
  return out;
}

/// The piece with another size, where it is one of the list.
void* resized(void* piece, std::size_t size) {
  std::size_t before = 0;
  void* const begin = unfenced(piece, &before);
  if (begin == nullptr) return the_system.realloc(piece, size);
  void* const out = fenced(size);
  if (out != nullptr) std::memcpy(out, piece, std::min(before, size));
  the_system.free(begin);
  return out;
}
void* fenced_or_resized(void* piece, std::size_t size) {
  return piece == nullptr ? fenced(size) : resized(piece, size);
}

std::size_t usable_size(void* piece) {
  if (has_list()) {
    const InList at_work;
    if (const auto found = pieces->sizes.find(piece); found != pieces->sizes.end()) return found->second;
  }
  return the_system.usable_size(piece);
}

void* fenced_new(std::size_t size) {
  void* const out = fenced(size);
  if (out == nullptr) throw std::bad_alloc();
  return out;
}

// A library may give back what another one has allocated.
const Replacement for_everyone[] = {{"free", reinterpret_cast<void*>(&give_back)},
                                    {"realloc", reinterpret_cast<void*>(&resized)},
                                    {"malloc_usable_size", reinterpret_cast<void*>(&usable_size)},
                                    {"_ZdlPv", reinterpret_cast<void*>(&remove)},
                                    {"_ZdaPv", reinterpret_cast<void*>(&remove)},
                                    {"_ZdlPvm", reinterpret_cast<void*>(&remove_sized)},
                                    {"_ZdaPvm", reinterpret_cast<void*>(&remove_sized)}};
const Replacement for_library[] = {{"malloc", reinterpret_cast<void*>(&fenced)},
                                   {"calloc", reinterpret_cast<void*>(&fenced_zeros)},
                                   {"realloc", reinterpret_cast<void*>(&fenced_or_resized)},
                                   {"_Znwm", reinterpret_cast<void*>(&fenced_new)},
                                   {"_Znam", reinterpret_cast<void*>(&fenced_new)}};

}  // namespace

FencedMemory::FencedMemory(const std::filesystem::path& library) {
  find_function(the_system.malloc, "malloc");
  find_function(the_system.realloc, "realloc");
  find_function(the_system.free, "free");
  find_function(the_system.remove, "_ZdlPv");
  find_function(the_system.usable_size, "malloc_usable_size");
  pieces = new Pieces;
  redirect(for_everyone, Redirected::libraries_and_command);
  redirect(for_library, Redirected::libraries, library);
}

std::string FencedMemory::damage() {
  const InList at_work;
  for (const auto& [piece, size] : pieces->sizes)
    if (pieces->damage.empty()) note_damage(piece, size);
  return std::exchange(pieces->damage, {});
}

}  // namespace isogloss::cli
