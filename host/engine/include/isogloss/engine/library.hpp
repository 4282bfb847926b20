/// The plugins that are loaded, and what they contribute.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "isogloss/engine/diagnostic.hpp"
#include "isogloss_import.h"

namespace isogloss {

/// A file that looked like a plugin but was not loaded.
struct RefusedPlugin {
  std::filesystem::path file;
  std::string code;
  std::string reason;
};

struct LoadedPlugin {
  std::filesystem::path file;
  const ig_plugin* plugin = nullptr;
  std::vector<std::string> extra_exports;  ///< symbols besides the entry, which other plugins would share
};

/// Which files are loaded as plugins.
enum class PluginTrust : std::uint8_t {
  guarded,  ///< only those that nobody but their owner, the user, the user's groups and root can change or replace
  any,      ///< all, whoever can write them
};

/// Loads each *.so of the folders once and keeps it resident. When two folders hold a plugin of one name, the first
/// folder's wins and the other is refused. Nothing outside the folders is loaded.
class Library {
 public:
  explicit Library(const std::vector<std::filesystem::path>& folders, PluginTrust trust = PluginTrust::guarded);
  ~Library();
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  /// Loads only these plugins, by name, when they are not loaded yet (a dialect names its own); reports what fails.
  bool load(const std::string& name, const Location& where, DiagnosticSink& sink);
  /// Loads one file, whatever the folders are; when it fails, refused() tells why.
  bool load_file(const std::filesystem::path& file);
  /// Loads every plugin of the folders, for listing.
  void load_all();

  const std::vector<LoadedPlugin>& plugins() const;
  const std::vector<RefusedPlugin>& refused() const;
  /// Codes of diagnostics that two of the loaded plugins, or a plugin and the host, declare: warnings.
  std::vector<Diagnostic> shared_codes() const;
  const ig_plugin* find(std::string_view name) const;
  const ig_syntax* syntax(std::string_view id, const ig_plugin** owner = nullptr) const;
  /// Of all plugins that are loaded.
  std::vector<std::string> syntax_ids() const;
  const ig_dependency* dependency(std::string_view id, const ig_plugin** owner = nullptr) const;
  /// Loads plugins in the order of load_all() until one has it.
  const ig_dependency* find_dependency(std::string_view id, const ig_plugin** owner = nullptr);
  const ig_importer* importer(std::string_view id, const ig_plugin** owner = nullptr) const;
  /// A plugin that is part of the program (tests, static builds).
  void add(const ig_plugin* plugin);
  /// The file that is being loaded, for a crash report that a signal handler writes; null when none is.
  static const char* loading();
  /// While loading() names a file: is its entry function at work, or the initializers of the library before it?
  static bool is_in_entry();

 private:
  template <class IsFound>
  void load_until(const IsFound& is_found);

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isogloss
