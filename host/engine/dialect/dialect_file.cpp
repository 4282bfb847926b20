#include "dialect/dialect_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <type_traits>

#include "dialect/dependency_reader.hpp"

namespace isogloss {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view dialect_namespace = "urn:isogloss:dialect:1";
constexpr std::array stages{Stage::parsing, Stage::evaluation, Stage::logic, Stage::post_logic, Stage::inspection};
constexpr std::array edit_kinds{EditKind::replace, EditKind::insert_before, EditKind::insert_after, EditKind::remove,
                                EditKind::configure};

class FileReader : XmlElements {
 public:
  FileReader(const XmlSource& xml, XmlBudget& budget, Report& report)
      : XmlElements(xml, report), budget_(budget), dependencies_(xml, budget, report) {}

  DialectFile dialect() {
    if (!read_head()) return std::move(file_);
    for (const pugi::xml_node section : elements(xml_.root())) read_section(section);
    return std::move(file_);
  }

  Dialect head() {
    if (const pugi::xml_node files = xml_.root().child("Files"); read_head() && files) read_files(files);
    if (file_.is_machine) file_.own.ancestors = {file_.extends};
    return std::move(file_.own);
  }

  DialectFile machine_part() {
    file_.own.file = xml_.file();
    file_.is_machine = is_part_ = true;
    const pugi::xml_node root = xml_.root();
    if (std::string_view(root.name()) != "Machine") {
      file_.own.dependencies = read_dependency_file(xml_, budget_, report_);
      return std::move(file_);
    }
    check_namespace("Machine");
    only_attributes(root, {});
    for (const pugi::xml_node section : elements(root)) read_section(section);
    return std::move(file_);
  }

 private:
  /// False when the root is not a dialect's: then the rest has no meaning.
  bool read_head() {
    const pugi::xml_node root = xml_.root();
    file_.own.file = xml_.file();
    file_.own.segmenter = {};
    file_.is_machine = file_.own.is_machine = std::string_view(root.name()) == "Machine";
    if (!check_namespace(file_.is_machine ? "Machine" : "Dialect")) return false;
    const char* const base = file_.is_machine ? "dialect" : "extends";
    only_attributes(root, {"name", "title", base});
    file_.own.name = required(root, "name");
    file_.own.title = root.attribute("title").value();
    file_.extends = file_.is_machine ? required(root, base) : root.attribute(base).value();
    file_.extends_where = xml_.at(root, base);
    return !file_.is_machine || !file_.extends.empty();
  }

  bool check_namespace(const char* name) {
    const pugi::xml_node root = xml_.root();
    const std::string_view space = root.attribute("xmlns").value();
    if (std::string_view(root.name()) == name && space == dialect_namespace) return true;
    const std::string found = root.attribute("xmlns") ? fmt::format("<{} xmlns=\"{}\">", root.name(), space)
                                                      : fmt::format("<{}>", root.name());
    report_("IG-0106", xml_.at(root), {fmt::format("<{} xmlns=\"{}\">", name, dialect_namespace), shown(found)});
    return false;
  }

  void read_section(pugi::xml_node section) {
    using Reader = void (FileReader::*)(pugi::xml_node);
    static const std::map<std::string, Reader> sections{
        {"Files", &FileReader::read_files},     {"Segmenter", &FileReader::read_segmenter},
        {"Plugins", &FileReader::read_plugins}, {"Dependencies", &FileReader::read_dependencies},
        {"Initial", &FileReader::read_initial}, {"Severities", &FileReader::read_severities},
        {"Chain", &FileReader::read_chain},     {"SearchOrder", &FileReader::read_search_order}};
    const bool is_include = file_.is_machine && section.name() == std::string_view("Include");
    if (is_include || section.name() == std::string_view("Programs")) {
      only_attributes(section, {"src"});
      leaves(section, {});
      if (!file_.is_machine && !once(section)) return;
      if (!required(section, "src").empty()) is_include ? read_include(section) : read_programs(section);
      return;
    }
    if (file_.is_machine && section.name() == std::string_view("Backup")) return read_backup(section);
    const auto found = sections.find(section.name());
    const bool is_of_head = found != sections.end() && (found->first == "Files" || found->first == "Segmenter");
    if (found == sections.end() || (is_part_ && is_of_head)) {
      std::vector<std::string> names = names_of(sections);
      names.emplace_back("Programs");
      if (file_.is_machine) names.insert(names.end(), {"Include", "Backup"});
      return unknown(section, names);
    }
    if (!once(section)) return;
    if (!is_of_head) only_attributes(section, {});
    (this->*found->second)(section);
  }

