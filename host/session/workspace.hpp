/// What a user's session has, whoever runs it: folders, loaded plugins, dialects and machines, and where faults go.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "isogloss/engine/diagnostic.hpp"
#include "isogloss/engine/dialect.hpp"
#include "isogloss/engine/library.hpp"
#include "isogloss/engine/linker.hpp"
#include "isogloss/engine/machine.hpp"

namespace isogloss {

/// A folder that is searched, and who named it.
struct Place {
  std::filesystem::path folder;
  std::string named_by;  ///< "--plugins", "ISOGLOSS_PLUGIN_PATH", "installation"
};

/// Who named the folder of machines in a folder of dialects: nobody.
inline constexpr const char* machines_beside_dialects = "beside the dialects";

/// Folders that the user names, which are searched first, and whether plugins are loaded that others can write.
struct NamedFolders {
  std::vector<std::string> plugins, dialects, machines;
  /// ISOGLOSS_ANY_PLUGINS=1 stands for PluginTrust::any as well.
  PluginTrust trust = PluginTrust::guarded;
  /// False: the library of the workspace finds no plugin, whoever asks it.
  bool loads_plugins = true;
};

/// The dialect whose vocabulary and tables serve where none is named (apply, case), and the last resort of guessing.
inline constexpr const char* default_dialect = "iso";

/// Belongs to one thread; see "For embedders" about plugins.
class Workspace {
 public:
  /// `home`: the folder of the command, in a build tree or an installation. `sink` outlives the workspace; nothing is
  /// reported to it before the first call.
  Workspace(const NamedFolders& named, const std::filesystem::path& home, DiagnosticSink& sink);
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  const std::vector<Place>& plugin_places() const { return plugin_places_; }
  const std::vector<Place>& dialect_places() const { return dialect_places_; }
  const std::vector<Place>& machine_places() const { return machine_places_; }
  Library& library() { return library_; }
  const DialectReader& reader() const { return reader_; }
  /// For texts that are not written to their files yet.
  DialectReader& reader() { return reader_; }
  DiagnosticSink& sink() { return sink_; }

  /// Reads a dialect, or a machine, which is completed with the plugins of its tables; empty, and reported, when
  /// something is wrong.
  std::optional<Dialect> read(const std::string& dialect) { return read(dialect, sink_); }
  std::optional<Dialect> read(const std::string& dialect, DiagnosticSink& sink);
  /// Those in the machine folders.
  std::vector<FoundMachine> machines() const;
  /// The machine of this name in the machine folders, or at this path; empty, and reported, when there is none.
  std::optional<FoundMachine> find_machine(const std::string& named);
  /// Where a command takes a dialect or a machine: the name to read. Empty, and reported, when both are given, the
  /// machine does not exist, or holds only tables.
  std::optional<std::string> dialect_or_machine(const std::string& dialect, const std::string& machine);

  /// Reads and links, with the user's own dependencies where the dialect lacks them; null, and reported, when something
  /// is wrong.
  std::unique_ptr<LinkedDialect> link(const std::string& dialect, const std::vector<DependencyElement>& own = {}) {
    return link(dialect, own, sink_);
  }
  std::unique_ptr<LinkedDialect> link(const std::string& dialect, const std::vector<DependencyElement>& own,
                                      DiagnosticSink& sink);
  /// Reports one of the host's diagnostics.
  void report(std::string_view code, Location where, std::initializer_list<std::string> arguments,
              std::string hint = {});

 private:
  std::vector<Place> plugin_places_, dialect_places_, machine_places_;
  Library library_;
  DialectReader reader_;
  DiagnosticSink& sink_;
};

/// A syntax that threw, and one that broke the contract, are faults inside, not faults of the input.
bool is_internal_fault(std::string_view code);

/// The text of a file, or of standard input for "-". Empty with a reason in `error`.
std::optional<std::string> read_text(const std::string& path, std::string& error);

}  // namespace isogloss
