// The part of the XML Schema of dialect files that does not depend on plugins.
#include "dialect/schema_parts.hpp"

namespace isogloss {
namespace {

// The types that it refers to and does not hold follow from the plugins.
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
  <xs:element name="Dependencies">
    <xs:annotation><xs:documentation>Named parts that answer questions. The nearest provider of a service wins: one's own before inherited ones, in written order.</xs:documentation></xs:annotation>
    <xs:complexType>
      <xs:choice minOccurs="0" maxOccurs="unbounded">
        <xs:group ref="dialect.Dependency"/>
        <xs:element name="Replace"><xs:complexType>
          <xs:group ref="dialect.Dependency" maxOccurs="unbounded"/>
          <xs:attribute name="dependency" type="dialect.DependencyName" use="required"/>
        </xs:complexType></xs:element>
        <xs:element name="Remove"><xs:complexType>
          <xs:attribute name="dependency" type="dialect.DependencyName" use="required"/>
        </xs:complexType></xs:element>
        <xs:element name="Configure" type="dialect.ConfigureDependency"/>
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
        <xs:attribute name="name" type="dialect.PluginName" use="required"/>
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
        <xs:attribute name="code" use="required"><xs:simpleType><xs:restriction base="xs:string"><xs:pattern value="[A-Z]+-[0-9]+"/></xs:restriction></xs:simpleType></xs:attribute>
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
        <xs:element name="Remove"><xs:complexType><xs:attribute name="syntax" type="dialect.SyntaxName" use="required"/></xs:complexType></xs:element>
        <xs:element name="Configure" type="dialect.ConfigureSyntax"/>
      </xs:choice>
    </xs:choice>
  </xs:complexType>
  <xs:complexType name="dialect.PutIn">
    <xs:group ref="dialect.Syntax" maxOccurs="unbounded"/>
    <xs:attribute name="syntax" type="dialect.SyntaxName" use="required"/>
  </xs:complexType>
  <xs:complexType name="dialect.Syntaxes">
    <xs:group ref="dialect.Syntax" minOccurs="0" maxOccurs="unbounded"/>
  </xs:complexType>
  <xs:attributeGroup name="dialect.Instance">
    <xs:attribute name="as" type="dialect.Alias"><xs:annotation><xs:documentation>The name that edits and explanations use, when the element stands more than once. It begins with a small letter: this schema takes a capital for a misspelt syntax or dependency.</xs:documentation></xs:annotation></xs:attribute>
  </xs:attributeGroup>
  <xs:attributeGroup name="dialect.Slot">
    <xs:attribute name="override" type="dialect.Boolean"><xs:annotation><xs:documentation>true: may claim an exclusive slot that another syntax holds, or take a code that another one takes.</xs:documentation></xs:annotation></xs:attribute>
  </xs:attributeGroup>
  <xs:attributeGroup name="dialect.Table">
    <xs:attribute name="src" type="dialect.Text"><xs:annotation><xs:documentation>A file beside or below this one with the rows: XML whose root element has this element's name, or a file of a control that an importer reads.</xs:documentation></xs:annotation></xs:attribute>
  </xs:attributeGroup>
  <xs:simpleType name="dialect.Text"><xs:restriction base="xs:string"><xs:minLength value="1"/></xs:restriction></xs:simpleType>
  <xs:simpleType name="dialect.Alias"><xs:restriction base="xs:string"><xs:pattern value="[^A-Z\s]\S*"/></xs:restriction></xs:simpleType>
  <xs:simpleType name="dialect.Boolean"><xs:restriction base="xs:string"><xs:enumeration value="true"/><xs:enumeration value="false"/></xs:restriction></xs:simpleType>
</xs:schema>)";

}  // namespace

const char* dialect_schema_frame() { return schema_frame; }

}  // namespace isogloss
