// The XML Schema of dialect files. What a schema cannot say (anchors that exist, orders, services) the reader and the
// linker check.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <pugixml.hpp>
#include <span>
#include <sstream>
#include <vector>

#include "dialect/xml_source.hpp"
#include "isogloss/engine/dialect.hpp"
#include "isogloss/engine/library.hpp"
#include "isogloss/engine/schema.hpp"

namespace isogloss {
namespace {

// The part that does not depend on plugins. The places for syntaxes and dependencies are groups that follow.
constexpr const char* schema_frame = R"(
<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema" xmlns="urn:isogloss:dialect:1"
           targetNamespace="urn:isogloss:dialect:1" elementFormDefault="qualified">
  <xs:element name="Dialect">
    <xs:annotation><xs:documentation>A controller dialect: which plugins, which tables, which syntaxes in which order. Relative paths resolve against the file that holds them.</xs:documentation></xs:annotation>
    <xs:complexType>
      <xs:all>
        <xs:element name="Files" type="dialect.Files" minOccurs="0"/>
        <xs:element name="Segmenter" type="dialect.Segmenter" minOccurs="0"/>
        <xs:element name="Plugins" type="dialect.Plugins" minOccurs="0"/>
        <xs:element name="Programs" type="dialect.Programs" minOccurs="0"/>
        <xs:element name="SearchOrder" type="dialect.SearchOrder" minOccurs="0"/>
        <xs:element ref="Dependencies" minOccurs="0"/>
        <xs:element name="Initial" type="dialect.Initial" minOccurs="0"/>
        <xs:element name="Severities" type="dialect.Severities" minOccurs="0"/>
        <xs:element name="Chain" type="dialect.Chain" minOccurs="0"/>
      </xs:all>
      <xs:attribute name="name" type="dialect.Text" use="required"/>
      <xs:attribute name="title" type="xs:string"/>
      <xs:attribute name="extends" type="dialect.Text"><xs:annotation><xs:documentation>The dialect that this one inherits chain, plugins, dependencies and initial state from: a name, or a file.</xs:documentation></xs:annotation></xs:attribute>
    </xs:complexType>
  </xs:element>
  <xs:element name="Machine">
    <xs:annotation><xs:documentation>What one machine has on top of its dialect, in machine.xml of its folder; or, without attributes, a part of it that machine.xml includes. Paths are relative to the file and stay in its folder.</xs:documentation></xs:annotation>
    <xs:complexType>
      <xs:choice minOccurs="0" maxOccurs="unbounded">
        <xs:element name="Files" type="dialect.Files"/>
        <xs:element name="Segmenter" type="dialect.Segmenter"/>
        <xs:element name="Plugins" type="dialect.Plugins"/>
        <xs:element name="Programs" type="dialect.Programs"/>
        <xs:element name="SearchOrder" type="dialect.SearchOrder"/>
        <xs:element name="Include" type="dialect.Include"/>
        <xs:element name="Backup" type="dialect.Backup"/>
        <xs:element ref="Dependencies"/>
        <xs:element name="Initial" type="dialect.Initial"/>
        <xs:element name="Severities" type="dialect.Severities"/>
        <xs:element name="Chain" type="dialect.Chain"/>
      </xs:choice>
      <xs:attribute name="name" type="dialect.Text"/>
      <xs:attribute name="title" type="xs:string"/>
      <xs:attribute name="dialect" type="dialect.Text"><xs:annotation><xs:documentation>The dialect that the machine stands on: a name, or a file.</xs:documentation></xs:annotation></xs:attribute>
    </xs:complexType>
  </xs:element>
  <xs:complexType name="dialect.Programs">
    <xs:annotation><xs:documentation>Where called programs are looked for: a folder, or a file of several programs.</xs:documentation></xs:annotation>
    <xs:attribute name="src" type="dialect.Text" use="required"/>
  </xs:complexType>
  <xs:complexType name="dialect.SearchOrder">
    <xs:annotation><xs:documentation>The folders in which the control searches a called program, in this order, after the folder of the main program and those of Programs. They stand below these, or one folder further down in those of Programs; letters match in any case.</xs:documentation></xs:annotation>
    <xs:choice minOccurs="0" maxOccurs="unbounded">
      <xs:element name="Folder"><xs:complexType>
        <xs:attribute name="name" type="dialect.Text" use="required"><xs:annotation><xs:documentation>The folder's name; several spellings of it are separated by blanks.</xs:documentation></xs:annotation></xs:attribute>
      </xs:complexType></xs:element>
      <xs:element name="ProgramPath"><xs:annotation><xs:documentation>The folders that the program itself adds to the search.</xs:documentation></xs:annotation><xs:complexType/></xs:element>
    </xs:choice>
  </xs:complexType>
  <xs:complexType name="dialect.Include">
    <xs:annotation><xs:documentation>A file with a part of the machine, or with tables alone.</xs:documentation></xs:annotation>
    <xs:attribute name="src" type="dialect.Text" use="required"/>
  </xs:complexType>
  <xs:complexType name="dialect.Backup">
    <xs:annotation><xs:documentation>A file of the control, or a folder of such files, whose tables the machine takes. Other attributes are options of the importer.</xs:documentation></xs:annotation>
    <xs:attribute name="src" type="dialect.Text" use="required"/>
    <xs:attribute name="format" type="dialect.Text"><xs:annotation><xs:documentation>The importer; without it the content decides.</xs:documentation></xs:annotation></xs:attribute>
    <xs:anyAttribute namespace="##local" processContents="skip"/>
  </xs:complexType>
  <xs:element name="Dependencies">
    <xs:annotation><xs:documentation>Named parts that answer questions. The nearest provider of a service wins: one's own before inherited ones, in written order.</xs:documentation></xs:annotation>
    <xs:complexType>
      <xs:choice minOccurs="0" maxOccurs="unbounded">
        <xs:group ref="dialect.Dependency"/>
        <xs:element name="Replace"><xs:complexType>
          <xs:group ref="dialect.Dependency" maxOccurs="unbounded"/>
          <xs:attribute name="dependency" type="dialect.Text" use="required"/>
        </xs:complexType></xs:element>
        <xs:element name="Remove"><xs:complexType>
          <xs:attribute name="dependency" type="dialect.Text" use="required"/>
        </xs:complexType></xs:element>
        <xs:element name="Configure"><xs:complexType>
          <xs:attribute name="dependency" type="dialect.Text" use="required"/>
          <xs:anyAttribute namespace="##local" processContents="skip"/>
        </xs:complexType></xs:element>
      </xs:choice>
    </xs:complexType>
  </xs:element>
  <xs:complexType name="dialect.Signature">
    <xs:annotation><xs:documentation>A sign of a dialect: in a line of the text, or in the name of the file.</xs:documentation></xs:annotation>
    <xs:attribute name="pattern" type="dialect.Text" use="required"><xs:annotation><xs:documentation>Shell pattern (* ? [0-9]) for a line in the head of a program; of a Name, for the file's name in small letters.</xs:documentation></xs:annotation></xs:attribute>
    <xs:attribute name="weight" default="4"><xs:annotation><xs:documentation>How much the sign tells: lower where programs of other dialects show it too. A file's extension weighs 2.</xs:documentation></xs:annotation>
      <xs:simpleType><xs:restriction base="xs:positiveInteger"><xs:maxInclusive value="100"/></xs:restriction></xs:simpleType>
    </xs:attribute>
  </xs:complexType>
  <xs:complexType name="dialect.Files">
    <xs:annotation><xs:documentation>How a program of this dialect is recognised.</xs:documentation></xs:annotation>
    <xs:choice minOccurs="0" maxOccurs="unbounded">
      <xs:element name="Signature" type="dialect.Signature"/>
      <xs:element name="Name" type="dialect.Signature"/>
    </xs:choice>
    <xs:attribute name="extensions"><xs:annotation><xs:documentation>Endings of file names, separated by blanks.</xs:documentation></xs:annotation>
      <xs:simpleType><xs:restriction base="xs:token"><xs:pattern value="(\.[^/ ]+( \.[^/ ]+)*)?"/></xs:restriction></xs:simpleType>
    </xs:attribute>
  </xs:complexType>
  <xs:complexType name="dialect.Segmenter">
    <xs:annotation><xs:documentation>How text is cut into blocks.</xs:documentation></xs:annotation>
    <xs:attribute name="type" use="required"><xs:simpleType><xs:restriction base="xs:string"><xs:enumeration value="line"/></xs:restriction></xs:simpleType></xs:attribute>
    <xs:attribute name="continuation" type="dialect.Mark"><xs:annotation><xs:documentation>A line that ends with this mark continues in the next one: both are one block. Without it each line is a block.</xs:documentation></xs:annotation></xs:attribute>
    <xs:attribute name="comment" type="dialect.Mark"><xs:annotation><xs:documentation>Begins a comment, which may stand after the mark.</xs:documentation></xs:annotation></xs:attribute>
  </xs:complexType>
  <xs:simpleType name="dialect.Mark"><xs:restriction base="xs:string"><xs:pattern value="[^ \t\r\n]{1,8}"/></xs:restriction></xs:simpleType>
  <xs:complexType name="dialect.Plugins">
    <xs:sequence>
      <xs:element name="Plugin" minOccurs="0" maxOccurs="unbounded"><xs:complexType>
        <xs:attribute name="name" use="required"><xs:simpleType><xs:restriction base="xs:string"><xs:pattern value="[^/]+"/></xs:restriction></xs:simpleType></xs:attribute>
      </xs:complexType></xs:element>
    </xs:sequence>
  </xs:complexType>
  <xs:complexType name="dialect.Initial">
    <xs:annotation><xs:documentation>Field values of a block before the first: the modal state at power-on.</xs:documentation></xs:annotation>
    <xs:sequence>
      <xs:element name="Field" minOccurs="0" maxOccurs="unbounded"><xs:complexType>
        <xs:attribute name="path" use="required"><xs:simpleType><xs:restriction base="xs:string"><xs:pattern value="[^. ]+(\.[^. ]+)+"/></xs:restriction></xs:simpleType></xs:attribute>
        <xs:attribute name="value" type="dialect.Text" use="required"/>
      </xs:complexType></xs:element>
    </xs:sequence>
  </xs:complexType>
  <xs:complexType name="dialect.Severities">
    <xs:annotation><xs:documentation>Severities of diagnostics that differ from their tables.</xs:documentation></xs:annotation>
    <xs:sequence>
      <xs:element name="Severity" minOccurs="0" maxOccurs="unbounded"><xs:complexType>
        <xs:attribute name="code" type="dialect.Text" use="required"/>
        <xs:attribute name="is" use="required"><xs:simpleType><xs:restriction base="xs:string"><xs:enumeration value="note"/><xs:enumeration value="warning"/><xs:enumeration value="error"/></xs:restriction></xs:simpleType></xs:attribute>
      </xs:complexType></xs:element>
    </xs:sequence>
  </xs:complexType>
  <xs:complexType name="dialect.Chain">
    <xs:annotation><xs:documentation>The syntaxes in the order in which they run, by stage; in a dialect that extends another, edits of the inherited chain in written order.</xs:documentation></xs:annotation>
    <xs:choice>
      <xs:sequence>
        <xs:element name="Parsing" type="dialect.Syntaxes" minOccurs="0"/>
        <xs:element name="Evaluation" type="dialect.Syntaxes" minOccurs="0"/>
        <xs:element name="Logic" type="dialect.Syntaxes" minOccurs="0"/>
        <xs:element name="PostLogic" type="dialect.Syntaxes" minOccurs="0"/>
        <xs:element name="Inspection" type="dialect.Syntaxes" minOccurs="0"/>
      </xs:sequence>
      <xs:choice maxOccurs="unbounded">
        <xs:element name="Replace" type="dialect.PutIn"/>
        <xs:element name="InsertBefore" type="dialect.PutIn"/>
        <xs:element name="InsertAfter" type="dialect.PutIn"/>
        <xs:element name="Remove"><xs:complexType><xs:attribute name="syntax" type="dialect.Text" use="required"/></xs:complexType></xs:element>
        <xs:element name="Configure"><xs:complexType>
          <xs:attribute name="syntax" type="dialect.Text" use="required"/>
          <xs:anyAttribute namespace="##local" processContents="skip"/>
        </xs:complexType></xs:element>
      </xs:choice>
    </xs:choice>
  </xs:complexType>
  <xs:complexType name="dialect.PutIn">
    <xs:group ref="dialect.Syntax" maxOccurs="unbounded"/>
    <xs:attribute name="syntax" type="dialect.Text" use="required"/>
  </xs:complexType>
  <xs:complexType name="dialect.Syntaxes">
    <xs:group ref="dialect.Syntax" minOccurs="0" maxOccurs="unbounded"/>
  </xs:complexType>
  <xs:attributeGroup name="dialect.Instance">
    <xs:attribute name="as" type="dialect.Alias"><xs:annotation><xs:documentation>The name that edits and explanations use, when the element stands more than once.</xs:documentation></xs:annotation></xs:attribute>
  </xs:attributeGroup>
  <xs:attributeGroup name="dialect.Slot">
    <xs:attribute name="override" type="dialect.Boolean"><xs:annotation><xs:documentation>true: may claim an exclusive slot that another syntax holds, or take a code that another one takes.</xs:documentation></xs:annotation></xs:attribute>
  </xs:attributeGroup>
  <xs:attributeGroup name="dialect.Table">
    <xs:attribute name="src" type="dialect.Text"><xs:annotation><xs:documentation>A file beside or below this one with the rows: XML whose root element has this element's name, or a file of a control that an importer reads.</xs:documentation></xs:annotation></xs:attribute>
    <xs:attribute name="format" type="dialect.Text"><xs:annotation><xs:documentation>The importer of the file that src names; without it the content decides. Its options stand beside it.</xs:documentation></xs:annotation></xs:attribute>
  </xs:attributeGroup>
  <xs:simpleType name="dialect.Text"><xs:restriction base="xs:string"><xs:minLength value="1"/></xs:restriction></xs:simpleType>
  <xs:simpleType name="dialect.Alias"><xs:restriction base="xs:string"><xs:pattern value="\S+"/></xs:restriction></xs:simpleType>
  <xs:simpleType name="dialect.Boolean"><xs:restriction base="xs:string"><xs:enumeration value="true"/><xs:enumeration value="false"/></xs:restriction></xs:simpleType>
</xs:schema>)";

/// Without exponent, which xs:decimal does not have.
std::string decimal(double value) {
  char text[512];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed);
  return {text, end};
}

