/// What every command needs: folders, loaded plugins, and how diagnostics are written.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command_line.hpp"
#include "isogloss/engine/diagnostic_writer.hpp"
#include "isogloss/engine/dialect.hpp"
#include "isogloss/engine/library.hpp"
#include "isogloss/engine/linker.hpp"
#include "isogloss/engine/machine.hpp"
#include "output_file.hpp"
#include "terminal.hpp"

namespace isogloss::cli {

/// A folder that is searched, and who named it.
struct Place {
  std::filesystem::path folder;
  std::string named_by;  ///< "--plugins", "ISOGLOSS_PLUGIN_PATH", "installation"
};

struct CommonOptions {
  std::vector<std::string> plugins, dialects, machines;
  std::string diagnostics = "text", diagnostics_output;
  std::uint64_t repeats = 5;
  static constexpr std::uint64_t many_errors = 100'000;
  std::uint64_t maximum_errors = many_errors;
  bool warnings_are_errors = false;

  void add_to(CommandLine& line);
};

/// The dialect whose vocabulary and tables serve where none is named (apply, case), and the last resort of guessing.
inline constexpr const char* default_dialect = "iso";

class Session {
 public:
  explicit Session(const CommonOptions& options);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const std::vector<Place>& plugin_places() const { return plugin_places_; }
  const std::vector<Place>& dialect_places() const { return dialect_places_; }
  const std::vector<Place>& machine_places() const { return machine_places_; }
  Library& library() { return library_; }
  const DialectReader& reader() const { return reader_; }
  DiagnosticWriter& diagnostics() { return diagnostics_; }
  Progress& progress() { return progress_; }

  /// Reads a dialect, or a machine, which is completed with the plugins of its tables; empty, and reported, when
  /// something is wrong.
  std::optional<Dialect> read(const std::string& dialect) { return read(dialect, diagnostics_); }
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
    return link(dialect, own, diagnostics_);
  }
  std::unique_ptr<LinkedDialect> link(const std::string& dialect, const std::vector<DependencyElement>& own,
                                      DiagnosticSink& sink);
  /// Reports one of the host's diagnostics.
  void report(std::string_view code, Location where, std::initializer_list<std::string> arguments,
              std::string hint = {});
  /// From now on, whatever --diagnostics-output names; diagnostics already written to that file are dropped.
  void report_to_stderr() { diagnostics_file_.reset(); }
  /// From now on diagnostics are given to `taker` as text; a server has no use for standard error.
  void report_to(std::function<void(std::string_view)> taker) { taker_ = std::move(taker); }
  /// input_errors when there were errors, internal_fault when a plugin broke the contract, else success.
  int status() const;

 private:
  std::vector<Place> plugin_places_, dialect_places_, machine_places_;
  Library library_;
  DialectReader reader_;
  std::string diagnostics_output_;
  std::unique_ptr<OutputFile> diagnostics_file_;
  std::function<void(std::string_view)> taker_;
  Progress progress_;
  DiagnosticWriter diagnostics_;
};

/// Stays until the process ends, which frees all of it at once: to take thousands of small parts down one by one is
/// what short programs would wait for.
template <class T>
void keep_to_the_end(std::unique_ptr<T> whole) {
  static auto& kept = *std::make_unique<std::vector<std::unique_ptr<T>>>().release();
  kept.push_back(std::move(whole));
}

/// Where the command itself stands; what is installed with it is found from there.
std::filesystem::path folder_of_executable();

/// The text of a file, or of standard input for "-". Empty with a reason in `error`.
std::optional<std::string> read_text(const std::string& path, std::string& error);

}  // namespace isogloss::cli
