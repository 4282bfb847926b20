#include "contract/elf_check.hpp"

#include <elf.h>

#include <cstring>
#include <fstream>

namespace isogloss {

std::optional<std::string> elf_fault(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  Elf64_Ehdr header{};
  if (error || !in) return std::nullopt;
  if (size == 0) return "the file is empty";
  if (!in.read(reinterpret_cast<char*>(&header), sizeof header) || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0)
    return "the file does not begin as an ELF file does";
  if (header.e_ident[EI_CLASS] != ELFCLASS64) return std::nullopt;

  const auto lies_inside = [&](std::uint64_t offset, std::uint64_t bytes) {
    return offset <= size && bytes <= size - offset;
  };
  if (header.e_shnum != 0 && header.e_shentsize != sizeof(Elf64_Shdr)) return "its section table is damaged";
  if (header.e_shnum == 0 || header.e_shstrndx >= header.e_shnum) return "it has no section table";
  if (!lies_inside(header.e_shoff, std::uint64_t{header.e_shnum} * sizeof(Elf64_Shdr)))
    return "its section table lies outside the file";
  in.seekg(static_cast<std::streamoff>(header.e_shoff));
  for (unsigned i = 0; i < header.e_shnum; ++i) {
    Elf64_Shdr section{};
    if (!in.read(reinterpret_cast<char*>(&section), sizeof section)) return "its section table cannot be read";
    if (section.sh_type != SHT_NOBITS && section.sh_type != SHT_NULL &&
        !lies_inside(section.sh_offset, section.sh_size))
      return "section " + std::to_string(i) + " lies outside the file";
  }
  return std::nullopt;
}

}  // namespace isogloss
