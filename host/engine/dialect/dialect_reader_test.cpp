#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <random>

#include "isogloss/engine/dialect.hpp"

using namespace isogloss;
using namespace std::string_literals;
namespace fs = std::filesystem;

namespace {

constexpr const char* xmlns = "xmlns=\"urn:isogloss:dialect:1\"";

/// A folder of dialect files that goes when the test ends.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "isogloss-dialects-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  void file(const std::string& name, const std::string& text) const {
    fs::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
  }
  /// A dialect file of this content.
  void dialect(const std::string& name, const std::string& content, const std::string& attributes = "") const {
    file(name + ".xml", "<Dialect " + std::string(xmlns) + " name=\"" + name + "\" " + attributes + ">\n" + content +
                            "\n</Dialect>\n");
  }
  std::optional<Dialect> read(const std::string& name, DiagnosticSink& sink) const {
    return DialectReader({path_}).read(name, sink);
  }
  Dialect read(const std::string& name) const {
    DiagnosticList found;
    std::optional<Dialect> dialect = read(name, found);
    for (const Diagnostic& d : found.all) UNSCOPED_INFO(d.where.line << ": " << d.message);
    REQUIRE(dialect);
    CHECK(found.all.empty());
    return *dialect;
  }
  /// "code line:column" of each diagnostic; the dialect must be refused.
  std::vector<std::string> faults(const std::string& name) const {
    DiagnosticList found;
    CHECK_FALSE(read(name, found));
    std::vector<std::string> all;
    for (const Diagnostic& d : found.all)
      all.push_back(d.code + " " + std::to_string(d.where.line) + ":" + std::to_string(d.where.column));
    return all;
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

std::vector<std::string> chain_of(const Dialect& dialect) {
  std::vector<std::string> all;
  for (const ChainElement& e : dialect.chain) {
    std::string line = std::string(to_string(e.stage)) + " " + e.syntax;
    if (e.alias != e.syntax) line += " as " + e.alias;
    if (e.override_slot) line += " override";
    for (const Attribute& a : e.options) line += " " + a.name + "=" + a.value;
    all.push_back(line);
  }
  return all;
}

std::vector<std::string> dependencies_of(const Dialect& dialect) {
  std::vector<std::string> all;
  for (const DependencyElement& e : dialect.dependencies) {
    std::string line = e.id;
    if (e.alias != e.id) line += " as " + e.alias;
    for (const Attribute& a : e.options) line += " " + a.name + "=" + a.value;
    for (const TableRow& row : e.rows) {
      line += " [" + row.element;
      for (const Attribute& a : row.attributes) line += " " + a.name + "=" + a.value;
      line += "]";
    }
    all.push_back(line);
  }
  return all;
}

/// All that a dialect means, without places: two dialects with the same image are the same.
std::vector<std::string> image(const Dialect& d) {
  std::vector<std::string> all = chain_of(d);
  const auto add = [&](const std::vector<std::string>& more) { all.insert(all.end(), more.begin(), more.end()); };
  add(dependencies_of(d));
  add(d.extensions);
  for (const std::vector<Signature>* const signs : {&d.signatures, &d.names})
    for (const Signature& s : *signs) all.push_back(s.pattern + " " + std::to_string(s.weight));
  add({d.name, d.title, d.segmenter.type, d.segmenter.continuation, d.segmenter.comment});
  for (const PluginReference& p : d.plugins) all.push_back(p.name);
  for (const InitialField& f : d.initial) all.push_back(f.path + "=" + f.value);
  for (const auto& [code, given] : d.severities) all.push_back(code + " " + std::string(to_string(given.severity)));
  return all;
}

using Strings = std::vector<std::string>;

const char* const root_content =
    R"(<Files extensions=".nc .tap"><Signature pattern="%*" weight="2"/><Name pattern="*base*"/></Files>
<Segmenter type="line" continuation="~" comment=";"/>
<Plugins><Plugin name="one"/></Plugins>
<Dependencies>
  <Offsets><Row id="a" X="1"/></Offsets>
  <Tools kind="mill"/>
</Dependencies>
<Initial><Field path="Unit.Term" value="mm"/><Field path="Plane.Term" value="XY"/></Initial>
<Severities><Severity code="ONE-1" is="note"/></Severities>
<Chain>
  <Parsing><Words/></Parsing>
  <Logic><First a="1" b="2"/><Second/><Second as="again" override="true"/></Logic>
  <Inspection><Check/></Inspection>
</Chain>)";

}  // namespace

