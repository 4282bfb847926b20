// The effective dialect as XML, so that nobody has to apply `extends` and edits by hand.
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "dialect/xml_source.hpp"
#include "isogloss/engine/dialect.hpp"

namespace isogloss {
namespace {

namespace fs = std::filesystem;

std::string text_of(const pugi::xml_document& document) {
  std::ostringstream out;
  document.save(out, "  ", pugi::format_indent, pugi::encoding_utf8);
  return out.str();
}

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : " ") + word;
  return all;
}

void set_all(pugi::xml_node node, const std::vector<Attribute>& attributes) {
  for (const Attribute& a : attributes) set_attribute(node, a.name.c_str(), a.value);
}

/// Where the side file of a dependency lies below `base`: in its old place when it has one there.
std::string side_file_name(const DependencyElement& dependency, const fs::path& base,
                           const std::map<std::string, std::string>& taken) {
  const fs::path file = fs::path(dependency.source_file).lexically_normal();
  const fs::path relative = file.lexically_relative(base.lexically_normal());
  const bool is_below = !relative.empty() && *relative.begin() != ".." && *relative.begin() != ".";
  std::string name = is_below ? relative.generic_string() : file.filename().string();
  while (taken.count(name) > 0) name = dependency.alias + "." + fs::path(name).filename().string();
  return name;
}

class DialectWriter {
 public:
  DialectWriter(const Dialect& dialect, const fs::path& base, bool inline_tables, Annotations annotations)
      : dialect_(dialect), base_(base), inline_tables_(inline_tables), annotations_(annotations) {}

  WrittenDialect write() {
    pugi::xml_document document;
    pugi::xml_node root = document.append_child("Dialect");
    set_attribute(root, "xmlns", "urn:isogloss:dialect:1");
    set_attribute(root, "name", dialect_.name);
    if (!dialect_.title.empty()) set_attribute(root, "title", dialect_.title);
    add_files(root);
    add_segmenter(root);
    add_plugins(root);
    add_programs(root);
    add_search_order(root);
    add_dependencies(root);
    add_initial(root);
    add_severities(root);
    add_chain(root);
    written_.xml = text_of(document);
    return std::move(written_);
  }

 private:
  /// A comment before what is appended next: the place of the element, and of options that stand elsewhere.
  void annotate(pugi::xml_node parent, const Location& where, const std::vector<Attribute>& options = {}) const {
    if (annotations_ == Annotations::none || where.file.empty()) return;
    const auto place = [](const Location& w) {
      std::string text = w.file + ":" + std::to_string(w.line);
      for (std::size_t i; (i = text.find("--")) != std::string::npos;) text.replace(i, 2, "- ");  // ends a comment
      return text;
    };
    std::string text = " " + place(where);
    for (const Attribute& option : options)
      if (!option.where.file.empty() && place(option.where) != place(where))
        text += "; " + option.name + ": " + place(option.where);
    parent.append_child(pugi::node_comment).set_value((text + " ").c_str());
  }

  void add_files(pugi::xml_node root) const {
    if (dialect_.extensions.empty() && dialect_.signatures.empty() && dialect_.names.empty()) return;
    annotate(root, dialect_.files_where);
    pugi::xml_node files = root.append_child("Files");
    if (!dialect_.extensions.empty()) set_attribute(files, "extensions", joined(dialect_.extensions));
    add_signatures(files, "Signature", dialect_.signatures);
    add_signatures(files, "Name", dialect_.names);
  }
  static void add_signatures(pugi::xml_node files, const char* element, const std::vector<Signature>& all) {
    for (const Signature& signature : all) {
      pugi::xml_node node = files.append_child(element);
      set_attribute(node, "pattern", signature.pattern);
      if (signature.weight != Signature::usual_weight) set_attribute(node, "weight", std::to_string(signature.weight));
    }
  }

  void add_segmenter(pugi::xml_node root) const {
    annotate(root, dialect_.segmenter_where);
    pugi::xml_node segmenter = root.append_child("Segmenter");
    set_attribute(segmenter, "type", dialect_.segmenter.type);
    if (!dialect_.segmenter.continuation.empty())
      set_attribute(segmenter, "continuation", dialect_.segmenter.continuation);
    if (!dialect_.segmenter.comment.empty()) set_attribute(segmenter, "comment", dialect_.segmenter.comment);
  }

