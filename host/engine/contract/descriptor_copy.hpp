/// A plugin's descriptor in this host's own shape. The contract's structs grow at their ends, so a plugin built with
/// another minor version has arrays of another stride: element i stands at base + i * base->struct_size. The copy has
/// this host's stride, and zeros where the plugin knew no member.
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "isogloss_import.h"

namespace isogloss {

class PluginCopy {
 public:
  /// Copies what is sound enough to be copied; null or absurd parts stay as they are, for descriptor_fault() to find.
  explicit PluginCopy(const ig_plugin& original);
  const ig_plugin* get() const { return &plugin_; }

 private:
  template <class T>
  const T* array(const T* first, std::uint32_t count, std::deque<std::vector<T>>& store);

  ig_plugin plugin_{};
  std::deque<ig_syntax> syntaxes_;
  std::deque<ig_dependency> dependencies_;
  std::deque<ig_importer> importers_;
  std::vector<const ig_importer*> importer_list_;
  std::vector<const ig_syntax*> syntax_list_;
  std::vector<const ig_dependency*> dependency_list_;
  std::deque<std::vector<ig_field_decl>> fields_;
  std::deque<std::vector<ig_option_decl>> options_;
  std::deque<std::vector<ig_service_decl>> services_;
  std::deque<std::vector<ig_column_decl>> columns_;
  std::deque<std::vector<ig_diagnostic_decl>> diagnostics_;
};

}  // namespace isogloss
