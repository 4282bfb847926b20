#include "isogloss/engine/import.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "import/control_text.hpp"
#include "isogloss/engine/machine.hpp"
#include "test_plugin.hpp"

using namespace isogloss;
using isogloss::test::Plugin;

namespace {

ig_text text(const char* s) { return {s, std::char_traits<char>::length(s)}; }

/// A dependency with a table, and the importers that the tests need.
struct Shop {
  Plugin plugin{"shop"};
  Library library{{}};
  DiagnosticList found;

  Shop() {
    test::Dependency& tools = plugin.dependency("Tools");
    tools.columns = {test::column("H")};
    tools.out.row_element = "Tool";
    tools.out.row_key = "id";
    plugin.dependency("Settings");
    plugin.diagnostics = {{sizeof(ig_diagnostic_decl), IG_WARNING, "AB-0001", "odd {0}", "", ""},
                          {sizeof(ig_diagnostic_decl), IG_ERROR, "AB-0002", "useless", "", ""}};
  }
  test::Importer& importer(const char* id, ig_status (*reads)(const ig_import_api*, ig_import*)) {
    test::Importer& out = plugin.importer(id);
    out.dependencies = {"Tools"};
    out.out.read = reads;
    return out;
  }
  std::optional<ImportedFile> read(const char* format, const char* bytes) {
    library.add(plugin.get());
    found.all.clear();
    return import_bytes({"dir/a.txt", format, options, {"machine.xml", 3, 5}}, bytes, library, found);
  }
  std::vector<std::string> codes() const {
    std::vector<std::string> out;
    for (const Diagnostic& d : found.all)
      out.push_back(d.code + " " + std::to_string(d.where.line) + ":" + std::to_string(d.where.column));
    return out;
  }
  std::vector<Attribute> options;
};

using Codes = std::vector<std::string>;

}  // namespace

TEST_CASE("an importer gives rows, cells with their places, and what it does not read") {
  Shop shop;
  shop.importer("Plain", [](const ig_import_api* api, ig_import* in) -> ig_status {
    CHECK(std::string(api->text(in).data, api->text(in).size) == "one\r\ntwo\rthree");
    CHECK(std::string(api->file_name(in).data, api->file_name(in).size) == "a.txt");
    api->row(in, text("Tools"), text("7"), 0);
    api->number_cell(in, text("H"), 0.1, 5);
    api->row(in, text("Tools"), text("8"), 9);
    api->text_cell(in, text("H"), text("5"), 9);
    api->row(in, text("Tools"), text("7"), 12);
    api->number_cell(in, text("H"), 1e21, 12);
    api->option(in, text("Settings"), text("unit"), text("inch"), 2);
    api->unused(in, text("word P"), text("no place"), 10, 11);
    api->unused(in, text("word P"), text("no place"), 2, 3);
    const ig_argument word{1, 0, 0, text("thing")};
    api->report(in, 0, 6, 7, &word, 1);
    return IG_CHANGED;
  });
  const auto file = shop.read("Plain", "one\r\ntwo\rthree");
  REQUIRE(file);
  CHECK(shop.codes() == Codes{"AB-0001 2:2", "IG-0143 2:1"});
  CHECK(shop.found.all[0].message == "odd thing");
  CHECK(shop.found.all[1].message ==
        "row '7' has H=0.1 here and H=1000000000000000000000 in line 3 of the file: the later value is taken (such "
        "values: 1)");
  CHECK(shop.found.all[0].where.file == "dir/a.txt");
  REQUIRE(file->tables.size() == 2);
  REQUIRE(file->tables[0].rows.size() == 2);
  const TableRow& first = file->tables[0].rows[0];
  CHECK(first.element == "Tool");
  REQUIRE(first.attributes.size() == 2);
  CHECK(first.attributes[0].value == "7");
  CHECK(first.attributes[1].value == "1000000000000000000000");
  CHECK((first.attributes[1].where.line == 3 && first.attributes[1].where.column == 4));
  CHECK(file->tables[1].options[0].value == "inch");
  REQUIRE(file->unused.size() == 1);
  CHECK((file->unused[0].count == 2 && file->unused[0].first.line == 3));
}

