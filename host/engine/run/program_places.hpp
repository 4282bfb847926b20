/// Where the files of called programs may be: the folders and files that the user gives, and below them the folders of
/// the control's search order.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <isogloss_flow.h>

#include "isogloss/engine/dialect.hpp"

namespace isogloss {

std::string in_small_letters(std::string_view text);

/// The names under which a call looks for its program, apart from the folders that they name ("SPF.DIR/").
struct SearchedNames {
  explicit SearchedNames(std::span<const ig_text> files);
  std::vector<std::string> own_folders;   ///< of the call: where one of them is there, nothing else is searched
  std::vector<std::string> stems;         ///< small letters, the best first
  std::vector<std::string> path_folders;  ///< that the program has added to the search
};

/// Finds files of programs by name. Only what lies in a searched folder itself is found: no link that leads elsewhere.
class ProgramPlaces {
 public:
  /// Folders of the search order stand in those of `places`, or one folder further down; not so below the folder of the
  /// main program, whose subfolders may be those of other machines.
  ProgramPlaces(const std::vector<std::string>& places, const std::vector<std::string>& extensions,
                const std::vector<SearchFolder>& order, const std::filesystem::path& main_folder);
  struct Found {
    std::filesystem::path file;  ///< resolved
    std::string name;            ///< as it is shown
    bool is_library = false;     ///< a file of several programs: used only when it holds the label
  };
  using Take = std::function<bool(const Found&)>;
  /// Calls `take` with each file that may hold the program, the best first, until it returns true. An obstacle is
  /// written to `reason`.
  bool find(const SearchedNames& names, const Take& take, std::string& reason);
  /// Whether a folder of the call itself is there.
  bool has_own_folder(const SearchedNames& names);
  /// The files that the search order places after the one that find() has taken.
  std::vector<std::string> hidden(const SearchedNames& names);
  /// The place of a folder in the search order, from 1; 0 where the order does not have it.
  int rank_of(std::string_view folder, const SearchedNames& names) const;
  /// Every file of the folders that may hold programs, whatever its name; of a folder of more than 256 none, and of all
  /// together 4096 files and 64 MiB at most. Listed once.
  const std::vector<Found>& inside();
  /// The folders and files that were looked at up to now, those of the search order and of paths among them.
  std::vector<std::string> looked_in() const;
  /// Folders that may hold folders of the search order one day, and hold none of them yet.
  const std::vector<std::string>& asked() const { return asked_; }
  std::string describe() const;  ///< "folder a, file b"; what inside() has left out of a folder is told

 private:
  struct Folder {
    std::string shown;
    std::filesystem::path resolved;
    bool is_listed = false, is_library = false;
    std::size_t unread = 0;                                                // files that inside() leaves out
    std::map<std::string, std::vector<std::string>, std::less<>> files;    // by stem in small letters
    std::map<std::string, std::vector<std::string>, std::less<>> folders;  // by name in small letters
  };
  void list(Folder& folder) const;
  /// The folders of that name in a folder.
  std::vector<Folder*> below(Folder& folder, const std::string& name);
  Folder* known(const std::filesystem::path& resolved, const std::string& shown);
  /// The folders that a path such as "wks.dir/part.wpd" names, below the given folders or as one of them.
  std::vector<Folder*> at_path(const std::string& path);
  /// The folders in the order in which a call searches them.
  std::vector<Folder*> searched(const SearchedNames& names);
  bool find_in(Folder& folder, const std::vector<std::string>& stems, const Take& take, std::string& reason);
  std::vector<Found> list_inside();

  std::optional<std::vector<Found>> inside_;
  std::deque<Folder> folders_;
  std::vector<std::string> asked_;
  std::vector<Folder*> given_, roots_;  // roots_: where folders of the search order stand, or may stand
  const std::vector<SearchFolder>& order_;
  std::vector<std::vector<Folder*>> levels_;  // the folders for each part of order_
  std::vector<std::string> extensions_;
};

}  // namespace isogloss
