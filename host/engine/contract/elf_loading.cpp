#include "contract/elf_loading.hpp"

#include <elf.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <set>
#include <string_view>
#include <vector>

namespace isogloss {
namespace {

constexpr std::uint64_t page = 4096;
constexpr std::uint64_t most_address = std::uint64_t{1} << 47, most_thread_local = std::uint64_t{1} << 30;

constexpr unsigned most_segments = 64;  // linkers make about ten
constexpr std::size_t longest_file_name = 4096;

/// A description of what is wrong, or nothing.
using Fault = std::optional<std::string>;

std::uint64_t end_of_page(std::uint64_t address) { return (address + page - 1) / page * page; }

/// The library as the loader lays it into memory, addresses counted from where it begins there.
class Image {
 public:
  explicit Image(std::span<const std::byte> file) : file_(file) {}

  Fault read_segments() {
    const auto header = at<Elf64_Ehdr>(file_, 0);
    if (!header || header->e_phentsize != sizeof(Elf64_Phdr)) return "its program headers have another size";
    if (header->e_phnum > most_segments) return "it has too many segments";
    for (unsigned i = 0; i < header->e_phnum; ++i) {
      const auto segment = at<Elf64_Phdr>(file_, header->e_phoff + i * sizeof(Elf64_Phdr));
      if (!segment) return "its program headers lie outside the file";
      if (segment->p_type == PT_NULL || segment->p_type == PT_GNU_STACK) continue;
      if (segment->p_offset > file_.size() || segment->p_filesz > file_.size() - segment->p_offset)
        return "segment " + std::to_string(i) + " lies outside the file";
      if (segment->p_filesz > segment->p_memsz || segment->p_vaddr > most_address || segment->p_memsz > most_address)
        return "segment " + std::to_string(i) + " has a size that cannot be right";
      if (segment->p_type == PT_LOAD) {
        if (!loads_.empty() && segment->p_vaddr / page * page < end_of_page(end_of(loads_.back())))
          return "segment " + std::to_string(i) + " lies on the one before it";
        loads_.push_back(*segment);
      } else {
        others_.push_back(*segment);
      }
    }
    return loads_.empty() ? Fault("it has no segment to load") : std::nullopt;
  }
  /// Does each section that is loaded lie where its segment puts it? The section table lies inside the file.
  Fault check_sections() const {
    const auto header = at<Elf64_Ehdr>(file_, 0);
    for (unsigned i = 0; header && i < header->e_shnum; ++i) {
      const auto section = at<Elf64_Shdr>(file_, header->e_shoff + i * sizeof(Elf64_Shdr));
      if (!section || (section->sh_flags & SHF_ALLOC) == 0 || section->sh_size == 0) continue;
      const std::vector<Elf64_Phdr>& all = (section->sh_flags & SHF_TLS) != 0 ? others_ : loads_;
      const bool is_held = std::any_of(all.begin(), all.end(), [&](const Elf64_Phdr& s) { return agree(*section, s); });
      if (!is_held) return "section " + std::to_string(i) + " lies outside its segment";
    }
    return std::nullopt;
  }
  /// The segments that are not loaded, but describe parts of those that are.
  const std::vector<Elf64_Phdr>& others() const { return others_; }

