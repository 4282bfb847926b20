#include "validate/own_memory.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

#include "validate/redirection.hpp"

namespace isogloss::cli {

namespace {

std::set<const void*>* owned = nullptr;
// The set allocates and gives back memory itself.
thread_local bool is_in_set = false;

/// The functions themselves: the command's own calls lead here, too.
struct System {
  void* (*realloc)(void*, std::size_t);
  void (*free)(void*);
  void (*remove)(void*);  // operator delete
};
System the_system{};

template <class F>
void find_function(F& function, const char* name) {
  function = reinterpret_cast<F>(dlsym(RTLD_DEFAULT, name));
}

void* note_owned(void* memory) {
  if (owned == nullptr || memory == nullptr || is_in_set) return memory;
  is_in_set = true;
  owned->insert(memory);
  is_in_set = false;
  return memory;
}
void forget_owned(const void* memory) {
  if (owned == nullptr || is_in_set) return;
  is_in_set = true;
  owned->erase(memory);
  is_in_set = false;
}

// Zeros, so that what was in the memory before is not taken for a pointer.
void* own_malloc(std::size_t size) { return note_owned(std::calloc(1, size)); }
void* own_calloc(std::size_t count, std::size_t size) { return note_owned(std::calloc(count, size)); }
void* own_new(std::size_t size) { return note_owned(std::memset(::operator new(size), 0, size)); }
void* own_realloc(void* old, std::size_t size) {
  forget_owned(old);
  return note_owned(the_system.realloc(old, size));
}

void* any_realloc(void* old, std::size_t size) {
  forget_owned(old);
  return the_system.realloc(old, size);
}
void any_free(void* memory) {
  forget_owned(memory);
  the_system.free(memory);
}
void any_delete(void* memory) {
  forget_owned(memory);
  the_system.remove(memory);
}
void any_sized_delete(void* memory, std::size_t) { any_delete(memory); }

// What the library has allocated, everyone may give back, and then it is somebody else's.
const Replacement for_everyone[] = {{"free", reinterpret_cast<void*>(&any_free)},
                                    {"realloc", reinterpret_cast<void*>(&any_realloc)},
                                    {"_ZdlPv", reinterpret_cast<void*>(&any_delete)},
                                    {"_ZdaPv", reinterpret_cast<void*>(&any_delete)},
                                    {"_ZdlPvm", reinterpret_cast<void*>(&any_sized_delete)},
                                    {"_ZdaPvm", reinterpret_cast<void*>(&any_sized_delete)}};
const Replacement for_library[] = {{"malloc", reinterpret_cast<void*>(&own_malloc)},
                                   {"calloc", reinterpret_cast<void*>(&own_calloc)},
                                   {"realloc", reinterpret_cast<void*>(&own_realloc)},
                                   {"_Znwm", reinterpret_cast<void*>(&own_new)},
                                   {"_Znam", reinterpret_cast<void*>(&own_new)}};

}  // namespace

OwnMemory::OwnMemory(const std::filesystem::path& library) {
  find_function(the_system.realloc, "realloc");
  find_function(the_system.free, "free");
  find_function(the_system.remove, "_ZdlPv");
  owned = new std::set<const void*>;
  redirect(for_everyone, Redirected::libraries_and_command);
  redirect(for_library, Redirected::libraries, library);
}
OwnMemory::~OwnMemory() { delete std::exchange(owned, nullptr); }

void OwnMemory::add(const void* begin) {
  is_in_set = true;
  owned->insert(begin);
  is_in_set = false;
}

bool OwnMemory::contains(const void* begin) const { return owned->contains(begin); }

}  // namespace isogloss::cli
