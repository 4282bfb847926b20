#include "prepared_heap.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

namespace isogloss::cli {

void prepare_heap() {
#if defined(MADV_POPULATE_WRITE) && !defined(ISOGLOSS_SANITIZED)
  constexpr std::size_t size = std::size_t{2} << 20;
  // What is as large as this is mapped on its own and given back at once. The C library takes that for a size that
  // comes again: from now on it serves it from the heap, and keeps as much there (mallopt(3), M_MMAP_THRESHOLD).
  void* volatile part = std::malloc(size);  // volatile: a compiler may leave out what is freed unused
  std::free(part);
  part = std::malloc(size - (size >> 3));
  if (part == nullptr) return;
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const std::uintptr_t begin = reinterpret_cast<std::uintptr_t>(part), whole = (begin + page - 1) / page * page;
  // Where the kernel does not know it (before Linux 5.14), the pages come as they are touched.
  ::madvise(reinterpret_cast<void*>(whole), (begin + size - (size >> 3) - whole) / page * page, MADV_POPULATE_WRITE);
  std::free(part);
#endif
}

}  // namespace isogloss::cli
