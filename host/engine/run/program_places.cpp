#include "run/program_places.hpp"

#include <algorithm>
#include <set>

namespace isogloss {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_subfolders = 256;  // that are looked into for folders of the search order

std::string_view view(const ig_text& text) { return {text.data, text.size}; }

/// The parts of "wks.dir/part.wpd".
std::vector<std::string> parts_of(std::string_view path) {
  std::vector<std::string> out;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('/'), path.size());
    if (end > 0) out.emplace_back(path.substr(0, end));
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return out;
}

template <class T>
void add_once(std::vector<T*>& all, T* one) {
  if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
}

}  // namespace

std::string in_small_letters(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

SearchedNames::SearchedNames(std::span<const ig_text> files) {
  for (const ig_text& file : files) {
    std::string name = in_small_letters(view(file));
    if (!name.ends_with('/')) {
      stems.push_back(std::move(name));
      continue;
    }
    name.pop_back();
    (stems.empty() ? own_folders : path_folders).push_back(std::move(name));
  }
}

ProgramPlaces::ProgramPlaces(const std::vector<std::string>& places, const std::vector<std::string>& extensions,
                             const std::vector<SearchFolder>& order, const fs::path& main_folder)
    : order_(order), levels_(order.size()) {
  extensions_.emplace_back();
  for (const std::string& e : extensions) extensions_.push_back(in_small_letters(e));
  for (const std::string& place : places) {
    std::error_code code;
    const std::string shown = place.empty() ? "." : place;
    const fs::path resolved = fs::canonical(shown, code);
    if (code) continue;
    Folder* const folder = known(resolved, shown);
    folder->is_library = !fs::is_directory(resolved, code);
    add_once(given_, folder);
    if (!folder->is_library) add_once(roots_, folder);
  }
  const auto place_levels = [&](Folder& root) {
    bool any = false;
    for (std::size_t i = 0; i < order_.size(); ++i)
      for (const std::string& name : order_[i].names)
        for (Folder* const level : below(root, in_small_letters(name))) {
          add_once(levels_[i], level);
          any = true;
        }
    return any;
  };
  // A folder is listed only where one of these is there: the folder of a main program may have any neighbours.
  const auto may_hold_levels = [&](const fs::path& folder) {
    for (const SearchFolder& level : order_)
      for (const std::string& name : level.names) {
        std::error_code code;
        std::string capitals = in_small_letters(name);
        for (char& c : capitals)
          if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
        for (const std::string& spelling : {name, in_small_letters(name), capitals})
          if (fs::is_directory(folder / spelling, code)) return true;
      }
    return false;
  };
  if (order_.empty()) return;
  for (Folder* const given : std::vector(roots_)) {
    if (place_levels(*given)) continue;
    if (given->folders.size() > most_subfolders || given->resolved == main_folder) continue;
    const auto subfolders = given->folders;
    for (const auto& [name, spellings] : subfolders)
      for (const std::string& spelling : spellings) {
        if (!may_hold_levels(given->resolved / spelling)) {
          asked_.push_back(given->shown == "." ? spelling : (fs::path(given->shown) / spelling).string());
          continue;
        }
        for (Folder* const subfolder : below(*given, name))
          if (place_levels(*subfolder)) add_once(roots_, subfolder);
      }
  }
}

ProgramPlaces::Folder* ProgramPlaces::known(const fs::path& resolved, const std::string& shown) {
  for (Folder& folder : folders_)
    if (folder.resolved == resolved) return &folder;
  Folder& folder = folders_.emplace_back();
  folder.shown = shown;
  folder.resolved = resolved;
  return &folder;
}

std::vector<ProgramPlaces::Folder*> ProgramPlaces::below(Folder& folder, const std::string& name) {
  std::vector<Folder*> out;
  if (folder.is_library) return out;
  if (!folder.is_listed) list(folder);
  const auto named = folder.folders.find(name);
  if (named == folder.folders.end()) return out;
  for (const std::string& spelling : named->second) {
    std::error_code code;
    const fs::path resolved = fs::canonical(folder.resolved / spelling, code);
    if (code || resolved.parent_path() != folder.resolved) continue;
    out.push_back(known(resolved, folder.shown == "." ? spelling : (fs::path(folder.shown) / spelling).string()));
  }
  return out;
}

std::vector<ProgramPlaces::Folder*> ProgramPlaces::at_path(const std::string& path) {
  const std::vector<std::string> parts = parts_of(path);
  std::vector<Folder*> out;
  if (parts.empty()) return out;
  for (Folder* const root : std::vector(roots_)) {
    // The folder itself may end as the path begins: PART.WPD, or WKS.DIR, or the root above both.
    for (std::size_t matched = parts.size() + 1; matched-- > 0;) {
      fs::path end = root->resolved;
      bool is_same = true;
      for (std::size_t i = matched; is_same && i-- > 0; end = end.parent_path())
        is_same = in_small_letters(end.filename().string()) == parts[i];
      if (!is_same) continue;
      std::vector<Folder*> reached{root};
      for (std::size_t i = matched; i < parts.size(); ++i) {
        std::vector<Folder*> next;
        for (Folder* const folder : reached)
          for (Folder* const one : below(*folder, parts[i])) add_once(next, one);
        reached = std::move(next);
      }
      for (Folder* const folder : reached) add_once(out, folder);
    }
  }
  return out;
}

std::vector<ProgramPlaces::Folder*> ProgramPlaces::searched(const SearchedNames& names) {
  std::vector<Folder*> out = given_;
  bool has_path = false;
  const auto add_path = [&] {
    for (const std::string& path : names.path_folders)
      for (Folder* const folder : at_path(path)) add_once(out, folder);
    has_path = true;
  };
  for (std::size_t i = 0; i < order_.size(); ++i) {
    if (order_[i].names.empty()) add_path();
    for (Folder* const folder : levels_[i]) add_once(out, folder);
  }
  if (!has_path) add_path();
  return out;
}

bool ProgramPlaces::has_own_folder(const SearchedNames& names) {
  return std::any_of(names.own_folders.begin(), names.own_folders.end(),
                     [&](const std::string& path) { return !at_path(path).empty(); });
}

int ProgramPlaces::rank_of(std::string_view folder, const SearchedNames& names) const {
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const std::vector<std::string>& all = order_[i].names.empty() ? names.path_folders : order_[i].names;
    for (const std::string& name : all)
      if (in_small_letters(name) == folder) return static_cast<int>(i) + 1;
  }
  return 0;
}