  /// Are there so many bytes in memory, in one segment that has all the flags?
  bool holds(std::uint64_t address, std::uint64_t bytes, std::uint32_t flags = 0) const {
    const auto is_held = [&](const Elf64_Phdr& load) {
      return lies_in(load.p_vaddr, load.p_memsz, address, bytes) && (load.p_flags & flags) == flags;
    };
    if (is_held(loads_[last_])) return true;
    const auto found = std::find_if(loads_.begin(), loads_.end(), is_held);
    if (found == loads_.end()) return false;
    last_ = static_cast<std::size_t>(found - loads_.begin());
    return true;
  }
  /// The same for what ends with a page.
  bool holds_pages(std::uint64_t address, std::uint64_t bytes, std::uint32_t flags) const {
    return std::any_of(loads_.begin(), loads_.end(), [&](const Elf64_Phdr& load) {
      return (load.p_flags & flags) == flags &&
             lies_in(load.p_vaddr, end_of_page(end_of(load)) - load.p_vaddr, address, bytes);
    });
  }
  /// Those bytes of the file that are laid there, up to the end of the segment's part of the file.
  std::span<const std::byte> bytes_at(std::uint64_t address) const {
    for (const Elf64_Phdr& load : loads_)
      if (lies_in(load.p_vaddr, load.p_filesz, address, 0))
        return file_.subspan(load.p_offset, load.p_filesz).subspan(address - load.p_vaddr);
    return {};
  }
  template <class Record>
  std::optional<Record> record_at(std::uint64_t address) const {
    return at<Record>(bytes_at(address), 0);
  }
  /// The records of a table; nothing where it leaves the file's part of a segment, or begins within a record.
  template <class Record>
  std::optional<std::span<const Record>> table_at(std::uint64_t address, std::uint64_t bytes) const {
    const std::span<const std::byte> found = bytes_at(address);
    if (bytes > found.size() || reinterpret_cast<std::uintptr_t>(found.data()) % alignof(Record) != 0)
      return std::nullopt;
    return std::span(reinterpret_cast<const Record*>(found.data()), bytes / sizeof(Record));
  }
  std::uint64_t end() const { return end_of(loads_.back()); }

 private:
  static std::uint64_t end_of(const Elf64_Phdr& segment) { return segment.p_vaddr + segment.p_memsz; }
  static bool agree(const Elf64_Shdr& section, const Elf64_Phdr& segment) {
    const std::uint32_t flags = PF_R | ((section.sh_flags & SHF_WRITE) != 0 ? PF_W : 0u) |
                                ((section.sh_flags & SHF_EXECINSTR) != 0 ? PF_X : 0u);
    if (segment.p_type == PT_TLS) return lies_in(segment.p_vaddr, segment.p_memsz, section.sh_addr, section.sh_size);
    const bool is_placed =
        section.sh_type == SHT_NOBITS || section.sh_addr - segment.p_vaddr == section.sh_offset - segment.p_offset;
    return (segment.p_flags & flags) == flags && is_placed &&
           lies_in(segment.p_vaddr, section.sh_type == SHT_NOBITS ? segment.p_memsz : segment.p_filesz, section.sh_addr,
                   section.sh_size);
  }
  static bool lies_in(std::uint64_t begin, std::uint64_t size, std::uint64_t address, std::uint64_t bytes) {
    return address >= begin && address - begin <= size && bytes <= size - (address - begin);
  }
  template <class Record>
  static std::optional<Record> at(std::span<const std::byte> bytes, std::uint64_t offset) {
    if (offset > bytes.size() || sizeof(Record) > bytes.size() - offset) return std::nullopt;
    Record out;
    std::memcpy(&out, bytes.data() + offset, sizeof out);
    return out;
  }

  std::span<const std::byte> file_;
  std::vector<Elf64_Phdr> loads_, others_;
  mutable std::size_t last_ = 0;  ///< the segment that held what was asked for last: most relocations fill one
};

/// The tables that the dynamic section names, checked in the order in which one needs the other.
class DynamicTables {
 public:
  explicit DynamicTables(const Image& image) : image_(image) {}

  Fault fault() {
    using Check = Fault (DynamicTables::*)();
    constexpr std::array<Check, 9> checks{
        &DynamicTables::read_section,  &DynamicTables::check_segments,    &DynamicTables::check_strings,
        &DynamicTables::count_symbols, &DynamicTables::check_symbols,     &DynamicTables::check_versions,
        &DynamicTables::check_arrays,  &DynamicTables::check_relocations, &DynamicTables::check_functions};
    for (const Check check : checks) {
      if (Fault out = (this->*check)()) return out;
      if (check == &DynamicTables::count_symbols && symbols_ == 0) return std::nullopt;  // it exports no entry function
    }
    return std::nullopt;
  }

