// The folder of a plugin. All that can be wrong is looked at before the first file is written.
#include <fmt/format.h>

#include "known_codes.hpp"
#include "new/folder.hpp"
#include "new/names.hpp"

namespace isogloss::cli {

namespace {

class NewPlugin : public NewFolder {
 public:
  explicit NewPlugin(const NewOptions& options) : NewFolder(options, "a plugin") {}

  int run() {
    if (!begins() || !has_free_name() || !has_free_prefix() || !is_one_kind()) return cannot_start;
    words()["namespace"] = identifier(lower_case(options().name));
    words()["NAMESPACE"] = identifier(upper_case(options().name));
    words()["vendor"] = escaped_literal(options().vendor.empty() ? options().name : options().vendor);
    words()["vendor_name"] = options().vendor.empty() ? options().name : options().vendor;
    words()["entry"] = is_c() ? "plugin.c" : "plugin.cpp";
    words()["languages"] = is_c() ? "C" : "CXX";
    words()["plugin_arguments"] = is_c() ? " LANGUAGE C" : "";
    words()["first_block"] = family() == "iso" ? "G21 G17 G90" : "G17 G90";
    words()["more_syntaxes"] = words()["more_declarations"] = "";
    words()["extension"] = family() == "klartext" ? "h" : "nc";
    const std::string of = kind();
    if (!has_template(of) || !describes(of)) return cannot_start;
    const std::string language = is_c() ? "c" : "cxx";
    const bool is_klartext = family() == "klartext";
    std::vector<std::string> layers{"plugin", "plugin-" + language, of, of + "-" + language};
    if (of != "cycle") layers.push_back(of + (is_klartext ? "-klartext" : "-iso"));
    if (is_klartext && of != "switch") layers.insert(layers.end(), {"statement", "statement-" + language});
    return write(layers);
  }

 private:
  bool is_c() const { return options().language == "c"; }

  bool is_one_kind() {
    const bool is_word = !options().word.empty() || !options().table.empty();
    if ((options().cycle.empty() ? 0 : 1) + (options().switch_codes.empty() ? 0 : 1) + (is_word ? 1 : 0) <= 1)
      return true;
    return refuse("IG-0513", {"a plugin begins with one syntax: give --cycle, --switch, or --word and --table"});
  }

  /// What the plugin begins with; without an option a cycle where there is a template for one.
  std::string kind() {
    if (!options().table.empty()) return "table";
    if (!options().word.empty()) return "word";
    if (!options().cycle.empty()) return "cycle";
    return options().switch_codes.empty() && has_cycles() ? "cycle" : "switch";
  }

  bool has_cycles() const {
    return in_chain("DrillingCycleSyntax") != nullptr && in_chain("CannedCycleResolveSyntax") != nullptr &&
           family() == "iso";
  }

  bool has_template(const std::string& of) {
    if (of == "cycle" && !has_cycles())
      return refuse("IG-0154", {"a cycle of dialect " + base().name,
                                "only ISO programs have canned cycles with a G code; begin with --switch, --word or "
                                "--table, and write a cycle of the maker as a program of a machine (<Programs>)"});
    const bool reads_words = of == "word" || of == "table";
    if (reads_words && family() == "klartext" && in_chain("KlartextUnknownSyntax") == nullptr)
      return refuse("IG-0154", {"a word of dialect " + base().name,
                                "it has no KlartextUnknownSyntax, before which a new statement stands"});
    if (in_chain("LinearMotionSyntax") == nullptr)
      return refuse("IG-0154", {"a plugin on dialect " + base().name, "it has no LinearMotionSyntax to stand before"});
    return true;
  }

  bool describes(const std::string& of) {
    return of == "cycle" ? describes_cycle() : of == "switch" ? describes_switch() : describes_word();
  }

  bool has_free_name() {
    session().library().load_all();
    for (const LoadedPlugin& loaded : session().library().plugins())
      if (loaded.plugin->name == options().name)
        return refuse("IG-0151", {options().name, "a plugin that is installed"});
    return true;
  }

  /// After has_free_name(), which loads all plugins.
  bool has_free_prefix() {
    const std::string prefix = options().prefix.empty() ? prefix_of(options().name) : options().prefix;
    if (!is_prefix(prefix)) return refuse("IG-0152", {prefix, "is not two to eight capital letters"});
    for (const KnownCode& known : known_codes(session().library()))
      if (known.info.code.starts_with(prefix + "-")) return refuse("IG-0152", {prefix, "belongs to " + known.plugin});
    words()["prefix"] = prefix;
    return true;
  }

  static bool takes(const ig_syntax& syntax, std::string_view named) {
    for (std::uint32_t i = 0; i < syntax.field_count; ++i) {
      const ig_field_decl& field = syntax.fields[i];
      const std::string_view path = field.path;
      if ((field.access & IG_TAKE) != 0 && path.starts_with("Parsing.") && path.ends_with(named) &&
          (path.size() == 8 + named.size() || path.substr(8, path.size() - 8 - named.size()) == "Flags."))
        return true;
    }
    return false;
  }

  /// Takes the words of codes that it reports, whatever they are: most of the alphabet.
  static bool takes_any_word(const ig_syntax& syntax) {
    int count = 0;
    for (char letter = 'A'; letter <= 'Z'; ++letter) count += takes(syntax, {&letter, 1}) ? 1 : 0;
    return count > 13;
  }

  /// False, and reported, when a syntax of the base dialect answers to the word or code already.
  bool is_free(const std::string& named) {
    const std::unique_ptr<LinkedDialect> linked = session().link(base().file.string());
    if (linked == nullptr) return false;
    for (const LinkedSyntax& s : linked->chain)
      if (takes(*s.syntax, named) && !takes_any_word(*s.syntax))
        return refuse("IG-0153", {named, base().name, s.element.alias});
    return true;
  }

