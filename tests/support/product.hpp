/// The product of the build tree, for test programs in C++: its plugins, its dialects, and the programs of the tree.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isogloss/engine/exporter.hpp"
#include "workspace.hpp"

namespace isogloss::product {

/// The workspace of the build tree, with all its plugins. One for the process.
Workspace& workspace();
/// A dialect without tables of the user. Throws std::runtime_error where it does not link.
const LinkedDialect& dialect(const std::string& name);
/// All files of the project's tree whose names end so, up to 64 KiB each, in the order of their paths.
std::vector<std::string> texts_of_files(const std::string& below, const std::string& ending);
/// The golden programs of a dialect.
std::vector<std::string> programs_of(const std::string& dialect);

class TextOutput : public Output {
 public:
  bool write(std::string_view bytes) override {
    text.append(bytes);
    return true;
  }
  std::string text;
};

}  // namespace isogloss::product