TEST_CASE("a root dialect is read whole") {
  const Folder folder;
  folder.dialect("base", root_content, "title=\"The base\"");
  const Dialect d = folder.read("base");
  CHECK(d.name == "base");
  CHECK(d.title == "The base");
  CHECK(d.file == folder.path() / "base.xml");
  CHECK(d.extensions == Strings{".nc", ".tap"});
  CHECK(d.signatures == std::vector<Signature>{{"%*", 2}});
  CHECK(d.names == std::vector<Signature>{{"*base*", 4}});
  CHECK(d.plugins.at(0).name == "one");
  CHECK(dependencies_of(d) == Strings{"Offsets [Row id=a X=1]", "Tools kind=mill"});
  CHECK(d.initial.at(1).value == "XY");
  CHECK(d.severities.at("ONE-1").severity == Severity::note);
  CHECK(chain_of(d) == Strings{"Parsing Words", "Logic First a=1 b=2", "Logic Second", "Logic Second as again override",
                               "Inspection Check"});
  // Elements stand at their '<', attributes at their name.
  CHECK(d.chain[1].where.line == 13);
  CHECK(d.chain[1].where.column == 10);
  CHECK(d.chain[1].options[1].where.column == 23);
  CHECK(d.dependencies[0].rows[0].attributes[1].where.column == 24);
}

TEST_CASE("a derived dialect adds, replaces and edits") {
  const Folder folder;
  folder.dialect("base", root_content, "title=\"The base\"");
  folder.dialect("derived", R"(<Plugins><Plugin name="two"/><Plugin name="one"/></Plugins>
<Dependencies><Mine/><Tools kind="lathe"/><Replace dependency="Offsets"><Other as="Offsets"/></Replace></Dependencies>
<Initial><Field path="Unit.Term" value="inch"/><Field path="New.Term" value="1"/></Initial>
<Severities><Severity code="ONE-1" is="error"/></Severities>
<Chain>
  <Replace syntax="First"><FirstA/><FirstB/></Replace>
  <InsertBefore syntax="again"><Before x="1"/></InsertBefore>
  <InsertAfter syntax="Before"><After/><AfterThat/></InsertAfter>
  <Remove syntax="Second"/>
  <InsertAfter syntax="Check"><Second/></InsertAfter>
  <Configure syntax="again" p="1"/>
  <Configure syntax="again" p="2" q="3"/>
</Chain>)",
                 "extends=\"base\"");
  const Dialect d = folder.read("derived");
  CHECK(d.name == "derived");
  CHECK(d.title == "The base");
  CHECK(d.ancestors == Strings{"base"});
  CHECK(d.extensions == Strings{".nc", ".tap"});
  CHECK(d.signatures == std::vector<Signature>{{"%*", 2}});
  REQUIRE(d.plugins.size() == 2);
  CHECK(d.plugins[0].name == "one");
  CHECK(d.plugins[1].name == "two");
  CHECK(dependencies_of(d) == Strings{"Mine", "Tools kind=lathe", "Other as Offsets"});
  REQUIRE(d.initial.size() == 3);
  CHECK(d.initial[0].value == "inch");
  CHECK(d.initial[0].where.file == (folder.path() / "derived.xml").string());
  CHECK(d.severities.at("ONE-1").severity == Severity::error);
  CHECK(chain_of(d) == Strings{"Parsing Words", "Logic FirstA", "Logic FirstB", "Logic Before x=1", "Logic After",
                               "Logic AfterThat", "Logic Second as again override p=2 q=3", "Inspection Check",
                               "Inspection Second"});
}

TEST_CASE("dependencies are removed and configured by name; files of one's own replace inherited ones") {
  const Folder folder;
  folder.dialect("base", root_content);
  folder.dialect("derived", R"(<Files extensions=".h"/><Dependencies>
<Configure dependency="Tools" kind="drill" more="1"/><Remove dependency="Offsets"/></Dependencies>)",
                 "extends=\"base\"");
  folder.dialect("third", R"(<Dependencies><Tools/></Dependencies>)", "extends=\"derived\"");
  const Dialect d = folder.read("derived");
  CHECK(dependencies_of(d) == Strings{"Tools kind=drill more=1"});
  CHECK(d.extensions == Strings{".h"});
  CHECK(d.signatures.empty());
  CHECK(folder.read("third").ancestors == Strings{"derived", "base"});
  CHECK(dependencies_of(folder.read("third")) == Strings{"Tools"});
}