 private:
  Fault read_section() {
    const Elf64_Phdr* section = nullptr;
    for (const Elf64_Phdr& segment : image_.others())
      if (segment.p_type == PT_DYNAMIC) section = &segment;
    if (section == nullptr) return "it has no dynamic section";
    const auto entries = image_.table_at<Elf64_Dyn>(section->p_vaddr, section->p_filesz);
    if (!entries || !image_.holds(section->p_vaddr, section->p_memsz, PF_W))
      return "its dynamic section lies outside the segments";
    for (const Elf64_Dyn& entry : *entries) {
      if (entry.d_tag == DT_NULL) return std::nullopt;
      if (entry.d_tag == DT_NEEDED)
        needed_.push_back(entry.d_un.d_val);
      else
        entries_.push_back(entry);
    }
    return "its dynamic section has no end";
  }

  Fault check_segments() {
    for (const Elf64_Phdr& segment : image_.others()) {
      if (segment.p_type == PT_TLS) {
        const bool is_power = (segment.p_align & (segment.p_align - 1)) == 0;
        if (segment.p_memsz > most_thread_local || segment.p_align > most_thread_local || !is_power ||
            image_.bytes_at(segment.p_vaddr).size() < segment.p_filesz)
          return "its thread-local data cannot be right";
      }
      if (segment.p_type == PT_GNU_RELRO && !image_.holds_pages(segment.p_vaddr, segment.p_memsz, PF_W))
        return "what is protected after relocation lies outside the segments";
      const bool is_note = segment.p_type == PT_NOTE || segment.p_type == PT_GNU_PROPERTY;
      if (is_note && image_.bytes_at(segment.p_vaddr).size() < segment.p_filesz)
        return "a note lies outside the segments";
    }
    return std::nullopt;
  }

  Fault check_strings() {
    const auto bytes = value(DT_STRSZ);
    const auto found = table<char>(DT_STRTAB, bytes);
    if (!found || found->empty() || found->back() != '\0') return "its dynamic strings lie outside the segments";
    strings_ = *found;
    for (const std::int64_t tag :
         {DT_SONAME, DT_RPATH, DT_RUNPATH, DT_AUXILIARY, DT_FILTER, DT_CONFIG, DT_DEPAUDIT, DT_AUDIT})
      if (!is_string(value(tag).value_or(0))) return "a name in its dynamic section lies outside its strings";
    for (const std::uint64_t name : needed_)
      if (!is_string(name) || file_name(name).size() > longest_file_name)
        return "the name of a library that it needs lies outside its strings";
    for (const std::uint64_t name : needed_) needed_names_.emplace(file_name(name));
    return std::nullopt;
  }