  /// Where called programs are looked for: a folder below this file's, or a file of several programs.
  void read_programs(pugi::xml_node node) {
    const fs::path place = path_of_src(node);
    std::error_code error;
    if (place.empty()) return;
    if (fs::exists(place, error))
      file_.own.program_places.push_back(place);
    else
      report_("IG-0122", xml_.at(node, "src"), {place.string()});
  }

  /// The folders in which the control searches called programs, below those that the user gives.
  void read_search_order(pugi::xml_node node) {
    file_.has_search_order = true;
    file_.own.search_order.clear();
    bool has_path = false;
    for (const pugi::xml_node child : leaves(node, {"Folder", "ProgramPath"})) {
      SearchFolder folder;
      if (child.name() == std::string_view("Folder")) {
        only_attributes(child, {"name"});
        folder.names = words(required(child, "name"));
        if (folder.names.empty()) continue;
        for (const std::string& name : folder.names)
          if (name.find('/') != std::string::npos) bad_value(child, "name", "names of one folder, without a path");
      } else {
        only_attributes(child, {});
        if (has_path) report_("IG-0113", xml_.at(child), {"ProgramPath", "the search order has it already"});
        has_path = true;
      }
      file_.own.search_order.push_back(std::move(folder));
    }
  }

  /// A file of the control, or a folder of such files; other attributes are options of the importer.
  void read_backup(pugi::xml_node node) {
    leaves(node, {});
    if (required(node, "src").empty()) return;
    Import import{path_of_src(node), node.attribute("format").value(), {}, xml_.at(node, "src")};
    for (const pugi::xml_attribute a : node.attributes()) {
      const std::string_view name = a.name();
      if (name != "src" && name != "format" && !is_markup(name))
        import.options.push_back({a.name(), a.value(), xml_.at(node, name)});
    }
    if (!import.file.empty()) file_.own.imports.push_back(std::move(import));
  }

  /// Reads the parts of another file as if they stood here.
  void read_include(pugi::xml_node node) {
    if (is_part_) return report_("IG-0121", xml_.at(node), {});
    const fs::path path = path_of_src(node);
    if (path.empty()) return;
    const std::unique_ptr<XmlSource> xml = XmlSource::open(path, xml_.at(node, "src"), budget_, report_.sink());
    if (xml == nullptr) {
      report_.failed = true;
      return;
    }
    DialectFile part = read_machine_part(*xml, budget_, report_);
    const auto append = [](auto& to, auto& from) {
      to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
    };
    append(file_.own.dependencies, part.own.dependencies);  // rows of one table may stand in several files
    for (InitialField& field : part.own.initial) add_initial(std::move(field));
    append(file_.own.plugins, part.own.plugins);
    append(file_.own.program_places, part.own.program_places);
    append(file_.own.imports, part.own.imports);
    if (part.has_search_order) {
      if (file_.has_search_order)
        report_("IG-0113", xml->at(xml->root()), {"SearchOrder", "another file of the machine has it already"});
      file_.has_search_order = true;
      file_.own.search_order = std::move(part.own.search_order);
    }
    append(file_.chain_edits, part.chain_edits);
    append(file_.dependency_edits, part.dependency_edits);
    for (const auto& [code, given] : part.own.severities)
      if (!file_.own.severities.emplace(code, given).second)
        report_("IG-0113", given.where, {code, "another file of the machine gives its severity"});
  }

