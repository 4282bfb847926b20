/// Do the parts of a shared library lie inside the file? Checked before its offsets are followed: a damaged or
/// truncated file must not make the host reserve memory for sizes that it merely claims, nor end in the loader.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isogloss {

/// Why the file cannot be a shared library, or what is wrong with its section table or with the tables of the loader;
/// empty when nothing is, or when the file cannot be read or is none of 64 bits (the loader says the rest).
std::optional<std::string> elf_fault(const std::filesystem::path& file);

/// The symbols that a library without elf_fault() exports: those that the loader sees, which stripping leaves in the
/// file. (The parser's own list is of the symbols that stripping removes.)
std::vector<std::string> elf_exports(const std::filesystem::path& file);

}  // namespace isogloss
