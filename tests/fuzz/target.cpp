#include "target.hpp"

#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <map>

namespace isogloss::fuzz {

namespace {

using Make = std::function<std::unique_ptr<Target>()>;

const std::map<std::string, Make>& targets() {
  static const std::map<std::string, Make> all = [] {
    std::map<std::string, Make> out{{"dialect", make_dialect_target}, {"tables", make_tables_target},
                                    {"import", make_import_target},   {"page", make_page_target},
                                    {"block", make_block_target},     {"descriptor", make_descriptor_target},
                                    {"stream", make_stream_target},   {"messages", make_messages_target}};
    for (const char* const name : {"fanuc", "haas", "iso", "okuma", "syntec", "siemens", "heidenhain"})
      out["program." + std::string(name)] = [name] { return make_program_target(name, "", ""); };
    out["expression.fanuc"] = [] {
      return make_program_target("fanuc", "G21 G90\n#1=1\n#2=2.5\n#3=", "\nG0 X#3\nM30\n");
    };
    out["expression.siemens"] = [] {
      return make_program_target("siemens", "G71 G90\nR1=1 R2=2.5\nR3=", "\nG0 X=R3\nM30\n");
    };
    out["expression.syntec"] = [] {
      return make_program_target("syntec", "%@MACRO\nG71 G90;\n#1 := 1;\n#2 := 2.5;\n#3 := ", ";\nG00 X#3;\nM30;\n");
    };
    out["expression.heidenhain"] = [] {
      return make_program_target("heidenhain",
                                 "BEGIN PGM A MM\nQ1 = 1\nQ2 = 2.5\nQ3 = ", "\nL X+Q3 R0 FMAX\nEND PGM A MM\n");
    };
    return out;
  }();
  return all;
}

}  // namespace

std::unique_ptr<Target> make_target(const std::string& name) {
  const auto found = targets().find(name);
  return found == targets().end() ? nullptr : found->second();
}

std::vector<std::string> target_names() {
  std::vector<std::string> out;
  for (const auto& [name, make] : targets()) out.push_back(name);
  return out;
}

void fail(const std::string& promise) {
  std::fprintf(stderr, "a promise is broken: %s\n", promise.c_str());
  std::abort();
}

void add_words(std::string_view text, std::set<std::string>& out) {
  constexpr std::string_view joining = "_$#@.";
  constexpr std::size_t fewest = 2, most = 40;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    if (i < text.size() &&
        (std::isalnum(static_cast<unsigned char>(text[i])) != 0 || joining.find(text[i]) != std::string_view::npos))
      continue;
    if (i - begin >= fewest && i - begin <= most) out.emplace(text.substr(begin, i - begin));
    begin = i + 1;
  }
}

std::vector<std::string> declared_names() {
  workspace().library().load_all();
  std::set<std::string> out;
  const auto add = [&](const char* text) { add_words(text == nullptr ? "" : text, out); };
  for (const LoadedPlugin& loaded : workspace().library().plugins()) {
    const ig_plugin& plugin = *loaded.plugin;
    add(plugin.name);
    for (std::uint32_t i = 0; i < plugin.syntax_count; ++i) {
      const ig_syntax& syntax = *plugin.syntaxes[i];
      add(syntax.id);
      for (std::uint32_t o = 0; o < syntax.option_count; ++o)
        for (const char* const text : {syntax.options[o].name, syntax.options[o].fallback, syntax.options[o].choices})
          add(text);
    }
    for (std::uint32_t i = 0; i < plugin.dependency_count; ++i) {
      const ig_dependency& table = *plugin.dependencies[i];
      for (const char* const text : {table.id, table.row_element, table.row_key}) add(text);
      for (std::uint32_t c = 0; c < table.column_count; ++c) add(table.columns[c].name);
    }
    for (std::uint32_t i = 0; i < plugin.importer_count; ++i) add(plugin.importers[i]->id);
  }
  return {out.begin(), out.end()};
}

std::vector<std::string> dictionary(const Target& target) {
  std::set<std::string> out;
  for (const std::string& word : target.words()) out.insert(word);
  std::map<std::string, int> samples_with;
  for (const std::string& sample : target.samples()) {
    std::set<std::string> words;
    add_words(sample, words);
    for (const std::string& word : words) ++samples_with[word];
  }
  for (const auto& [word, count] : samples_with)
    if (count > 1) out.insert(word);
  return {out.begin(), out.end()};
}

void expect_no_internal_fault(const std::vector<Diagnostic>& said) {
  for (const Diagnostic& d : said)
    if (is_internal_fault(d.code)) fail("no input makes a plugin or the host fail: " + d.message + " [" + d.code + "]");
}

}  // namespace isogloss::fuzz
