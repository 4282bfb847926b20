// What the descriptor says, for people and beside other plugins.
#include <algorithm>
#include <map>
#include <set>

#include "isogloss/engine/printable.hpp"
#include "validate/option_pages.hpp"
#include "validate/subject.hpp"

namespace isogloss::cli {

namespace {

bool is_empty(const char* text) { return text == nullptr || *text == '\0'; }

std::string prefix_of(std::string_view code) { return std::string(code.substr(0, code.rfind('-'))); }

/// Of a section that the host lists, or a word, or of a list's record: the host knows how long it lives.
bool has_host_life(std::string_view path) {
  const auto section = [](std::string_view p) { return p.substr(0, p.find('.')); };
  const std::vector<FieldInfo>& all = standard_fields();
  return section(path) == "Parsing" || path.find("[].") != std::string_view::npos ||
         std::any_of(all.begin(), all.end(), [&](const FieldInfo& f) { return section(f.path) == section(path); });
}

/// Own fields that somebody of the plugin writes and nobody gives a life: they end with their block, which few want.
void check_lives(Examination& e, const Subject& subject) {
  std::map<std::string, const ig_syntax*> without;
  std::set<std::string> with;
  for (const ig_syntax* s : subject.syntaxes())
    for (std::uint32_t i = 0; i < s->field_count; ++i) {
      const ig_field_decl& f = s->fields[i];
      if (f.life != IG_LIFE_STANDARD) with.insert(f.path);
      const bool has_choice = f.type >= IG_NUMBER && f.type <= IG_SYMBOL;
      if (has_choice && (f.access & (IG_WRITE | IG_PATTERN)) == IG_WRITE && !has_host_life(f.path))
        without.emplace(f.path, s);
    }
  for (const auto& [path, syntax] : without)
    if (!with.contains(path))
      e.find(syntax->id,
             "field '" + path + "' is of no standard section and has no life: declare IG_LIFE_BLOCK, _MODAL or _FRAME");
}

}  // namespace

void check_documented(Examination& e) {
  Subject subject(e);
  std::set<std::string> with_case;
  std::map<std::string, std::string> pages;  // the texts of each syntax or importer
  DiagnosticList said;
  for (const PageText& page : pages_of(subject, e.options)) {
    const Page read = read_page(page.text, page.name, said);
    if (!read.cases.empty()) with_case.insert(read.syntax);
    pages[read.syntax] += page.text + "\n";
  }
  const auto check_options = [&](const char* id, const ig_option_decl* options, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i)
      if (is_empty(options[i].doc)) e.find(id, "option '" + std::string(options[i].name) + "' has no explanation");
    if (const auto page = pages.find(id); page != pages.end())
      for (const std::string& fault : page_faults(page->second, {options, count})) e.find(id, fault);
  };
  for (const Diagnostic& d : said.all) e.find(d.where.file, d.message + " [" + d.code + "]");
  for (const ig_syntax* s : subject.syntaxes()) {
    if (is_empty(s->summary)) e.find(s->id, "has no summary");
    if (!with_case.contains(s->id)) e.find(s->id, "has no page with a case; write one, or give --pages DIR");
    check_options(s->id, s->options, s->option_count);
  }
  const ig_plugin& plugin = subject.plugin();
  for (std::uint32_t i = 0; i < plugin.dependency_count; ++i) {
    const ig_dependency& d = *plugin.dependencies[i];
    if (is_empty(d.summary)) e.find(d.id, "has no summary");
    if (d.page != nullptr) pages[d.id] = d.page;
    check_options(d.id, d.options, d.option_count);
  }
  for (std::uint32_t i = 0; i < plugin.importer_count; ++i) {
    const ig_importer& importer = *plugin.importers[i];
    if (is_empty(importer.summary)) e.find(importer.id, "has no summary");
    if (!with_case.contains(importer.id))
      e.find(importer.id, "has no page with a case; write one, or give --pages DIR");
    check_options(importer.id, importer.options, importer.option_count);
  }
  check_lives(e, subject);
  for (const auto& [id, text] : pages)
    if (printable(text, "\n\t\r") != text) e.find(id, "its page is not UTF-8, or holds control characters");
  for (std::uint32_t i = 0; i < plugin.diagnostic_count; ++i) {
    const ig_diagnostic_decl& row = plugin.diagnostics[i];
    if (is_empty(row.explanation)) e.find(row.code, "has no explanation");
    if (is_empty(row.example)) e.find(row.code, "has no example");
  }
  if (is_empty(plugin.version)) e.find("", "the plugin has no version");
  if (is_empty(plugin.vendor)) e.find("", "the plugin has no vendor");
}