TEST_CASE("an importer asks for the rows of the machine's own file") {
  Shop shop;
  shop.importer("Plain", [](const ig_import_api* api, ig_import* in) -> ig_status {
    const auto shown = [](ig_text t) { return std::string(t.data == nullptr ? "" : t.data, t.size); };
    CHECK(api->machine_row_count(in, text("Tools")) == 2);
    CHECK(shown(api->machine_row_key(in, text("Tools"), 1)) == "B");
    CHECK(shown(api->machine_cell(in, text("Tools"), 1, text("H"))) == "5");
    CHECK(shown(api->machine_cell(in, text("Tools"), 0, text("H"))).empty());
    CHECK(shown(api->machine_cell(in, text("Tools"), 2, text("H"))).empty());
    CHECK(shown(api->machine_row_key(in, text("Tools"), 2)).empty());
    CHECK(api->machine_row_count(in, text("Settings")) == 0);
    CHECK(shown(api->machine_row_key(in, text("Settings"), 0)).empty());
    return IG_CHANGED;
  });
  shop.library.add(shop.plugin.get());
  const DependencyElement own{
      "Tools", "Tools", {}, {{"Tool", {{"id", "A", {}}}, {}}, {"Tool", {{"id", "B", {}}, {"H", "5", {}}}, {}}}, {}, {}};
  const DependencyElement of_dialect{"Tools", "Tools", {}, {{"Tool", {{"id", "C", {}}}, {}}}, {}, {}};
  Import asked{"dir/a.txt", "Plain", {}, {"machine.xml", 3, 5}};
  asked.machine_tables = {&own, &of_dialect};
  CHECK(import_bytes(asked, "one", shop.library, shop.found));
}