  Fault count_symbols() {
    if (const auto address = value(DT_GNU_HASH)) return count_by_gnu_hash(*address);
    if (const auto address = value(DT_HASH)) return count_by_hash(*address);
    return "it has no hash table of its symbols";
  }
  Fault count_by_gnu_hash(std::uint64_t address) {
    struct Header {
      std::uint32_t buckets, first, words, shift;
    };
    const char* const fault = "the hash table of its symbols is damaged";
    const auto header = image_.record_at<Header>(address);
    if (!header || header->buckets == 0 || header->words == 0 || (header->words & (header->words - 1)) != 0)
      return fault;
    const std::uint64_t at_buckets = address + sizeof(Header) + std::uint64_t{header->words} * 8;
    const auto buckets = image_.table_at<std::uint32_t>(at_buckets, std::uint64_t{header->buckets} * 4);
    if (!buckets) return fault;
    const std::uint64_t at_chains = at_buckets + std::uint64_t{header->buckets} * 4;
    std::uint32_t last = 0;
    for (const std::uint32_t bucket : *buckets) {
      if (bucket != 0 && bucket < header->first) return fault;
      last = std::max(last, bucket);
    }
    if (last == 0) return std::nullopt;
    // The end of the last chain bounds all others.
    for (std::uint64_t i = last;; ++i) {
      const auto hash = image_.record_at<std::uint32_t>(at_chains + (i - header->first) * 4);
      if (!hash) return fault;
      symbols_ = i + 1;
      if ((*hash & 1) != 0) return std::nullopt;
    }
  }
  Fault count_by_hash(std::uint64_t address) {
    const char* const fault = "the hash table of its symbols is damaged";
    const auto counts = image_.table_at<std::uint32_t>(address, 8);
    if (!counts || (*counts)[0] == 0) return fault;
    symbols_ = (*counts)[1];
    const auto buckets = image_.table_at<std::uint32_t>(address + 8, std::uint64_t{(*counts)[0]} * 4);
    const auto chains = image_.table_at<std::uint32_t>(address + 8 + std::uint64_t{(*counts)[0]} * 4, symbols_ * 4);
    if (!buckets || !chains) return fault;
    std::uint64_t steps = 0;
    for (std::uint32_t bucket : *buckets) {
      for (; bucket != 0; bucket = (*chains)[bucket])
        if (bucket >= symbols_ || ++steps > symbols_) return fault;
    }
    return std::nullopt;
  }

  Fault check_symbols() {
    if (value(DT_SYMENT) != sizeof(Elf64_Sym)) return "its symbols have another size";
    const auto symbols = table<Elf64_Sym>(DT_SYMTAB, symbols_ * sizeof(Elf64_Sym));
    if (!symbols) return "its symbols lie outside the segments";
    for (const Elf64_Sym& symbol : *symbols) {
      if (!is_string(symbol.st_name)) return "the name of a symbol lies outside its strings";
      const unsigned type = ELF64_ST_TYPE(symbol.st_info);
      if (symbol.st_shndx == SHN_UNDEF || symbol.st_shndx == SHN_ABS || type == STT_TLS) continue;
      const bool is_code = type == STT_FUNC || type == STT_GNU_IFUNC;
      const bool is_inside = is_code ? image_.holds(symbol.st_value, 1, PF_X) : symbol.st_value <= end_of_image();
      if (!is_inside) return "the symbol " + std::string(string(symbol.st_name)) + " lies outside the segments";
    }
    return std::nullopt;
  }

  Fault check_versions() {
    const char* const fault = "the versions of its symbols are damaged";
    std::uint32_t highest = 1;
    if (!walk<Elf64_Verneed>(DT_VERNEED, [&](std::uint64_t at, const Elf64_Verneed& need) {
          if (need.vn_version != VER_NEED_CURRENT || !needed_names_.contains(file_name(need.vn_file))) return false;
          return walk_from<Elf64_Vernaux>(at + need.vn_aux, [&](std::uint64_t, const Elf64_Vernaux& version) {
            highest = std::max<std::uint32_t>(highest, version.vna_other & hidden_mask);
            return is_string(version.vna_name);
          });
        }))
      return fault;
    if (!walk<Elf64_Verdef>(DT_VERDEF, [&](std::uint64_t at, const Elf64_Verdef& definition) {
          highest = std::max<std::uint32_t>(highest, definition.vd_ndx & hidden_mask);
          return definition.vd_version == VER_DEF_CURRENT &&
                 walk_from<Elf64_Verdaux>(at + definition.vd_aux, [&](std::uint64_t, const Elf64_Verdaux& name) {
                   return is_string(name.vda_name);
                 });
        }))
      return fault;
    if (!value(DT_VERSYM)) return value(DT_VERNEED) || value(DT_VERDEF) ? Fault(fault) : std::nullopt;
    const auto versions = table<std::uint16_t>(DT_VERSYM, symbols_ * 2);
    if (!versions) return fault;
    const bool is_sound = std::all_of(versions->begin(), versions->end(),
                                      [&](std::uint16_t version) { return (version & hidden_mask) <= highest; });
    return is_sound ? std::nullopt : Fault(fault);
  }