pugi::xml_node add(pugi::xml_node parent, const char* element, const char* name = nullptr) {
  pugi::xml_node node = parent.append_child(element);
  if (name != nullptr) set_attribute(node, "name", name);
  return node;
}

void document(pugi::xml_node node, const std::string& text) {
  if (text.empty()) return;
  add(add(node, "xs:annotation"), "xs:documentation").text().set(text.c_str());
}

void add_range(pugi::xml_node restriction, double minimum, double maximum) {
  if (std::isfinite(minimum)) set_attribute(add(restriction, "xs:minInclusive"), "value", decimal(minimum));
  if (std::isfinite(maximum)) set_attribute(add(restriction, "xs:maxInclusive"), "value", decimal(maximum));
}

pugi::xml_node restrict_to(pugi::xml_node attribute, const char* base) {
  pugi::xml_node restriction = add(add(attribute, "xs:simpleType"), "xs:restriction");
  set_attribute(restriction, "base", base);
  return restriction;
}

std::string with_unit(const char* doc, const char* unit) {
  return *unit == '\0' ? std::string(doc) : fmt::format("{} [{}]", doc, unit);
}

void add_option(pugi::xml_node type, const ig_option_decl& option) {
  pugi::xml_node attribute = add(type, "xs:attribute", option.name);
  // An inherited element may get it from a Configure, so a schema cannot demand it.
  std::string doc = with_unit(option.doc, option.unit);
  if (option.fallback == nullptr) doc += doc.empty() ? "Required." : " Required.";
  if (option.fallback != nullptr) set_attribute(attribute, "default", option.fallback);
  switch (option.type) {
    case IG_OPTION_BOOLEAN: set_attribute(attribute, "type", "dialect.Boolean"); return document(attribute, doc);
    case IG_OPTION_CHOICE: {
      document(attribute, doc);
      pugi::xml_node restriction = restrict_to(attribute, "xs:string");
      std::istringstream choices(option.choices);
      for (std::string choice; std::getline(choices, choice, '|');)
        set_attribute(add(restriction, "xs:enumeration"), "value", choice);
      return;
    }
    case IG_OPTION_NUMBER:
      document(attribute, doc);
      return add_range(restrict_to(attribute, "xs:decimal"), option.minimum, option.maximum);
    case IG_OPTION_INTEGER: {
      document(attribute, doc);
      pugi::xml_node restriction = restrict_to(attribute, "xs:integer");
      set_attribute(add(restriction, "xs:pattern"), "value", "-?[0-9]+");
      return add_range(restriction, option.minimum, option.maximum);
    }
    case IG_OPTION_FIELDS:
      set_attribute(attribute, "type", "xs:string");
      return document(attribute, doc + " Field patterns, separated by blanks.");
    default: set_attribute(attribute, "type", "xs:string"); return document(attribute, doc);
  }
}