TEST_CASE("src names a table beside the file") {
  const Folder folder;
  folder.file("tables/tools.xml", "<Tools unit=\"mm\" kind=\"lathe\">\n  <Tool id=\"1\"/>\n</Tools>\n");
  folder.dialect("base",
                 R"(<Dependencies><Tools src="tables/tools.xml" kind="mill"><Tool id="2"/></Tools></Dependencies>)");
  const Dialect d = folder.read("base");
  CHECK(dependencies_of(d) == Strings{"Tools unit=mm kind=mill [Tool id=1] [Tool id=2]"});
  CHECK(d.dependencies[0].source_file == (folder.path() / "tables/tools.xml").string());
  CHECK(d.dependencies[0].rows[0].where.line == 2);
  CHECK(d.dependencies[0].rows[0].attributes[0].where.column == 9);
}

TEST_CASE("a dialect is found by name, by path, and beside the file that extends it") {
  const Folder folder, own;
  folder.dialect("shared", "");
  own.dialect("mine", "", "extends=\"shared\"");
  own.dialect("near", "", "extends=\"mine.xml\"");
  own.dialect("nearer", "", "extends=\"near\"");
  DiagnosticList found;
  const DialectReader reader({folder.path()});
  CHECK(reader.read("shared", found));
  CHECK(reader.read((own.path() / "nearer.xml").string(), found)->ancestors == Strings{"near", "mine", "shared"});
  CHECK(found.all.empty());
  const auto list = DialectReader({own.path(), folder.path()}).list();
  REQUIRE(list.size() == 4);
  CHECK(list[3].name == "shared");
}