TEST_CASE("places of rows are found in any order, and in no more time") {
  Shop shop;
  shop.importer("Backwards", [](const ig_import_api* api, ig_import* in) -> ig_status {
    for (std::size_t i = 200'000; i-- > 0;) api->report(in, 0, i * 2, i * 2 + 1, nullptr, 0);
    return IG_CHANGED;
  });
  std::string lines;
  for (int i = 0; i < 200'000; ++i) lines += i % 2 == 0 ? "a\n" : "a\r";
  REQUIRE(shop.read("Backwards", lines.c_str()));
  REQUIRE(shop.found.all.size() == 200'000);
  CHECK(shop.codes().front() == "AB-0001 200000:1");
  CHECK(shop.codes().back() == "AB-0001 1:1");
}

TEST_CASE("an importer that breaks the contract is reported, and its file gives nothing") {
  const std::vector<std::pair<const char*, ig_status (*)(const ig_import_api*, ig_import*)>> faults{
      {"not finite",
       [](const ig_import_api* api, ig_import* in) -> ig_status {
         api->row(in, text("Tools"), text("1"), 0);
         api->number_cell(in, text("H"), NAN, 0);
         return IG_CHANGED;
       }},
      {"no plugin has",
       [](const ig_import_api* api, ig_import* in) -> ig_status {
         api->row(in, text("Nowhere"), text("1"), 0);
         return IG_CHANGED;
       }},
      {"has no rows",
       [](const ig_import_api* api, ig_import* in) -> ig_status {
         api->row(in, text("Settings"), text("1"), 0);
         return IG_CHANGED;
       }},
      {"plugin's table",
       [](const ig_import_api* api, ig_import* in) -> ig_status {
         api->report(in, 99, 0, 0, nullptr, 0);
         return IG_CHANGED;
       }},
      {"it gave up", [](const ig_import_api* api, ig_import* in) -> ig_status {
         api->fail(in, text("it gave up"));
         return IG_FAILED;
       }}};
  for (const auto& [words, read] : faults) {
    Shop shop;
    shop.importer("Bad", read);
    CHECK_FALSE(shop.read("Bad", "x"));
    CHECK(shop.codes() == Codes{"IG-0127 3:5"});
    CHECK(shop.found.all[0].message.find(words) != std::string::npos);
  }
}

TEST_CASE("an error of the importer leaves the file out; a cell without a row is nothing") {
  Shop shop;
  shop.importer("Useless", [](const ig_import_api* api, ig_import* in) -> ig_status {
    api->number_cell(in, text("H"), 1, 0);
    api->report(in, 1, 0, 1, nullptr, 0);
    return IG_CHANGED;
  });
  CHECK_FALSE(shop.read("Useless", "x"));
  CHECK(shop.codes() == Codes{"AB-0002 1:1"});
}

TEST_CASE("the surest importer reads a file, and a doubt is reported") {
  Shop shop;
  shop.importer("Half", [](const ig_import_api*, ig_import*) -> ig_status { return IG_CHANGED; }).out.recognise =
      [](ig_text, ig_text name) { return std::string(name.data, name.size) == "a.txt" ? 50u : 0u; };
  shop.importer("Sure", [](const ig_import_api*, ig_import*) -> ig_status { return IG_CHANGED; }).out.recognise =
      [](ig_text t, ig_text) {
        return t.size > 0 && t.data[0] == 'S' ? 1000u : t.size > 3 ? 50u : 0u;
      };
  auto file = shop.read("", "S");
  REQUIRE(file);
  CHECK(std::string(file->importer->id) == "Sure");
  CHECK(shop.codes().empty());
  file = shop.read("", "long");
  REQUIRE(file);
  CHECK(shop.codes() == Codes{"IG-0130 3:5"});
  CHECK_FALSE(shop.read("Sured", "x"));
  CHECK(shop.codes() == Codes{"IG-0129 3:5"});
  CHECK(shop.found.all[0].hint == "did you mean Sure?");
}

TEST_CASE("a file that is no text is named by an importer that is sure of its beginning") {
  Shop shop;
  shop.importer("Binary",
                [](const ig_import_api* api, ig_import* in) -> ig_status {
                  CHECK(api->text(in).size == 5);
                  api->report(in, 1, 0, 5, nullptr, 0);
                  return IG_CHANGED;
                })
      .out.recognise = [](ig_text t, ig_text) { return t.size >= 5 && t.data[0] == '@' ? 100u : 0u; };
  shop.importer("Guess",
                [](const ig_import_api* api, ig_import* in) -> ig_status {
                  api->report(in, 0, 0, 1, nullptr, 0);
                  return IG_CHANGED;
                })
      .out.recognise = [](ig_text t, ig_text) { return t.size > 0 && t.data[0] == '?' ? 99u : 0u; };
  shop.importer("Rows",
                [](const ig_import_api* api, ig_import* in) -> ig_status {
                  api->row(in, text("Tools"), text("1"), 0);
                  api->report(in, 0, 0, 1, nullptr, 0);
                  return IG_CHANGED;
                })
      .out.recognise = [](ig_text t, ig_text) { return t.size > 0 && t.data[0] == '#' ? 100u : 0u; };
  shop.library.add(shop.plugin.get());
  const auto of = [&](std::string bytes) {
    shop.found.all.clear();
    CHECK_FALSE(import_bytes({"dir/a.txt", "", {}, {"machine.xml", 3, 5}}, std::move(bytes), shop.library, shop.found));
    return shop.codes();
  };
  CHECK(of(std::string("@ARCH\0\0x", 8)) == Codes{"AB-0002 1:1"});
  CHECK(of(std::string("?ARCH\0\0x", 8)) == Codes{"IG-0126 3:5"});
  CHECK(of(std::string("#ARCH\0\0x", 8)) == Codes{"IG-0126 3:5"});
}

TEST_CASE("a file that no importer recognises, and options, are reported where they stand") {
  Shop shop;
  shop.importer("Never", [](const ig_import_api*, ig_import*) -> ig_status { return IG_CHANGED; }).options = {
      test::option("unit", IG_OPTION_CHOICE, "mm", "mm|inch")};
  CHECK_FALSE(shop.read("", "x"));
  CHECK(shop.codes() == Codes{"IG-0124 3:5"});
  shop.options = {{"unit", "foot", {"machine.xml", 3, 20}}, {"init", "1", {"machine.xml", 3, 30}}};
  CHECK_FALSE(shop.read("Never", "x"));
  CHECK(shop.codes() == Codes{"IG-0205 3:20", "IG-0204 3:30"});
}

TEST_CASE("text of any code becomes UTF-8, and bytes that are no text are refused") {
  const auto of = [](std::string bytes) {
    std::string reason;
    return text_of_control(std::move(bytes), reason).value_or("refused: " + reason);
  };
  CHECK(of("\xef\xbb\xbf"
           "a") == "a");
  CHECK(of("fr\xc3\xa4ser") == "fr\xc3\xa4ser");
  CHECK(of("fr\xe4ser") == "fr\xc3\xa4ser");
  CHECK(of(std::string("\xff\xfe"
                       "a\0\xe4\0"
                       "\x3d\xd8\x00\xde",
                       10)) == "a\xc3\xa4\xf0\x9f\x98\x80");
  CHECK(of(std::string("\xfe\xff\0a", 4)) == "a");
  CHECK(of(std::string("\xff\xfe\x00\xd8"
                       "a\0",
                       6)) ==
        "\xef\xbf\xbd"
        "a");
  CHECK(of(std::string("a\0\0", 3)) == "a");
  CHECK(of(std::string("a\0b", 3)).starts_with("refused: it is no text"));
  CHECK(of("PK\x03\x04").starts_with("refused: it is a zip archive"));
}

TEST_CASE("codes of tape punches and serial lines are no part of a text, and cost no line") {
  const auto of = [](std::string_view bytes) {
    std::string reason;
    return text_of_control(std::string(bytes), reason).value_or("refused: " + reason);
  };
  using namespace std::string_view_literals;
  CHECK(of("\0\0\0%\nN1\n"sv) == "%\nN1\n");
  CHECK(of("\0\x12\xef\xbb\xbf%\n"sv) == "%\n");
  CHECK(of("\x12%\n\0\0%_N_A_INI\0\x11\r\nR1\x13\x11=5\n\x14\0\x1a\x1a\r\n"sv) == "%\n%_N_A_INI\r\nR1=5\n");
  CHECK(of("a\r\r\nb\r\nc\r\rd\re"sv) == "a\r\nb\r\nc\r\rd\re");
  CHECK(of("\x7f\x7f%\x7f"sv) == "%");
  CHECK(of("a\x1a"
           "b"sv) ==
        "a\x1a"
        "b");
  CHECK(of("\0\0"sv).empty());
}

TEST_CASE("tables become a file again, where the importer writes") {
  Shop shop;
  shop.importer("Mute", [](const ig_import_api*, ig_import*) -> ig_status { return IG_CHANGED; });
  shop.importer("Writer", [](const ig_import_api*, ig_import*) -> ig_status { return IG_CHANGED; }).out.write =
      [](const ig_export_api* api, ig_export* out) -> ig_status {
    CHECK(api->row_count(out, text("Tools")) == 1);
    CHECK(api->row_count(out, text("Nowhere")) == 0);
    api->write(out, api->row_key(out, text("Tools"), 0));
    api->write(out, text("="));
    api->write(out, api->cell(out, text("Tools"), 0, text("H")));
    CHECK(api->cell(out, text("Tools"), 1, text("H")).size == 0);
    api->unused(out, text("D"), text("no column"));
    api->unused(out, text("D"), text("no column"));
    return IG_CHANGED;
  };
  shop.library.add(shop.plugin.get());
  const std::vector<DependencyElement> tables{
      {"Tools", "Tools", {}, {{"Tool", {{"id", "3", {}}, {"H", "1.5", {}}}, {}}}, {}, {}}};
  std::vector<UnusedPart> unused;
  CHECK(export_tables({"out", "Writer", {}, {}}, tables, shop.library, unused, shop.found) == "3=1.5");
  REQUIRE(unused.size() == 1);
  CHECK(unused[0].count == 2);
  CHECK_FALSE(export_tables({"out", "Mute", {}, {}}, tables, shop.library, unused, shop.found));
  CHECK(shop.codes() == Codes{"IG-0131 0:0"});
}

TEST_CASE("tables and columns that a writer never asks for are named") {
  Shop shop;
  shop.importer("Keys", [](const ig_import_api*, ig_import*) -> ig_status { return IG_CHANGED; }).out.write =
      [](const ig_export_api* api, ig_export* out) -> ig_status {
    api->row_key(out, text("Tools"), 0);
    return IG_CHANGED;
  };
  shop.importer("Cells", [](const ig_import_api*, ig_import*) -> ig_status { return IG_CHANGED; }).out.write =
      [](const ig_export_api* api, ig_export* out) -> ig_status {
    api->cell(out, text("Tools"), 0, text("H"));
    return IG_CHANGED;
  };
  shop.importer("Blind", [](const ig_import_api*, ig_import*) -> ig_status { return IG_CHANGED; }).out.write =
      [](const ig_export_api*, ig_export*) -> ig_status { return IG_CHANGED; };
  shop.library.add(shop.plugin.get());
  const TableRow row{"Tool", {{"id", "3", {}}, {"H", "1.5", {}}, {"D", "2", {}}}, {}};
  const auto named = [&](const char* format) {
    std::vector<UnusedPart> unused;
    CHECK(export_tables({"out", format, {}, {}}, {{"Tools", "Tools", {}, {row, row}, {}, {}}}, shop.library, unused,
                        shop.found));
    Codes out;
    for (const UnusedPart& part : unused) out.push_back(part.what + " " + std::to_string(part.count));
    return out;
  };
  CHECK(named("Keys").empty());
  CHECK(named("Cells") == Codes{"column D of Tools 2"});
  CHECK(named("Blind") == Codes{"rows of Tools 2"});
}

TEST_CASE("rows of a machine go over those of its file, which go over those of the dialect") {
  Shop shop;
  shop.library.add(shop.plugin.get());
  const auto row = [](const char* file, const char* id, const char* h) {
    return TableRow{"Tool", {{"id", id, {file, 1, 1}}, {"H", h, {file, 1, 1}}}, {file, 1, 1}};
  };
  Dialect machine;
  machine.is_machine = true;
  machine.dependencies = {{"Tools", "Tools", {{"size", "9", {}}}, {row("d", "1", "10"), row("d", "2", "20")}, {}, {}}};
  machine.own_tables = {{"Tools", "Tools", {{"size", "8", {}}}, {row("m", "2", "22"), row("m", "3", "33")}, {}, {}}};
  CHECK(is_incomplete(machine));
  REQUIRE(complete_machine(machine, shop.library, shop.found));
  CHECK_FALSE(is_incomplete(machine));
  REQUIRE(machine.dependencies.size() == 1);
  const DependencyElement& tools = machine.dependencies[0];
  CHECK(tools.options.size() == 1);
  CHECK(tools.options[0].value == "8");
  REQUIRE(tools.rows.size() == 3);
  CHECK(tools.rows[0].attributes[1].value == "10");
  CHECK(tools.rows[1].attributes[1].value == "22");
  CHECK(tools.rows[2].attributes[1].value == "33");
  REQUIRE(machine.plugins.size() == 1);
  CHECK(machine.plugins[0].name == "shop");
}