void add_attribute_group(pugi::xml_node type, const char* group) {
  set_attribute(add(type, "xs:attributeGroup"), "ref", group);
}

void add_syntax_type(pugi::xml_node schema, const ig_syntax& syntax, const ig_plugin& plugin) {
  pugi::xml_node type = add(schema, "xs:complexType", fmt::format("syntax.{}", syntax.id).c_str());
  document(type, fmt::format("{} (plugin {})", syntax.summary, plugin.name));
  add_attribute_group(type, "dialect.Instance");
  add_attribute_group(type, "dialect.Slot");
  for (std::uint32_t i = 0; i < syntax.option_count; ++i) add_option(type, syntax.options[i]);
}

void add_row(pugi::xml_node type, const ig_dependency& dependency) {
  pugi::xml_node row = add(add(type, "xs:sequence"), "xs:element", dependency.row_element);
  set_attribute(row, "minOccurs", "0");
  set_attribute(row, "maxOccurs", "unbounded");
  pugi::xml_node row_type = add(row, "xs:complexType");
  pugi::xml_node key = add(row_type, "xs:attribute", dependency.row_key);
  set_attribute(key, "type", "dialect.Text");
  set_attribute(key, "use", "required");
  for (std::uint32_t i = 0; i < dependency.column_count; ++i) {
    const ig_column_decl& column = dependency.columns[i];
    pugi::xml_node attribute = add(row_type, "xs:attribute", column.name);
    document(attribute, with_unit(column.doc, column.unit));
    if (column.is_text != 0) {
      set_attribute(attribute, "type", "xs:string");
    } else {
      add_range(restrict_to(attribute, "xs:decimal"), column.minimum, column.maximum);
    }
  }
}