TEST_CASE("what a dialect file says wrongly is told with code and place") {
  const Folder folder;
  folder.dialect("base", root_content);
  folder.file("tools.xml", "<Tools/>");
  folder.file("broken.xml", "<Tools>");
  struct Row {
    const char* attributes;
    const char* content;
    Strings faults;
  };
  const std::vector<Row> rows{
      {"", "<Chian/>", {"IG-0107 2:1"}},
      {"", "<Chain><Logics/></Chain>", {"IG-0107 2:8"}},
      {"", "<Chain><Logic><A><B/></A></Logic></Chain>", {"IG-0107 2:18"}},
      {"", "<Plugins><Plugin name=\"a\" nam=\"b\"/></Plugins>", {"IG-0108 2:27"}},
      {"colour=\"red\"", "", {"IG-0108 1:54"}},
      {"", "<Plugins x=\"1\"/>", {"IG-0108 2:10"}},
      {"", "<Plugins><Plugin/></Plugins>", {"IG-0109 2:10"}},
      {"", "<Initial><Field path=\"A.B\"/></Initial>", {"IG-0109 2:10"}},
      {"", "<Severities><Severity code=\"A-1\" is=\"fatal\"/></Severities>", {"IG-0110 2:34"}},
      {"", "<Segmenter type=\"lines\"/>", {"IG-0110 2:12"}},
      {"", "<Segmenter type=\"line\" continuation=\"\"/>", {"IG-0110 2:24"}},
      {"", "<Segmenter type=\"line\" continuation=\"a b\"/>", {"IG-0110 2:24"}},
      {"", "<Segmenter type=\"line\" comment=\";\"/>", {"IG-0110 2:24"}},
      {"", "<Files extensions=\"nc\"/>", {"IG-0110 2:8"}},
      {"", "<Files><Signature pattern=\"*\"/></Files>", {"IG-0110 2:19"}},
      {"", "<Files><Signature pattern=\"%\" weight=\"0\"/></Files>", {"IG-0110 2:31"}},
      {"", "<Files><Signature pattern=\"%\" weight=\"many\"/></Files>", {"IG-0110 2:31"}},
      {"", "<Plugins><Plugin name=\"../a\"/></Plugins>", {"IG-0110 2:18"}},
      {"", "<Chain><Logic><A override=\"yes\"/></Logic></Chain>", {"IG-0110 2:18"}},
      {"", "<Chain><Logic><A as=\"\"/></Logic></Chain>", {"IG-0110 2:18"}},
      {"", "<Initial><Field path=\"A.B\" value=\"1\"/><Field path=\"A.B\" value=\"2\"/></Initial>", {"IG-0113 2:46"}},
      {"", "<Chain><Logic><A/>\n<B as=\"A\"/></Logic></Chain>", {"IG-0113 3:1"}},
      {"", "<Dependencies><T/>\n <T/></Dependencies>", {"IG-0113 3:2"}},
      {"", "<Chain/>\n<Chain/>", {"IG-0114 3:1"}},
      {"", "<Chain><Logic/>\n<Logic/></Chain>", {"IG-0114 3:1"}},
      {"", "<Chain><Logic/>\n<Parsing/></Chain>", {"IG-0115 3:1"}},
      {"", "<Chain><Remove syntax=\"A\"/></Chain>", {"IG-0116 2:8"}},
      {"extends=\"base\"", "<Chain><Logic/></Chain>", {"IG-0116 2:8"}},
      {"", "<Dependencies><Tools src=\"/etc/passwd\"/></Dependencies>", {"IG-0117 2:22"}},
      {"", "<Dependencies><Tools src=\"a/../../x.xml\"/></Dependencies>", {"IG-0117 2:22"}},
      {"", "<Dependencies><Tools src=\"none.xml\"/></Dependencies>", {"IG-0102 2:22"}},
      {"", "<Dependencies><Tools src=\".\"/></Dependencies>", {"IG-0102 2:22"}},
      {"", "<Dependencies><Offsets src=\"tools.xml\"/></Dependencies>", {"IG-0118 1:1"}},
      {"", "<Dependencies><Tools src=\"broken.xml\"/></Dependencies>", {"IG-0103 1:7"}},
      {"", "<Chain>Words</Chain>", {"IG-0119 2:8"}},
      {"extends=\"nowhere\"", "", {"IG-0101 1:54"}},
      {"extends=\"../nowhere.xml\"", "", {"IG-0117 1:54"}},
      {"extends=\"base\"", "<Chain><Replace syntax=\"First\"/></Chain>", {"IG-0120 2:8"}},
      {"extends=\"base\"", "<Chain><Remove syntax=\"Frist\"/></Chain>", {"IG-0112 2:16"}},
      {"extends=\"base\"", "<Chain><Remove/></Chain>", {"IG-0109 2:8"}},
      {"extends=\"base\"", "<Chain><InsertAfter syntax=\"First\"><Second/></InsertAfter></Chain>", {"IG-0113 2:36"}},
      {"extends=\"base\"", "<Chain><Configure syntax=\"First\" as=\"x\"/></Chain>", {"IG-0108 2:34"}},
      {"extends=\"base\"", "<Dependencies><Remove dependency=\"Offset\"/></Dependencies>", {"IG-0112 2:23"}},
      {"extends=\"base\"", "<Dependencies><InsertAfter dependency=\"Tools\"/></Dependencies>", {"IG-0107 2:15"}},
      {"", "<Chian/>\n<Plugins><Plugin/></Plugins>", {"IG-0107 2:1", "IG-0109 3:10"}}};
  for (const Row& row : rows) {
    CAPTURE(row.attributes, row.content);
    folder.dialect("wrong", row.content, row.attributes);
    CHECK(folder.faults("wrong") == row.faults);
  }
}

TEST_CASE("a misspelt name is answered with the nearest one") {
  const Folder folder;
  folder.dialect("base", root_content);
  folder.dialect("wrong", "<Chain><Remove syntax=\"Frist\"/></Chain>", "extends=\"base\"");
  DiagnosticList found;
  CHECK_FALSE(folder.read("wrong", found));
  CHECK_FALSE(folder.read("bass", found));
  REQUIRE(found.all.size() == 2);
  CHECK(found.all[0].hint == "did you mean First?");
  CHECK(found.all[1].hint == "did you mean base?");
  CHECK(found.all[1].code == "IG-0101");
  CHECK(found.all[1].message.find(folder.path().string()) != std::string::npos);
}

TEST_CASE("a loop of extends is told, not followed") {
  const Folder folder;
  folder.dialect("a", "", "extends=\"b\"");
  folder.dialect("b", "", "extends=\"c\"");
  folder.dialect("c", "", "extends=\"b.xml\"");
  DiagnosticList found;
  CHECK_FALSE(folder.read("a", found));
  REQUIRE(found.all.size() == 1);
  CHECK(found.all[0].code == "IG-0111");
  CHECK(found.all[0].message == "the dialect extends itself: b → c → b");
  CHECK(found.all[0].where.file == (folder.path() / "c.xml").string());
  for (int i = 0; i < 20; ++i)
    folder.dialect("deep" + std::to_string(i), "", "extends=\"deep" + std::to_string(i + 1) + "\"");
  folder.dialect("deep20", "");
  CHECK(folder.faults("deep0") == Strings{"IG-0105 1:55"});
  CHECK(folder.read("deep10").ancestors.size() == 10);
}

