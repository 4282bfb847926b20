/// Would the loader of the system follow a damaged table of a shared library? It follows what the file claims without a
/// look, and ends the process where that is wrong: with a signal, or with exit status 127 and no name of the file.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace isogloss {

/// What is wrong with the segments of a library of 64 bits, or with the tables through which the loader connects it
/// (strings, symbols, hashes, versions, relocations, initializers); empty when nothing is. Code and data are not looked
/// at. The bytes are those of the whole file and begin at a multiple of 8.
std::optional<std::string> elf_loading_fault(std::span<const std::byte> file);

}  // namespace isogloss
