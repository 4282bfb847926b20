#include "docs/reference.hpp"

#include <algorithm>

#include "dialect/chain_map.hpp"
#include "page_section.hpp"

namespace isogloss::cli::docs {

namespace {

template <class Declaration>
Part part(PartKind kind, const Declaration& d, const ig_plugin& plugin, const char* cases) {
  return {kind, d.id, plugin.name, describe(d, plugin), printable_page(d.page), printable_page(cases)};
}

void add_parts(const ig_plugin& p, std::vector<Part>& out) {
  for (std::uint32_t i = 0; i < p.syntax_count; ++i)
    out.push_back(part(PartKind::syntax, *p.syntaxes[i], p, p.syntaxes[i]->cases));
  for (std::uint32_t i = 0; i < p.dependency_count; ++i)
    out.push_back(part(PartKind::dependency, *p.dependencies[i], p, nullptr));
  for (std::uint32_t i = 0; i < p.importer_count; ++i)
    out.push_back(part(PartKind::importer, *p.importers[i], p, p.importers[i]->cases));
}

/// Of a listed dialect only the head is known.
ShownDialect show(const Dialect& listed, Session& session) {
  ShownDialect out;
  out.name = listed.name;
  DiagnosticList unheard;  // linking reports them
  const std::optional<Dialect> dialect = session.read(listed.file.string(), unheard);
  out.declaration = describe(dialect ? *dialect : listed);
  const std::unique_ptr<LinkedDialect> linked = session.link(listed.file.string());
  if (linked == nullptr) return out;
  out.is_linked = true;
  out.chain = describe_chain(*linked);
  out.services = describe_services(*linked);
  out.codes = describe_codes(*linked);
  for (const LinkedSyntax& s : linked->chain)
    out.instances.push_back({listed.name, s.element.alias, s.syntax->id, describe_link(s, linked->layout)});
  return out;
}

void add_codes(const ShownDialect& dialect, Reference& out) {
  std::map<std::string, std::string> syntaxes;
  for (const Instance& i : dialect.instances) syntaxes[i.alias] = i.syntax;
  for (const Json& row : dialect.codes) {
    Code& code = out.codes[row["Code"].get<std::string>()];
    code.is_word = row["Kind"] == "word";
    std::vector<CodeAnswer>& answers = code.answers;
    const std::string& syntax = syntaxes[row["Syntax"].get<std::string>()];
    auto known = std::find_if(answers.begin(), answers.end(), [&](const CodeAnswer& a) { return a.syntax == syntax; });
    if (known == answers.end()) known = answers.insert(answers.end(), CodeAnswer{syntax, {}});
    if (known->dialects.empty() || known->dialects.back() != dialect.name) known->dialects.push_back(dialect.name);
  }
}

}  // namespace

Reference collect(Session& session) {
  session.library().load_all();
  Reference out;
  for (const LoadedPlugin& loaded : session.library().plugins()) {
    out.plugins.push_back(describe(loaded));
    add_parts(*loaded.plugin, out.parts);
  }
  std::stable_sort(out.parts.begin(), out.parts.end(), [](const Part& a, const Part& b) { return a.id < b.id; });
  out.fields = describe_fields(session.library());
  for (const KnownCode& known : known_codes(session.library())) out.diagnostics.push_back(describe(known));
  for (const Dialect& dialect : session.reader().list()) out.dialects.push_back(show(dialect, session));
  for (const FoundMachine& machine : session.machines()) out.machines.push_back(show_machine(machine, session));
  for (const ShownDialect& dialect : out.dialects) add_codes(dialect, out);
  return out;
}

std::vector<std::string> texts(const Json& list) {
  std::vector<std::string> out;
  for (const Json& one : list) out.push_back(one.get<std::string>());
  return out;
}

std::string text_of(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) return {};
  return found->is_string() ? found->get<std::string>() : found->dump();
}

}  // namespace isogloss::cli::docs
