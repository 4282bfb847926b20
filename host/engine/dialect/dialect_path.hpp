/// Paths in a dialect name files beside it or below its folder.
#pragma once

#include <filesystem>
#include <string>

namespace isogloss {

/// `path` below the folder of `file`; empty when it is absolute or leads out.
std::filesystem::path below_folder_of(const std::string& file, const std::string& path);

}  // namespace isogloss
