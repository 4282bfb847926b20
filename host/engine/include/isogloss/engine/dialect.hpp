/// A dialect file, read and resolved: plugins, dependencies, initial state and chain, each with its place.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "isogloss/engine/diagnostic.hpp"

namespace isogloss {

struct Attribute {
  std::string name;
  std::string value;
  Location where;
};

enum class Stage : std::uint8_t { parsing, evaluation, logic, post_logic, inspection };

/// One syntax of the chain. The alias (`as="…"`, else the syntax's id) is what edits and provenance address.
struct ChainElement {
  Stage stage = Stage::logic;
  std::string syntax;
  std::string alias;
  std::vector<Attribute> options;
  bool override_slot = false;  ///< override="true": may claim a slot or take a code that another one has
  Location where;
};

struct TableRow {
  std::string element;
  std::vector<Attribute> attributes;
  Location where;
};

struct DependencyElement;

/// A file of a control, or a folder of such files, that importers read.
struct Import {
  std::filesystem::path file;
  std::string format;              ///< id of the importer; empty: the one that recognises the file
  std::vector<Attribute> options;  ///< of the importer
  Location where;
  bool shares_options = false;  ///< options that its importer lacks are meant for others: files, or the dependency
  std::vector<const DependencyElement*> machine_tables{};  ///< rows of the machine's own file, which importers may ask
};

struct DependencyElement {
  std::string id;
  std::string alias;
  std::vector<Attribute> options;  ///< without src
  std::vector<TableRow> rows;      ///< those of src, too
  std::string source_file;         ///< what src named, resolved; empty when inline
  Location where;
  std::optional<Import> control_file = std::nullopt;  ///< src names a file of a control, which has not been read yet
};

struct InitialField {
  std::string path;
  std::string value;
  Location where;
};

/// An edit that was applied to what a file inherits, in the order of application: the dialect's own come last.
struct AppliedEdit {
  struct Option {
    Attribute given;
    std::optional<Attribute> before;  ///< what the element had until then
  };
  std::string kind;     ///< "Replace", "InsertBefore", "InsertAfter", "Remove", "Configure"
  std::string dialect;  ///< whose file it stands in
  bool of_dependency = false;
  std::string anchor;                 ///< the alias that it names
  std::vector<std::string> elements;  ///< aliases of what it puts in
  std::vector<Option> options;        ///< Configure
  bool override_slot = false;         ///< Configure: override="true"
  Location where;
};

/// A value that a file repeats: what it says stands there already.
struct Repetition {
  std::string what;  ///< "the plugin iso", "the initial value of Feedrate.Term"
  Location first, where;
};

struct PluginReference {
  std::string name;
  Location where;
};

/// How text is cut into blocks.
struct Segmenter {
  std::string type;          ///< "line"
  std::string continuation;  ///< a line that ends with it continues in the next one; empty: each line is a block
  std::string comment;       ///< begins a comment that may follow the mark; empty: no comment may
};

/// A sign of a dialect in the head of a program.
struct Signature {
  static constexpr unsigned usual_weight = 4;
  std::string pattern;             ///< shell pattern (* ? [0-9]) for a line
  unsigned weight = usual_weight;  ///< lower where other dialects' programs may show the sign, too
  friend bool operator==(const Signature&, const Signature&) = default;
};

/// One place of the order in which called programs are searched.
struct SearchFolder {
  std::vector<std::string> names;  ///< spellings of a folder's name; empty: the folders that the program has added
};

/// The severity that a dialect gives to a diagnostic.
struct GivenSeverity {
  Severity severity = Severity::warning;
  Location where;
};

/// A dialect with everything that it extends applied.
struct Dialect {
  std::string name;
  std::string title;
  bool is_machine = false;  ///< its file is a <Machine>: ancestors[0] is the dialect that it stands on
  /// Of a machine: what complete_machine() has still to read and to put into `dependencies`. link() does it too.
  std::vector<Import> imports;
  std::vector<DependencyElement> own_tables;
  std::filesystem::path file;
  std::vector<std::string> ancestors;   ///< names, nearest first
  std::vector<std::string> extensions;  ///< ".nc"
  std::vector<Signature> signatures;
  std::vector<Signature> names;  ///< of a program's file, without its folder; small letters
  Segmenter segmenter{"line", {}, {}};
  std::vector<PluginReference> plugins;
  std::vector<DependencyElement> dependencies;  ///< nearest provider first
  std::vector<InitialField> initial;
  std::vector<ChainElement> chain;                  ///< by stage, in written order
  std::map<std::string, GivenSeverity> severities;  ///< by diagnostic code
  /// How it came to be: for those who ask where something comes from, and for `lint`.
  std::vector<AppliedEdit> edits;
  std::vector<Repetition> repetitions;
  Location files_where, segmenter_where;
  /// Folders, or files of several programs, in which called programs are looked for, in this order.
  std::vector<std::filesystem::path> program_places;
  /// Folders below those of program_places that the control searches after them, in this order.
  std::vector<SearchFolder> search_order;
};

/// Texts of files that an editor has not written yet, by canonical path.
using UnsavedFiles = std::map<std::string, std::string, std::less<>>;

/// Finds and reads dialect files. Relative paths resolve against the file that holds them; nothing outside the
/// folders given (and the folder of a dialect named by path) is read.
class DialectReader {
 public:
  explicit DialectReader(std::vector<std::filesystem::path> folders);

  /// From now on this text stands in place of the file; forget() ends that.
  void give(const std::filesystem::path& file, std::string text);
  void forget(const std::filesystem::path& file);

  /// `name` is a dialect's name or, when it holds a '/' or ends in .xml, a file: of a dialect or of a machine. Empty,
  /// and reported, on a fault.
  std::optional<Dialect> read(const std::string& name, DiagnosticSink& sink) const;

  /// The dialect files in the folders: name, title, extensions, signatures; nothing resolved. Sorted by name.
  std::vector<Dialect> list() const;

  /// A dependency's table file (--machine, --offsets, --tools): the elements in it. Empty and reported when wrong.
  std::vector<DependencyElement> read_dependencies(const std::filesystem::path& file, DiagnosticSink& sink) const;

 private:
  std::vector<std::filesystem::path> folders_;
  UnsavedFiles unsaved_;
};

/// The dialect as one file without `extends` (architecture: `dialect --effective`). `base` is the folder that side
/// files lie in and are named from; with `inline_tables` there are none.
struct WrittenDialect {
  std::string xml;
  std::map<std::string, std::string> side_files;  ///< relative name, content
};
enum class Annotations : std::uint8_t { none, places };  ///< places: a comment names the file and line of each part
WrittenDialect write_dialect(const Dialect& dialect, const std::filesystem::path& base, bool inline_tables,
                             Annotations annotations = Annotations::none);

std::string_view to_string(Stage stage);

}  // namespace isogloss
