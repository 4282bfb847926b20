// The tables through which a library calls malloc() are filled in when it is loaded. Here they are filled in anew, so
// that the command itself needs no allocator of its own, and a run knows nothing of counting.
#include "validate/allocation_counter.hpp"

#include <dlfcn.h>
#include <elf.h>
#include <link.h>
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

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
Malloc system_malloc = nullptr;
Calloc system_calloc = nullptr;
Realloc system_realloc = nullptr;
Calloc system_aligned_alloc = nullptr;
Memalign system_posix_memalign = nullptr;
Free system_free = nullptr;

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
void counting_free(void* memory) {
  note_free(memory);
  system_free(memory);
}

struct Replacement {
  const char* name;
  void* counting;
};
const Replacement replacements[] = {{"malloc", reinterpret_cast<void*>(&counting_malloc)},
                                    {"calloc", reinterpret_cast<void*>(&counting_calloc)},
                                    {"realloc", reinterpret_cast<void*>(&counting_realloc)},
                                    {"aligned_alloc", reinterpret_cast<void*>(&counting_aligned_alloc)},
                                    {"posix_memalign", reinterpret_cast<void*>(&counting_posix_memalign)},
                                    {"free", reinterpret_cast<void*>(&counting_free)}};

void* replacement(std::string_view name) {
  for (const Replacement& r : replacements)
    if (name == r.name) return r.counting;
  return nullptr;
}

/// The dynamic section of one loaded library.
struct LibraryTables {
  const ElfW(Sym) * symbols = nullptr;
  const char* names = nullptr;
  const ElfW(Rela) * data = nullptr;
  const ElfW(Rela) * calls = nullptr;
  std::size_t data_size = 0, calls_size = 0;  // bytes
};

LibraryTables tables_of(const dl_phdr_info& info) {
  LibraryTables out;
  const auto at = [&](ElfW(Addr) address) {  // relative to the library where the loader has left it so
    return reinterpret_cast<const char*>(address < info.dlpi_addr ? address + info.dlpi_addr : address);
  };
  for (int i = 0; i < info.dlpi_phnum; ++i) {
    if (info.dlpi_phdr[i].p_type != PT_DYNAMIC) continue;
    const auto* entry = reinterpret_cast<const ElfW(Dyn)*>(info.dlpi_addr + info.dlpi_phdr[i].p_vaddr);
    for (; entry->d_tag != DT_NULL; ++entry) switch (entry->d_tag) {
        case DT_SYMTAB: out.symbols = reinterpret_cast<const ElfW(Sym)*>(at(entry->d_un.d_ptr)); break;
        case DT_STRTAB: out.names = at(entry->d_un.d_ptr); break;
        case DT_RELA: out.data = reinterpret_cast<const ElfW(Rela)*>(at(entry->d_un.d_ptr)); break;
        case DT_RELASZ: out.data_size = entry->d_un.d_val; break;
        case DT_JMPREL: out.calls = reinterpret_cast<const ElfW(Rela)*>(at(entry->d_un.d_ptr)); break;
        case DT_PLTRELSZ: out.calls_size = entry->d_un.d_val; break;
        default: break;
      }
  }
  return out;
}

/// A table that holds addresses is often read-only once it is filled in; it stays writable from here on.
void fill_in(void** slot, void* value) {
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  void* const begin = reinterpret_cast<void*>(reinterpret_cast<std::uintptr_t>(slot) & ~(page - 1));
  if (mprotect(begin, page, PROT_READ | PROT_WRITE) == 0) *slot = value;
}

void redirect(const dl_phdr_info& info, const LibraryTables& tables, const ElfW(Rela) * rows, std::size_t bytes) {
  if (rows == nullptr || tables.symbols == nullptr || tables.names == nullptr) return;
  for (std::size_t i = 0; i < bytes / sizeof *rows; ++i) {
    const auto symbol = static_cast<std::size_t>(rows[i].r_info >> (sizeof(ElfW(Addr)) == 8 ? 32 : 8));
    if (symbol == 0 || rows[i].r_addend != 0) continue;
    if (void* const counting = replacement(tables.names + tables.symbols[symbol].st_name))
      fill_in(reinterpret_cast<void**>(info.dlpi_addr + rows[i].r_offset), counting);
  }
}

int redirect_library(dl_phdr_info* info, std::size_t, void*) {
  const std::string_view name = info->dlpi_name;
  // The loader allocates before and after everyone else; the system's own page has no tables.
  if (name.find("ld-linux") != std::string_view::npos || name.find("vdso") != std::string_view::npos) return 0;
  const LibraryTables tables = tables_of(*info);
  redirect(*info, tables, tables.data, tables.data_size);
  redirect(*info, tables, tables.calls, tables.calls_size);
  return 0;
}

template <class F>
bool find_function(F& function, const char* name) {
  function = reinterpret_cast<F>(dlsym(RTLD_DEFAULT, name));
  return function != nullptr;
}

bool find_functions() {
  return find_function(system_malloc, "malloc") && find_function(system_calloc, "calloc") &&
         find_function(system_realloc, "realloc") && find_function(system_aligned_alloc, "aligned_alloc") &&
         find_function(system_posix_memalign, "posix_memalign") && find_function(system_free, "free");
}

}  // namespace

AllocationCounter::AllocationCounter() {
  if (system_free == nullptr && !find_functions()) return;
  dl_iterate_phdr(redirect_library, nullptr);
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
