// The names that a value may be, by the word that stands for the value in --help.
#include <algorithm>
#include <set>

#include "completion/completion.hpp"
#include "completion/completion_parts.hpp"
#include "known_codes.hpp"
#include "validate/check.hpp"

namespace isogloss::cli {

namespace {

struct CompletionNames {
  const TypedLine& line;
  Session& session;
  std::vector<Completion> names;

  void add(std::string_view name, std::string_view description) {
    names.push_back({.text = std::string(name), .description = std::string(description)});
  }
};

using NameSource = void (*)(CompletionNames&);

void add_dialects(CompletionNames& asked) {
  for (const Dialect& d : asked.session.reader().list()) asked.add(d.name, d.title);
}

void add_machines(CompletionNames& asked) {
  for (const FoundMachine& m : asked.session.machines()) asked.add(m.name, m.title);
}

/// What each plugin contributes in one of its lists.
template <class Declared>
void add_declared(CompletionNames& asked, const Declared* const* ig_plugin::*list, std::uint32_t ig_plugin::*count) {
  asked.session.library().load_all();
  for (const LoadedPlugin& p : asked.session.library().plugins())
    for (std::uint32_t i = 0; i < p.plugin->*count; ++i) {
      const Declared& one = *((p.plugin->*list)[i]);
      asked.add(one.id, one.summary == nullptr ? "" : one.summary);
    }
}

void add_syntaxes(CompletionNames& asked) { add_declared(asked, &ig_plugin::syntaxes, &ig_plugin::syntax_count); }
void add_dependencies(CompletionNames& asked) {
  add_declared(asked, &ig_plugin::dependencies, &ig_plugin::dependency_count);
}
void add_importers(CompletionNames& asked) { add_declared(asked, &ig_plugin::importers, &ig_plugin::importer_count); }

std::string text_in(const Json& row, const char* key) {
  const auto found = row.find(key);
  return found != row.end() && found->is_string() ? found->get<std::string>() : "";
}

/// Codes of diagnostics. There are more than a thousand: some of it must be typed.
void add_diagnostics(CompletionNames& asked) {
  if (asked.line.word.empty()) return;
  asked.session.library().load_all();
  for (const KnownCode& known : known_codes(asked.session.library())) asked.add(known.info.code, known.info.text);
}

/// Codes and words of programs, in the dialect or machine that the line names.
void add_codes(CompletionNames& asked) {
  const std::string& named = asked.line.dialect;
  const auto machine = asked.session.dialect_or_machine(named, asked.line.machine);
  if (!machine || machine->empty()) return;
  const auto linked = asked.session.link(*machine);
  if (linked == nullptr) return;
  const Json rows = describe_codes(*linked);
  for (const Json& row : rows) {
    const std::string code = text_in(row, "Code");
    if (asked.names.empty() || asked.names.back().text != code) asked.add(code, text_in(row, "Syntax"));
  }
}

void add_fields(CompletionNames& asked) {
  if (asked.line.word.empty()) return;
  asked.session.library().load_all();
  const Json rows = describe_fields(asked.session.library());
  for (const Json& row : rows) {
    const std::string path = text_in(row, "Path");
    if (path.find('~') == std::string::npos) asked.add(path, text_in(row, "Doc"));  // a syntax's own are not for people
  }
}

/// A section stands for all of its fields.
void add_sections_and_fields(CompletionNames& asked) {
  add_fields(asked);
  std::set<std::string> sections;
  for (const Completion& field : asked.names)
    sections.insert(field.text.substr(0, std::min(field.text.find_first_of(".["), field.text.size())));
  for (const std::string& section : sections) asked.add(section, "all fields of the section");
}

void add_headings(CompletionNames& asked) { asked.names = headings_of(asked.line, asked.session); }
void add_settings(CompletionNames& asked) { asked.names = settings_of(asked.line, asked.session); }
void add_importer_options(CompletionNames& asked) { asked.names = importer_options_of(asked.line, asked.session); }

void add_all_names(CompletionNames& asked) {
  add_codes(asked);
  add_syntaxes(asked);
  add_dependencies(asked);
  add_importers(asked);
  add_dialects(asked);
  add_machines(asked);
  add_fields(asked);
}

void add_checks(CompletionNames& asked) {
  for (const Check& check : all_checks()) asked.add(check.name, check.summary);
}

struct ValueRule {
  std::string_view command;  ///< empty: of any
  std::string_view value;
  std::string_view files;
  NameSource names = nullptr;
};
constexpr ValueRule rules[] = {
    {"", "DIALECT", "*.xml", add_dialects},
    {"", "MACHINE", "*.xml", add_machines},
    {"", "SYNTAX", "", add_syntaxes},
    {"", "CHECK", "", add_checks},
    {"", "CODE", "", add_codes},
    {"", "PLUGIN", "*.so"},
    {"", "PROGRAM", "*"},
    {"", "PROGRAM:LINE", "*", add_diagnostics},
    {"", "FILE", "*"},
    {"", "FILE|DIR", "*"},
    {"", "PLACE", "*"},
    {"", "PATH", "*"},
    {"", "NAME=FILE", "*"},
    {"", "DIR", "/"},
    {"", "FIELD", "", add_sections_and_fields},
    {"", "HEADING", "", add_headings},
    {"import", "NAME=VALUE", "", add_importer_options},
    {"export", "NAME=VALUE", "", add_importer_options},
    {"", "NAME=VALUE", "", add_settings},
    {"inspect", "NAME", "", add_all_names},
    {"import", "NAME", "", add_importers},
    {"export", "NAME", "", add_importers},
};

const ValueRule* value_rule(const TypedLine& line) {
  if (line.item == nullptr || !line.item->words.empty()) return nullptr;
  const std::string_view command = line.command == nullptr ? "" : line.command->name;
  const auto found = std::find_if(std::begin(rules), std::end(rules), [&](const ValueRule& rule) {
    return rule.value == line.item->value && (rule.command.empty() || rule.command == command);
  });
  return found == std::end(rules) ? nullptr : found;
}

}  // namespace

std::string_view files_of(const TypedLine& line) {
  const ValueRule* const rule = value_rule(line);
  return rule == nullptr ? "" : rule->files;
}

std::vector<Completion> names_of(const TypedLine& line) {
  const ValueRule* const rule = value_rule(line);
  if (rule == nullptr || rule->names == nullptr) return {};
  CommonOptions options = line.places;
  options.diagnostics_output = "/dev/null";  // a line that is half typed is full of errors
  Session session(options);
  CompletionNames asked{line, session, {}};
  rule->names(asked);
  return std::move(asked.names);
}

}  // namespace isogloss::cli