  void read_files(pugi::xml_node node) {
    only_attributes(node, {"extensions"});
    file_.has_files = true;
    file_.own.files_where = xml_.at(node);
    file_.own.extensions = words(node.attribute("extensions").value());
    for (const std::string& extension : file_.own.extensions) {
      if (!extension.starts_with('.') || extension.size() < 2 || extension.find('/') != std::string::npos)
        bad_value(node, "extensions", "endings such as .nc, separated by blanks");
    }
    for (const pugi::xml_node child : leaves(node, {"Signature", "Name"})) {
      only_attributes(child, {"pattern", "weight"});
      Signature signature{required(child, "pattern")};
      if (const pugi::xml_attribute weight = child.attribute("weight")) signature.weight = weight.as_uint();
      if (signature.pattern.find_first_not_of("* ") == std::string::npos)
        bad_value(child, "pattern", "a pattern that not every text matches");
      else if (signature.weight < 1 || signature.weight > 100)
        bad_value(child, "weight", "a whole number from 1 to 100; 4 where it is not given");
      else
        (std::string_view(child.name()) == "Name" ? file_.own.names : file_.own.signatures)
            .push_back(std::move(signature));
    }
  }

  void read_segmenter(pugi::xml_node node) {
    only_attributes(node, {"type", "continuation", "comment"});
    leaves(node, {});
    file_.own.segmenter_where = xml_.at(node);
    Segmenter& own = file_.own.segmenter;
    own.type = required(node, "type");
    if (!own.type.empty() && own.type != "line") bad_value(node, "type", "line");
    own.continuation = mark(node, "continuation");
    own.comment = mark(node, "comment");
    if (!own.comment.empty() && own.continuation.empty()) bad_value(node, "comment", "a continuation beside it");
  }

  /// A few characters of a program's text, or nothing.
  std::string mark(pugi::xml_node node, const char* attribute) {
    constexpr std::size_t longest = 8;
    const pugi::xml_attribute a = node.attribute(attribute);
    const std::string_view text = a.value();
    if (a && (text.empty() || text.size() > longest || text.find_first_of(" \t\r\n") != std::string_view::npos))
      bad_value(node, attribute, "1 to 8 characters without blanks");
    return std::string(text);
  }

  void read_plugins(pugi::xml_node node) {
    for (const pugi::xml_node child : leaves(node, {"Plugin"})) {
      only_attributes(child, {"name"});
      const std::string name = required(child, "name");
      if (name.find('/') != std::string::npos) bad_value(child, "name", "a plugin's name, without folders");
      if (!name.empty()) file_.own.plugins.push_back({name, xml_.at(child, "name")});
    }
  }

  void read_initial(pugi::xml_node node) {
    for (const pugi::xml_node child : leaves(node, {"Field"})) {
      only_attributes(child, {"path", "value"});
      add_initial({required(child, "path"), required(child, "value"), xml_.at(child, "path")});
    }
  }

  void add_initial(InitialField field) {
    const auto same = std::find_if(file_.own.initial.begin(), file_.own.initial.end(),
                                   [&](const InitialField& f) { return f.path == field.path; });
    if (same == file_.own.initial.end())
      file_.own.initial.push_back(std::move(field));
    else
      report_("IG-0113", field.where, {shown(field.path), place(same->where)});
  }

  void read_severities(pugi::xml_node node) {
    for (const pugi::xml_node child : leaves(node, {"Severity"})) {
      only_attributes(child, {"code", "is"});
      const std::string code = required(child, "code");
      const std::string is = required(child, "is");
      bool known = is.empty();
      for (const Severity severity : {Severity::note, Severity::warning, Severity::error}) {
        if (is != to_string(severity)) continue;
        known = true;
        file_.own.severities[code] = {severity, xml_.at(child)};
      }
      if (!known) bad_value(child, "is", "note, warning or error", {"note", "warning", "error"});
    }
  }

