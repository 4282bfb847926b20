#include "contract/descriptor_check.hpp"

#include <catch2/catch.hpp>
#include <functional>

#include "isogloss_scan.h"
#include "test_plugin.hpp"

using namespace isogloss;
using namespace isogloss::test;

namespace {

/// A plugin in which everything is used and nothing is wrong.
Plugin good() {
  Plugin plugin("good");
  Syntax& syntax = plugin.syntax("GoodSyntax");
  syntax.fields = {field("Feedrate.FeedrateValue", IG_READ), field("Parsing.A54.1.X", IG_TAKE | IG_WAKE),
                   field("Steps.Items[].Dwell.Time", IG_WRITE), field("@words", IG_READ | IG_PATTERN),
                   field("Parsing.~Signal", IG_WAKE, IG_SWITCH, IG_LIFE_BLOCK)};
  syntax.options = {option("words", IG_OPTION_FIELDS, "Parsing.? Parsing.*.X"),
                    option("unit", IG_OPTION_CHOICE, "ms", "s|ms"),
                    option("on", IG_OPTION_BOOLEAN, "false"),
                    option("count", IG_OPTION_INTEGER, "3", "", 0, 10),
                    option("length", IG_OPTION_NUMBER, "-0.5", "", -1, 1),
                    option("name", IG_OPTION_TEXT, nullptr)};
  syntax.services = {{sizeof(ig_service_decl), 0, "test.offset/1", ""}};
  syntax.after = {"Other"};
  Dependency& dependency = plugin.dependency("GoodTable");
  dependency.out.row_element = "Row";
  dependency.out.row_key = "id";
  dependency.columns = {column("X", "0", -10, 10), column("Y")};
  dependency.rows = {"a|X=1|Y=-2.5", "b"};
  dependency.provides = {"test.offset/1"};
  plugin.diagnostics = {{sizeof(ig_diagnostic_decl), IG_ERROR, "GOOD-0001", "text", "why", "example"}};
  return plugin;
}

struct Row {
  const char* what;
  std::function<void(Plugin&)> spoil;
  const char* reason;  ///< a part of the answer
};

Syntax& syntax(Plugin& p) { return p.syntaxes[0]; }
Dependency& dependency(Plugin& p) { return p.dependencies[0]; }

}  // namespace

TEST_CASE("a sound descriptor has no fault") {
  Plugin plugin = good();
  CHECK(descriptor_fault(*plugin.get()).value_or("") == "");
  plugin.out.abi_minor = 7;
  CHECK_FALSE(descriptor_fault(*plugin.get()));
  syntax(plugin).out.struct_size = sizeof(ig_syntax) + 64;
  CHECK_FALSE(descriptor_fault(*plugin.get()));
}

