/// Paths of programs as the control writes them: /_N_WKS_DIR/_N_PART_WPD/_N_NAME_SPF is NAME in WKS.DIR/PART.WPD.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <isogloss/sdk.hpp>

#include "language/upper.hpp"

namespace siemens {

/// A name of the control's file system without _N_, in capitals. The end of a folder's name becomes an extension.
inline std::string plain_name(std::string_view name) {
  std::string out = upper(ig::cnc::trim(name));
  if (out.starts_with("_N_")) out.erase(0, 3);
  if (out.size() > 4 && (out.ends_with("_DIR") || out.ends_with("_WPD"))) out[out.size() - 4] = '.';
  return out;
}

/// WKS.DIR/PART.WPD of /_N_WKS_DIR/_N_PART_WPD; drives ("//NC:", "C:") are left out.
inline std::string folder_of(std::string_view path) {
  std::string out;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find_first_of("/\\"), path.size());
    const std::string part = plain_name(path.substr(0, end));
    if (!part.empty() && !part.ends_with(':')) out += (out.empty() ? "" : "/") + part;
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return out;
}

/// A program as a call names it.
struct CalledProgram {
  std::string name;    ///< in capitals, without _N_ and without _SPF or _MPF
  std::string kind{};  ///< "SPF" or "MPF" where the call names one
  std::string folder{};

  static CalledProgram at(std::string_view path) {
    const std::size_t begin = std::min(path.find_last_of("/\\:") + 1, path.size());
    const std::string_view file = path.substr(begin);
    CalledProgram out{upper(ig::cnc::trim(file.substr(0, file.find('.')))), {}, folder_of(path.substr(0, begin))};
    if (out.name.starts_with("_N_")) out.name.erase(0, 3);
    const std::string extension =
        file.find('.') == std::string_view::npos ? "" : upper(ig::cnc::trim(file.substr(file.find('.') + 1)));
    for (const std::string_view kind : {"SPF", "MPF"}) {
      if (extension == kind) out.kind = kind;
      if (out.name.size() <= 4 || !out.name.ends_with(kind) || out.name[out.name.size() - 4] != '_') continue;
      out.name.erase(out.name.size() - 4);
      out.kind = kind;
    }
    return out;
  }
};

/// The files that may hold the program, and the folders that the call and CALLPATH name, for ig::Flow::Call.
class CalledFiles {
 public:
  CalledFiles(const CalledProgram& program, const std::vector<std::string>& call_path) {
    if (!program.folder.empty()) add_folder(program.folder);
    if (!program.kind.empty()) add_kind(program.name, program.kind);
    names_.push_back(program.name);
    add_kind(program.name, "SPF");
    add_kind(program.name, "MPF");
    for (const std::string& folder : call_path) add_folder(folder);
    for (const std::string& name : names_) texts_.push_back(ig::to_text(name));
  }
  std::span<const ig_text> list() const { return texts_; }
  CalledFiles(const CalledFiles&) = delete;
  CalledFiles& operator=(const CalledFiles&) = delete;

 private:
  void add_kind(const std::string& name, const std::string& kind) {
    names_.push_back(name + "." + kind);
    names_.push_back(name + "_" + kind);
    names_.push_back("_N_" + name + "_" + kind);
  }
  /// As the folder is called on a disk, and as the control writes it.
  void add_folder(const std::string& folder) {
    names_.push_back(folder + "/");
    std::string written;
    for (std::string_view rest = folder; !rest.empty();) {
      const std::size_t end = std::min(rest.find('/'), rest.size());
      std::string part = "_N_" + std::string(rest.substr(0, end));
      std::replace(part.begin(), part.end(), '.', '_');
      written += part + "/";
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    names_.push_back(written);
  }

  std::vector<std::string> names_;
  std::vector<ig_text> texts_;
};

}  // namespace siemens
