#include "lsp/dialect_features.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "isogloss/engine/schema.hpp"
#include "lsp/features.hpp"
#include "lsp/tag_context.hpp"

namespace isogloss::editors {

namespace {

// CompletionItemKind of the protocol.
enum : int { item_class = 7, item_property = 10, item_value = 12 };

std::string text_or_empty(const char* text) { return text == nullptr ? "" : text; }

struct Described {
  std::string id, summary, plugin;
  const ig_option_decl* options = nullptr;
  std::uint32_t option_count = 0;
  const ig_dependency* table = nullptr;
};

std::vector<Described> parts_of(const Library& library) {
  std::vector<Described> out;
  for (const LoadedPlugin& loaded : library.plugins()) {
    const ig_plugin& p = *loaded.plugin;
    for (std::uint32_t i = 0; i < p.syntax_count; ++i) {
      const ig_syntax& s = *p.syntaxes[i];
      out.push_back({s.id, text_or_empty(s.summary), p.name, s.options, s.option_count, nullptr});
    }
    for (std::uint32_t i = 0; i < p.dependency_count; ++i) {
      const ig_dependency& d = *p.dependencies[i];
      out.push_back({d.id, text_or_empty(d.summary), p.name, d.options, d.option_count, &d});
    }
  }
  return out;
}

std::string option_doc(const ig_option_decl& o) {
  std::string out = text_or_empty(o.doc);
  if (o.unit != nullptr && *o.unit != '\0') out += fmt::format(" [{}]", o.unit);
  if (o.choices != nullptr && *o.choices != '\0') out += fmt::format("\n\nOne of {}.", o.choices);
  if (o.type == IG_OPTION_NUMBER || o.type == IG_OPTION_INTEGER) {
    if (std::isfinite(o.minimum)) out += fmt::format("\n\nAt least {}.", o.minimum);
    if (std::isfinite(o.maximum)) out += fmt::format("\n\nAt most {}.", o.maximum);
  }
  return out + (o.fallback == nullptr ? "\n\nMust be given." : fmt::format("\n\nDefault: `{}`.", o.fallback));
}

class DialectCompletion {
 public:
  DialectCompletion(const OpenDialect& dialect, std::size_t offset, const Library& library)
      : dialect_(dialect), at_(context_at(dialect.text.text(), offset)), parts_(parts_of(library)), library_(library) {}

  Json items() {
    switch (at_.part) {
      case TagContext::Part::element: add_elements(); break;
      case TagContext::Part::attribute: add_attributes(); break;
      case TagContext::Part::value: add_values(); break;
      case TagContext::Part::none: break;
    }
    return {{"isIncomplete", false}, {"items", std::move(out_)}};
  }

 private:
  void add_elements() {
    for (const Described& p : parts_) add(p.id, item_class, p.plugin, p.summary);
    for (const Described& p : parts_)
      if (p.table != nullptr && p.table->row_element != nullptr)
        add(p.table->row_element, item_class, "row of " + p.id, p.summary);
    const std::string schema = dialect_schema(library_);
    constexpr std::string_view element = "<xs:element name=\"";
    for (std::size_t at = schema.find(element); at != std::string::npos; at = schema.find(element, at + 1)) {
      const std::size_t begin = at + element.size();
      add(schema.substr(begin, schema.find('"', begin) - begin), item_class, "dialect format", "");
    }
  }

  void add_attributes() {
    for (const Described& p : parts_) {
      if (p.id == at_.element) {
        for (std::uint32_t i = 0; i < p.option_count; ++i)
          add(p.options[i].name, item_property, "option of " + p.id, option_doc(p.options[i]));
        add("as", item_property, "alias", "Another name for this part of the dialect.");
        if (p.table != nullptr) add("src", item_property, "file", "A file that holds the rows.");
      }
      if (p.table == nullptr || p.table->row_element == nullptr || at_.element != p.table->row_element) continue;
      add(text_or_empty(p.table->row_key), item_property, "key of the row", "");
      for (std::uint32_t i = 0; i < p.table->column_count; ++i) {
        const ig_column_decl& c = p.table->columns[i];
        const std::string unit = text_or_empty(c.unit);
        add(c.name, item_property, "column of " + p.id, text_or_empty(c.doc) + (unit.empty() ? "" : " [" + unit + "]"));
      }
    }
    if (!out_.empty()) return;
    for (const char* const name : {"name", "title", "extends", "syntax", "as", "pattern", "weight", "src"})
      add(name, item_property, "dialect format", "");
    // An edit of what is inherited takes the options of what it names.
    for (const Described& p : parts_)
      for (std::uint32_t i = 0; i < p.option_count && names_part(p.id); ++i)
        add(p.options[i].name, item_property, "option of " + p.id, option_doc(p.options[i]));
  }

  /// Does the tag name this part in one of its attributes?
  bool names_part(const std::string& id) const {
    const std::string& all = dialect_.text.text();
    const std::size_t open = all.rfind('<', at_.begin);
    const std::size_t close = std::min(all.find('>', at_.begin), all.size());
    return open != std::string::npos && all.substr(open, close - open).find('"' + id + '"') != std::string::npos;
  }