TEST_CASE("malformed files are told with the place of the fault") {
  const Folder folder;
  const std::string head = "<Dialect " + std::string(xmlns) + " name=\"x\">";
  const std::vector<std::pair<std::string, std::string>> rows{
      {"", "IG-0103 1:1"},
      {"no XML", "IG-0103 1:1"},
      {"<Dialect", "IG-0103 1:8"},
      {"<Table/>", "IG-0106 1:1"},
      {"<Dialect name=\"x\"/>", "IG-0106 1:1"},
      {"\n <Dialect xmlns=\"urn:other\" name=\"x\"/>", "IG-0106 2:2"},
      {head + "\r\n<Chain>\r\n</Chian></Dialect>", "IG-0103 3:3"},
      {head + "</Dialect><Dialect/>", "IG-0103 1:60"},
      {head + "</Dialect>tail", "IG-0103 1:60"},
      {"<!DOCTYPE x [<!ENTITY a \"aaaa\">]>" + head + "</Dialect>", "IG-0103 1:1"},
      {head + "<Plugins><Plugin name=\"&bomb;\"/></Plugins></Dialect>", "IG-0103 1:73"},
      {head + "<Plugins><Plugin name=\"&#0;\"/></Plugins></Dialect>", "IG-0103 1:73"},
      {head + "<Plugins><Plugin name=\"a\" name=\"b\"/></Plugins></Dialect>", "IG-0103 1:76"},
      {head + "<Plugins><Plugin name=\"a<b\"/></Plugins></Dialect>", "IG-0103 1:74"},
      {head + "\x01</Dialect>", "IG-0103 1:50"},
      {head + "\xe4</Dialect>", "IG-0104 1:50"},
      {"\xff\xfe<\0D\0", "IG-0104 1:1"},
      {"<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>" + head + "</Dialect>", "IG-0104 1:21"},
  };
  for (const auto& [text, fault] : rows) {
    CAPTURE(text);
    folder.file("x.xml", text);
    CHECK(folder.faults("x") == Strings{fault});
  }
  std::string deep = head;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  for (int i = 0; i < 100000; ++i) deep += "</a>";
  folder.file("x.xml", deep + "</Dialect>");
  CHECK(folder.faults("x") == Strings{"IG-0105 1:239"});
  folder.file("x.xml", head + std::string(std::size_t{17} << 20, ' ') + "</Dialect>");
  CHECK(folder.faults("x") == Strings{"IG-0105 0:0"});
}

TEST_CASE("a byte order mark and any line ending keep places right") {
  const Folder folder;
  for (const std::string eol : {"\n", "\r\n", "\r"}) {
    folder.file("x.xml", "\xef\xbb\xbf<?xml version=\"1.0\" encoding=\"utf-8\"?>" + eol + "<!-- über -->" + eol +
                             "<Dialect " + xmlns + eol + "  name=\"x\">" + eol + "<Chain><Logic>" + eol + "<A" + eol +
                             "  note=\"a > b\"" + eol + "\tb = '2'/></Logic></Chain></Dialect>");
    const Dialect d = folder.read("x");
    CHECK(d.chain.at(0).where.line == 6);
    CHECK(d.chain[0].options.at(0).where.line == 7);
    CHECK(d.chain[0].options[0].where.column == 3);
    CHECK(d.chain[0].options.at(1).where.line == 8);
    CHECK(d.chain[0].options[1].where.column == 2);
    CHECK(d.chain[0].options[0].value == "a > b");
  }
}

TEST_CASE("table files are read on their own") {
  const Folder folder;
  folder.file("one.xml", "<Tools a=\"1\"><Tool id=\"1\" H=\"50\"/></Tools>");
  folder.file("two.xml", "<Dependencies><Tools src=\"one.xml\"/><Offsets/></Dependencies>");
  folder.file("bad.xml", "<Tools><Tool><X/></Tool></Tools>");
  const DialectReader reader({});
  DiagnosticList found;
  const auto one = reader.read_dependencies(folder.path() / "one.xml", found);
  REQUIRE(one.size() == 1);
  CHECK(one[0].id == "Tools");
  CHECK(one[0].rows.at(0).attributes.at(1).value == "50");
  CHECK(reader.read_dependencies(folder.path() / "two.xml", found).size() == 2);
  CHECK(found.all.empty());
  CHECK(reader.read_dependencies(folder.path() / "bad.xml", found).empty());
  CHECK(reader.read_dependencies(folder.path() / "none.xml", found).empty());
  REQUIRE(found.all.size() == 2);
  CHECK(found.all[0].code == "IG-0107");
  CHECK(found.all[1].code == "IG-0102");
}

