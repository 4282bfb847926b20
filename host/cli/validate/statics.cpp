// Static variables belong to all chains of a process. The bytes in which a library keeps them are compared before and
// after each block.
#include <fmt/format.h>
#include <link.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

/// The writable part of a loaded library, without what the loader makes read-only.
struct WritablePart {
  const char* begin;
  std::size_t size;
  std::size_t offset;  ///< from the begin of the library, as nm shows it
  std::string before{};
};

struct Sought {
  std::filesystem::path file;
  std::vector<WritablePart> parts{};
};

int note_parts(dl_phdr_info* info, std::size_t, void* data) {
  auto& sought = *static_cast<Sought*>(data);
  std::error_code error;
  if (info->dlpi_name[0] == '\0' || !std::filesystem::equivalent(info->dlpi_name, sought.file, error)) return 0;
  ElfW(Addr) writable = 0;  // what stands before is read-only once it is filled in
  for (int i = 0; i < info->dlpi_phnum; ++i)
    if (info->dlpi_phdr[i].p_type == PT_GNU_RELRO)
      writable = std::max(writable, info->dlpi_phdr[i].p_vaddr + info->dlpi_phdr[i].p_memsz);
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const ElfW(Phdr)& part = info->dlpi_phdr[i];
    if (part.p_type != PT_LOAD || (part.p_flags & PF_W) == 0) continue;
    const ElfW(Addr) begin = std::max(part.p_vaddr, writable), end = part.p_vaddr + part.p_memsz;
    if (begin < end)
      sought.parts.push_back({reinterpret_cast<const char*>(info->dlpi_addr + begin), end - begin, begin});
  }
  return 1;
}

/// Where a byte has changed since the last call; nothing where none has.
std::optional<std::size_t> changed_offset(std::vector<WritablePart>& parts) {
  std::optional<std::size_t> out;
  for (WritablePart& part : parts) {
    const std::string_view now(part.begin, part.size);
    if (!out && part.before.size() == part.size && now != part.before) {
      const auto at = std::mismatch(now.begin(), now.end(), part.before.begin()).first;
      out = part.offset + static_cast<std::size_t>(at - now.begin());
    }
    part.before = now;
  }
  return out;
}

}  // namespace

void check_statics(Examination& e) {
  constexpr std::uint64_t random_ones = 100;
  Subject subject(e);
  Sought sought{.file = e.file};
  dl_iterate_phdr(note_parts, &sought);
  for (const Stand& stand : stands_of(subject, e)) {
    Bench bench(stand.alone, in_mode(Mode::fast));
    const std::vector<TestBlock> blocks = many_blocks(stand, e, stand.dependencies.empty() ? random_ones : 0);
    // What is computed at its first use, and stays so, may be static.
    for (const TestBlock& block : blocks) bench.run(block, false);
    changed_offset(sought.parts);
    for (const TestBlock& block : blocks) {
      const std::string where = std::string(stand.syntax->id) + ", " + block.name;
      e.attempt(where);
      bench.run(block, false);
      const std::optional<std::size_t> offset = changed_offset(sought.parts);
      if (!offset) continue;
      e.find(where,
             fmt::format("it changes a static variable, which all chains share; nm -C names it near {:#x}", *offset));
      break;
    }
  }
}

}  // namespace isogloss::cli
