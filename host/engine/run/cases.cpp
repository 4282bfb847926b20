// A syntax alone is a chain of which only one syntax is built: the others give the vocabulary, so that patterns and
// scanners know the same words as in the whole chain.
#include "isogloss/engine/cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <stdexcept>

#include "document/json_difference.hpp"
#include "isogloss/engine/chain.hpp"
#include "isogloss/engine/document_json.hpp"

namespace isogloss {

namespace {

std::string_view trimmed(std::string_view s) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!s.empty() && blank(s.front())) s.remove_prefix(1);
  while (!s.empty() && blank(s.back())) s.remove_suffix(1);
  return s;
}

class PageReader {
 public:
  PageReader(const std::string& file, DiagnosticSink& sink) : file_(file), sink_(sink) {}

  Page read(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = text.find('\n');
      line(text.substr(0, end));
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    if (inside_) fault(fence_.line, "a fence is not closed");
    close_case();
    return std::move(page_);
  }

 private:
  void line(std::string_view raw) {
    ++line_;
    const std::string_view text = trimmed(raw);
    if (inside_) {
      if (text.starts_with("```"))
        close_fence();
      else
        (fence_.text += raw) += '\n';
    } else if (text.starts_with("```")) {
      inside_ = true;
      fence_ = {"", line_ + 1};
    } else if (text.starts_with("## ")) {
      close_case();
      heading_ = text.substr(3);
    } else if (text.starts_with("# ")) {
      if (page_.syntax.empty()) page_.syntax = trimmed(text.substr(2));
    } else if (text == "#Diagnostics: any") {
      begin_case();
      case_.says_anything = true;
    } else if (std::optional<Fence>* const wanted = marker(text)) {
      awaited_ = wanted;
    }
  }

  /// The member that a marker line fills; a marker that was filled already begins the next case.
  std::optional<Fence>* marker(std::string_view text) {
    static constexpr std::pair<std::string_view, std::optional<Fence> Case::*> markers[] = {
        {"#Previous:", &Case::previous},  {"#Ahead:", &Case::ahead},      {"#Dependencies:", &Case::dependencies},
        {"#BeforeBuild:", &Case::before}, {"#AfterBuild:", &Case::after}, {"#Diagnostics:", &Case::diagnostics},
    };
    for (const auto& [name, member] : markers) {
      if (text != name) continue;
      if ((case_.*member).has_value()) close_case();
      begin_case();
      return &(case_.*member);
    }
    return nullptr;
  }

  void begin_case() {
    if (case_.line == 0) case_.line = line_;
  }

  void close_fence() {
    inside_ = false;
    if (awaited_ != nullptr) *awaited_ = std::move(fence_);
    awaited_ = nullptr;
  }

  void close_case() {
    awaited_ = nullptr;
    Case done = std::move(case_);
    case_ = {};
    if (done.line == 0) return;
    if (!done.before) return fault(done.line, "a case without #BeforeBuild: and its fence");
    if (!done.after) return fault(done.line, "a case without #AfterBuild: and its fence");
    done.heading = heading_;
    page_.cases.push_back(std::move(done));
  }

  void fault(std::uint32_t at, std::string what) {
    sink_.add(host_diagnostic("IG-0501", {file_, at, 0}, {std::move(what)}));
  }

  const std::string& file_;
  DiagnosticSink& sink_;
  Page page_;
  Case case_;
  Fence fence_;
  std::string heading_;
  std::optional<Fence>* awaited_ = nullptr;
  std::uint32_t line_ = 0;
  bool inside_ = false;
};

/// The XML beside a case, as text.
struct CaseDependencies {
  std::vector<Attribute> options;
  std::vector<DependencyElement> dependencies;
  std::map<std::string, std::string, std::less<>> settings;
};

std::vector<Attribute> attributes(const pugi::xml_node& node, const Location& where) {
  std::vector<Attribute> out;
  for (const pugi::xml_attribute& a : node.attributes()) out.push_back({a.name(), a.value(), where});
  return out;
}

