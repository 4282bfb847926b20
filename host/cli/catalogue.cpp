#include "catalogue.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <tuple>

#include "isogloss/engine/layout.hpp"
#include "isogloss_scan.h"
#include "new/names.hpp"

namespace isogloss::cli {

namespace {

std::string text(const char* s) { return s == nullptr ? "" : s; }

Json names(const char* const* list) {
  Json out = Json::array();
  for (; list != nullptr && *list != nullptr; ++list) out.push_back(*list);
  return out;
}

Json access_words(std::uint32_t access) {
  static constexpr std::pair<std::uint32_t, const char*> words[] = {
      {IG_REQUIRED, "required"}, {IG_READ, "read"}, {IG_WRITE, "write"},           {IG_TAKE, "take"},
      {IG_PREVIOUS, "previous"}, {IG_WAKE, "wake"}, {IG_WAKE_WHILE, "wake-while"}, {IG_ENDS_AHEAD, "ends-ahead"},
  };
  Json out = Json::array();
  for (const auto& [bit, word] : words)
    if ((access & bit) != 0) out.push_back(word);
  return out;
}

std::string_view life_name(ig_life life) {
  switch (life) {
    case IG_LIFE_WORD: return "word";
    case IG_LIFE_MODAL: return "modal";
    case IG_LIFE_BLOCK: return "block";
    case IG_LIFE_FRAME: return "frame";
    default: return "";
  }
}

std::string_view option_type_name(ig_option_type type) {
  static constexpr std::string_view table[] = {"", "text", "number", "integer", "boolean", "choice", "fields"};
  return type < std::size(table) ? table[type] : "";
}

void add_range(Json& out, double minimum, double maximum) {
  if (std::isfinite(minimum)) out["Minimum"] = minimum;
  if (std::isfinite(maximum)) out["Maximum"] = maximum;
}

void add_text(Json& out, const char* key, const char* value) {
  if (value != nullptr && *value != '\0') out[key] = value;
}

Json options(const ig_option_decl* list, std::uint32_t count) {
  Json out = Json::array();
  for (std::uint32_t i = 0; i < count; ++i) {
    const ig_option_decl& o = list[i];
    Json one{{"Name", o.name}, {"Type", option_type_name(o.type)}};
    if (o.fallback != nullptr)
      one["Default"] = o.fallback;
    else
      one["MustBeGiven"] = true;
    if (o.type == IG_OPTION_CHOICE) add_text(one, "Choices", o.choices);
    if (o.type == IG_OPTION_NUMBER || o.type == IG_OPTION_INTEGER) add_range(one, o.minimum, o.maximum);
    add_text(one, "Unit", o.unit);
    add_text(one, "Doc", o.doc);
    out.push_back(std::move(one));
  }
  return out;
}

}  // namespace

std::string_view type_name(ig_type type) {
  static constexpr std::string_view table[] = {"",     "number", "integer",   "boolean", "name",
                                               "text", "code",   "transform", "switch"};
  return type < std::size(table) ? table[type] : "";
}

bool ByNumber::operator()(const std::string& a, const std::string& b) const {
  const auto key = [](const std::string& s) {
    std::size_t letters = 0;
    while (letters < s.size() && (s[letters] < '0' || s[letters] > '9')) ++letters;
    double number = 0;
    std::from_chars(s.data() + letters, s.data() + s.size(), number);
    return std::tuple(s.substr(0, letters), number, s);
  };
  return key(a) < key(b);
}

Json describe(const LoadedPlugin& p) {
  return {{"Name", p.plugin->name},
          {"Version", text(p.plugin->version)},
          {"Vendor", text(p.plugin->vendor)},
          {"Contract", fmt::format("{}.{}", p.plugin->abi_major, p.plugin->abi_minor)},
          {"BuiltWith", text(p.plugin->built_with)},
          {"Syntaxes", p.plugin->syntax_count},
          {"Dependencies", p.plugin->dependency_count},
          {"Diagnostics", p.plugin->diagnostic_count},
          {"File", p.file.string()}};
}

Json describe(const KnownCode& known) {
  return {{"Code", known.info.code}, {"Severity", to_string(known.info.severity)}, {"Plugin", known.plugin},
          {"Text", known.info.text}, {"Explanation", known.info.explanation},      {"Example", known.info.example}};
}

Json describe(const ig_syntax& s, const ig_plugin& plugin) {
  Json out{{"Id", s.id}, {"Plugin", plugin.name}, {"Summary", text(s.summary)}, {"HasPage", s.page != nullptr}};
  out["After"] = names(s.after);
  out["Before"] = names(s.before);
  add_text(out, "ExclusiveSlot", s.exclusive_slot);
  add_text(out, "FirstWriterSlot", s.first_writer_slot);
  add_text(out, "Scans", s.triggers);
  if ((s.scan_flags & IG_SCANS_AHEAD) != 0) out["ScansAhead"] = true;
  if (s.look_ahead != 0) out["LookAhead"] = s.look_ahead;
  if (s.inspects != 0) out["Inspects"] = true;
  Json services = Json::array();
  for (std::uint32_t i = 0; i < s.service_count; ++i)
    services.push_back({{"Id", s.services[i].id}, {"Optional", s.services[i].is_optional != 0}});
  out["Services"] = std::move(services);
  out["Options"] = options(s.options, s.option_count);
  Json fields = Json::array();
  for (std::uint32_t i = 0; i < s.field_count; ++i) {
    const ig_field_decl& f = s.fields[i];
    Json one{{"Path", f.path}, {"Type", type_name(f.type)}, {"Access", access_words(f.access)}};
    add_text(one, "Unit", f.unit);
    if (f.wake_value != nullptr) one["WakeValue"] = f.wake_value;
    add_text(one, "Doc", f.doc);
    fields.push_back(std::move(one));
  }
  out["Fields"] = std::move(fields);
  return out;
}

Json describe(const ig_dependency& d, const ig_plugin& plugin) {
  Json out{{"Id", d.id}, {"Plugin", plugin.name}, {"Summary", text(d.summary)}, {"HasPage", d.page != nullptr}};
  out["Provides"] = names(d.provides);
  out["Options"] = options(d.options, d.option_count);
  if (d.row_element == nullptr) return out;
  Json columns = Json::array();
  for (std::uint32_t i = 0; i < d.column_count; ++i) {
    const ig_column_decl& c = d.columns[i];
    Json one{{"Name", c.name}, {"Type", c.is_text != 0 ? "text" : "number"}};
    if (c.fallback != nullptr) one["Default"] = c.fallback;
    if (c.is_text == 0) add_range(one, c.minimum, c.maximum);
    add_text(one, "Unit", c.unit);
    add_text(one, "Doc", c.doc);
    columns.push_back(std::move(one));
  }
  Json rows = Json::array();
  for (std::uint32_t i = 0; i < d.default_row_count; ++i) rows.push_back(d.default_rows[i]);
  out["Row"] = d.row_element;
  out["Key"] = text(d.row_key);
  out["Columns"] = std::move(columns);
  out["ShippedRows"] = std::move(rows);
  return out;
}

Json describe(const ig_importer& importer, const ig_plugin& plugin) {
  Json out{{"Id", importer.id},
           {"Plugin", plugin.name},
           {"Summary", text(importer.summary)},
           {"HasPage", importer.page != nullptr}};
  add_text(out, "Files", importer.files);
  out["Tables"] = names(importer.dependencies);
  out["Writes"] = importer.write != nullptr;
  out["Options"] = options(importer.options, importer.option_count);
  return out;
}

Json describe(const Dialect& d) {
  Json out{{"Name", d.name}, {"Title", d.title}, {"File", d.file.string()}};
  out["Extends"] = d.ancestors;
  out["Extensions"] = d.extensions;
  out["Signatures"] = Json::array();
  for (const Signature& s : d.signatures) out["Signatures"].push_back({{"Pattern", s.pattern}, {"Weight", s.weight}});
  out["Names"] = Json::array();
  for (const Signature& s : d.names) out["Names"].push_back({{"Pattern", s.pattern}, {"Weight", s.weight}});
  out["Segmenter"] = d.segmenter.type;
  if (!d.segmenter.continuation.empty()) out["Continuation"] = d.segmenter.continuation;
  const auto attributes = [](const std::vector<Attribute>& list) {
    Json o = Json::object();
    for (const Attribute& a : list) o[a.name] = a.value;
    return o;
  };
  Json plugins = Json::array(), dependencies = Json::array(), initial = Json::object(), chain = Json::array();
  for (const PluginReference& p : d.plugins) plugins.push_back(p.name);
  for (const DependencyElement& e : d.dependencies)
    dependencies.push_back(
        {{"Id", e.id}, {"As", e.alias}, {"Options", attributes(e.options)}, {"Rows", e.rows.size()}});
  for (const InitialField& f : d.initial) initial[f.path] = f.value;
  for (const ChainElement& e : d.chain)
    chain.push_back(
        {{"Stage", to_string(e.stage)}, {"Syntax", e.syntax}, {"As", e.alias}, {"Options", attributes(e.options)}});
  out["Plugins"] = std::move(plugins);
  out["Dependencies"] = std::move(dependencies);
  out["Initial"] = std::move(initial);
  out["Chain"] = std::move(chain);
  return out;
}

Json describe_services(const LinkedDialect& linked) {
  Json out = Json::array();
  for (const Provision& p : provisions(linked)) {
    const auto alias = [&](std::size_t i) { return linked.dependencies[p.dependencies[i]].element.alias; };
    Json others = Json::array();
    for (std::size_t i = 1; i < p.dependencies.size(); ++i) others.push_back(alias(i));
    out.push_back({{"Service", p.service}, {"Answers", alias(0)}, {"Not asked", std::move(others)}});
  }
  return out;
}

Json describe_fields(const Library& library) {
  std::map<std::string, Json> fields;
  const auto field = [&](const std::string& path, ig_type type, ig_life life, std::string_view unit,
                         std::string_view doc) -> Json& {
    Json& f = fields[path];
    if (f.is_null()) {
      f = {{"Path", path}, {"Type", type_name(type)}};
      for (const char* const role : {"Readers", "Writers", "Takers"}) f[role] = Json::array();
    }
    if (life != IG_LIFE_STANDARD && !f.contains("Life")) f["Life"] = life_name(life);
    if (!unit.empty() && !f.contains("Unit")) f["Unit"] = unit;
    if (!doc.empty() && !f.contains("Doc")) f["Doc"] = doc;
    return f;
  };
  for (const FieldInfo& f : standard_fields()) field(f.path, f.type, f.life, f.unit, f.doc);
  for (const ListInfo& list : standard_lists())
    for (const FieldInfo& f : list.fields) field(list.path + "[]." + f.path, f.type, IG_LIFE_BLOCK, f.unit, f.doc);
  for (const LoadedPlugin& loaded : library.plugins())
    for (std::uint32_t i = 0; i < loaded.plugin->syntax_count; ++i) {
      const ig_syntax& s = *loaded.plugin->syntaxes[i];
      for (std::uint32_t k = 0; k < s.field_count; ++k) {
        const ig_field_decl& d = s.fields[k];
        if ((d.access & IG_PATTERN) != 0) continue;
        Json& f = field(d.path, d.type, d.life, d.unit, d.doc);
        const auto note = [&](const char* role) {
          if (f[role].empty() || f[role].back() != s.id) f[role].push_back(s.id);
        };
        if ((d.access & (IG_READ | IG_PREVIOUS)) != 0) note("Readers");
        if ((d.access & IG_WRITE) != 0) note("Writers");
        if ((d.access & IG_TAKE) != 0) note("Takers");
      }
    }
  Json out = Json::array();
  for (auto& [path, f] : fields) out.push_back(std::move(f));
  return out;
}

/// "iso/cycles/drilling_cycle_syntax.md"
std::string page_of(const LinkedSyntax& s) {
  const std::string folder = s.syntax->folder != nullptr ? std::string(s.syntax->folder) + "/" : "";
  return fmt::format("{}/{}{}.md", s.plugin->name, folder, snake_case(s.syntax->id));
}

Json describe_codes(const LinkedDialect& linked) {
  constexpr std::string_view parsing = "Parsing.", flags = "Parsing.Flags.";
  const std::vector<FieldInfo>& fields = linked.layout.fields;
  std::map<std::string, ig_field, ByNumber> fields_by_name;
  std::map<std::string, Json> words;
  for (ig_field f = 0; f < fields.size(); ++f) {
    const FieldInfo& field = fields[f];
    const bool is_code = field.type == IG_CODE;
    if (field.hidden || !field.path.starts_with(parsing) || (!is_code && field.life != IG_LIFE_WORD)) continue;
    const std::string name = field.path.substr(field.path.starts_with(flags) ? flags.size() : parsing.size());
    const std::size_t dot = is_code ? std::string::npos : name.rfind('.');
    if (dot == std::string::npos)
      fields_by_name.emplace(name, f);
    else
      words[name.substr(0, dot)].push_back(name.substr(dot + 1));
  }
  Json out = Json::array();
  for (const auto& [name, f] : fields_by_name)
    for (const LinkedSyntax& s : linked.chain) {
      if ((s.may_take[f >> 6] >> (f & 63) & 1) == 0) continue;
      Json row{{"Code", name},
               {"Kind", fields[f].type == IG_CODE ? "code" : "word"},
               {"Syntax", s.element.alias},
               {"Page", page_of(s)}};
      if (!fields[f].unit.empty()) row["Unit"] = fields[f].unit;
      if (const auto own = words.find(name); own != words.end()) row["Words"] = own->second;
      out.push_back(std::move(row));
    }
  return out;
}

Json describe_link(const LinkedSyntax& s, const Layout& layout) {
  Json options = Json::object(), patterns = Json::object();
  for (std::uint32_t i = 0; i < s.syntax->option_count; ++i) options[s.syntax->options[i].name] = s.options[i].text;
  for (std::uint32_t i = 0; i < s.expansions.size(); ++i) {
    if (s.expansions[i].empty()) continue;
    Json& list = patterns[s.syntax->fields[i].path];
    for (const ig_field f : s.expansions[i]) list.push_back(layout.fields[f].path);
  }
  return {{"As", s.element.alias},        {"Stage", to_string(s.element.stage)}, {"File", s.element.where.file},
          {"Line", s.element.where.line}, {"Options", std::move(options)},       {"Patterns", std::move(patterns)}};
}

}  // namespace isogloss::cli