void ProgramPlaces::list(Folder& folder) const {
  folder.is_listed = true;
  std::error_code code;
  for (fs::directory_iterator i(folder.resolved, code), end; !code && i != end; i.increment(code)) {
    const std::string name = i->path().filename().string();
    std::error_code ignored;
    if (i->is_directory(ignored)) folder.folders[in_small_letters(name)].push_back(name);
    const std::string extension = in_small_letters(i->path().extension().string());
    if (std::find(extensions_.begin(), extensions_.end(), extension) != extensions_.end())
      folder.files[in_small_letters(i->path().stem().string())].push_back(name);
    if (!extension.empty()) folder.files[in_small_letters(name)].push_back(name);
  }
  for (auto& [name, spellings] : folder.folders) std::sort(spellings.begin(), spellings.end());
  const auto rank = [&](const std::string& name) {
    const std::string extension = in_small_letters(fs::path(name).extension().string());
    return std::find(extensions_.begin(), extensions_.end(), extension) - extensions_.begin();
  };
  for (auto& [stem, names] : folder.files)
    std::sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
      return std::pair(rank(a), a) < std::pair(rank(b), b);
    });
}

bool ProgramPlaces::find(const SearchedNames& names, const Take& take, std::string& reason) {
  if (has_own_folder(names)) {
    for (const std::string& path : names.own_folders)
      for (Folder* const folder : at_path(path)) {
        if (find_in(*folder, names.stems, take, reason)) return true;
        if (reason.empty()) reason = "looked in folder " + folder->shown;
      }
    return false;
  }
  for (Folder* const folder : searched(names))
    if (find_in(*folder, names.stems, take, reason)) return true;
  return false;
}

