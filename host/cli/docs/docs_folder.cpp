#include "docs/docs_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include "outputs.hpp"

namespace isogloss::cli::docs {

namespace fs = std::filesystem;

namespace {

/// Lists the files of the reference, one a line, below a line that tells what it is.
constexpr const char* list_name = ".isogloss-docs";
constexpr std::string_view list_head = "Files that `isogloss docs` made; the next reference replaces them.";

bool is_below(const fs::path& path) {
  return !path.empty() && path.is_relative() &&
         std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
}

std::set<std::string> listed_files(const fs::path& folder) {
  std::string ignored;
  std::set<std::string> out;
  std::istringstream list(read_text((folder / list_name).string(), ignored).value_or(""));
  std::string line;
  std::getline(list, line);
  while (std::getline(list, line))
    if (is_below(line)) out.insert(line);
  return out;
}

}  // namespace

bool DocsFolder::is_ours(Session& session) const {
  std::error_code error;
  const fs::file_status status = fs::status(folder_, error);
  if (!fs::exists(status)) return true;
  if (!fs::is_directory(status)) {
    session.report("IG-0511", {folder_}, {"it is a file, not a folder"});
    return false;
  }
  const bool is_empty = fs::is_empty(folder_, error);
  if (error) {
    session.report("IG-0511", {folder_}, {error.message()});
    return false;
  }
  std::string ignored;
  const std::string list = read_text((fs::path(folder_) / list_name).string(), ignored).value_or("");
  if (is_empty || list.starts_with(list_head)) return true;
  session.report("IG-0175", {folder_}, {});
  return false;
}

bool DocsFolder::write(const std::map<std::string, std::string>& files, Session& session) const {
  const fs::path folder(folder_);
  std::set<std::string> old = listed_files(folder), made;
  for (const auto& [name, text] : files) made.insert(name);
  const auto write_list = [&](const std::set<std::string>& names) {
    std::string list = std::string(list_head) + "\n";
    for (const std::string& name : names) list += name + "\n";
    return write_file((folder / list_name).string(), list, session);
  };
  std::error_code error;
  for (const std::string& name : made) fs::create_directories((folder / name).parent_path(), error);
  if (error) {
    session.report("IG-0511", {folder_}, {error.message()});
    return false;
  }
  // Both stand in the list until the end, so that a reference that was broken off is made anew the next time.
  std::set<std::string> all = made;
  all.insert(old.begin(), old.end());
  if (!write_list(all)) return false;
  for (const auto& [name, text] : files)
    if (!write_file((folder / name).string(), text, session)) return false;
  for (const std::string& name : old)
    if (!made.contains(name)) fs::remove(folder / name, error);
  return write_list(made);
}

}  // namespace isogloss::cli::docs
