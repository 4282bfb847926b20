// The XML Schemas of dialect files and of table files. What XSD 1.0 cannot say the reader and the linker check: that an
// attribute of Configure belongs to the syntax which it names, anchors that exist, orders, services.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>
#include <sstream>
#include <string_view>

#include "dialect/schema_parts.hpp"
#include "dialect/xml_source.hpp"
#include "isogloss/engine/library.hpp"
#include "isogloss/engine/schema.hpp"

namespace isogloss {
namespace {

template <class Part>
using Owned = std::pair<const Part*, const ig_plugin*>;

/// What the plugins of a library contribute, sorted by id.
struct Parts {
  std::vector<Owned<ig_syntax>> syntaxes;
  std::vector<Owned<ig_dependency>> dependencies;
  std::vector<Owned<ig_importer>> importers;
  std::vector<NamedText> plugins;

  explicit Parts(const Library& library) {
    for (const LoadedPlugin& loaded : library.plugins()) {
      const ig_plugin& plugin = *loaded.plugin;
      plugins.emplace_back(plugin.name, "");
      for (std::uint32_t i = 0; i < plugin.syntax_count; ++i) syntaxes.emplace_back(plugin.syntaxes[i], &plugin);
      for (std::uint32_t i = 0; i < plugin.dependency_count; ++i)
        dependencies.emplace_back(plugin.dependencies[i], &plugin);
      for (std::uint32_t i = 0; i < plugin.importer_count; ++i) importers.emplace_back(plugin.importers[i], &plugin);
    }
    const auto by_id = [](const auto& a, const auto& b) { return std::string_view(a.first->id) < b.first->id; };
    std::sort(syntaxes.begin(), syntaxes.end(), by_id);
    std::sort(dependencies.begin(), dependencies.end(), by_id);
    std::sort(importers.begin(), importers.end(), by_id);
    std::sort(plugins.begin(), plugins.end());
  }
};

template <class Part>
std::vector<NamedText> names_of(const std::vector<Owned<Part>>& parts) {
  std::vector<NamedText> out;
  for (const auto& [part, plugin] : parts) out.emplace_back(part->id, part->summary);
  return out;
}

/// The options of all parts by name, each with its owners.
template <class Part>
std::map<std::string, std::vector<OwnedOption>> options_of(const std::vector<Owned<Part>>& parts) {
  std::map<std::string, std::vector<OwnedOption>> out;
  for (const auto& [part, plugin] : parts)
    for (const ig_option_decl& option : std::span(part->options, part->option_count))
      out[option.name].emplace_back(part->id, &option);
  return out;
}

void add_attribute_group(pugi::xml_node type, const char* group) {
  set_attribute(add_element(type, "xs:attributeGroup"), "ref", group);
}

void add_required(pugi::xml_node type, const char* name, const char* of) {
  pugi::xml_node attribute = add_element(type, "xs:attribute", name);
  add_type(attribute, of);
  set_attribute(attribute, "use", "required");
}

void add_syntax_type(pugi::xml_node schema, const ig_syntax& syntax, const ig_plugin& plugin) {
  pugi::xml_node type = add_element(schema, "xs:complexType", fmt::format("syntax.{}", syntax.id));
  add_documentation(type, fmt::format("{} (plugin {})", syntax.summary, plugin.name));
  add_attribute_group(type, "dialect.Instance");
  add_attribute_group(type, "dialect.Slot");
  for (std::uint32_t i = 0; i < syntax.option_count; ++i) add_option(type, syntax.options[i]);
}

void add_row(pugi::xml_node type, const ig_dependency& dependency) {
  pugi::xml_node row = add_element(add_element(type, "xs:sequence"), "xs:element", dependency.row_element);
  set_attribute(row, "minOccurs", "0");
  set_attribute(row, "maxOccurs", "unbounded");
  pugi::xml_node row_type = add_element(row, "xs:complexType");
  add_required(row_type, dependency.row_key, "dialect.Text");
  for (std::uint32_t i = 0; i < dependency.column_count; ++i) {
    const ig_column_decl& column = dependency.columns[i];
    pugi::xml_node attribute = add_element(row_type, "xs:attribute", column.name);
    add_documentation(attribute, with_unit(column.doc, column.unit));
    if (column.is_text != 0)
      add_type(attribute, "xs:string");
    else
      add_range(restrict_to(attribute, "xs:decimal"), column.minimum, column.maximum);
  }
}

bool fills(const ig_importer& importer, const ig_dependency& dependency) {
  for (const char* const* id = importer.dependencies; id != nullptr && *id != nullptr; ++id)
    if (std::string_view(*id) == dependency.id) return true;
  return false;
}

void add_format(pugi::xml_node type, const std::vector<Owned<ig_importer>>& importers, const char* doc) {
  if (importers.empty()) return;
  pugi::xml_node attribute = add_element(type, "xs:attribute", "format");
  add_documentation(attribute, doc);
  pugi::xml_node restriction = restrict_to(attribute, "xs:string");
  for (const auto& [importer, plugin] : importers)
    set_attribute(add_element(restriction, "xs:enumeration"), "value", importer->id);
}

/// The format and options of the importers that read the table's src.
void add_importer_options(pugi::xml_node type, const ig_dependency& dependency, const Parts& parts) {
  std::vector<Owned<ig_importer>> importers;
  for (const auto& owned : parts.importers)
    if (fills(*owned.first, dependency)) importers.push_back(owned);
  add_format(type, importers,
             "The importer of the file that src names; without it the content decides. Its options stand beside it.");
  const std::span<const ig_option_decl> own(dependency.options, dependency.option_count);
  for (const auto& shared : options_of(importers))
    if (std::none_of(own.begin(), own.end(), [&](const ig_option_decl& o) { return shared.first == o.name; }))
      add_shared_option(type, shared.second);
}

void add_dependency_type(pugi::xml_node schema, const Owned<ig_dependency>& owned, const Parts& parts) {
  const auto& [dependency, plugin] = owned;
  // Global elements: a table file in this namespace can be validated on its own.
  add_type(add_element(schema, "xs:element", dependency->id), fmt::format("dependency.{}", dependency->id).c_str());
  pugi::xml_node type = add_element(schema, "xs:complexType", fmt::format("dependency.{}", dependency->id));
  add_documentation(type, fmt::format("{} (plugin {})", dependency->summary, plugin->name));
  if (dependency->row_element != nullptr) add_row(type, *dependency);
  add_attribute_group(type, "dialect.Instance");
  add_attribute_group(type, "dialect.Table");
  for (std::uint32_t i = 0; i < dependency->option_count; ++i) add_option(type, dependency->options[i]);
  add_importer_options(type, *dependency, parts);
}

void add_dependencies(pugi::xml_node schema, const Parts& parts) {
  pugi::xml_node choice = add_element(add_element(schema, "xs:group", "dialect.Dependency"), "xs:choice");
  for (const auto& [dependency, plugin] : parts.dependencies)
    set_attribute(choice.append_child("xs:element"), "ref", dependency->id);
  for (const auto& owned : parts.dependencies) add_dependency_type(schema, owned, parts);
}

/// XSD 1.0 cannot type attributes by the value of another one: a Configure takes each option of any syntax, with any
/// value that some syntax takes. The rest is up to `lint`.
template <class Part>
pugi::xml_node add_configure_type(pugi::xml_node schema, const char* name, const char* doc,
                                  const std::vector<Owned<Part>>& parts) {
  pugi::xml_node type = add_element(schema, "xs:complexType", name);
  add_documentation(type, doc);
  for (const auto& [option, owned] : options_of(parts)) add_shared_option(type, owned);
  return type;
}

void add_edits(pugi::xml_node schema, const Parts& parts) {
  add_name_type(schema, "dialect.SyntaxName", names_of(parts.syntaxes), "dialect.Alias");
  add_name_type(schema, "dialect.DependencyName", names_of(parts.dependencies), "dialect.Alias");
  add_name_type(schema, "dialect.PluginName", parts.plugins);

  pugi::xml_node syntax = add_configure_type(schema, "dialect.ConfigureSyntax",
                                             "Sets options of an inherited syntax. Each attribute names the syntaxes "
                                             "that have it; `isogloss lint` checks that "
                                             "the one named has it, and takes the value.",
                                             parts.syntaxes);
  add_attribute_group(syntax, "dialect.Slot");
  add_required(syntax, "syntax", "dialect.SyntaxName");

  pugi::xml_node dependency = add_configure_type(
      schema, "dialect.ConfigureDependency",
      "Sets options of an inherited dependency. Each attribute names the dependencies that have it; `isogloss lint` "
      "checks that the one named has it, and takes the value.",
      parts.dependencies);
  add_required(dependency, "dependency", "dialect.DependencyName");

  pugi::xml_node backup = add_configure_type(schema, "dialect.Backup",
                                             "A file of the control, or a folder of such files, whose tables the "
                                             "machine takes. Other attributes are options of "
                                             "the importers that they name.",
                                             parts.importers);
  add_required(backup, "src", "dialect.Text");
  add_format(backup, parts.importers, "The importer; without it the content decides.");
}

std::string as_text(pugi::xml_document& document, const char* command) {
  document.prepend_child(pugi::node_comment).set_value(fmt::format(" Generated by `{}`. ", command).c_str());
  std::ostringstream out;
  document.save(out, "  ", pugi::format_indent, pugi::encoding_utf8);
  return out.str();
}

bool belongs_to_tables(pugi::xml_node node) {
  const std::string_view kind = node.name(), name = node.attribute("name").value();
  if (kind == "xs:simpleType") return name == "dialect.Text" || name == "dialect.Alias" || name == "dialect.Boolean";
  return kind == "xs:attributeGroup" && (name == "dialect.Instance" || name == "dialect.Table");
}

}  // namespace

std::string dialect_schema(const Library& library) {
  const Parts parts(library);
  pugi::xml_document document;
  document.load_string(dialect_schema_frame());
  pugi::xml_node schema = document.document_element();
  pugi::xml_node choice = add_element(add_element(schema, "xs:group", "dialect.Syntax"), "xs:choice");
  for (const auto& [syntax, plugin] : parts.syntaxes)
    add_type(add_element(choice, "xs:element", syntax->id), fmt::format("syntax.{}", syntax->id).c_str());
  for (const auto& [syntax, plugin] : parts.syntaxes) add_syntax_type(schema, *syntax, *plugin);
  add_dependencies(schema, parts);
  add_edits(schema, parts);
  return as_text(document, "isogloss schema dialect");
}

std::string table_schema(const Library& library) {
  pugi::xml_document frame, document;
  frame.load_string(dialect_schema_frame());
  pugi::xml_node schema = document.append_child("xs:schema");
  set_attribute(schema, "xmlns:xs", "http://www.w3.org/2001/XMLSchema");
  pugi::xml_node all = add_element(schema, "xs:element", "Dependencies");
  add_documentation(all, "Tables of a machine in one file, for --machine, --offsets, --tools and <Include>.");
  pugi::xml_node choice = add_element(add_element(all, "xs:complexType"), "xs:choice");
  set_attribute(choice, "minOccurs", "0");
  set_attribute(choice, "maxOccurs", "unbounded");
  set_attribute(add_element(choice, "xs:group"), "ref", "dialect.Dependency");
  for (const pugi::xml_node part : frame.document_element().children())
    if (belongs_to_tables(part)) schema.append_copy(part);
  add_dependencies(schema, Parts(library));
  return as_text(document, "isogloss schema tables");
}

}  // namespace isogloss
