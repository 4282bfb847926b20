#include "validate/own_memory.hpp"

#include <cstdlib>
#include <new>

#include "validate/redirection.hpp"

namespace isogloss::cli {

namespace {

std::set<const void*>* owned = nullptr;

void* note_owned(void* memory) {
  if (owned != nullptr && memory != nullptr) owned->insert(memory);
  return memory;
}
void forget_owned(const void* memory) {
  if (owned != nullptr) owned->erase(memory);
}

void* own_malloc(std::size_t size) { return note_owned(std::malloc(size)); }
void* own_calloc(std::size_t count, std::size_t size) { return note_owned(std::calloc(count, size)); }
void* own_realloc(void* old, std::size_t size) {
  forget_owned(old);
  return note_owned(std::realloc(old, size));
}
void own_free(void* memory) {
  forget_owned(memory);
  std::free(memory);
}
void* own_new(std::size_t size) { return note_owned(::operator new(size)); }
void own_delete(void* memory) {
  forget_owned(memory);
  ::operator delete(memory);
}
void own_sized_delete(void* memory, std::size_t) { own_delete(memory); }

const Replacement own_functions[] = {{"malloc", reinterpret_cast<void*>(&own_malloc)},
                                     {"calloc", reinterpret_cast<void*>(&own_calloc)},
                                     {"realloc", reinterpret_cast<void*>(&own_realloc)},
                                     {"free", reinterpret_cast<void*>(&own_free)},
                                     {"_Znwm", reinterpret_cast<void*>(&own_new)},
                                     {"_Znam", reinterpret_cast<void*>(&own_new)},
                                     {"_ZdlPv", reinterpret_cast<void*>(&own_delete)},
                                     {"_ZdaPv", reinterpret_cast<void*>(&own_delete)},
                                     {"_ZdlPvm", reinterpret_cast<void*>(&own_sized_delete)},
                                     {"_ZdaPvm", reinterpret_cast<void*>(&own_sized_delete)}};

}  // namespace

OwnMemory::OwnMemory(const std::filesystem::path& library) {
  owned = new std::set<const void*>;
  redirect(own_functions, Redirected::libraries, library);
}
OwnMemory::~OwnMemory() {
  delete owned;
  owned = nullptr;
}

bool OwnMemory::contains(const void* begin) const { return owned->contains(begin); }

}  // namespace isogloss::cli
