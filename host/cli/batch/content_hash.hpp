/// What a batch compares contents by: XXH3, 128 bits. It finds changes, not forgeries.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace isogloss::cli::batch {

struct ContentHash {
  std::uint64_t high = 0, low = 0;
  bool operator==(const ContentHash&) const = default;
  std::string text() const;  ///< 32 hexadecimal digits
};

ContentHash hash_of(std::string_view bytes);

/// Hashes of files, each read once.
class FileHashes {
 public:
  /// "missing" for what cannot be read.
  const std::string& of(const std::string& file);
  /// Of the names in a folder, to see that one is added or gone.
  const std::string& of_names_in(const std::string& folder);

 private:
  std::map<std::string, std::string> files_, folders_;
};

}  // namespace isogloss::cli::batch
