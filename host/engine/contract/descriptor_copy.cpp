#include "contract/descriptor_copy.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace isogloss {

namespace {

constexpr std::uint32_t most_elements = 8192;
constexpr std::uint32_t largest_struct = 4096;

/// The size in version 1.0: a plugin in the field has at least this much of the struct.
template <class T>
constexpr std::size_t first_size = sizeof(T);
template <>
constexpr std::size_t first_size<ig_syntax> = offsetof(ig_syntax, cases);
template <>
constexpr std::size_t first_size<ig_plugin> = offsetof(ig_plugin, importers);
template <>
constexpr std::size_t first_size<ig_dependency> = offsetof(ig_dependency, row_fault);

/// False when the struct's size cannot be right; then it is left alone.
template <class T>
bool copy_struct(T& to, const void* from) {
  std::uint32_t size = 0;
  std::memcpy(&size, from, sizeof size);
  if (size < sizeof(std::uint32_t) || size > largest_struct) return false;
  std::memcpy(&to, from, std::min<std::size_t>(size, sizeof to));
  // Members that the plugin's version lacks are zero; members of version 1.0 that it left out show as a small size.
  if (size >= first_size<T>) to.struct_size = sizeof to;
  return true;
}

}  // namespace

template <class T>
const T* PluginCopy::array(const T* first, std::uint32_t count, std::deque<std::vector<T>>& store) {
  if (first == nullptr || count == 0 || count > most_elements) return first;
  const std::uint32_t stride = first->struct_size;
  if (stride < sizeof(std::uint32_t) || stride > largest_struct) return first;
  // An array of this host's own structs is used where it stands.
  if (stride == sizeof(T)) return first;
  std::vector<T>& out = store.emplace_back(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const void* const from = reinterpret_cast<const char*>(first) + std::size_t{i} * stride;
    std::uint32_t size = 0;
    std::memcpy(&size, from, sizeof size);
    // Past the end of an array that is shorter than its count: to read on could leave the library.
    if (size != stride) return first;
    copy_struct(out[i], from);
  }
  return out.data();
}

PluginCopy::PluginCopy(const ig_plugin& original) {
  if (!copy_struct(plugin_, &original)) return;
  if (plugin_.syntaxes != nullptr && plugin_.syntax_count <= most_elements) {
    for (std::uint32_t i = 0; i < plugin_.syntax_count; ++i) {
      const ig_syntax* const from = plugin_.syntaxes[i];
      ig_syntax copy{};
      if (from == nullptr || !copy_struct(copy, from)) {
        syntax_list_.push_back(from);
        continue;
      }
      copy.fields = array(copy.fields, copy.field_count, fields_);
      copy.options = array(copy.options, copy.option_count, options_);
      copy.services = array(copy.services, copy.service_count, services_);
      syntax_list_.push_back(&syntaxes_.emplace_back(copy));
    }
    plugin_.syntaxes = syntax_list_.data();
  }
  if (plugin_.dependencies != nullptr && plugin_.dependency_count <= most_elements) {
    for (std::uint32_t i = 0; i < plugin_.dependency_count; ++i) {
      const ig_dependency* const from = plugin_.dependencies[i];
      ig_dependency copy{};
      if (from == nullptr || !copy_struct(copy, from)) {
        dependency_list_.push_back(from);
        continue;
      }
      copy.columns = array(copy.columns, copy.column_count, columns_);
      copy.options = array(copy.options, copy.option_count, options_);
      dependency_list_.push_back(&dependencies_.emplace_back(copy));
    }
    plugin_.dependencies = dependency_list_.data();
  }
  if (plugin_.importers != nullptr && plugin_.importer_count <= most_elements) {
    for (std::uint32_t i = 0; i < plugin_.importer_count; ++i) {
      const ig_importer* const from = plugin_.importers[i];
      ig_importer copy{};
      if (from == nullptr || !copy_struct(copy, from)) {
        importer_list_.push_back(from);
        continue;
      }
      copy.options = array(copy.options, copy.option_count, options_);
      importer_list_.push_back(&importers_.emplace_back(copy));
    }
    plugin_.importers = importer_list_.data();
  }
  plugin_.diagnostics = array(plugin_.diagnostics, plugin_.diagnostic_count, diagnostics_);
}

}  // namespace isogloss