  void add_plugins(pugi::xml_node root) const {
    if (dialect_.plugins.empty()) return;
    pugi::xml_node plugins = root.append_child("Plugins");
    for (const PluginReference& plugin : dialect_.plugins) {
      annotate(plugins, plugin.where);
      set_attribute(plugins.append_child("Plugin"), "name", plugin.name);
    }
  }

  void add_programs(pugi::xml_node root) const {
    for (const fs::path& place : dialect_.program_places) {
      const fs::path relative = place.lexically_normal().lexically_relative(base_.lexically_normal());
      const bool is_below = !relative.empty() && *relative.begin() != "..";
      set_attribute(root.append_child("Programs"), "src", (is_below ? relative : place).generic_string());
    }
  }

  void add_search_order(pugi::xml_node root) const {
    if (dialect_.search_order.empty()) return;
    pugi::xml_node order = root.append_child("SearchOrder");
    for (const SearchFolder& folder : dialect_.search_order) {
      std::string names;
      for (const std::string& name : folder.names) names += (names.empty() ? "" : " ") + name;
      if (names.empty())
        order.append_child("ProgramPath");
      else
        set_attribute(order.append_child("Folder"), "name", names);
    }
  }

  void add_dependencies(pugi::xml_node root) {
    if (dialect_.dependencies.empty()) return;
    pugi::xml_node dependencies = root.append_child("Dependencies");
    for (const DependencyElement& dependency : dialect_.dependencies) {
      annotate(dependencies, dependency.where, dependency.options);
      pugi::xml_node node = dependencies.append_child(dependency.id.c_str());
      if (dependency.alias != dependency.id) set_attribute(node, "as", dependency.alias);
      if (inline_tables_ || dependency.source_file.empty()) {
        set_all(node, dependency.options);
        add_rows(node, dependency);
        continue;
      }
      const std::string name = side_file_name(dependency, base_, written_.side_files);
      set_attribute(node, "src", name);
      pugi::xml_document table;
      pugi::xml_node table_root = table.append_child(dependency.id.c_str());
      set_all(table_root, dependency.options);
      add_rows(table_root, dependency);
      written_.side_files[name] = text_of(table);
    }
  }

  void add_rows(pugi::xml_node node, const DependencyElement& dependency) const {
    for (const TableRow& row : dependency.rows) {
      annotate(node, row.where);
      set_all(node.append_child(row.element.c_str()), row.attributes);
    }
  }

  void add_initial(pugi::xml_node root) const {
    if (dialect_.initial.empty()) return;
    pugi::xml_node initial = root.append_child("Initial");
    for (const InitialField& field : dialect_.initial) {
      annotate(initial, field.where);
      pugi::xml_node node = initial.append_child("Field");
      set_attribute(node, "path", field.path);
      set_attribute(node, "value", field.value);
    }
  }

  void add_severities(pugi::xml_node root) const {
    if (dialect_.severities.empty()) return;
    pugi::xml_node severities = root.append_child("Severities");
    for (const auto& [code, given] : dialect_.severities) {
      annotate(severities, given.where);
      pugi::xml_node node = severities.append_child("Severity");
      set_attribute(node, "code", code);
      set_attribute(node, "is", std::string(to_string(given.severity)));
    }
  }

  void add_chain(pugi::xml_node root) const {
    if (dialect_.chain.empty()) return;
    pugi::xml_node chain = root.append_child("Chain");
    for (const ChainElement& element : dialect_.chain) {
      const std::string stage(to_string(element.stage));
      pugi::xml_node group = chain.child(stage.c_str());
      if (!group) group = chain.append_child(stage.c_str());
      annotate(group, element.where, element.options);
      pugi::xml_node node = group.append_child(element.syntax.c_str());
      if (element.alias != element.syntax) set_attribute(node, "as", element.alias);
      if (element.override_slot) set_attribute(node, "override", "true");
      set_all(node, element.options);
    }
  }

  const Dialect& dialect_;
  const fs::path& base_;
  bool inline_tables_;
  Annotations annotations_;
  WrittenDialect written_;
};

}  // namespace

WrittenDialect write_dialect(const Dialect& dialect, const std::filesystem::path& base, bool inline_tables,
                             Annotations annotations) {
  return DialectWriter(dialect, base, inline_tables, annotations).write();
}

}  // namespace isogloss