  /// Functions that the loader calls: each place must be filled by a relocation.
  Fault check_arrays() {
    const std::array<std::pair<std::int64_t, std::int64_t>, 2> tags{
        {{DT_INIT_ARRAY, DT_INIT_ARRAYSZ}, {DT_FINI_ARRAY, DT_FINI_ARRAYSZ}}};
    for (const auto& [at, bytes] : tags) {
      const auto address = value(at), size = value(bytes);
      if (!address && !size) continue;
      if (!address || !size || *size % 8 != 0 || !image_.table_at<std::uint64_t>(*address, *size))
        return "the list of its initializers lies outside the segments";
      for (std::uint64_t i = 0; i < *size; i += 8) called_.push_back(*address + i);
    }
    std::sort(called_.begin(), called_.end());
    is_filled_.resize(called_.size());
    return std::nullopt;
  }

  Fault check_relocations() {
    const auto entry = value(DT_RELAENT);
    if ((value(DT_RELA) && entry != sizeof(Elf64_Rela)) || (entry && !value(DT_RELA)) ||
        (value(DT_JMPREL) && value(DT_PLTREL) != DT_RELA) || (value(DT_PLTRELSZ) && !value(DT_JMPREL)))
      return "its relocations have another form";
    if (Fault out = check_relocations(DT_RELA, DT_RELASZ, value(DT_RELACOUNT).value_or(0))) return out;
    if (Fault out = check_relocations(DT_JMPREL, DT_PLTRELSZ, 0)) return out;
    return check_relative();
  }
  Fault check_relocations(std::int64_t tag, std::int64_t size, std::uint64_t relative) {
    if (!value(tag)) return std::nullopt;
    const auto relocations = table<Elf64_Rela>(tag, value(size));
    if (!relocations || relative > relocations->size()) return "its relocations lie outside the segments";
    for (std::size_t i = 0; i < relocations->size(); ++i) {
      const Elf64_Rela& relocation = (*relocations)[i];
      const std::uint64_t type = ELF64_R_TYPE(relocation.r_info);
      if (i < relative && type != R_X86_64_RELATIVE) return "its relocations are damaged";
      if (type == R_X86_64_NONE) continue;
      if (ELF64_R_SYM(relocation.r_info) >= symbols_ ||
          !image_.holds(relocation.r_offset, type == R_X86_64_32 || type == R_X86_64_PC32 ? 4 : 8))
        return "a relocation leads outside the segments";
      const auto to = static_cast<std::uint64_t>(relocation.r_addend);
      const bool is_called = fills_called(relocation.r_offset);
      const bool must_be_code = type == R_X86_64_IRELATIVE || (type == R_X86_64_RELATIVE && is_called);
      if ((type == R_X86_64_RELATIVE && to > end_of_image()) || (must_be_code && !image_.holds(to, 1, PF_X)))
        return "a relocation leads outside the segments";
    }
    return std::nullopt;
  }
  /// The packed list of the places to which the address of the library is added.
  Fault check_relative() {
    if (!value(DT_RELR)) return std::nullopt;
    const auto list = table<std::uint64_t>(DT_RELR, value(DT_RELRSZ));
    if (!list || value(DT_RELRENT) != sizeof(std::uint64_t)) return "its packed relocations lie outside the segments";
    std::uint64_t next = 0;
    for (const std::uint64_t entry : *list) {
      if ((entry & 1) == 0) {
        if (!relocate(entry)) return "a packed relocation leads outside the segments";
        next = entry + 8;
        continue;
      }
      for (unsigned bit = 1; bit < 64; ++bit)
        if ((entry >> bit & 1) != 0 && !relocate(next + (bit - 1) * 8))
          return "a packed relocation leads outside the segments";
      next += 63 * 8;
    }
    return std::nullopt;
  }
  bool relocate(std::uint64_t place) {
    const auto to = image_.record_at<std::uint64_t>(place);
    return to && image_.holds(place, 8) && (!fills_called(place) || image_.holds(*to, 1, PF_X));
  }
  /// True where the loader calls what stands there, which is filled now.
  bool fills_called(std::uint64_t place) {
    if (called_.empty() || place < called_.front() || place > called_.back()) return false;
    const auto found = std::lower_bound(called_.begin(), called_.end(), place);
    if (*found != place) return false;
    is_filled_[static_cast<std::size_t>(found - called_.begin())] = true;
    return true;
  }

