// Functions in place of malloc() and its kin, each of which counts and then allocates as the system does.
#include "validate/allocation_counter.hpp"

#include <malloc.h>
#include <sys/mman.h>

#include <cstdlib>

#include "validate/redirection.hpp"

namespace isogloss::cli {

namespace {

thread_local bool is_counting = false;
thread_local int host_calls = 0;  // under way
thread_local std::uint64_t allocations = 0;

thread_local std::int64_t bytes_kept = 0;

using Malloc = void* (*)(std::size_t);
using Calloc = void* (*)(std::size_t, std::size_t);
using Realloc = void* (*)(void*, std::size_t);
using Memalign = int (*)(void**, std::size_t, std::size_t);
using Free = void (*)(void*);
using Map = void* (*)(void*, std::size_t, int, int, int, off_t);
using Unmap = int (*)(void*, std::size_t);
Malloc system_malloc = nullptr;
Calloc system_calloc = nullptr;
Realloc system_realloc = nullptr;
Calloc system_aligned_alloc = nullptr;
Memalign system_posix_memalign = nullptr;
Calloc system_memalign = nullptr;
Free system_free = nullptr;
Map system_mmap = nullptr;
Unmap system_munmap = nullptr;

void* note_allocation(void* allocated) {
  if (is_counting) {
    if (host_calls == 0) ++allocations;
    bytes_kept += static_cast<std::int64_t>(malloc_usable_size(allocated));
  }
  return allocated;
}

void note_free(void* memory) {
  if (is_counting) bytes_kept -= static_cast<std::int64_t>(malloc_usable_size(memory));
}

void* counting_malloc(std::size_t size) { return note_allocation(system_malloc(size)); }
void* counting_calloc(std::size_t count, std::size_t size) { return note_allocation(system_calloc(count, size)); }
void* counting_realloc(void* old, std::size_t size) {
  note_free(old);
  return note_allocation(system_realloc(old, size));
}
void* counting_aligned_alloc(std::size_t alignment, std::size_t size) {
  return note_allocation(system_aligned_alloc(alignment, size));
}
int counting_posix_memalign(void** out, std::size_t alignment, std::size_t size) {
  const int error = system_posix_memalign(out, alignment, size);
  if (error == 0) note_allocation(*out);
  return error;
}
void* counting_memalign(std::size_t alignment, std::size_t size) {
  return note_allocation(system_memalign(alignment, size));
}
void* counting_mmap(void* wanted, std::size_t size, int protection, int flags, int file, off_t offset) {
  void* const out = system_mmap(wanted, size, protection, flags, file, offset);
  if (is_counting && host_calls == 0 && out != MAP_FAILED) ++allocations, bytes_kept += static_cast<std::int64_t>(size);
  return out;
}
int counting_munmap(void* memory, std::size_t size) {
  if (is_counting && host_calls == 0) bytes_kept -= static_cast<std::int64_t>(size);
  return system_munmap(memory, size);
}
void counting_free(void* memory) {
  note_free(memory);
  system_free(memory);
}

const Replacement counting_functions[] = {{"malloc", reinterpret_cast<void*>(&counting_malloc)},
                                          {"calloc", reinterpret_cast<void*>(&counting_calloc)},
                                          {"realloc", reinterpret_cast<void*>(&counting_realloc)},
                                          {"aligned_alloc", reinterpret_cast<void*>(&counting_aligned_alloc)},
                                          {"posix_memalign", reinterpret_cast<void*>(&counting_posix_memalign)},
                                          {"memalign", reinterpret_cast<void*>(&counting_memalign)},
                                          {"mmap", reinterpret_cast<void*>(&counting_mmap)},
                                          {"mmap64", reinterpret_cast<void*>(&counting_mmap)},
                                          {"munmap", reinterpret_cast<void*>(&counting_munmap)},
                                          {"free", reinterpret_cast<void*>(&counting_free)}};

bool find_functions() {
  return find_function(system_malloc, "malloc") && find_function(system_calloc, "calloc") &&
         find_function(system_realloc, "realloc") && find_function(system_aligned_alloc, "aligned_alloc") &&
         find_function(system_posix_memalign, "posix_memalign") && find_function(system_memalign, "memalign") &&
         find_function(system_mmap, "mmap") && find_function(system_munmap, "munmap") &&
         find_function(system_free, "free");
}

}  // namespace

AllocationCounter::AllocationCounter() {
  if (system_free == nullptr && !find_functions()) return;
  redirect(counting_functions, Redirected::libraries_and_command);
  start();
  void* volatile probe = ::operator new(1);
  const bool is_seen = allocations == 1 && bytes_kept > 0;
  ::operator delete(probe);
  is_complete_ = is_seen && bytes_kept == 0;
  stop();
}

void AllocationCounter::start() {
  allocations = 0;
  bytes_kept = 0;
  is_counting = true;
}

std::uint64_t AllocationCounter::stop() {
  is_counting = false;
  return allocations;
}

std::int64_t AllocationCounter::bytes() { return bytes_kept; }

AllocationCounter::InHost::InHost() { ++host_calls; }
AllocationCounter::InHost::~InHost() { --host_calls; }

}  // namespace isogloss::cli