/// Throws std::runtime_error when the text is not XML.
CaseDependencies read_dependencies(const std::string& xml, const std::string& syntax, const Location& where) {
  CaseDependencies out;
  if (trimmed(xml).empty()) return out;
  pugi::xml_document document;
  const pugi::xml_parse_result parsed =
      document.load_buffer(xml.data(), xml.size(), pugi::parse_default | pugi::parse_fragment);
  if (!parsed) throw std::runtime_error(std::string("the dependencies are no XML: ") + parsed.description());
  pugi::xml_node parent = document;
  if (const pugi::xml_node wrapper = document.child("Dependencies")) parent = wrapper;
  for (const pugi::xml_node& node : parent.children()) {
    if (node.type() != pugi::node_element) continue;
    const std::string name = node.name();
    if (name == syntax) {
      out.options = attributes(node, where);
    } else if (name == "Settings") {
      for (const pugi::xml_attribute& a : node.attributes()) out.settings[a.name()] = a.value();
    } else {
      DependencyElement element{name, name, attributes(node, where), {}, {}, where};
      for (const pugi::xml_node& row : node.children())
        if (row.type() == pugi::node_element) element.rows.push_back({row.name(), attributes(row, where), where});
      out.dependencies.push_back(std::move(element));
    }
  }
  return out;
}

Stage stage_of(const ig_syntax& syntax) {
  if (syntax.inspects != 0) return Stage::inspection;
  if (syntax.look_ahead != 0) return Stage::post_logic;
  return syntax.scan != nullptr ? Stage::parsing : Stage::logic;
}

ChainElement element_of(const ig_syntax& syntax, const Location& where) {
  return {stage_of(syntax), syntax.id, syntax.id, {}, true, where};
}

bool has_plugin(const Dialect& dialect, std::string_view name) {
  return std::any_of(dialect.plugins.begin(), dialect.plugins.end(),
                     [&](const PluginReference& p) { return p.name == name; });
}

/// The dialect around one syntax. `alias` becomes the place to look for it in the chain.
Dialect surround(const ig_syntax& syntax, const ig_plugin& plugin, const Surroundings& around,
                 const CaseDependencies& own, const Location& where, std::string& alias, Library& library) {
  Dialect d;
  if (around.dialect) {
    d = *around.dialect;
    d.initial.clear();
    if (!around.is_named) {
      // The default surroundings must not hinder a plugin that is being written.
      std::erase_if(d.plugins, [&](const PluginReference& p) { return library.find(p.name) == nullptr; });
      std::erase_if(d.chain, [&](const ChainElement& e) { return library.syntax(e.syntax) == nullptr; });
      std::erase_if(d.dependencies, [&](const DependencyElement& e) { return library.dependency(e.id) == nullptr; });
    }
  } else {
    d.name = plugin.name;
    for (std::uint32_t i = 0; i < plugin.syntax_count; ++i) d.chain.push_back(element_of(*plugin.syntaxes[i], where));
  }
  if (!has_plugin(d, plugin.name)) d.plugins.push_back({plugin.name, where});

  const auto named = [&](const ChainElement& e) { return e.alias == alias; };
  const auto same = [&](const ChainElement& e) { return e.syntax == syntax.id; };
  auto at = std::find_if(d.chain.begin(), d.chain.end(), named);
  if (at == d.chain.end()) at = std::find_if(d.chain.begin(), d.chain.end(), same);
  if (at == d.chain.end()) at = d.chain.insert(d.chain.end(), element_of(syntax, where));
  if (!around.is_named) at->options.clear();
  for (const Attribute& option : own.options) {
    std::erase_if(at->options, [&](const Attribute& a) { return a.name == option.name; });
    at->options.push_back(option);
  }
  alias = at->alias;
  std::stable_sort(d.chain.begin(), d.chain.end(),
                   [](const ChainElement& a, const ChainElement& b) { return a.stage < b.stage; });

  std::vector<DependencyElement> dependencies = own.dependencies;
  for (const DependencyElement& e : own.dependencies) {
    const ig_plugin* owner = nullptr;
    if (library.dependency(e.id, &owner) != nullptr && !has_plugin(d, owner->name))
      d.plugins.push_back({owner->name, where});
  }
  for (const DependencyElement& inherited : d.dependencies) {
    const bool replaced = std::any_of(own.dependencies.begin(), own.dependencies.end(),
                                      [&](const DependencyElement& e) { return e.alias == inherited.alias; });
    if (!replaced) dependencies.push_back(inherited);
  }
  d.dependencies = std::move(dependencies);
  return d;
}

std::string id_of_alias(const std::string& name, const Surroundings& around) {
  if (around.dialect)
    for (const ChainElement& e : around.dialect->chain)
      if (e.alias == name) return e.syntax;
  return name;
}

