// Finds dialect files, follows what they extend, and folds it in: the base first, then each file's own parts and
// edits in written order.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "dialect/dependency_reader.hpp"
#include "dialect/dialect_file.hpp"
#include "dialect/dialect_path.hpp"

namespace isogloss {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_ancestors = 16;

bool names_a_file(std::string_view name) { return name.find('/') != std::string_view::npos || name.ends_with(".xml"); }

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// One spelling for each file, so that a loop is seen.
std::string identity(const fs::path& path) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(path, error);
  return error ? path.string() : canonical.string();
}

bool is_below(const fs::path& path, const fs::path& folder) {
  const fs::path relative = fs::path(identity(path)).lexically_relative(identity(folder));
  return !relative.empty() && *relative.begin() != "..";
}

template <class Element>
const char* kind_of() {
  return std::is_same_v<Element, ChainElement> ? "syntax" : "dependency";
}

/// Hint for two instances of one part in one dialect.
template <class Element>
std::string second_name(const Element& element) {
  if constexpr (std::is_same_v<Element, ChainElement>)
    return fmt::format("give the second one a name of its own: <{} as=\"second\"/>; or <Replace> the first",
                       shown(element.syntax));
  else
    return fmt::format("give the second one a name of its own: <{} as=\"second\"/>; or <Configure> the first",
                       shown(element.id));
}

/// Applies one file's edits to what it inherits.
template <class Element>
class Editor {
 public:
  Editor(std::vector<Element>& list, std::string dialect, std::vector<AppliedEdit>& applied, Report& report)
      : list_(list), dialect_(std::move(dialect)), applied_(applied), report_(report) {
    for (const Element& e : list_) names_.insert(e.alias);
  }

  void apply(const Edit<Element>& edit) {
    const auto at = std::find_if(list_.begin(), list_.end(), [&](const Element& e) { return e.alias == edit.anchor; });
    if (at == list_.end()) {
      report_("IG-0112", edit.anchor_where, {std::string(to_string(edit.kind)), kind_of<Element>(), shown(edit.anchor)},
              absent(edit.anchor));
      return;
    }
    applied_.push_back({std::string(to_string(edit.kind)),
                        dialect_,
                        !std::is_same_v<Element, ChainElement>,
                        edit.anchor,
                        {},
                        {},
                        edit.override_slot,
                        edit.where});
    for (const Element& element : edit.elements) applied_.back().elements.push_back(element.alias);
    switch (edit.kind) {
      case EditKind::configure: return configure(*at, edit);
      case EditKind::remove:
        names_.erase(at->alias);
        list_.erase(at);
        return;
      case EditKind::replace:
      case EditKind::insert_before:
      case EditKind::insert_after: return put_in(at, edit);
    }
  }

 private:
  std::string absent(const std::string& name) const {
    const auto edit = std::find_if(applied_.rbegin(), applied_.rend(), [&name](const auto& one) {
      return (one.kind == "Remove" || one.kind == "Replace") && one.anchor == name &&
             one.of_dependency == !std::is_same_v<Element, ChainElement>;
    });
    if (edit != applied_.rend())
      return fmt::format("<{}> of {}:{} took it away: name another {}, or drop that edit", edit->kind, edit->where.file,
                         edit->where.line, kind_of<Element>());
    const std::string near = meant(name, {names_.begin(), names_.end()});
    return near.empty() ? "isogloss dialect --effective NAME prints what the dialect inherits" : near;
  }

  void put_in(typename std::vector<Element>::iterator at, const Edit<Element>& edit) {
    const Element anchor = *at;
    if (edit.kind == EditKind::replace) {
      names_.erase(anchor.alias);
      at = list_.erase(at);
    } else if (edit.kind == EditKind::insert_after) {
      ++at;
    }
    for (Element element : edit.elements) {
      if (!names_.insert(element.alias).second) {
        const auto other =
            std::find_if(list_.begin(), list_.end(), [&](const Element& e) { return e.alias == element.alias; });
        report_("IG-0113", element.where,
                {shown(element.alias), fmt::format("{}:{}", other->where.file, other->where.line)},
                second_name(element));
        continue;
      }
      if constexpr (std::is_same_v<Element, ChainElement>) element.stage = anchor.stage;
      at = std::next(list_.insert(at, std::move(element)));
    }
  }

  void configure(Element& element, const Edit<Element>& edit) {
    for (const Attribute& option : edit.options) {
      const auto old = std::find_if(element.options.begin(), element.options.end(),
                                    [&](const Attribute& a) { return a.name == option.name; });
      applied_.back().options.push_back({option, std::nullopt});
      if (old == element.options.end()) {
        element.options.push_back(option);
      } else {
        applied_.back().options.back().before = *old;
        *old = option;
      }
    }
    if constexpr (std::is_same_v<Element, ChainElement>) element.override_slot |= edit.override_slot;
  }

  std::vector<Element>& list_;
  std::string dialect_;
  std::vector<AppliedEdit>& applied_;
  Report& report_;
  std::set<std::string> names_;
};