  void read_dependencies(pugi::xml_node node) {
    for (const pugi::xml_node child : elements(node)) {
      const std::optional<EditKind> kind = edit_kind(child);
      if (!kind) {
        dependencies_.add(file_.own.dependencies, dependencies_.read(child));
      } else if (*kind == EditKind::insert_before || *kind == EditKind::insert_after) {
        unknown(child, {"Replace", "Remove", "Configure"});
      } else if (const auto head = edit<DependencyElement>(child, *kind, "dependency", {"as", "src"})) {
        Edit<DependencyElement> edit = *head;
        for (const pugi::xml_node inserted : put_in<DependencyElement>(child, *kind))
          edit.elements.push_back(dependencies_.read(inserted));
        file_.dependency_edits.push_back(std::move(edit));
      }
    }
  }

  void read_chain(pugi::xml_node node) {
    if (const std::size_t count = count_elements(node); count > XmlBudget::chain)
      return report_("IG-0105", xml_.at(node), {"the chain", fmt::format("{} elements", XmlBudget::chain)});
    int last_stage = -1;
    std::string_view last_name;
    for (const pugi::xml_node child : elements(node)) {
      const auto stage =
          std::find_if(stages.begin(), stages.end(), [&](Stage s) { return to_string(s) == child.name(); });
      if (const std::optional<EditKind> kind = edit_kind(child)) {
        if (const auto head = edit<ChainElement>(child, *kind, "syntax", {"as"})) read_chain_edit(child, *head);
      } else if (stage == stages.end()) {
        std::vector<std::string> names;
        for (const Stage s : stages) names.emplace_back(to_string(s));
        for (const EditKind k : edit_kinds) names.emplace_back(to_string(k));
        unknown(child, names);
      } else if (edits()) {
        report_("IG-0116", xml_.at(child), {child.name(), "extends none"}, "edit the inherited chain instead");
      } else if (once(child)) {
        if (static_cast<int>(*stage) < last_stage)
          report_("IG-0115", xml_.at(child), {child.name(), std::string(last_name)});
        last_stage = static_cast<int>(*stage);
        last_name = child.name();
        only_attributes(child, {});
        for (const pugi::xml_node syntax : elements(child)) file_.own.chain.push_back(chain_element(syntax, *stage));
      }
    }
  }

  static std::size_t count_elements(pugi::xml_node node) {
    std::size_t count = 0;
    for (const pugi::xml_node child : node.children()) count += 1 + count_elements(child);
    return count;
  }

  void read_chain_edit(pugi::xml_node node, Edit<ChainElement> edit) {
    // The anchor gives the stage when the edit is applied.
    for (const pugi::xml_node inserted : put_in<ChainElement>(node, edit.kind))
      edit.elements.push_back(chain_element(inserted, Stage::logic));
    file_.chain_edits.push_back(std::move(edit));
  }

  ChainElement chain_element(pugi::xml_node node, Stage stage) {
    ChainElement element{stage, node.name(), node.name(), {}, false, xml_.at(node)};
    leaves(node, {});
    for (const pugi::xml_attribute a : node.attributes()) {
      const std::string_view name = a.name();
      if (name == "as") {
        element.alias = alias(node);
      } else if (name == "override") {
        element.override_slot = override_value(node);
      } else {
        element.options.push_back({a.name(), a.value(), xml_.at(node, name)});
      }
    }
    return element;
  }

  // ---- Edits ----

  /// Does the file change what it inherits, rather than list a chain of its own?
  bool edits() const { return is_part_ || !file_.extends.empty(); }