std::vector<std::string> syntax_ids(const Library& library) {
  std::vector<std::string> ids;
  for (const LoadedPlugin& loaded : library.plugins())
    for (std::uint32_t i = 0; i < loaded.plugin->syntax_count; ++i) ids.emplace_back(loaded.plugin->syntaxes[i]->id);
  return ids;
}

bool is_list_of_objects(const Json& json) {
  return json.is_array() && std::all_of(json.begin(), json.end(), [](const Json& one) { return one.is_object(); });
}

/// No real block is nested so deep, and the walk through the objects is recursive.
constexpr int deepest_json = 100;

struct TooDeep {};

Json parse_json(const std::string& text, const Location& where, DiagnosticSink& sink, bool wants_list = false) {
  try {
    Json json = Json::parse(text, [](int depth, Json::parse_event_t, const Json&) -> bool {
      if (depth > deepest_json) throw TooDeep();
      return true;
    });
    if (wants_list ? is_list_of_objects(json) : json.is_object()) return json;
    sink.add(host_diagnostic("IG-0502", where, {wants_list ? "it is not a list of objects" : "it is not an object"}));
  } catch (const Json::parse_error& e) {
    const std::size_t before = std::min(e.byte == 0 ? 0 : e.byte - 1, text.size());
    const auto lines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(before), '\n');
    Location at = where;
    if (at.line != 0) at.line += static_cast<std::uint32_t>(lines);
    const std::string_view what = e.what();
    const std::size_t detail = what.find("] ");
    sink.add(host_diagnostic("IG-0502", at,
                             {std::string(detail == std::string_view::npos ? what : what.substr(detail + 2))}));
  } catch (const TooDeep&) {
    sink.add(host_diagnostic("IG-0502", where,
                             {"its objects are nested more than " + std::to_string(deepest_json) + " deep"}));
  } catch (const Json::out_of_range&) {
    sink.add(host_diagnostic("IG-0502", where, {"it holds a number beyond 1.8e308"}));
  }
  return Json();
}

void merge(Json& into, const Json& from) {
  for (const auto& [key, value] : from.items()) {
    if (value.is_structured() && value.empty()) continue;
    if (value.is_object() && into.contains(key) && into[key].is_object())
      merge(into[key], value);
    else
      into[key] = value;
  }
}

/// One chain, ready for one build of one of its syntaxes.
class Bench {
 public:
  Bench(const LinkedDialect& linked, std::uint32_t position, ChainSettings settings, DiagnosticSink& sink)
      : chain_(linked, std::move(settings), sink), position_(position), syntax_(*linked.chain[position].syntax) {}

  Json run(Json before, const Json* previous, const Json& ahead) {
    if (previous != nullptr) {
      chain_.begin_block({"previous", 1, 0, ""});
      load_json(*previous, chain_.document(), chain_.symbols());
    }
    std::string text;
    if (const auto unparsed = before.find("UnparsedText"); unparsed != before.end() && unparsed->is_string()) {
      text = unparsed->get<std::string>();
      if (syntax_.scan != nullptr) before.erase("UnparsedText");
    }
    chain_.begin_block({"block", 2, 0, text});
    Document& document = chain_.document();
    const Json unknown = load_json(before, document, chain_.symbols());
    if (syntax_.scan != nullptr) chain_.scan_with(position_);
    if (!ahead.empty()) return run_before(ahead, before, unknown);
    return finish(document, before, unknown);
  }

 private:
  Json finish(Document& document, const Json& before, const Json& unknown) {
    // Through run(), not build(): the checked chain then checks the result against the contract.
    if (syntax_.build != nullptr) chain_.wake(document, position_);
    chain_.run(document, position_, position_ + 1);

    std::set<std::string> sections = written_sections(document, static_cast<std::uint16_t>(position_ + 1));
    for (const auto& [section, value] : before.items()) sections.insert(section);
    if (syntax_.scan != nullptr) sections.insert("UnparsedText");
    Json after = show_json(document, chain_.symbols(), &sections);
    merge(after, unknown);
    return after.is_null() ? Json::object() : after;
  }

  /// The chain goes on to the blocks ahead, as in a run; the build then sees copies of them.
  Json run_before(const Json& ahead, const Json& before, const Json& unknown) {
    const auto block = std::make_unique<Document>(chain_.document());
    std::vector<std::unique_ptr<Document>> window;
    for (const Json& next : ahead) {
      chain_.begin_block({"ahead", static_cast<std::uint32_t>(window.size() + 3), 0, ""});
      load_json(next, chain_.document(), chain_.symbols());
      window.push_back(std::make_unique<Document>(chain_.document()));
      chain_.window.push_back(window.back().get());
    }
    Json after = finish(*block, before, unknown);
    chain_.window.clear();
    return after;
  }