/// One call of DialectReader::read.
class Reading {
 public:
  Reading(const std::vector<fs::path>& folders, const UnsavedFiles& unsaved, DiagnosticSink& sink)
      : folders_(folders), report_(sink) {
    budget_.unsaved = &unsaved;
  }

  std::optional<Dialect> read(const std::string& name) {
    const fs::path file = names_a_file(name) ? fs::path(name) : search(name, folders_);
    if (file.empty()) {
      not_found(name, {});
      return std::nullopt;
    }
    std::optional<Dialect> dialect = read_file(file, {});
    return report_.failed ? std::nullopt : std::move(dialect);
  }

 private:
  std::optional<Dialect> read_file(const fs::path& path, const Location& asked_at) {
    const std::string id = identity(path);
    const auto open = std::find(open_.begin(), open_.end(), id);
    if (open != open_.end()) {
      std::string way;
      for (auto it = open; it != open_.end(); ++it) way += fs::path(*it).stem().string() + " → ";
      report_("IG-0111", asked_at, {way + path.stem().string()});
      return std::nullopt;
    }
    if (open_.size() > most_ancestors) {
      report_("IG-0105", asked_at, {"the dialect", fmt::format("{} ancestors", most_ancestors)});
      return std::nullopt;
    }
    const std::unique_ptr<XmlSource> xml = XmlSource::open(path, asked_at, budget_, report_.sink());
    if (xml == nullptr) {
      report_.failed = true;
      return std::nullopt;
    }
    DialectFile file = read_dialect_file(*xml, budget_, report_);
    if (file.extends.empty()) return finish_root(std::move(file));
    const fs::path base_path = find_base(file);
    if (base_path.empty()) return std::nullopt;
    open_.push_back(id);
    std::optional<Dialect> base = read_file(base_path, file.extends_where);
    open_.pop_back();
    if (!base) return std::nullopt;
    return fold(std::move(*base), std::move(file));
  }

  Dialect finish_root(DialectFile file) {
    std::set<std::string> names;
    for (const ChainElement& element : file.own.chain) {
      if (names.insert(element.alias).second) continue;
      const auto first = std::find_if(file.own.chain.begin(), file.own.chain.end(),
                                      [&](const ChainElement& e) { return e.alias == element.alias; });
      report_("IG-0113", element.where, {shown(element.alias), fmt::format("line {}", first->where.line)},
              second_name(element));
    }
    if (file.own.segmenter.type.empty()) file.own.segmenter.type = "line";
    return std::move(file.own);
  }

  /// `base` with the file's own parts on top.
  Dialect fold(Dialect base, DialectFile file) {
    Dialect& own = file.own;
    base.ancestors.insert(base.ancestors.begin(), base.name);
    base.name = own.name;
    if (!own.title.empty()) base.title = own.title;
    base.file = own.file;
    if (!own.segmenter.type.empty()) {
      base.segmenter = own.segmenter;
      base.segmenter_where = own.segmenter_where;
    }
    if (file.has_files) {
      base.files_where = own.files_where;
      if (!own.extensions.empty()) base.extensions = own.extensions;
      base.signatures = own.signatures;
      base.names = own.names;
    }
    for (PluginReference& plugin : own.plugins) {
      const auto same = std::find_if(base.plugins.begin(), base.plugins.end(),
                                     [&](const PluginReference& p) { return p.name == plugin.name; });
      if (same == base.plugins.end())
        base.plugins.push_back(std::move(plugin));
      else
        base.repetitions.push_back({"the plugin " + shown(plugin.name), same->where, plugin.where});
    }
    for (InitialField& field : own.initial) {
      const auto old = std::find_if(base.initial.begin(), base.initial.end(),
                                    [&](const InitialField& f) { return f.path == field.path; });
      if (old == base.initial.end()) {
        base.initial.push_back(std::move(field));
      } else {
        if (old->value == field.value)
          base.repetitions.push_back({"the initial value of " + shown(field.path), old->where, field.where});
        *old = std::move(field);
      }
    }
    for (const auto& [code, given] : own.severities) base.severities[code] = given;
    base.program_places.insert(base.program_places.begin(), own.program_places.begin(), own.program_places.end());
    if (file.has_search_order) base.search_order = own.search_order;
    base.is_machine = own.is_machine;
    const auto append = [](auto& to, auto& from) {
      to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
    };
    append(base.imports, own.imports);
    if (own.is_machine) {
      append(base.own_tables, own.dependencies);
      own.dependencies.clear();
    }
    fold_dependencies(base, std::move(own.dependencies), file.dependency_edits);
    Editor chain(base.chain, base.name, base.edits, report_);
    for (const Edit<ChainElement>& edit : file.chain_edits) chain.apply(edit);
    return base;
  }

