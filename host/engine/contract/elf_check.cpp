#include "contract/elf_check.hpp"

#include <elf.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <span>

#include "contract/elf_loading.hpp"

namespace isogloss {
namespace {

/// The bytes of a file, for as long as this lives; none where it cannot be mapped.
class MappedFile {
 public:
  MappedFile(const std::filesystem::path& file, std::uint64_t size) : size_(size) {
    const int opened = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (opened < 0) return;
    void* const mapped = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, opened, 0);
    ::close(opened);
    if (mapped != MAP_FAILED) data_ = static_cast<const std::byte*>(mapped);
  }
  ~MappedFile() {
    if (data_ != nullptr) ::munmap(const_cast<std::byte*>(data_), size_);
  }
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::span<const std::byte> bytes() const { return {data_, data_ == nullptr ? 0 : size_}; }

 private:
  const std::byte* data_ = nullptr;
  std::uint64_t size_;
};

}  // namespace

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
  // A library for another processor is refused by the loader, with a message of its own.
  if (header.e_machine != EM_X86_64 || header.e_type != ET_DYN || header.e_ident[EI_DATA] != ELFDATA2LSB)
    return std::nullopt;
  const MappedFile mapped(file, size);
  return mapped.bytes().empty() ? std::nullopt : elf_loading_fault(mapped.bytes());
}

namespace {

template <class Record>
std::vector<Record> records(std::istream& in, std::uint64_t offset, std::uint64_t bytes) {
  std::vector<Record> out(bytes / sizeof(Record));
  in.seekg(static_cast<std::streamoff>(offset));
  const auto wanted = static_cast<std::streamsize>(out.size() * sizeof(Record));
  if (!in.read(reinterpret_cast<char*>(out.data()), wanted)) out.clear();
  return out;
}

}  // namespace

std::vector<std::string> elf_exports(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const auto headers = records<Elf64_Ehdr>(in, 0, sizeof(Elf64_Ehdr));
  if (headers.empty() || headers[0].e_ident[EI_CLASS] != ELFCLASS64) return {};
  const auto sections =
      records<Elf64_Shdr>(in, headers[0].e_shoff, std::uint64_t{headers[0].e_shnum} * sizeof(Elf64_Shdr));
  std::vector<std::string> out;
  for (const Elf64_Shdr& section : sections) {
    if (section.sh_type != SHT_DYNSYM || section.sh_link >= sections.size()) continue;
    const Elf64_Shdr& table = sections[section.sh_link];
    if (table.sh_type != SHT_STRTAB) continue;  // the size of another may be a mere claim
    std::vector<char> names = records<char>(in, table.sh_offset, table.sh_size);
    names.push_back('\0');
    for (const Elf64_Sym& symbol : records<Elf64_Sym>(in, section.sh_offset, section.sh_size)) {
      const unsigned visibility = ELF64_ST_VISIBILITY(symbol.st_other);
      const bool is_hidden = visibility == STV_HIDDEN || visibility == STV_INTERNAL;
      // Marks of the linker, such as _end, have no size.
      const bool is_mark = symbol.st_shndx == SHN_UNDEF || symbol.st_size == 0;
      if (is_hidden || is_mark || ELF64_ST_BIND(symbol.st_info) == STB_LOCAL || symbol.st_name >= names.size())
        continue;
      out.emplace_back(names.data() + symbol.st_name);
    }
  }
  return out;
}

}  // namespace isogloss
