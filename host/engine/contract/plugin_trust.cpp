#include "contract/plugin_trust.hpp"

#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <vector>

namespace isogloss {

namespace fs = std::filesystem;

namespace {

/// What of a path is looked at: plugins, links and the folders that hold them closely; folders further up hold what
/// belongs to others as well, and administrators let groups of theirs write there.
enum class Near : std::uint8_t { yes, no };

bool is_in_group(gid_t group) {
  if (group == ::getegid()) return true;
  std::vector<gid_t> groups(static_cast<std::size_t>(std::max(::getgroups(0, nullptr), 0)));
  const int count = ::getgroups(static_cast<int>(groups.size()), groups.data());
  return std::find(groups.begin(), groups.begin() + std::max(count, 0), group) != groups.begin() + std::max(count, 0);
}

std::string name_of_group(gid_t group) {
  const struct group* const entry = ::getgrgid(group);
  return "the group " + (entry != nullptr ? std::string(entry->gr_name) : std::to_string(group));
}

std::optional<OpenPlace> open_by_mode(const fs::path& path, const struct stat& info, Near near) {
  const bool others = (info.st_mode & S_IWOTH) != 0;
  const bool group = near == Near::yes && (info.st_mode & S_IWGRP) != 0 && !is_in_group(info.st_gid);
  if (!others && !group) return std::nullopt;
  const char* const modes = others && group ? "go-w" : others ? "o-w" : "g-w";
  return OpenPlace{path, others ? "every user" : name_of_group(info.st_gid),
                   std::string("chmod ") + modes + " " + path.string()};
}

/// Whoever can write a folder above the program that runs can replace the program itself: such a folder is no better
/// guarded by a look at it.
bool is_above_program(const fs::path& folder) {
  static const fs::path program = [] {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error);
  }();
  const auto [ended, rest] = std::mismatch(folder.begin(), folder.end(), program.begin(), program.end());
  return ended == folder.end() && rest != program.end();
}

/// The folder that holds the entry: a sticky one lets others replace only what belongs to them.
std::optional<OpenPlace> open_folder(const fs::path& folder, const struct stat& entry, Near near) {
  struct stat info {};
  if (::stat(folder.c_str(), &info) != 0) return std::nullopt;
  const bool is_kept = entry.st_uid == 0 || entry.st_uid == ::geteuid();
  if ((info.st_mode & S_ISVTX) != 0 && is_kept) return std::nullopt;
  return open_by_mode(folder, info, near);
}

}  // namespace

std::optional<OpenPlace> open_place(const fs::path& path) {
  std::error_code error;
  const fs::path whole = fs::absolute(path, error);
  if (error) return std::nullopt;
  // What is still to be walked, the next part last.
  std::vector<fs::path> rest;
  const auto walk = [&](const fs::path& relative) {
    std::vector<fs::path> parts(relative.begin(), relative.end());
    rest.insert(rest.end(), parts.rbegin(), parts.rend());
  };
  walk(whole.relative_path());
  fs::path at = "/";
  // The loader gives up much earlier.
  for (int links = 0; !rest.empty() && links <= 100;) {
    const fs::path part = rest.back();
    rest.pop_back();
    if (part.empty() || part == ".") continue;
    if (part == "..") {
      at = at.parent_path();
      continue;
    }
    const fs::path entry = at / part;
    struct stat info {};
    if (::lstat(entry.c_str(), &info) != 0) return std::nullopt;  // which the loader reports
    const bool is_link = S_ISLNK(info.st_mode);
    const bool is_last = std::all_of(rest.begin(), rest.end(), [](const fs::path& p) { return p.empty() || p == "."; });
    const bool is_near = is_link || (is_last && !S_ISDIR(info.st_mode));
    if (is_near || !is_above_program(at))
      if (auto open = open_folder(at, info, is_near ? Near::yes : Near::no)) return open;
    if (!is_link) {
      // A sticky folder with plugins is judged by each of them.
      const bool is_sticky = S_ISDIR(info.st_mode) && (info.st_mode & S_ISVTX) != 0;
      if (auto open = is_last && !is_sticky ? open_by_mode(entry, info, Near::yes) : std::nullopt) return open;
      at = entry;
      continue;
    }
    ++links;
    const fs::path target = fs::read_symlink(entry, error);
    if (error) return std::nullopt;
    if (target.is_absolute()) at = "/";
    walk(target.relative_path());
  }
  return std::nullopt;
}

}  // namespace isogloss