/// Options of the importers that read the table's src. Importers may have one of a name with different values, so that
/// a run checks them.
void add_importer_options(pugi::xml_node type, const ig_dependency& dependency, const Library& library) {
  std::map<std::string, std::string> importers;  // by option
  for (const LoadedPlugin& loaded : library.plugins())
    for (const ig_importer* importer : std::span(loaded.plugin->importers, loaded.plugin->importer_count)) {
      bool fills = false;
      for (const char* const* id = importer->dependencies; id != nullptr && *id != nullptr; ++id)
        fills = fills || std::string_view(*id) == dependency.id;
      for (std::uint32_t i = 0; fills && i < importer->option_count; ++i) {
        std::string& names = importers[importer->options[i].name];
        (names += names.empty() ? "" : ", ") += importer->id;
      }
    }
  const std::span<const ig_option_decl> own(dependency.options, dependency.option_count);
  for (const auto& option : importers) {
    if (std::any_of(own.begin(), own.end(), [&](const ig_option_decl& o) { return option.first == o.name; })) continue;
    pugi::xml_node attribute = add(type, "xs:attribute", option.first.c_str());
    set_attribute(attribute, "type", "xs:string");
    document(attribute, "Option of the importer that reads src: " + option.second + ".");
  }
}

void add_dependency_type(pugi::xml_node schema, const ig_dependency& dependency, const ig_plugin& plugin,
                         const Library& library) {
  pugi::xml_node type = add(schema, "xs:complexType", fmt::format("dependency.{}", dependency.id).c_str());
  document(type, fmt::format("{} (plugin {})", dependency.summary, plugin.name));
  if (dependency.row_element != nullptr) add_row(type, dependency);
  add_attribute_group(type, "dialect.Instance");
  add_attribute_group(type, "dialect.Table");
  for (std::uint32_t i = 0; i < dependency.option_count; ++i) add_option(type, dependency.options[i]);
  add_importer_options(type, dependency, library);
}