  /// The file's own stand before the inherited ones. An inherited one of the same name never answers: it is removed.
  void fold_dependencies(Dialect& base, std::vector<DependencyElement> own,
                         const std::vector<Edit<DependencyElement>>& edits) {
    std::vector<DependencyElement>& inherited = base.dependencies;
    {
      Editor editor(inherited, base.name, base.edits, report_);
      for (const Edit<DependencyElement>& edit : edits) editor.apply(edit);
    }
    std::set<std::string> names;
    for (const DependencyElement& element : own) names.insert(element.alias);
    std::erase_if(inherited, [&](const DependencyElement& e) { return names.count(e.alias) > 0; });
    inherited.insert(inherited.begin(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
  }

  fs::path find_base(const DialectFile& file) {
    const fs::path folder = file.own.file.parent_path();
    if (!names_a_file(file.extends)) {
      // Beside the file that asks, then in the folders. Links in those are the user's, others may be anybody's.
      const std::string beside = file.extends + ".xml";
      const bool is_users = std::any_of(folders_.begin(), folders_.end(), [&](const fs::path& users) {
        std::error_code error;
        return fs::equivalent(users, folder.empty() ? "." : folder, error);
      });
      if (!is_users && is_file(folder / beside) && below_folder_of(file.own.file.string(), beside).empty()) {
        leads_out(file);
        return {};
      }
      std::vector<fs::path> places = folders_;
      places.insert(places.begin(), folder);
      fs::path found = search(file.extends, places);
      if (found.empty()) not_found(file.extends, file.extends_where);
      return found;
    }
    fs::path path = (folder / file.extends).lexically_normal();
    const bool allowed =
        !fs::path(file.extends).is_absolute() &&
        (!below_folder_of(file.own.file.string(), file.extends).empty() ||
         std::any_of(folders_.begin(), folders_.end(), [&](const fs::path& f) { return is_below(path, f); }));
    if (!allowed) leads_out(file);
    return allowed ? path : fs::path();
  }

  void leads_out(const DialectFile& file) {
    report_("IG-0117", file.extends_where, {shown(file.extends), "the dialect's folder and the dialect folders"});
  }

  static fs::path search(const std::string& name, const std::vector<fs::path>& places) {
    for (const fs::path& folder : places) {
      fs::path file = folder / (name + ".xml");
      if (is_file(file)) return file;
    }
    return {};
  }

  void not_found(const std::string& name, const Location& asked_at) {
    std::string places;
    std::vector<std::string> names;
    for (const fs::path& folder : folders_) {
      places += (places.empty() ? "" : ", ") + folder.string();
      std::error_code error;
      for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
        if (it->path().extension() == ".xml") names.push_back(it->path().stem().string());
    }
    report_("IG-0101", asked_at, {shown(name), places.empty() ? "there are none" : places}, meant(name, names));
  }

  const std::vector<fs::path>& folders_;
  Report report_;
  XmlBudget budget_;
  std::vector<std::string> open_;
};

}  // namespace

DialectReader::DialectReader(std::vector<std::filesystem::path> folders) : folders_(std::move(folders)) {}

std::optional<Dialect> DialectReader::read(const std::string& name, DiagnosticSink& sink) const {
  return Reading(folders_, unsaved_, sink).read(name);
}

void DialectReader::give(const std::filesystem::path& file, std::string text) {
  std::error_code error;
  unsaved_[fs::weakly_canonical(file, error).string()] = std::move(text);
}

void DialectReader::forget(const std::filesystem::path& file) {
  std::error_code error;
  unsaved_.erase(fs::weakly_canonical(file, error).string());
}

std::vector<Dialect> DialectReader::list() const {
  std::vector<Dialect> all;
  std::set<std::string> names;
  for (const fs::path& folder : folders_) {
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
      if (it->path().extension() != ".xml") continue;
      DiagnosticList unheard;
      XmlBudget budget;
      const std::unique_ptr<XmlSource> xml = XmlSource::open(it->path(), {}, budget, unheard);
      // Tables lie beside the dialects.
      if (xml == nullptr || std::string_view(xml->root().name()) != "Dialect") continue;
      Report report(unheard);
      Dialect dialect = read_dialect_head(*xml, report);
      // It is found by its file's name, so that is the name it has here.
      dialect.name = it->path().stem().string();
      if (names.insert(dialect.name).second) all.push_back(std::move(dialect));
    }
  }
  std::sort(all.begin(), all.end(), [](const Dialect& a, const Dialect& b) { return a.name < b.name; });
  return all;
}

std::vector<DependencyElement> DialectReader::read_dependencies(const std::filesystem::path& file,
                                                                DiagnosticSink& sink) const {
  XmlBudget budget;
  budget.unsaved = &unsaved_;
  Report report(sink);
  const std::unique_ptr<XmlSource> xml = XmlSource::open(file, {}, budget, sink, Pipes::read);
  if (xml == nullptr) return {};
  std::vector<DependencyElement> all = read_dependency_file(*xml, budget, report);
  return report.failed ? std::vector<DependencyElement>{} : all;
}

}  // namespace isogloss
