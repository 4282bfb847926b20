// Finds machines, and completes one that was read.
#include "isogloss/engine/machine.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "dialect/dialect_file.hpp"
#include "dialect/row_checks.hpp"
#include "isogloss/engine/import.hpp"
#include "isogloss/engine/own_dependencies.hpp"

namespace isogloss {

namespace fs = std::filesystem;

namespace {

bool is_readable_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// Rows of several files with one key become one row, in which the later file's cells win.
void merge_rows(const ig_dependency& dependency, std::vector<TableRow>& rows) {
  std::map<std::string, std::size_t> first;
  std::vector<TableRow> merged;
  for (TableRow& row : rows) {
    const std::string key(key_of(dependency, row));
    const auto [same, is_new] = first.emplace(key, merged.size());
    // Two rows of one file are a mistake, which the checks report.
    if (is_new || key.empty() || merged[same->second].where.file == row.where.file) {
      merged.push_back(std::move(row));
      continue;
    }
    TableRow& older = merged[same->second];
    for (Attribute& cell : row.attributes) {
      const auto old = std::find_if(older.attributes.begin(), older.attributes.end(),
                                    [&](const Attribute& a) { return a.name == cell.name; });
      if (old == older.attributes.end())
        older.attributes.push_back(std::move(cell));
      else
        *old = std::move(cell);
    }
    if (row.attributes.size() > 1) older.where = row.where;
  }
  rows = std::move(merged);
}

/// The table's options and rows go over those of the same table in `all`; a new one comes last.
void lay_over(std::vector<DependencyElement>& all, DependencyElement element) {
  const auto old =
      std::find_if(all.begin(), all.end(), [&](const DependencyElement& e) { return e.alias == element.alias; });
  if (old == all.end() || old->id != element.id) {  // another dependency of the same name takes its place
    if (old != all.end()) all.erase(old);
    all.push_back(std::move(element));
    return;
  }
  for (Attribute& option : element.options) {
    std::erase_if(old->options, [&](const Attribute& a) { return a.name == option.name; });
    old->options.push_back(std::move(option));
  }
  old->rows.insert(old->rows.end(), std::make_move_iterator(element.rows.begin()),
                   std::make_move_iterator(element.rows.end()));
  old->where = element.where;
}

/// The machine's own tables over those of its dialect; they stand first, so that they answer.
void fill(std::vector<DependencyElement>& inherited, std::vector<DependencyElement> own) {
  std::vector<DependencyElement> out;
  for (DependencyElement& element : own) {
    std::vector<DependencyElement> one;
    const auto base = std::find_if(inherited.begin(), inherited.end(),
                                   [&](const DependencyElement& e) { return e.alias == element.alias; });
    if (base != inherited.end()) {
      one.push_back(std::move(*base));
      one.back().source_file.clear();
      inherited.erase(base);
    }
    lay_over(one, std::move(element));
    out.push_back(std::move(one.back()));
  }
  out.insert(out.end(), std::make_move_iterator(inherited.begin()), std::make_move_iterator(inherited.end()));
  inherited = std::move(out);
}

/// Passes diagnostics on and remembers whether one was an error. A wrong option of a folder concerns each of its files,
/// and is one fault.
class ErrorWatch : public DiagnosticSink {
 public:
  explicit ErrorWatch(DiagnosticSink& sink) : sink_(sink) {}
  void add(Diagnostic d) override {
    has_error = has_error || d.severity == Severity::error;
    if (d.code == "IG-0205" && !wrong_options_.emplace(d.where.file, d.where.line, d.where.column).second) return;
    sink_.add(std::move(d));
  }
  bool has_error = false;

 private:
  std::set<std::tuple<std::string, std::uint32_t, std::uint32_t>> wrong_options_;
  DiagnosticSink& sink_;
};

/// Reads the files of a control into tables. What fails is reported as an error.
class Importing {
 public:
  Importing(const Dialect& machine, Library& library, DiagnosticSink& sink)
      : extensions_(machine.extensions), program_places_(machine.program_places), library_(library), sink_(sink) {
    for (const std::vector<DependencyElement>* const tables : {&machine.own_tables, &machine.dependencies})
      for (const DependencyElement& table : *tables) machine_tables_.push_back(&table);
  }