template <class Part>
using Owned = std::pair<const Part*, const ig_plugin*>;

template <class Part>
void sort_by_id(std::vector<Owned<Part>>& parts) {
  std::sort(parts.begin(), parts.end(),
            [](const auto& a, const auto& b) { return std::string_view(a.first->id) < b.first->id; });
}

void add_parts(pugi::xml_node schema, const Library& library) {
  std::vector<Owned<ig_syntax>> syntaxes;
  std::vector<Owned<ig_dependency>> dependencies;
  for (const LoadedPlugin& loaded : library.plugins()) {
    const ig_plugin& plugin = *loaded.plugin;
    for (std::uint32_t i = 0; i < plugin.syntax_count; ++i) syntaxes.emplace_back(plugin.syntaxes[i], &plugin);
    for (std::uint32_t i = 0; i < plugin.dependency_count; ++i)
      dependencies.emplace_back(plugin.dependencies[i], &plugin);
  }
  sort_by_id(syntaxes);
  sort_by_id(dependencies);

  pugi::xml_node syntax_choice = add(add(schema, "xs:group", "dialect.Syntax"), "xs:choice");
  for (const auto& [syntax, plugin] : syntaxes)
    set_attribute(add(syntax_choice, "xs:element", syntax->id), "type", fmt::format("syntax.{}", syntax->id));
  pugi::xml_node dependency_choice = add(add(schema, "xs:group", "dialect.Dependency"), "xs:choice");
  for (const auto& [dependency, plugin] : dependencies)
    set_attribute(dependency_choice.append_child("xs:element"), "ref", dependency->id);

  for (const auto& [syntax, plugin] : syntaxes) add_syntax_type(schema, *syntax, *plugin);
  for (const auto& [dependency, plugin] : dependencies) {
    // Global elements: a table file in this namespace can be validated on its own.
    set_attribute(add(schema, "xs:element", dependency->id), "type", fmt::format("dependency.{}", dependency->id));
    add_dependency_type(schema, *dependency, *plugin, library);
  }
}

}  // namespace

std::string dialect_schema(const Library& library) {
  pugi::xml_document document;
  document.load_string(schema_frame);
  document.prepend_child(pugi::node_comment).set_value(" Generated by `isogloss schema dialect`. ");
  add_parts(document.document_element(), library);
  std::ostringstream out;
  document.save(out, "  ", pugi::format_indent, pugi::encoding_utf8);
  return out.str();
}

}  // namespace isogloss