namespace {

void check_round_trip(const Dialect& dialect, const fs::path& base) {
  CAPTURE(dialect.name);
  for (const bool inline_tables : {false, true}) {
    const WrittenDialect written = write_dialect(dialect, base, inline_tables);
    CHECK(written.side_files.empty() ==
          (inline_tables || std::all_of(dialect.dependencies.begin(), dialect.dependencies.end(),
                                        [](const auto& d) { return d.source_file.empty(); })));
    const Folder copy;
    copy.file("copy.xml", written.xml);
    for (const auto& [name, text] : written.side_files) copy.file(name, text);
    const Dialect again = copy.read("copy");
    CHECK(image(again) == image(dialect));
    CHECK(write_dialect(again, copy.path(), inline_tables).xml == written.xml);
    CHECK(write_dialect(again, copy.path(), inline_tables).side_files == written.side_files);
  }
}

}  // namespace

TEST_CASE("load, save, load gives the same dialect") {
  const Folder folder;
  folder.dialect("base", root_content, "title=\"Base &lt;&quot;&amp;'&gt; &#10; über\"");
  folder.file("tools.xml", "<Tools k=\"v\"><Tool id=\"1\"/></Tools>");
  folder.file("sub/tools.xml", "<More><Tool id=\"2\"/></More>");
  folder.file("sub/middle.xml", "<Dialect " + std::string(xmlns) + R"( name="middle" extends="base">
<Dependencies><More src="tools.xml"/></Dependencies></Dialect>)");
  folder.dialect("derived", R"(<Dependencies><Tools src="tools.xml" as="mine"/></Dependencies>
<Chain><Configure syntax="again" text="a&lt;b&quot;c"/><Remove syntax="Check"/></Chain>)",
                 "extends=\"sub/middle.xml\"");
  check_round_trip(folder.read("base"), folder.path());
  check_round_trip(folder.read("derived"), folder.path());
  check_round_trip(folder.read("derived"), folder.path() / "elsewhere");
  CHECK(write_dialect(folder.read("derived"), folder.path(), false).side_files.count("sub/tools.xml") == 1);
  CHECK(write_dialect(folder.read("derived"), "/nowhere", false).side_files.count("More.tools.xml") == 1);
}

TEST_CASE("load, save, load gives the same dialect for those that ship") {
  const fs::path folder = ISOGLOSS_SOURCE_DIR "/dialects";
  const DialectReader reader({folder});
  const auto list = reader.list();
  REQUIRE_FALSE(list.empty());
  for (const Dialect& head : list) {
    DiagnosticList found;
    const auto dialect = reader.read(head.name, found);
    REQUIRE(dialect);
    CHECK(dialect->name == head.name);
    check_round_trip(*dialect, folder);
  }
}

TEST_CASE("no bytes crash the reader") {
  const Folder folder;
  folder.dialect("base", root_content);
  folder.dialect("derived", "<Chain><Replace syntax=\"First\"><A as=\"x\"/></Replace></Chain>", "extends=\"base\"");
  std::ifstream in(folder.path() / "derived.xml", std::ios::binary);
  const std::string good((std::istreambuf_iterator<char>(in)), {});
  const std::string bytes = "<>/\"'=& \n\0\xff!-?[]Ax;#"s;
  std::mt19937 random(7);
  int refused = 0;
  for (int i = 0; i < 1000; ++i) {
    std::string text = good;
    for (unsigned changes = 1 + random() % 4; changes > 0; --changes) {
      const std::size_t at = random() % text.size();
      if (random() % 3 == 0) {
        text.erase(at, 1 + random() % 9);
      } else if (random() % 2 == 0) {
        text.insert(at, 1, bytes[random() % bytes.size()]);
      } else {
        text[at] = bytes[random() % bytes.size()];
      }
    }
    folder.file("wild.xml", text);
    DiagnosticList found;
    const bool read = folder.read("wild", found).has_value();
    CHECK(read == found.all.empty());
    refused += read ? 0 : 1;
  }
  CHECK(refused > 300);
}