  Chain chain_;
  std::uint32_t position_;
  const ig_syntax& syntax_;
};

}  // namespace

Page read_page(std::string_view text, const std::string& file, DiagnosticSink& sink) {
  return PageReader(file, sink).read(text);
}

std::optional<std::string> apply(const Application& application, const Surroundings& surroundings, Library& library,
                                 DiagnosticSink& sink) {
  const ig_plugin* plugin = nullptr;
  const std::string id = id_of_alias(application.syntax, surroundings);
  const ig_syntax* const syntax = library.syntax(id, &plugin);
  if (syntax == nullptr) {
    const std::string near = nearest_name(id, syntax_ids(library));
    sink.add(host_diagnostic("IG-0504", application.where, {id}, near.empty() ? "" : "did you mean " + near + "?"));
    return std::nullopt;
  }
  const Json before = parse_json(application.before, application.where, sink);
  Json previous;
  if (application.previous) previous = parse_json(*application.previous, application.where, sink);
  Json ahead;
  if (application.ahead) ahead = parse_json(*application.ahead, application.where, sink, true);
  if (before.is_null() || (application.previous && previous.is_null()) || (application.ahead && ahead.is_null()))
    return std::nullopt;

  try {
    const CaseDependencies own = read_dependencies(application.dependencies, id, application.where);
    std::string alias = application.syntax;
    const Dialect dialect = surround(*syntax, *plugin, surroundings, own, application.where, alias, library);
    const std::unique_ptr<LinkedDialect> linked = link(dialect, library, sink, LinkMode::parts);
    if (linked == nullptr) return std::nullopt;
    ChainSettings settings;
    settings.mode = Mode::checked;
    settings.settings = surroundings.settings;
    for (const auto& [name, value] : own.settings) settings.settings[name] = value;
    Bench bench(*linked, linked->position(alias).value(), std::move(settings), sink);
    return bench.run(before, application.previous ? &previous : nullptr, ahead).dump(2);
  } catch (const std::exception& e) {
    sink.add(host_diagnostic("IG-0503", application.where, {e.what()}));
    return std::nullopt;
  }
}

std::string run_case(const Page& page, const Case& one, const std::string& file, const Surroundings& surroundings,
                     Library& library) {
  DiagnosticList said;
  Application application{page.syntax, one.before->text, {}, {}, {file, one.before->line, 0}};
  if (one.previous) application.previous = one.previous->text;
  if (one.ahead) application.ahead = one.ahead->text;
  if (one.dependencies) application.dependencies = one.dependencies->text;
  const std::optional<std::string> after = apply(application, surroundings, library, said);

  std::string out;
  if (after) {
    const Json expected = parse_json(one.after->text, {file, one.after->line, 0}, said);
    if (!expected.is_null()) out = json_difference(expected, Json::parse(*after));
  }
  std::vector<std::string> codes, wanted;
  for (const Diagnostic& d : said.all) {
    const bool is_host = d.code.starts_with("IG-");
    if (!is_host) codes.push_back(d.code);
    if (is_host && d.severity == Severity::error)
      out += fmt::format("  {}: {} [{}]\n", to_string(d.severity), d.message, d.code);
  }
  if (one.diagnostics) {
    std::string_view rest = one.diagnostics->text;
    while (!rest.empty()) {
      const std::size_t begin = rest.find_first_not_of(" \t\r\n,");
      if (begin == std::string_view::npos) break;
      const std::size_t end = std::min(rest.find_first_of(" \t\r\n,", begin), rest.size());
      wanted.emplace_back(rest.substr(begin, end - begin));
      rest.remove_prefix(end);
    }
  }
  if (!one.says_anything && wanted != codes) {
    const auto list = [](const std::vector<std::string>& all) {
      return all.empty() ? std::string("none") : fmt::format("{}", fmt::join(all, " "));
    };
    out += fmt::format("  diagnostics: expected {}, got {}\n", list(wanted), list(codes));
  }
  if (!out.empty() && after) out += "  the document after the build:\n" + *after + "\n";
  return out;
}

}  // namespace isogloss