bool ProgramPlaces::find_in(Folder& folder, const std::vector<std::string>& stems, const Take& take,
                            std::string& reason) {
  if (folder.is_library) return take({folder.resolved, folder.shown, true});
  if (!folder.is_listed) list(folder);
  for (const std::string& stem : stems) {
    const auto named = folder.files.find(stem);
    if (named == folder.files.end()) continue;
    for (const std::string& name : named->second) {
      std::error_code code;
      const fs::path resolved = fs::canonical(folder.resolved / name, code);
      const std::string shown = folder.shown == "." ? name : (fs::path(folder.shown) / name).string();
      if (code)
        reason = shown + " cannot be read: " + code.message();
      else if (resolved.parent_path() != folder.resolved)
        reason = shown + " is a link that leads out of its folder";
      else if (fs::is_directory(resolved, code))
        reason = shown + " is a folder";
      else if (take({resolved, shown, false}))
        return true;
    }
  }
  return false;
}

std::vector<std::string> ProgramPlaces::hidden(const SearchedNames& names) {
  std::vector<std::string> out;
  if (order_.empty() || has_own_folder(names)) return out;
  bool is_found = false;
  for (Folder* const folder : searched(names)) {
    std::string ignored;
    const auto is_there = [&](const Found& found) {
      if (found.is_library) return false;
      if (is_found) out.push_back(found.name);
      return true;
    };
    is_found = find_in(*folder, names.stems, is_there, ignored) || is_found;
  }
  return out;
}

const std::vector<ProgramPlaces::Found>& ProgramPlaces::inside() {
  if (!inside_) inside_ = list_inside();
  return *inside_;
}

std::vector<ProgramPlaces::Found> ProgramPlaces::list_inside() {
  constexpr std::size_t most_files_of_folder = 256, most_files = 4096;
  std::uintmax_t bytes_left = std::uintmax_t{64} << 20;
  std::vector<Found> out;
  for (Folder* const folder : searched(SearchedNames({}))) {
    if (folder->is_library) continue;
    if (!folder->is_listed) list(*folder);
    std::set<std::string> names;
    for (const auto& [stem, files] : folder->files)
      for (const std::string& name : files)
        if (const std::string e = in_small_letters(fs::path(name).extension().string());
            std::find(extensions_.begin(), extensions_.end(), e) != extensions_.end())
          names.insert(name);
    if (names.size() > most_files_of_folder) {
      folder->unread = names.size();
      continue;
    }
    for (const std::string& name : names) {
      std::error_code code;
      const fs::path resolved = fs::canonical(folder->resolved / name, code);
      if (code || resolved.parent_path() != folder->resolved || !fs::is_regular_file(resolved, code)) continue;
      const std::uintmax_t size = fs::file_size(resolved, code);
      if (code || size > bytes_left || out.size() == most_files) {
        ++folder->unread;
        continue;
      }
      bytes_left -= size;
      out.push_back({resolved, folder->shown == "." ? name : (fs::path(folder->shown) / name).string(), true});
    }
  }
  return out;
}

std::vector<std::string> ProgramPlaces::looked_in() const {
  std::vector<std::string> out;
  for (const Folder& folder : folders_) out.push_back(folder.shown);
  return out;
}

std::string ProgramPlaces::describe() const {
  std::string out;
  const auto add = [&](const Folder& folder) {
    out += (out.empty() ? "" : ", ") + std::string(folder.is_library ? "file " : "folder ") + folder.shown;
    if (folder.unread > 0) out += " (not inside " + std::to_string(folder.unread) + " files of other names)";
  };
  for (const Folder* const folder : given_) add(*folder);
  for (const auto& level : levels_)
    for (const Folder* const folder : level) add(*folder);
  return out;
}

}  // namespace isogloss
