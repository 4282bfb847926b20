// Static variables belong to all chains of a process. The pages in which a library keeps them are write-protected while
// a block is built; what they point to, and the variables of the thread, are compared before and after each block.
#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <map>

#include "validate/own_memory.hpp"
#include "validate/reachable_memory.hpp"
#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

/// The writable part of a loaded library, without what the loader makes read-only.
struct WritablePart {
  char* begin;
  std::size_t size;
  std::size_t offset;  ///< from the begin of the library, as nm shows it
  std::string before{};
};

struct Sought {
  std::filesystem::path file;
  std::vector<WritablePart> parts{};
  WritablePart of_thread{};
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
    if (part.p_type == PT_TLS && info->dlpi_tls_data != nullptr)
      sought.of_thread = {static_cast<char*>(info->dlpi_tls_data), part.p_memsz, 0};
    if (part.p_type != PT_LOAD || (part.p_flags & PF_W) == 0) continue;
    const ElfW(Addr) begin = std::max(part.p_vaddr, writable), end = part.p_vaddr + part.p_memsz;
    if (begin < end) sought.parts.push_back({reinterpret_cast<char*>(info->dlpi_addr + begin), end - begin, begin});
  }
  return 1;
}

/// Where a byte of the part has changed since the last call; nothing where none has.
std::optional<std::size_t> changed_offset(WritablePart& part) {
  std::optional<std::size_t> out;
  const std::string_view now(part.begin, part.size);
  if (part.before.size() == part.size && now != part.before)
    out = part.offset +
          static_cast<std::size_t>(std::mismatch(now.begin(), now.end(), part.before.begin()).first - now.begin());
  part.before = now;
  return out;
}

// A write to a protected page opens the pages again and is done; its place is kept.
constexpr std::size_t most_parts = 8;
struct Protected {
  char *begin, *end;   // of the variables
  char *first, *last;  // of their pages
  std::size_t offset;
} protected_parts[most_parts];
std::size_t protected_count = 0;
volatile std::size_t written_offset = 0;
volatile bool is_written = false;
struct sigaction before_guard {};

void set_protection(int protection) {
  for (std::size_t i = 0; i < protected_count; ++i)
    mprotect(protected_parts[i].first, static_cast<std::size_t>(protected_parts[i].last - protected_parts[i].first),
             protection);
}

void on_write(int, siginfo_t* info, void*) {
  auto* const at = static_cast<char*>(info->si_addr);
  for (std::size_t i = 0; i < protected_count; ++i) {
    const Protected& part = protected_parts[i];
    if (at < part.first || at >= part.last) continue;
    if (at >= part.begin && at < part.end && !is_written) {
      written_offset = part.offset + static_cast<std::size_t>(at - part.begin);
      is_written = true;
    }
    set_protection(PROT_READ | PROT_WRITE);
    return;
  }
  sigaction(SIGSEGV, &before_guard, nullptr);  // the instruction comes again, and its fault is told
}

/// While one of these lives, a write to the library's variables is seen.
class WriteGuard {
 public:
  explicit WriteGuard(const std::vector<WritablePart>& parts) {
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    protected_count = 0;
    for (const WritablePart& part : parts) {
      if (protected_count == most_parts) break;
      const auto begin = reinterpret_cast<std::uintptr_t>(part.begin), end = begin + part.size;
      protected_parts[protected_count++] = {part.begin, part.begin + part.size,
                                            reinterpret_cast<char*>(begin & ~(page - 1)),
                                            reinterpret_cast<char*>((end + page - 1) & ~(page - 1)), part.offset};
    }
    struct sigaction guard {};
    guard.sa_sigaction = on_write;
    guard.sa_flags = SA_SIGINFO | SA_ONSTACK;
    sigaction(SIGSEGV, &guard, &before_guard);
    is_written = false;
    set_protection(PROT_READ);
  }
  ~WriteGuard() {
    set_protection(PROT_READ | PROT_WRITE);
    sigaction(SIGSEGV, &before_guard, nullptr);
  }
  WriteGuard(const WriteGuard&) = delete;
  WriteGuard& operator=(const WriteGuard&) = delete;
};

std::vector<std::string_view> variables_of(const Sought& sought) {
  std::vector<std::string_view> out;
  for (const WritablePart& part : sought.parts) out.emplace_back(part.begin, part.size);
  return out;
}

