/// Who can change or replace a plugin before it is loaded?
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace isogloss {

/// A file or folder on the way to a plugin that others can write.
struct OpenPlace {
  std::filesystem::path path;
  std::string who;     ///< "every user", "the group games"
  std::string remedy;  ///< "chmod o-w PATH"
};

/// The first such place; empty when there is none. Looks at the file or folder, at the folder that holds it, at the
/// same of each link on the way, and whether every user can write one of the folders above.
std::optional<OpenPlace> open_place(const std::filesystem::path& path);

}  // namespace isogloss