  Fault check_functions() {
    for (const std::int64_t tag : {DT_INIT, DT_FINI})
      if (value(tag) && !image_.holds(*value(tag), 1, PF_X)) return "its initializer lies outside the segments";
    const bool are_filled = std::find(is_filled_.begin(), is_filled_.end(), false) == is_filled_.end();
    return are_filled ? std::nullopt : Fault("an initializer has no address");
  }

  static constexpr std::uint16_t hidden_mask = 0x7fff;
  static constexpr unsigned most_versions = 1u << 16;

  std::optional<std::uint64_t> value(std::int64_t tag) const {
    const auto found =
        std::find_if(entries_.rbegin(), entries_.rend(), [&](const Elf64_Dyn& e) { return e.d_tag == tag; });
    return found == entries_.rend() ? std::nullopt : std::optional<std::uint64_t>(found->d_un.d_val);
  }
  template <class Record>
  std::optional<std::span<const Record>> table(std::int64_t tag, std::optional<std::uint64_t> bytes) const {
    const auto address = value(tag);
    return address && bytes ? image_.table_at<Record>(*address, *bytes) : std::nullopt;
  }
  bool is_string(std::uint64_t offset) const { return offset < strings_.size(); }
  std::string_view string(std::uint64_t offset) const { return is_string(offset) ? strings_.data() + offset : ""; }
  /// Looked at no further than the longest one goes, since any number of records may name the same.
  std::string_view file_name(std::uint64_t offset) const {
    return is_string(offset)
               ? std::string_view(strings_.data() + offset, ::strnlen(strings_.data() + offset, longest_file_name + 1))
               : "";
  }
  std::uint64_t end_of_image() const { return image_.end(); }

  static std::uint32_t next_of(const Elf64_Verneed& need) { return need.vn_next; }
  static std::uint32_t next_of(const Elf64_Vernaux& version) { return version.vna_next; }
  static std::uint32_t next_of(const Elf64_Verdef& definition) { return definition.vd_next; }
  static std::uint32_t next_of(const Elf64_Verdaux& name) { return name.vda_next; }
  /// Hands over each record of a list whose records say how far the next one is; false where one lies outside or is not
  /// taken, or where there are too many.
  template <class Record, class Take>
  bool walk_from(std::uint64_t at, const Take& take) {
    while (++records_ < most_versions) {
      const auto record = image_.record_at<Record>(at);
      if (!record || !take(at, *record)) return false;
      if (next_of(*record) == 0) return true;
      at += next_of(*record);
    }
    return false;
  }
  template <class Record, class Take>
  bool walk(std::int64_t tag, const Take& take) {
    return !value(tag) || walk_from<Record>(*value(tag), take);
  }

  const Image& image_;
  std::vector<Elf64_Dyn> entries_;
  std::vector<std::uint64_t> needed_;
  std::set<std::string_view> needed_names_;
  std::span<const char> strings_;
  std::uint64_t symbols_ = 0;
  unsigned records_ = 0;
  std::vector<std::uint64_t> called_;  ///< places of functions that the loader calls, in order
  std::vector<bool> is_filled_;        ///< by relocations
};

}  // namespace

std::optional<std::string> elf_loading_fault(std::span<const std::byte> file) {
  Image image(file);
  if (Fault fault = image.read_segments()) return fault;
  if (Fault fault = image.check_sections()) return fault;
  return DynamicTables(image).fault();
}

}  // namespace isogloss
