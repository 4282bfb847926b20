#include "dialect/dialect_path.hpp"

#include <algorithm>

namespace isogloss {

namespace fs = std::filesystem;

fs::path below_folder_of(const std::string& file, const std::string& path) {
  const fs::path relative = fs::path(path).lexically_normal();
  if (path.empty() || relative.is_absolute() || *relative.begin() == "..") return {};
  const fs::path folder = fs::path(file).parent_path();
  fs::path named = (folder / relative).lexically_normal();
  std::error_code error;
  const fs::path real = fs::canonical(named, error);
  if (error) return named;  // the file does not exist, which its reader reports
  const fs::path real_folder = fs::canonical(folder.empty() ? "." : folder, error);
  return !error && std::mismatch(real_folder.begin(), real_folder.end(), real.begin(), real.end()).first ==
                       real_folder.end()
             ? named
             : fs::path();
}

}  // namespace isogloss