  void names_syntax(const std::string& syntax, const std::string& structure, const std::string& program) {
    words()["syntax"] = syntax;
    words()["struct"] = structure;
    words()["file"] = snake_case(syntax);
    words()["program"] = program;
    words()["section"] = "";
  }

  bool describes_cycle() {
    const std::string code = cycle_code(options().cycle.empty() ? "G181" : options().cycle);
    if (code.empty()) return refuse("IG-0513", {"a cycle has a G code of up to three digits, such as G181"});
    if (!is_free(code)) return false;
    std::string unit = "s";
    for (const Attribute& option : in_chain("DrillingCycleSyntax")->options)
      if (option.name == "p-unit") unit = option.value;
    const std::string structure = words()["name"] + code + "Cycle";
    names_syntax(structure + "Syntax", structure, snake_case(code));
    words()["code"] = code;
    words()["p_unit"] = unit;
    words()["half_second"] = unit == "ms" ? "500" : ".5";
    words()["what"] = "the drilling cycle " + code;
    list_files({{is_c() ? ".c" : ".cpp", "the cycle"}, {".md", "its page, whose cases are tests"}}, "");
    return true;
  }

  bool describes_switch() {
    const auto [on, off] = switch_codes(options().switch_codes.empty() ? "M171,M172" : options().switch_codes);
    if (on.empty()) return refuse("IG-0513", {"a switch has two M codes, on and off: --switch M171,M172"});
    if (!is_free(on) || !is_free(off)) return false;
    const std::string& name = words()["name"];
    words()["on"] = on;
    words()["off"] = off;
    names_syntax(name + "SwitchSyntax", name + "Switch", "switch");
    words()["section"] = " SECTION " + name;
    words()["what"] = "a switch, which " + on + " puts on and " + off + " puts off";
    list_files(
        {{is_c() ? ".c" : ".cpp", "the syntax that reads both codes"}, {".md", "its page, whose cases are tests"}}, "");
    return true;
  }

  bool describes_word() {
    const std::string word = options().word.empty() ? "E" : upper_case(options().word);
    if (word.size() != 1 || word[0] < 'A' || word[0] > 'Z')
      return refuse("IG-0513", {"a word is named by its address, one letter: --word E"});
    if (!is_free(word)) return false;
    const std::string& name = words()["name"];
    words()["word"] = word;
    if (options().table.empty()) {
      names_syntax(name + "WordSyntax", name + "Word", "word");
      words()["what"] = "the word " + word + ", whose value stays in force";
      list_files(
          {{is_c() ? ".c" : ".cpp", "the syntax that reads " + word}, {".md", "its page, whose cases are tests"}}, "");
    } else {
      if (!is_plugin_name(options().table)) return refuse("IG-0150", {options().table, "a table"});
      const std::string own = type_name_of(options().table), table = own.starts_with(name) ? own : name + own;
      names_syntax(table + "WordSyntax", table + "Word", "table");
      words()["table"] = table;
      words()["table_file"] = snake_case(table);
      words()["table_variable"] = snake_case(own);
      words()["table_service"] = lower_case(own);
      words()["TABLE_SERVICE"] = upper_case(own);
      words()["what"] = "the table " + table + ", of which " + word + " names a row";
      list_files(
          {{is_c() ? ".c" : ".cpp", "the syntax that reads " + word}, {".md", "its page, whose cases are tests"}},
          fmt::format("| `{0}{1}.md` | the table, and its service for syntaxes |\n",
                      is_c() ? words()["table_file"] + ".c`, `"
                             : words()["table_file"] + ".hpp`, `" + words()["table_file"] + ".cpp`, `",
                      words()["table_file"]));
    }
    words()["section"] = " SECTION " + name;
    if (family() == "klartext") describes_statement(word);
    return true;
  }

  /// A word of Klartext stands in a statement of its own, which a second syntax reads.
  void describes_statement(const std::string& word) {
    const std::string structure = words()["name"] + "Statement", name = upper_case(options().name);
    words()["statement"] = structure + "Syntax";
    words()["statement_struct"] = structure;
    words()["statement_file"] = snake_case(words()["statement"]);
    words()["STATEMENT"] = name;
    words()["statement_words"] = "FUNCTION " + name;
    words()["word_column"] = std::to_string(words()["statement_words"].size() + 2);
    words()["more_syntaxes"] = "&" + words()["statement_file"] + ", ";
    words()["more_declarations"] = "\nextern const ig_syntax " + words()["statement_file"] + ";";
    words()["what"] += fmt::format("; the statement {} {}30 holds the word", words()["statement_words"], word);
    words()["files"] += fmt::format("| `{0}{1}`, `{0}.md` | the syntax that reads the statement, and its page |\n",
                                    words()["statement_file"], is_c() ? ".c" : ".cpp");
  }

  /// Rows of the README's table of files.
  void list_files(std::initializer_list<std::pair<std::string, std::string>> of_syntax, const std::string& more) {
    std::string out;
    for (const auto& [extension, what] : of_syntax)
      out += fmt::format("| `{}{}` | {} |\n", words()["file"], extension, what);
    out +=
        more + (is_c() ? fmt::format("| `plugin.c`, `{}.h` | name, version, syntaxes and diagnostics of the plugin |\n",
                                     words()["namespace"])
                       : "| `plugin.cpp` | name, version and vendor of the plugin |\n");
    words()["files"] = out;
  }
};

}  // namespace

int new_plugin(const NewOptions& options) { return NewPlugin(options).run(); }

}  // namespace isogloss::cli