  static std::optional<EditKind> edit_kind(pugi::xml_node node) {
    const auto kind =
        std::find_if(edit_kinds.begin(), edit_kinds.end(), [&](EditKind k) { return to_string(k) == node.name(); });
    return kind == edit_kinds.end() ? std::nullopt : std::optional(*kind);
  }

  /// The edit without the elements that it inserts; empty when it cannot be applied.
  template <class Element>
  std::optional<Edit<Element>> edit(pugi::xml_node node, EditKind kind, const char* anchor,
                                    std::vector<std::string_view> refused) {
    if (!edits()) {
      report_("IG-0116", xml_.at(node), {node.name(), "extends another"});
      return std::nullopt;
    }
    Edit<Element> edit{kind, required(node, anchor), {}, {}, false, xml_.at(node), xml_.at(node, anchor)};
    if (kind != EditKind::configure) {
      only_attributes(node, {anchor});
    } else {
      for (const pugi::xml_attribute a : node.attributes()) {
        const std::string_view name = a.name();
        if (name == anchor) continue;
        if (name == "override" && std::is_same_v<Element, ChainElement>) {
          edit.override_slot = override_value(node);
        } else if (std::find(refused.begin(), refused.end(), name) != refused.end()) {
          report_("IG-0108", xml_.at(node, name), {node.name(), a.name()}, beyond_configure<Element>());
        } else {
          edit.options.push_back({a.name(), a.value(), xml_.at(node, name)});
        }
      }
    }
    if (edit.anchor.empty()) return std::nullopt;
    return edit;
  }

  /// Parts of the edit that are more than options.
  template <class Element>
  static std::string beyond_configure() {
    return std::is_same_v<Element, ChainElement>
               ? "Configure sets options; to give another name, or another element, write <Replace>"
               : "Configure sets options; for a name, a file or rows <Remove> the dependency and list it anew";
  }

  template <class Element>
  std::vector<pugi::xml_node> put_in(pugi::xml_node node, EditKind kind) {
    if (kind == EditKind::configure)
      for (const pugi::xml_node child : node.children())
        if (child.type() == pugi::node_element) {
          report_("IG-0107", xml_.at(child), {shown(child.name()), node.name()}, beyond_configure<Element>());
          return {};
        }
    if (kind == EditKind::remove || kind == EditKind::configure) return leaves(node, {});
    std::vector<pugi::xml_node> all = elements(node);
    if (all.empty()) report_("IG-0120", xml_.at(node), {node.name()});
    return all;
  }

  bool override_value(pugi::xml_node node) {
    const std::string_view value = node.attribute("override").value();
    if (value != "true" && value != "false") bad_value(node, "override", "true or false");
    return value == "true";
  }

  template <class Map>
  static std::vector<std::string> names_of(const Map& map) {
    std::vector<std::string> names;
    for (const auto& [name, unused] : map) names.push_back(name);
    return names;
  }

  XmlBudget& budget_;
  DialectFile file_;
  DependencyReader dependencies_;
  bool is_part_ = false;
};

}  // namespace

std::string_view to_string(Stage stage) {
  constexpr std::array<std::string_view, 5> names{"Parsing", "Evaluation", "Logic", "PostLogic", "Inspection"};
  return names[static_cast<std::size_t>(stage)];
}

std::string_view to_string(EditKind kind) {
  constexpr std::array<std::string_view, 5> names{"Replace", "InsertBefore", "InsertAfter", "Remove", "Configure"};
  return names[static_cast<std::size_t>(kind)];
}

DialectFile read_dialect_file(const XmlSource& xml, XmlBudget& budget, Report& report) {
  return FileReader(xml, budget, report).dialect();
}

DialectFile read_machine_part(const XmlSource& xml, XmlBudget& budget, Report& report) {
  return FileReader(xml, budget, report).machine_part();
}

Dialect read_dialect_head(const XmlSource& xml, Report& report) {
  XmlBudget budget;
  return FileReader(xml, budget, report).head();
}

}  // namespace isogloss
