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
  std::string cycle, word, table, language, prefix, vendor;
};

int new_machine(const NewOptions& options);
int new_plugin(const NewOptions& options);
int new_dialect(const NewOptions& options);

/// What stands in a template as @key@, in its text and in its name.
using TemplateWords = std::map<std::string, std::string>;

/// Makes `place` of the layers, which are folders of templates; of two files of one name, the later layer's counts. All
/// paths of the files, or empty, and reported, when one cannot be read or written.
std::vector<std::string> write_templates(const std::filesystem::path& place, const std::vector<std::string>& layers,
                                         const TemplateWords& words, Session& session);

}  // namespace isogloss::cli