TEST_CASE("each fault of a descriptor is found and named") {
  const std::vector<Row> rows{
      {"size", [](Plugin& p) { p.out.struct_size = 0; }, "ig_plugin has struct_size 0"},
      {"name", [](Plugin& p) { p.out.name = nullptr; }, "the plugin's name is null"},
      {"name", [](Plugin& p) { p.out.name = "../x"; }, "'../x' is not a name"},
      {"version", [](Plugin& p) { p.out.version = nullptr; }, "the version of plugin 'good' is null"},
      {"id", [](Plugin& p) { syntax(p).out.id = nullptr; }, "syntaxes[0].id is null"},
      {"id", [](Plugin& p) { syntax(p).out.id = "a b"; }, "'a b' is not a name"},
      {"id", [](Plugin& p) { syntax(p).out.id = "Remove"; }, "an element of the dialect file itself"},
      {"two ids", [](Plugin& p) { p.syntax("GoodSyntax"); }, "the id 'GoodSyntax' is declared twice"},
      {"two kinds", [](Plugin& p) { p.syntax("GoodTable"); }, "the id 'GoodTable' is declared twice"},
      {"syntax size", [](Plugin& p) { syntax(p).out.struct_size = 8; }, "syntaxes[0] has struct_size 8"},
      {"summary", [](Plugin& p) { syntax(p).out.summary = nullptr; }, "GoodSyntax.summary is null"},
      {"summary", [](Plugin& p) { syntax(p).out.summary = "\x1b[31mred"; },
       "GoodSyntax.summary holds the control character 0x1B"},
      {"summary",
       [](Plugin& p) {
         static const std::string long_text(100'000, 'x');
         syntax(p).out.summary = long_text.c_str();
       },
       "GoodSyntax.summary is longer than 65536 bytes"},
      {"look-ahead", [](Plugin& p) { syntax(p).out.look_ahead = 4000000000u; }, "looks 4000000000 blocks ahead"},
      {"create", [](Plugin& p) { syntax(p).out.create = nullptr; }, "GoodSyntax.create is null"},
      {"destroy", [](Plugin& p) { syntax(p).out.destroy = nullptr; }, "GoodSyntax.destroy is null"},
      {"build", [](Plugin& p) { syntax(p).out.build = nullptr; }, "neither build, scan nor restart"},
      {"triggers", [](Plugin& p) { syntax(p).out.triggers = "X"; }, "triggers and no scan"},
      {"scan flags", [](Plugin& p) { syntax(p).out.scan_flags = IG_SCANS_AHEAD; }, "scan_flags and no scan"},
      {"scan flags",
       [](Plugin& p) {
         syntax(p).out.triggers = "X";
         syntax(p).out.scan = [](void*, const ig_host*, ig_block*, const char*, std::size_t, std::size_t at) {
           return at;
         };
         syntax(p).out.scan_flags = 6;
       },
       "the scan_flags 0x6, which have no meaning"},
      {"reserved", [](Plugin& p) { syntax(p).out.reserved = 1; }, "GoodSyntax.reserved is 1, not 0"},
      {"inspects",
       [](Plugin& p) {
         syntax(p).out.inspects = 1;
         syntax(p).out.restart = syntax(p).out.build;
         syntax(p).out.build = nullptr;
       },
       "inspects and has no build"},
      {"field size", [](Plugin& p) { syntax(p).fields[1].struct_size = 0; }, "fields[1] has struct_size 0"},
      {"path", [](Plugin& p) { syntax(p).fields[0].path = nullptr; }, "field 0 is null"},
      {"path", [](Plugin& p) { syntax(p).fields[0].path = "Feedrate"; }, "no path such as Section.Field"},
      {"path", [](Plugin& p) { syntax(p).fields[0].path = "A..B"; }, "no path such as Section.Field"},
      {"path", [](Plugin& p) { syntax(p).fields[0].path = "A[].B"; }, "no path such as Section.Field"},
      {"path", [](Plugin& p) { syntax(p).fields[0].path = "A.B[].C[].D"; }, "no path such as Section.Field"},
      {"path", [](Plugin& p) { syntax(p).fields[0].path = "A.B C"; }, "no path such as Section.Field"},
      {"access", [](Plugin& p) { syntax(p).fields[0].access = IG_REQUIRED; }, "neither read, written nor taken"},
      {"access", [](Plugin& p) { syntax(p).fields[0].access = IG_READ | 1u << 20; }, "the access bits 0x100000"},
      {"access", [](Plugin& p) { syntax(p).fields[1].access = IG_TAKE | IG_REQUIRED; },
       "IG_REQUIRED goes with IG_READ"},
      {"access", [](Plugin& p) { syntax(p).fields[0].access = IG_READ | IG_ENDS_AHEAD; },
       "IG_ENDS_AHEAD, and the syntax looks no block ahead"},
      {"access",
       [](Plugin& p) {
         syntax(p).out.look_ahead = 2;
         syntax(p).fields[0] = field("Steps.Items[].Dwell.Time", IG_READ | IG_ENDS_AHEAD);
       },
       "IG_ENDS_AHEAD, which a field of records cannot have"},
      {"wake value", [](Plugin& p) { syntax(p).fields[0].wake_value = "Turbo"; },
       "which only a field of names can have"},
      {"wake value",
       [](Plugin& p) {
         syntax(p).fields[0] = field("Feedrate.Term", IG_READ, IG_SYMBOL);
         syntax(p).fields[0].wake_value = "Turbo";
       },
       "and not the access IG_WAKE_WHILE"},
      {"wake value",
       [](Plugin& p) {
         syntax(p).fields[0] = field("Feedrate.Term", IG_READ | IG_WAKE_WHILE, IG_SYMBOL);
         syntax(p).fields[0].wake_value = "";
       },
       "has an empty wake_value"},
      {"doc",
       [](Plugin& p) {
         syntax(p).fields[0].doc =
             "Vorsch\xfc"
             "be";
       },
       "the doc of field 'Feedrate.FeedrateValue' of GoodSyntax is not UTF-8: its byte 6 is 0xFC"},
      {"reserved", [](Plugin& p) { p.out.reserved = 3; }, "ig_plugin.reserved is 3, not 0"},
      {"reserved",
       [](Plugin& p) {
         Importer& importer = p.importer("GoodFile");
         importer.dependencies = {"GoodTable"};
         importer.out.reserved = 1;
       },
       "GoodFile.reserved is 1, not 0"},
      {"type", [](Plugin& p) { syntax(p).fields[0].type = 9; }, "has the type 9"},
      {"life", [](Plugin& p) { syntax(p).fields[0].life = 5; }, "has the life 5"},
      {"unit", [](Plugin& p) { syntax(p).fields[0].unit = nullptr; }, "the unit of field"},
      {"doc", [](Plugin& p) { syntax(p).fields[0].doc = nullptr; }, "the doc of field"},
      {"pattern", [](Plugin& p) { syntax(p).fields[3].path = "@unit"; }, "no option of field patterns"},
      {"pattern", [](Plugin& p) { syntax(p).fields[3].path = "Parsing.X"; }, "its path is '@'"},
      {"option", [](Plugin& p) { syntax(p).options[1].name = nullptr; }, "option 1 is null"},
      {"option", [](Plugin& p) { syntax(p).options[1].name = "as"; }, "keeps for itself"},
      {"option", [](Plugin& p) { syntax(p).options[1].name = "on"; }, "'on' is declared twice"},
      {"option", [](Plugin& p) { syntax(p).options[1].type = 0; }, "has the type 0"},
      {"choices", [](Plugin& p) { syntax(p).options[1].choices = nullptr; }, "the choices of option 'unit'"},
      {"choices", [](Plugin& p) { syntax(p).options[1].choices = "s||ms"; }, "an empty choice"},
      {"choices", [](Plugin& p) { syntax(p).options[1].choices = "ms|ms"; }, "is declared twice"},
      {"choice", [](Plugin& p) { syntax(p).options[1].fallback = "h"; }, "'h', not one of s, ms"},
      {"boolean", [](Plugin& p) { syntax(p).options[2].fallback = "yes"; }, "'yes', not true or false"},
      {"integer", [](Plugin& p) { syntax(p).options[3].fallback = "1.5"; }, "'1.5', not a whole number from 0 to 10"},
      {"integer", [](Plugin& p) { syntax(p).options[3].fallback = "11"; }, "'11', not a whole number from 0 to 10"},
      {"number", [](Plugin& p) { syntax(p).options[4].fallback = "1e5"; }, "'1e5', not a number from -1 to 1"},
      {"range", [](Plugin& p) { syntax(p).options[4].minimum = 2; }, "has the range 2 to 1"},
      {"range", [](Plugin& p) { syntax(p).options[4].maximum = std::nan(""); }, "has the range -1 to nan"},
      {"service", [](Plugin& p) { syntax(p).services[0].id = nullptr; }, "GoodSyntax.services.id is null"},
      {"row", [](Plugin& p) { dependency(p).out.row_key = nullptr; }, "only one of row_element and row_key"},
      {"row", [](Plugin& p) { dependency(p).out.row_key = dependency(p).out.row_element = nullptr; },
       "columns or rows, and no row_element"},
      {"column", [](Plugin& p) { dependency(p).columns[0].name = "id"; }, "column 'id' is declared twice"},
      {"column", [](Plugin& p) { dependency(p).columns[0].fallback = "11"; }, "11, lies outside -10 to 10"},
      {"column", [](Plugin& p) { dependency(p).columns[0].fallback = "x"; }, "'x', is not a number"},
      {"default row", [](Plugin& p) { dependency(p).rows[0] = nullptr; }, "row 0 of GoodTable is null"},
      {"default row", [](Plugin& p) { dependency(p).rows[0] = "a|Z=1"; }, "names the unknown column 'Z'"},
      {"default row", [](Plugin& p) { dependency(p).rows[0] = "a|X"; }, "'X' is not column=value"},
      {"default row", [](Plugin& p) { dependency(p).rows[0] = "a|X=11"; }, "11, lies outside -10 to 10"},
      {"provider", [](Plugin& p) { dependency(p).out.service = nullptr; }, "its service function is null"},
      {"code", [](Plugin& p) { p.diagnostics[0].code = "good-1"; }, "is not a prefix and number"},
      {"code", [](Plugin& p) { p.diagnostics[0].code = "IG-0001"; }, "the host's own prefix"},
      {"code", [](Plugin& p) { p.diagnostics.push_back(p.diagnostics[0]); }, "'GOOD-0001' is declared twice"},
      {"code",
       [](Plugin& p) {
         p.diagnostics.push_back(p.diagnostics[0]);
         p.diagnostics[1].text = "another text";
       },
       "'GOOD-0001' is declared twice, with two texts"},
      {"places", [](Plugin& p) { p.diagnostics[0].text = "'{0}' and {1"; }, "holds '{1', which is no place"},
      {"places", [](Plugin& p) { p.diagnostics[0].text = "{10}"; }, "holds '{10', which is no place"},
      {"severity", [](Plugin& p) { p.diagnostics[0].severity = 0; }, "has the severity 0"},
      {"text", [](Plugin& p) { p.diagnostics[0].text = nullptr; }, "the text of diagnostic GOOD-0001 is null"}};
  for (const Row& row : rows) {
    CAPTURE(row.what, row.reason);
    Plugin plugin = good();
    row.spoil(plugin);
    const std::string found = descriptor_fault(*plugin.get()).value_or("no fault");
    CHECK_THAT(found, Catch::Contains(row.reason));
  }
}

TEST_CASE("absurd counts and null arrays are refused before they are read") {
  Plugin plugin = good();
  ig_plugin out = *plugin.get();
  ig_syntax counted = *out.syntaxes[0];
  const ig_syntax* list[] = {&counted};
  out.syntaxes = list;
  CHECK_FALSE(descriptor_fault(out));

  counted.field_count = 0xffffffffu;
  CHECK(*descriptor_fault(out) == "GoodSyntax.fields counts 4294967295, more than 8192");
  counted.field_count = 1;
  counted.fields = nullptr;
  CHECK(*descriptor_fault(out) == "GoodSyntax.fields counts 1 and is null");
  list[0] = nullptr;
  CHECK(*descriptor_fault(out) == "syntaxes[0] is null");
  out.syntaxes = nullptr;
  CHECK(*descriptor_fault(out) == "syntaxes is null");
  out.syntax_count = 0xffffffffu;
  CHECK(*descriptor_fault(out) == "syntaxes counts 4294967295, more than 2048");
}

TEST_CASE("a control character is found wherever it stands in a text, and no other one is refused") {
  Plugin plugin = good();
  const auto fault_of = [&](const std::string& text) {
    syntax(plugin).out.summary = text.c_str();
    return descriptor_fault(*plugin.get()).value_or("");
  };
  for (std::size_t size = 1; size <= 40; ++size)
    for (std::size_t at = 0; at < size; ++at)
      for (const int c : {0x01, 0x1b, 0x1f, 0x7f}) {
        std::string text(size, 'x');
        text[at] = static_cast<char>(c);
        CAPTURE(size, at, c);
        CHECK(fault_of(text).find("holds the control character") != std::string::npos);
      }
  std::string all = "\t\n";
  for (int c = 0x20; c < 0x7f; ++c) all += static_cast<char>(c);
  CHECK(fault_of(all) == "");
}

TEST_CASE("a text that is not UTF-8 is refused wherever it stands, and UTF-8 is not") {
  Plugin plugin = good();
  const auto fault_of = [&](const std::string& text) {
    syntax(plugin).out.summary = text.c_str();
    return descriptor_fault(*plugin.get()).value_or("");
  };
  for (std::size_t at = 0; at < 40; ++at) {
    const std::string before(at, 'x');
    CAPTURE(at);
    for (const char* const good_text : {"é", "…", "𝛼", "ÿ"}) CHECK(fault_of(before + good_text + "xx") == "");
    for (const char* const bad : {"\x80", "\xff", "\xc0\xaf", "\xe2\x80", "\xed\xa0\x80", "\xf5\x80\x80\x80"})
      CHECK_THAT(fault_of(before + bad), Catch::Contains("is not UTF-8: its byte " + std::to_string(at) + " "));
  }
}

TEST_CASE("a newer plugin may have given a reserved member a meaning") {
  Plugin plugin = good();
  plugin.out.reserved = 3;
  plugin.out.abi_minor = IG_ABI_MINOR + 1;
  CHECK(descriptor_fault(*plugin.get()).value_or("") == "");
}

TEST_CASE("a name or a path with a control character is refused as one, not shown") {
  Plugin plugin = good();
  syntax(plugin).out.id = "Good\x1b[31mSyntax";
  CHECK(descriptor_fault(*plugin.get()).value_or("") == "syntaxes[0].id holds the control character 0x1B");
  plugin = good();
  syntax(plugin).fields[0].path = "Feedrate.\x07Value";
  CHECK(descriptor_fault(*plugin.get()).value_or("").find("holds the control character 0x07") != std::string::npos);
}