void check_prefix(Examination& e) {
  Subject subject(e);
  struct Owner {
    std::string_view plugin, text;
  };
  std::map<std::string_view, Owner> of_others;
  std::map<std::string, std::string_view> prefixes;
  for (const LoadedPlugin& other : subject.library().plugins()) {
    if (other.plugin == &subject.plugin()) continue;
    for (std::uint32_t i = 0; i < other.plugin->diagnostic_count; ++i) {
      const ig_diagnostic_decl& row = other.plugin->diagnostics[i];
      of_others.emplace(row.code, Owner{other.plugin->name, row.text});
      prefixes.emplace(prefix_of(row.code), other.plugin->name);
    }
  }
  // The headers of the SDK put the same diagnostics into each plugin that includes them: such a prefix is shared.
  std::set<std::string> shared, told;
  for (std::uint32_t i = 0; i < subject.plugin().diagnostic_count; ++i) {
    const ig_diagnostic_decl& row = subject.plugin().diagnostics[i];
    if (const auto other = of_others.find(row.code); other != of_others.end() && other->second.text == row.text)
      shared.insert(prefix_of(row.code));
  }
  for (std::uint32_t i = 0; i < subject.plugin().diagnostic_count; ++i) {
    const ig_diagnostic_decl& row = subject.plugin().diagnostics[i];
    const std::string prefix = prefix_of(row.code);
    const auto same = of_others.find(row.code);
    if (same != of_others.end() && same->second.text != row.text)
      e.find(row.code, "plugin " + std::string(same->second.plugin) + " has this code with another text");
    else if (const auto owner = prefixes.find(prefix);
             owner != prefixes.end() && !shared.contains(prefix) && told.insert(prefix).second)
      e.find(row.code, "the prefix " + prefix + " belongs to plugin " + std::string(owner->second) +
                           "; choose a prefix of your own");
  }
}

void check_unused(Examination& e) {
  Subject subject(e);
  std::map<const ig_syntax*, std::set<std::uint32_t>> unused;
  for (const Stand& stand : stands_of(subject, e)) {
    const ig_syntax& syntax = *stand.syntax;
    const std::vector<ig_field>& ids = stand.alone.linked->chain[stand.alone.position].ids;
    if (!unused.contains(&syntax))
      for (std::uint32_t i = 0; i < syntax.field_count; ++i)
        if ((syntax.fields[i].access & (IG_WRITE | IG_TAKE)) != 0 && !is_record_field(ids[i]) && ids[i] != IG_NO_FIELD)
          unused[&syntax].insert(i);
    Bench bench(stand.alone, in_mode(Mode::checked));
    for (const TestBlock& block : stand.blocks) {
      e.attempt(std::string(syntax.id) + ", " + block.name);
      bench.run(block, false);
      const Document& d = bench.chain().document();
      std::erase_if(unused[&syntax], [&](std::uint32_t i) {
        const bool is_written = d.writer(ids[i]) == stand.alone.position + 1;
        // A mode that ended is written, too: it was there before, and is gone.
        return is_written || d.taken(ids[i]) ||
               ((syntax.fields[i].access & IG_WRITE) != 0 && !d.present(ids[i]) && !block.previous.is_null());
      });
    }
  }
  for (const auto& [syntax, left] : unused) {
    std::string paths;
    for (const std::uint32_t i : left) paths += " " + std::string(syntax->fields[i].path);
    if (!left.empty()) e.find(syntax->id, "no case writes or takes these fields, which it declares:" + paths);
  }
}

}  // namespace isogloss::cli
