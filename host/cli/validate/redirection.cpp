// The tables through which a library calls malloc() or write() are filled in when it is loaded. Here they are filled in
// anew, so that the command itself needs no such functions of its own, and a run knows nothing of it.
#include "validate/redirection.hpp"

#include <elf.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace isogloss::cli {

namespace {

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

void* replacement(std::span<const Replacement> all, std::string_view name) {
  for (const Replacement& r : all)
    if (name == r.name) return r.function;
  return nullptr;
}

void redirect_rows(const dl_phdr_info& info, const LibraryTables& tables, const ElfW(Rela) * rows, std::size_t bytes,
                   std::span<const Replacement> replacements) {
  if (rows == nullptr || tables.symbols == nullptr || tables.names == nullptr) return;
  for (std::size_t i = 0; i < bytes / sizeof *rows; ++i) {
    const auto symbol = static_cast<std::size_t>(rows[i].r_info >> (sizeof(ElfW(Addr)) == 8 ? 32 : 8));
    if (symbol == 0 || rows[i].r_addend != 0) continue;
    if (void* const function = replacement(replacements, tables.names + tables.symbols[symbol].st_name))
      fill_in(reinterpret_cast<void**>(info.dlpi_addr + rows[i].r_offset), function);
  }
}

struct Wish {
  std::span<const Replacement> replacements;
  Redirected what;
  const std::filesystem::path& only;
};

int redirect_library(dl_phdr_info* info, std::size_t, void* data) {
  const auto& wish = *static_cast<const Wish*>(data);
  const std::string_view name = info->dlpi_name;
  const bool is_command = name.empty();
  // The loader allocates before and after everyone else; the system's own page has no tables.
  if (name.find("ld-linux") != std::string_view::npos || name.find("vdso") != std::string_view::npos) return 0;
  if (is_command && wish.what == Redirected::libraries) return 0;
  std::error_code error;
  if (!wish.only.empty() && (is_command || !std::filesystem::equivalent(name, wish.only, error))) return 0;
  const LibraryTables tables = tables_of(*info);
  redirect_rows(*info, tables, tables.data, tables.data_size, wish.replacements);
  redirect_rows(*info, tables, tables.calls, tables.calls_size, wish.replacements);
  return 0;
}

}  // namespace

void redirect(std::span<const Replacement> replacements, Redirected what, const std::filesystem::path& only) {
  Wish wish{replacements, what, only};
  dl_iterate_phdr(redirect_library, &wish);
}

}  // namespace isogloss::cli