  /// The rows of the file that the element's src names, before its own. Options that the dependency lacks are those of
  /// the importer.
  void fill_from_file(DependencyElement& element) const {
    if (!element.control_file) return;
    library_.load_all();
    const ig_dependency* const dependency = library_.dependency(element.id);
    const auto of_dependency = [&](const Attribute& a) {
      return dependency != nullptr && declares(*dependency, a.name);
    };
    Import asked = *element.control_file;
    asked.shares_options = true;
    std::remove_copy_if(element.options.begin(), element.options.end(), std::back_inserter(asked.options),
                        of_dependency);
    const std::optional<ImportedFile> file = read(asked);
    if (!file) return;
    if (dependency != nullptr) {
      for (const Attribute& a : asked.options)
        if (!declares(*file->importer, a.name)) report_option(*dependency, *file->importer, a);
      std::erase_if(element.options, [&](const Attribute& a) { return !of_dependency(a); });
    }
    for (const DependencyElement& table : file->tables) {
      if (table.id != element.id) {
        sink_.add(
            host_diagnostic("IG-0128", element.control_file->where, {element.control_file->file.string(), table.id}));
        continue;
      }
      element.rows.insert(element.rows.begin(), table.rows.begin(), table.rows.end());
      for (const Attribute& option : table.options)
        if (std::none_of(element.options.begin(), element.options.end(),
                         [&](const Attribute& a) { return a.name == option.name; }))
          element.options.push_back(option);
    }
    element.control_file.reset();
  }

  /// All tables of a file, or of the files of a folder.
  void add_tables(const Import& asked, std::vector<DependencyElement>& all) const {
    std::error_code error;
    const bool is_folder = fs::is_directory(asked.file, error);
    std::set<std::string> options;  // that an importer of the folder has
    for (const fs::path& path : is_folder ? in_order(asked) : std::vector{asked.file}) {
      Import one = asked;
      one.file = path;
      one.shares_options = is_folder;
      std::optional<ImportedFile> file = read(one);
      const ig_importer* const importer = file        ? file->importer
                                          : is_folder ? importer_of(path, asked.format)  // a pipe is in no folder
                                                      : nullptr;
      for (std::uint32_t i = 0; importer != nullptr && i < importer->option_count; ++i)
        options.insert(importer->options[i].name);
      if (!file) continue;
      for (DependencyElement& table : file->tables) lay_over(all, std::move(table));
    }
    for (const Attribute& a : asked.options)
      if (is_folder && !options.contains(a.name))
        sink_.add(host_diagnostic("IG-0204", a.where, {"no importer of " + asked.file.string(), a.name}));
  }

 private:
  template <class Declaration>
  static bool declares(const Declaration& declaration, std::string_view option) {
    return std::any_of(declaration.options, declaration.options + declaration.option_count,
                       [&](const ig_option_decl& o) { return option == o.name; });
  }

  void report_option(const ig_dependency& dependency, const ig_importer& importer, const Attribute& given) const {
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < dependency.option_count; ++i) names.emplace_back(dependency.options[i].name);
    for (std::uint32_t i = 0; i < importer.option_count; ++i) names.emplace_back(importer.options[i].name);
    const std::string near = nearest_name(given.name, names);
    sink_.add(host_diagnostic("IG-0140", given.where, {dependency.id, importer.id, given.name},
                              near.empty() ? "" : "did you mean " + near + "?"));
  }

  std::optional<ImportedFile> read(const Import& asked) const {
    Import whole = asked;
    whole.machine_tables = machine_tables_;
    std::optional<ImportedFile> file = import_file(whole, library_, sink_);
    if (!file) return file;
    for (const UnusedPart& part : file->unused)
      sink_.add(host_diagnostic("IG-0125", part.first, {part.what, part.why, std::to_string(part.count)}));
    if (file->tables.empty() && file->unused.empty())
      sink_.add(host_diagnostic("IG-0134", asked.where, {asked.file.string(), file->importer->id}));
    return file;
  }

  /// The files of the folder that an importer reads: those with initial values first, so that saved values, which
  /// other files hold, replace them.
  std::vector<fs::path> in_order(const Import& folder) const {
    std::vector<fs::path> initial, others;
    std::map<std::string, std::vector<fs::path>> unknown;  // by extension
    for (const fs::path& path : files_of(folder, sink_)) {
      const ig_importer* const importer = importer_of(path, folder.format);
      if (importer != nullptr || !folder.format.empty())
        (importer != nullptr && importer->is_initial != 0 ? initial : others).push_back(path);
      else if (const std::string what = what_is_no_text(path, library_); !what.empty())
        sink_.add(host_diagnostic("IG-0141", folder.where, {path.string(), what}));
      else if (is_found_as_program(path))
        continue;
      else if (const std::string formats = formats_named_like(path); !formats.empty())
        sink_.add(host_diagnostic("IG-0142", folder.where, {path.string(), formats}));
      else
        unknown[path.extension().string()].push_back(path);
    }
    for (const auto& [extension, files] : unknown)
      sink_.add(host_diagnostic("IG-0132", folder.where, {files[0].string(), std::to_string(files.size())}));
    initial.insert(initial.end(), others.begin(), others.end());
    return initial;
  }

