/// What a batch compares contents by: XXH3, 128 bits. It finds changes, not forgeries.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace isogloss::cli::batch {

struct ContentHash {
  std::uint64_t high = 0, low = 0;
  bool operator==(const ContentHash&) const = default;
  std::string text() const;  ///< 32 hexadecimal digits
};

ContentHash hash_of(std::string_view bytes);

/// Which file it is, how large, and when it was last changed, without reading it. Empty: it is not there.
std::string state_of(const std::string& file);
/// The same of a place where programs are looked for; of a folder with those of its files, where they are read as well.
std::string state_of_place(const std::string& place, bool with_contents);

/// Hashes of files, each read once.
class FileHashes {
 public:
  /// "missing" for what cannot be read.
  const std::string& of(const std::string& file);
  /// The same, read again where the file has changed since.
  const std::string& of_now(const std::string& file);
  /// Of a file; of a folder the names in it, to see that one is added or gone, and where asked their contents, too:
  /// such a hash begins with `contents_mark`.
  const std::string& of_place(const std::string& place, bool with_contents);
  /// The same, read again where the folder, or a file whose contents count, has changed since.
  const std::string& of_place_now(const std::string& place, bool with_contents);

 private:
  struct Known {
    std::string hash, state;
  };
  std::map<std::string, Known> files_;
  std::map<std::pair<std::string, bool>, Known> folders_;
};

inline constexpr char contents_mark = '+';

}  // namespace isogloss::cli::batch
