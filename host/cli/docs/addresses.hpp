/// Where each thing stands in the reference: the page, without its extension, and the place on it.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace isogloss::cli::docs {

/// A part is a syntax, a dependency or an importer.
enum class Kind { part, dialect, machine, plugin, field, diagnostic, code };

struct Address {
  std::string file;    ///< "pages/drilling_cycle_syntax", from the folder of the reference
  std::string anchor;  ///< empty: the whole page
};

class Addresses {
 public:
  /// A name has one address: the first one. The file, too, becomes unique, on file systems that fold case as well.
  const Address& add(Kind kind, const std::string& name, const std::string& folder, const std::string& stem);
  /// A name that stands on a page of others.
  const Address& add_on(const std::string& file, Kind kind, const std::string& name);
  /// A page that has no name of its own.
  void add_file(const std::string& file) { files_.insert(file); }

  /// Null where nothing has the name.
  const Address* find(Kind kind, std::string_view name) const;
  bool has_file(const std::string& file) const { return files_.contains(file); }

 private:
  std::map<std::pair<Kind, std::string>, Address, std::less<>> by_name_;
  std::set<std::string> files_, anchors_;
};

/// Letters, digits, '.', '_' and '-' of a name, in small letters; '-' for all others.
std::string file_stem(std::string_view name);
/// From the page of one address to another one, with the extension: "../fields/dwell.html#Dwell.Time".
std::string relative_link(const std::string& from_file, const Address& to, std::string_view extension);

}  // namespace isogloss::cli::docs