std::size_t offset_of(const char* variable, const Sought& sought) {
  for (const WritablePart& part : sought.parts)
    if (variable >= part.begin && variable < part.begin + part.size)
      return part.offset + static_cast<std::size_t>(variable - part.begin);
  return 0;
}

/// The variables of the library and what it allocated for them, as they were when it was loaded.
class AtLoad {
 public:
  AtLoad(const Sought& sought, OwnMemory& own, const std::set<const void*>& before) {
    for (const void* const piece : pieces_in_use())
      if (!before.contains(piece)) own.add(piece), pieces_.insert(piece);
    const auto is_first = [&](const void* piece, const char*) { return pieces_.contains(piece); };
    std::vector<std::string_view> all = variables_of(sought);
    const std::vector<std::string_view> reached = ReachableMemory(all, is_first).pieces();
    all.insert(all.end(), reached.begin(), reached.end());
    for (const std::string_view memory : all) memory_.emplace(memory.data(), memory);
  }
  bool has(const void* piece) const { return pieces_.contains(piece); }
  /// The word has not been written since.
  bool is_same(const char* word) const {
    const auto behind = memory_.upper_bound(word);
    if (behind == memory_.begin()) return false;
    const auto& [begin, bytes] = *std::prev(behind);
    const auto offset = static_cast<std::size_t>(word - begin);
    return offset + sizeof(void*) <= bytes.size() && std::memcmp(bytes.data() + offset, word, sizeof(void*)) == 0;
  }

 private:
  std::set<const void*> pieces_;
  std::map<const char*, std::string> memory_;
};

/// What a build of the block changes of all chains' memory; empty where it is nothing.
std::string change_by(Bench& bench, const TestBlock& block, Sought& sought,
                      const ReachableMemory::IsPointer& is_pointer) {
  bench.prepare(block);
  changed_offset(sought.of_thread);
  const ReachableMemory before(variables_of(sought), is_pointer);
  {
    const WriteGuard guard(sought.parts);
    bench.scan();
    bench.build();
  }
  if (is_written)
    return fmt::format("it writes to a static variable, which all chains share; nm -C names it near {:#x}",
                       static_cast<std::size_t>(written_offset));
  if (changed_offset(sought.of_thread))
    return "it changes a variable of the thread (thread_local), which all chains of the thread share";
  if (const char* const variable = before.changed_from(); variable != nullptr)
    return fmt::format(
        "it changes memory to which a static variable points, which all chains share; nm -C names it near {:#x}",
        offset_of(variable, sought));
  return {};
}

}  // namespace

void check_statics(Examination& e) {
  constexpr std::uint64_t random_ones = 100;
  Sought sought{.file = e.file};
  const std::set<const void*> before = pieces_in_use();
  dlopen(e.file.c_str(), RTLD_NOW | RTLD_LOCAL);
  dl_iterate_phdr(note_parts, &sought);
  OwnMemory own(e.file);
  const AtLoad first(sought, own, before);
  // A word that was there before the piece was allocated points to it by chance alone.
  const ReachableMemory::IsPointer is_pointer = [&](const void* piece, const char* word) {
    return own.contains(piece) && (first.has(piece) || !first.is_same(word));
  };
  Subject subject(e);
  for (const Stand& stand : stands_of(subject, e)) {
    Bench bench(stand.alone, in_mode(Mode::fast));
    std::vector<TestBlock> blocks = many_blocks(stand, e, stand.dependencies.empty() ? random_ones : 0);
    for (const double number : rare_numbers) blocks.push_back(block_of_numbers(stand, number));
    // What is computed at its first use, and stays so, may be static; `two-chains` sees what is not the same for all.
    for (const TestBlock& block : blocks) bench.run(block, false);
    sought = {.file = e.file};
    dl_iterate_phdr(note_parts, &sought);
    for (const TestBlock& block : blocks) {
      const std::string where = std::string(stand.syntax->id) + ", " + block.name;
      e.attempt(where);
      const std::string change = change_by(bench, block, sought, is_pointer);
      if (change.empty()) continue;
      e.find(where, change);
      break;
    }
  }
}

}  // namespace isogloss::cli
