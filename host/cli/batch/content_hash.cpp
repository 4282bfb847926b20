#include "batch/content_hash.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <vector>

namespace isogloss::cli::batch {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t largest_searched = std::uintmax_t{64} << 20;  // no program is looked for in a larger file

std::string hash_of_file(const std::string& file) {
  std::error_code code;
  if (!fs::is_regular_file(file, code)) return "missing";  // a pipe would wait for its writer
  std::ifstream in(file, std::ios::binary);
  if (!in) return "missing";
  const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(), XXH3_freeState);
  XXH3_128bits_reset(state.get());
  std::string buffer(std::size_t{1} << 18, '\0');
  while (in.read(buffer.data(), static_cast<std::streamsize>(buffer.size())), in.gcount() > 0)
    XXH3_128bits_update(state.get(), buffer.data(), static_cast<std::size_t>(in.gcount()));
  const XXH128_hash_t hash = XXH3_128bits_digest(state.get());
  return ContentHash{hash.high64, hash.low64}.text();
}

}  // namespace

std::string ContentHash::text() const { return fmt::format("{:016x}{:016x}", high, low); }

ContentHash hash_of(std::string_view bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return {hash.high64, hash.low64};
}

std::string state_of(const std::string& file) {
  struct stat s {};
  if (::stat(file.empty() ? "." : file.c_str(), &s) != 0) return {};
  return fmt::format("{}:{}:{}:{}.{:09}:{}.{:09}", s.st_dev, s.st_ino, s.st_size, s.st_mtim.tv_sec, s.st_mtim.tv_nsec,
                     s.st_ctim.tv_sec, s.st_ctim.tv_nsec);
}

std::string state_of_place(const std::string& place, bool with_contents) {
  std::string out = state_of(place);
  std::error_code code;
  if (!with_contents || !fs::is_directory(place.empty() ? "." : place, code)) return out;
  std::vector<std::string> files;
  for (fs::directory_iterator i(place.empty() ? "." : place, code), end; !code && i != end; i.increment(code))
    if (std::error_code ignored; i->is_regular_file(ignored)) files.push_back(i->path().string());
  std::sort(files.begin(), files.end());
  std::string all;
  for (const std::string& file : files) all.append(file).append(1, '\0').append(state_of(file)).push_back('\0');
  return out + ":" + hash_of(all).text();
}

const std::string& FileHashes::of(const std::string& file) {
  const auto known = files_.find(file);
  return known != files_.end() ? known->second.hash : of_now(file);
}

const std::string& FileHashes::of_now(const std::string& file) {
  std::string state = state_of(file);  // before it is read: what changes meanwhile is seen the next time
  const auto [at, is_new] = files_.try_emplace(file);
  if (is_new || at->second.state != state) at->second = {hash_of_file(file), std::move(state)};
  return at->second.hash;
}

const std::string& FileHashes::of_place(const std::string& place, bool with_contents) {
  std::error_code code;
  if (fs::is_regular_file(place, code)) return of(place);
  const auto known = folders_.find(std::pair(place, with_contents));
  return known != folders_.end() ? known->second.hash : of_place_now(place, with_contents);
}

const std::string& FileHashes::of_place_now(const std::string& place, bool with_contents) {
  std::error_code code;
  if (fs::is_regular_file(place, code)) return of_now(place);
  std::string state = state_of_place(place, with_contents);
  const auto [at, is_new] = folders_.try_emplace(std::pair(place, with_contents));
  Known& known = at->second;
  if (!is_new && known.state == state) return known.hash;
  std::vector<std::string> names;
  for (fs::directory_iterator i(place.empty() ? "." : place, code), end; !code && i != end; i.increment(code))
    names.push_back(i->path().filename().string());
  std::sort(names.begin(), names.end());
  std::string all;
  for (const std::string& name : names) {
    all.append(name).push_back('\0');
    const fs::path file = fs::path(place) / name;
    if (with_contents && fs::file_size(file, code) <= largest_searched) all.append(of_now(file.string()));
  }
  known = {hash_of(all).text(), std::move(state)};
  if (with_contents) known.hash.insert(known.hash.begin(), contents_mark);
  return known.hash;
}

}  // namespace isogloss::cli::batch
