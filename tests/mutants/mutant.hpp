/// Which mutant of an instrumented source runs. The build of the mutants includes this header into each unit.
///
/// ISOGLOSS_MUTANT is the number of the mutant, 0 or nothing for none. ISOGLOSS_MUTANT_REACHED names a file with a byte
/// for each mutant: a run sets the bytes of those whose place it executes.
#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

namespace isogloss_mutants {

inline unsigned chosen = 0;
inline unsigned char* reached = nullptr;
inline unsigned long places = 0;

// Before the static objects of a plugin, whose constructors may hold mutants. A mapped file survives a crash.
__attribute__((constructor(101))) inline void choose() {
  if (const char* const number = std::getenv("ISOGLOSS_MUTANT")) chosen = std::strtoul(number, nullptr, 10);
  const char* const path = std::getenv("ISOGLOSS_MUTANT_REACHED");
  if (path == nullptr || reached != nullptr) return;
  const int file = ::open(path, O_RDWR | O_CLOEXEC);
  struct stat found {};
  if (file < 0 || ::fstat(file, &found) != 0) std::abort();
  void* const bytes = ::mmap(nullptr, found.st_size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ::close(file);
  if (bytes == MAP_FAILED) std::abort();
  places = found.st_size;
  reached = static_cast<unsigned char*>(bytes);
}

inline bool is(unsigned number) {
  if (__builtin_expect(reached != nullptr, 0) && number < places) reached[number] = 1;
  return __builtin_expect(number == chosen, 0);
}

}  // namespace isogloss_mutants