  void add_values() {
    for (const Described& p : parts_)
      for (std::uint32_t i = 0; i < p.option_count; ++i)
        if ((p.id == at_.element || names_part(p.id)) && at_.attribute == p.options[i].name) add_choices(p.options[i]);
    if (at_.element == "Plugin")
      for (const LoadedPlugin& p : library_.plugins()) add(p.plugin->name, item_value, "plugin", "");
    if (!out_.empty()) return;
    if (at_.attribute == "syntax" || at_.attribute == "dependency" || at_.attribute == "name")
      for (const Described& p : parts_) add(p.id, item_value, p.plugin, p.summary);
  }

  void add_choices(const ig_option_decl& o) {
    const std::string choices = o.type == IG_OPTION_BOOLEAN ? "true|false" : text_or_empty(o.choices);
    for (std::size_t begin = 0; begin < choices.size();) {
      const std::size_t end = std::min(choices.find('|', begin), choices.size());
      add(choices.substr(begin, end - begin), item_value, "option " + std::string(o.name), option_doc(o));
      begin = end + 1;
    }
  }

  void add(const std::string& label, int kind, const std::string& detail, const std::string& doc) {
    if (label.empty() || !known_.insert(label).second) return;
    Json one{{"label", label},
             {"kind", kind},
             {"detail", detail},
             {"textEdit", {{"range", to_json(dialect_.text.range_of(at_.begin, at_.end))}, {"newText", label}}}};
    if (!doc.empty()) one["documentation"] = {{"kind", "markdown"}, {"value", doc}};
    out_.push_back(std::move(one));
  }

  const OpenDialect& dialect_;
  TagContext at_;
  std::vector<Described> parts_;
  const Library& library_;
  std::set<std::string> known_;
  Json out_ = Json::array();
};

}  // namespace

bool is_dialect(std::string_view text) {
  constexpr std::size_t head = 65536;
  text = text.substr(0, head);
  for (const std::string_view root : {"<Dialect", "<Machine"})
    if (text.find(root) != std::string_view::npos) return true;
  return false;
}

Json dialect_diagnostics(const OpenDialect& dialect, const Surroundings& around) {
  Json out = Json::array();
  for (Diagnostic& d : around.toolbox.lint(dialect.path, dialect.text.text())) {
    Json related = Json::array();
    if (!d.where.file.empty() && d.where.file != dialect.path) {
      if (d.severity == Severity::note) continue;
      related.push_back(
          {{"location",
            {{"uri", uri_of(d.where.file)},
             {"range", to_json(Range{{std::max(d.where.line, 1u) - 1, 0}, {std::max(d.where.line, 1u) - 1, 0}})}}},
           {"message", d.message}});
      d.message = "in " + d.where.file + ": " + d.message;
      d.where = {dialect.path, 1, 0};
    }
    Json one = diagnostic_json(d, dialect.text, around.toolbox);
    if (!related.empty()) one["relatedInformation"] = std::move(related);
    out.push_back(std::move(one));
  }
  return out;
}

Json dialect_completion(const OpenDialect& dialect, const Position& at, const Surroundings& around) {
  return DialectCompletion(dialect, dialect.text.offset_of(at), around.toolbox.library()).items();
}

Json dialect_hover(const OpenDialect& dialect, const Position& at, const Surroundings& around) {
  const std::string& text = dialect.text.text();
  std::size_t offset = dialect.text.offset_of(at);
  while (offset < text.size() && is_xml_name(text[offset])) ++offset;
  const TagContext here = context_at(text, offset);
  if (here.part == TagContext::Part::none) return nullptr;
  std::string word = text.substr(here.begin, here.end - here.begin);
  std::string out;
  for (const Described& p : parts_of(around.toolbox.library())) {
    if (p.id == word)
      out += fmt::format("**{}** (plugin {})\n\n{}\n\nPage: `isogloss inspect {}`\n", p.id, p.plugin, p.summary, p.id);
    for (std::uint32_t i = 0; i < p.option_count; ++i)
      if (p.id == here.element && here.attribute == p.options[i].name)
        out += fmt::format("**{}** of {}\n\n{}\n", p.options[i].name, p.id, option_doc(p.options[i]));
  }
  if (out.empty()) return nullptr;
  return {{"contents", {{"kind", "markdown"}, {"value", out}}},
          {"range", to_json(dialect.text.range_of(here.begin, here.end))}};
}

Json dialect_symbols(const OpenDialect& dialect) {
  constexpr std::size_t most = 20'000;
  constexpr int kind_object = 19;
  Json out = Json::array();
  const std::string& text = dialect.text.text();
  for (std::size_t at = text.find('<'); at != std::string::npos && out.size() < most; at = text.find('<', at + 1)) {
    if (text.compare(at, 4, "<!--") == 0) {
      at = text.find("-->", at);
      if (at == std::string::npos) break;
      continue;
    }
    std::size_t end = at + 1;
    while (end < text.size() && is_xml_name(text[end])) ++end;
    if (end == at + 1) continue;
    const Json range = to_json(dialect.text.range_of(at + 1, end));
    out.push_back({{"name", text.substr(at + 1, end - at - 1)},
                   {"kind", kind_object},
                   {"range", range},
                   {"selectionRange", range}});
  }
  return out;
}

Json dialect_actions(const OpenDialect& dialect, const Range& range, const Json& context, const Surroundings& around) {
  OpenProgram as_program;
  as_program.uri = dialect.uri;
  return code_actions(as_program, range, context, around);
}

}  // namespace isogloss::editors
