/// What `isogloss new` writes: the folder of a machine, a plugin or a dialect.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "session.hpp"

namespace isogloss::cli {

struct NewOptions {
  CommonOptions common;
  std::string what, name, title, folder;
  std::string dialect;  ///< of a machine
  std::vector<std::string> backups;
  std::string base;  ///< what a plugin's dialect, or a dialect, extends
  std::string cycle, word, table, switch_codes, language, prefix, vendor;
  bool json = false;
};

/// Prints the paths of the files that were written, and with --json what was made; the exit status.
int print_written(const NewOptions& options, const std::filesystem::path& place, const std::vector<std::string>& files,
                  Session& session);

int new_machine(const NewOptions& options);
int new_plugin(const NewOptions& options);
int new_dialect(const NewOptions& options);

/// What stands in a template as @key@, in its text and in its name.
using TemplateWords = std::map<std::string, std::string>;

/// Makes `place` of the layers, which are folders of templates; of two files of one name, the later layer's counts. All
/// paths of the files, or empty, and reported, when one cannot be read or written.
std::vector<std::string> write_templates(const std::filesystem::path& place, const std::vector<std::string>& layers,
                                         const TemplateWords& words, Session& session);

/// The files of a layer, by name, as they are; empty, and reported, when one cannot be read.
std::map<std::string, std::string> read_templates(const std::string& layer, Session& session);

/// What plugin and dialect have in common: a name that is free, and the dialect that they stand on.
class NewFolder {
 public:
  /// `what` is "a plugin" or "a dialect"; the options must outlive this object.
  NewFolder(const NewOptions& options, const char* what);

  /// Reads the base; false, and reported, when the folder cannot be made.
  bool begins();
  /// Fills in the layers and prints what was written; the exit status.
  int write(const std::vector<std::string>& layers);
  /// Reports; false, so that a check can return it.
  bool refuse(std::string_view code, std::initializer_list<std::string> arguments);

  /// The element of the base's chain, null where it has none.
  const ChainElement* in_chain(std::string_view syntax) const;

  /// In which form the programs of the base are written: "iso", "sinumerik" or "klartext".
  std::string family() const;

  const NewOptions& options() const { return options_; }
  Session& session() { return session_; }
  const Dialect& base() const { return base_; }
  TemplateWords& words() { return words_; }

 private:
  const NewOptions& options_;
  const char* what_;
  Session session_;
  std::filesystem::path place_;
  Dialect base_;
  TemplateWords words_;
};

}  // namespace isogloss::cli