  /// The importers whose files usually have such a name. An extension that programs have, too, tells nothing.
  std::string formats_named_like(const fs::path& path) const {
    const std::string name = path.filename().string();
    const bool may_be_program = is_named_as_program(path);
    const auto is_named_like = [&](const ig_importer& importer) {
      std::istringstream patterns(importer.files == nullptr ? "" : importer.files);
      return std::any_of(std::istream_iterator<std::string>(patterns), {}, [&](const std::string& pattern) {
        return !(may_be_program && pattern[0] == '*') && ::fnmatch(pattern.c_str(), name.c_str(), FNM_CASEFOLD) == 0;
      });
    };
    std::string out;
    for (const LoadedPlugin& p : library_.plugins())
      for (std::uint32_t i = 0; i < p.plugin->importer_count; ++i)
        if (const ig_importer& importer = *p.plugin->importers[i]; is_named_like(importer))
          out.append(out.empty() ? "" : ", ").append(importer.id);
    return out;
  }

  bool is_named_as_program(const fs::path& path) const {
    const auto is_same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
    const std::string extension = path.extension().string();
    return std::any_of(extensions_.begin(), extensions_.end(), [&](const std::string& e) {
      return std::equal(extension.begin(), extension.end(), e.begin(), e.end(), is_same);
    });
  }

  /// A file of the dialect's programs below a folder of <Programs>.
  bool is_found_as_program(const fs::path& path) const {
    const auto holds_file = [&](const fs::path& place) {
      return std::mismatch(place.begin(), place.end(), path.begin(), path.end()).first == place.end();
    };
    return is_named_as_program(path) && std::any_of(program_places_.begin(), program_places_.end(), holds_file);
  }

  const ig_importer* importer_of(const fs::path& path, const std::string& format) const {
    library_.load_all();
    if (!format.empty()) return library_.importer(format);
    const std::optional<std::string> head = head_of_control_file(path);
    if (!head) return nullptr;
    const std::vector<RecognisedFormat> found = recognise(*head, path.filename().string(), library_);
    return found.empty() ? nullptr : found[0].importer;
  }

  const std::vector<std::string>& extensions_;
  const std::vector<fs::path>& program_places_;
  std::vector<const DependencyElement*> machine_tables_;
  Library& library_;
  DiagnosticSink& sink_;
};

}  // namespace

FoundMachine machine_at(const fs::path& path) {
  std::error_code error;
  const fs::path file = fs::is_directory(path, error) ? path / "machine.xml" : path;
  if (!is_readable_file(file)) return {};
  const bool is_of_folder = file.filename() == "machine.xml";
  const fs::path named = is_of_folder ? fs::absolute(file, error).parent_path().filename() : file.stem();
  FoundMachine out{named.string(), "", "", file, !is_of_folder};
  // What is wrong with the file is reported when it is read as a machine, or as tables.
  DiagnosticList unheard;
  XmlBudget budget;
  const std::unique_ptr<XmlSource> xml = XmlSource::open(file, {}, budget, unheard, Pipes::read);
  if (xml == nullptr) return out;
  out.is_tables = std::string_view(xml->root().name()) != "Machine";
  if (out.is_tables) return out;
  out.title = xml->root().attribute("title").value();
  out.dialect = xml->root().attribute("dialect").value();
  return out;
}

std::vector<FoundMachine> list_machines(const std::vector<fs::path>& folders) {
  std::map<std::string, FoundMachine> found;
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
      std::error_code ignored;
      const bool is_folder = it->is_directory(ignored);
      if (!is_folder && it->path().extension() != ".xml") continue;
      FoundMachine machine = machine_at(it->path());
      if (!machine.file.empty()) found.emplace(machine.name, std::move(machine));
    }
  }
  std::vector<FoundMachine> out;
  for (auto& [name, machine] : found) out.push_back(std::move(machine));
  return out;
}

bool is_incomplete(const Dialect& dialect) {
  return !dialect.imports.empty() || !dialect.own_tables.empty() ||
         std::any_of(dialect.dependencies.begin(), dialect.dependencies.end(),
                     [](const DependencyElement& e) { return e.control_file.has_value(); });
}

bool complete_machine(Dialect& machine, Library& library, DiagnosticSink& given) {
  ErrorWatch sink(given);
  if (!is_incomplete(machine)) return true;
  for (const PluginReference& plugin : machine.plugins)
    if (!library.load(plugin.name, plugin.where, sink)) return false;
  const Importing importing(machine, library, sink);
  for (DependencyElement& element : machine.dependencies) importing.fill_from_file(element);
  std::vector<DependencyElement> own;
  for (const Import& import : machine.imports) importing.add_tables(import, own);
  for (DependencyElement& element : machine.own_tables) {
    importing.fill_from_file(element);
    for (const DependencyElement& other : own)
      if (other.alias == element.alias && other.id != element.id)
        sink.add(host_diagnostic("IG-0113", element.where,
                                 {element.alias, other.where.file + ":" + std::to_string(other.where.line)}));
    lay_over(own, std::move(element));
  }
  machine.imports.clear();
  machine.own_tables.clear();
  fill(machine.dependencies, std::move(own));
  for (DependencyElement& element : machine.dependencies) {
    add_plugin_of(element, machine, library, sink);
    if (const ig_dependency* const dependency = library.dependency(element.id)) merge_rows(*dependency, element.rows);
  }
  return !sink.has_error;
}

}  // namespace isogloss
