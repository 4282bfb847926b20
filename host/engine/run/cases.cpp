// A syntax alone is a chain of which only one syntax is built: the others give the vocabulary, so that patterns and
// scanners know the same words as in the whole chain.
#include "isogloss/engine/cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>

#include "document/json_difference.hpp"
#include "isogloss/engine/chain.hpp"
#include "isogloss/engine/document_json.hpp"
#include "run/case_dialect.hpp"
#include "run/import_case.hpp"

namespace isogloss {

namespace {

std::string id_of_alias(const std::string& name, const Surroundings& around) {
  if (around.dialect)
    for (const ChainElement& e : around.dialect->chain)
      if (e.alias == name) return e.syntax;
  return name;
}

/// What may have been meant, or why it may be missing.
std::string hint_for_missing(const std::string& id, const Library& library) {
  std::vector<std::string> out;
  if (const std::string near = nearest_name(id, library.syntax_ids()); !near.empty())
    out.push_back("did you mean " + near + "?");
  for (const RefusedPlugin& refused : library.refused())  // a second plugin of one name is none that is missing
    if (refused.code != "IG-0306") out.push_back(fmt::format("not loaded: {} [{}]", refused.reason, refused.code));
  return fmt::format("{}", fmt::join(out, "; "));
}

bool is_list_of_objects(const Json& json) {
  return json.is_array() && std::all_of(json.begin(), json.end(), [](const Json& one) { return one.is_object(); });
}

/// No real block is nested so deep, and the walk through the objects is recursive.
constexpr int deepest_json = 100;

/// Objects keep the order of their names and look for each one from the first: more of them would take hours.
constexpr std::size_t most_names = 10'000;

struct TooMuch {
  std::string what;
};

/// Called by the parser for each part that it has read.
class JsonLimits {
 public:
  bool operator()(int depth, Json::parse_event_t event, const Json&) {
    const auto level = static_cast<std::size_t>(depth);
    if (depth > deepest_json)
      throw TooMuch{"its objects are nested more than " + std::to_string(deepest_json) + " deep"};
    if (event == Json::parse_event_t::object_start) names_[level + 1] = 0;
    if (event == Json::parse_event_t::key && ++names_[level] > most_names)
      throw TooMuch{"one of its objects has more than " + std::to_string(most_names) + " names"};
    return true;
  }

 private:
  std::array<std::size_t, deepest_json + 2> names_{};  // of the object of each level
};

/// What the parser says without the place, which counts from the begin of the text: "[json.exception.parse_error.101]
/// parse error at line 2, column 1: syntax error while …".
std::string fault_of(std::string_view what) {
  for (const std::string_view end_of_head : {"] ", ": "})
    if (const std::size_t at = what.find(end_of_head); at != std::string_view::npos)
      what.remove_prefix(at + end_of_head.size());
  return std::string(what);
}

Json parse_json(const std::string& text, const Location& where, DiagnosticSink& sink, bool wants_list = false) {
  try {
    Json json = Json::parse(text, JsonLimits());
    if (wants_list ? is_list_of_objects(json) : json.is_object()) return json;
    sink.add(host_diagnostic("IG-0502", where, {wants_list ? "it is not a list of objects" : "it is not an object"}));
  } catch (const Json::parse_error& e) {
    const std::size_t before = std::min(e.byte == 0 ? 0 : e.byte - 1, text.size());
    const auto lines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(before), '\n');
    Location at = where;
    if (at.line != 0) {
      at.line += static_cast<std::uint32_t>(lines);
      const std::size_t begin_of_line = before == 0 ? 0 : text.rfind('\n', before - 1) + 1;
      at.column = static_cast<std::uint32_t>(before - begin_of_line + 1);
    }
    sink.add(host_diagnostic("IG-0502", at, {fault_of(e.what())}));
  } catch (const TooMuch& limit) {
    sink.add(host_diagnostic("IG-0502", where, {limit.what}));
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

const Json* find(const Json* json, const std::string& key) {
  if (json == nullptr || !json->is_object()) return nullptr;
  const auto found = json->find(key);
  return found == json->end() ? nullptr : &*found;
}

/// The keys that lead to nulls.
void collect_erased(const Json& expected, std::vector<std::string>& keys, std::vector<std::vector<std::string>>& out) {
  for (const auto& [key, value] : expected.items()) {
    keys.push_back(key);
    if (value.is_null()) out.push_back(keys);
    if (value.is_object()) collect_erased(value, keys, out);
    keys.pop_back();
  }
}

/// Takes the nulls out of `expected` of which `got` has nothing, and the objects that held nothing else.
void drop_erased(Json& expected, const Json* got) {
  for (auto at = expected.begin(); at != expected.end();) {
    const Json* const other = find(got, at.key());
    const bool holds_values = at->is_object() && !at->empty();
    if (holds_values) drop_erased(*at, other);
    const bool is_erased = other == nullptr && (at->is_null() || (holds_values && at->empty()));
    if (is_erased)
      at = expected.erase(at);
    else
      ++at;
  }
}

/// A fault of the case or of its run, for people.
std::string fault_text(const Diagnostic& d) {
  const std::string place = d.where.column != 0 ? fmt::format("{}:{}:{}: ", d.where.file, d.where.line, d.where.column)
                            : d.where.line != 0 ? fmt::format("{}:{}: ", d.where.file, d.where.line)
                                                : "";
  return fmt::format("  {}{}: {} [{}]\n", place, to_string(d.severity), d.message, d.code) +
         (d.hint.empty() ? "" : fmt::format("    hint: {}\n", d.hint));
}

/// One chain, ready for one build of one of its syntaxes.
class Bench {
 public:
  Bench(const LinkedDialect& linked, std::uint32_t position, ChainSettings settings, const Application& application,
        DiagnosticSink& sink)
      : chain_(linked, std::move(settings), sink),
        position_(position),
        syntax_(*linked.chain[position].syntax),
        application_(application),
        sink_(sink) {}

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
    report_never_there(document);
    // Through run(), not build(): the checked chain then checks the result against the contract.
    if (syntax_.build != nullptr) chain_.wake(document, position_);
    chain_.run(document, position_, position_ + 1);

    std::set<std::string> sections = written_sections(document, static_cast<std::uint16_t>(position_ + 1));
    for (const auto& [section, value] : before.items()) sections.insert(section);
    if (syntax_.scan != nullptr) sections.insert("UnparsedText");
    for (const std::vector<std::string>& keys : application_.erased) sections.insert(keys.front());
    Json after = show_json(document, chain_.symbols(), &sections);
    merge(after, unknown);
    return after.is_null() ? Json::object() : after;
  }

  /// A null that names nothing would hold whatever the syntax does.
  void report_never_there(const Document& document) {
    if (application_.erased.empty()) return;
    const Json before = show_json(document, chain_.symbols());
    for (const std::vector<std::string>& keys : application_.erased) {
      const Json* value = &before;
      for (const std::string& key : keys) value = find(value, key);
      if (value == nullptr)
        sink_.add(host_diagnostic(
            "IG-0501", application_.where,
            {fmt::format("#AfterBuild: has null for {}, which is not there before the build", fmt::join(keys, "."))}));
    }
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
  const Application& application_;
  DiagnosticSink& sink_;
};

}  // namespace

std::optional<std::string> apply(const Application& application, const Surroundings& surroundings, Library& library,
                                 DiagnosticSink& sink) {
  const ig_plugin* plugin = nullptr;
  const std::string id = id_of_alias(application.syntax, surroundings);
  const ig_syntax* const syntax = library.syntax(id, &plugin);
  if (syntax == nullptr) {
    sink.add(host_diagnostic("IG-0504", application.where, {id}, hint_for_missing(id, library)));
    return std::nullopt;
  }
  const Json before = parse_json(application.before, application.where, sink);
  Json previous;
  const auto place = [&](const Location& own) { return own.file.empty() ? application.where : own; };
  if (application.previous) previous = parse_json(*application.previous, place(application.previous_at), sink);
  Json ahead;
  if (application.ahead) ahead = parse_json(*application.ahead, place(application.ahead_at), sink, true);
  if (before.is_null() || (application.previous && previous.is_null()) || (application.ahead && ahead.is_null()))
    return std::nullopt;

  const Location at = place(application.dependencies_at);
  const auto own = read_case_dependencies(application.dependencies, id, at, sink);
  if (!own) return std::nullopt;
  try {
    std::string alias = application.syntax;
    Dialect dialect = surround(*syntax, *plugin, surroundings, *own, at, alias, library);
    const std::unique_ptr<LinkedDialect> linked = link(std::move(dialect), library, sink, LinkMode::parts);
    if (linked == nullptr) return std::nullopt;
    ChainSettings settings;
    settings.mode = Mode::checked;
    settings.settings = surroundings.settings;
    for (const auto& [name, value] : own->settings) settings.settings[name] = value;
    Bench bench(*linked, linked->position(alias).value(), std::move(settings), application, sink);
    return bench.run(before, application.previous ? &previous : nullptr, ahead).dump(2);
  } catch (const std::exception& e) {
    sink.add(host_diagnostic("IG-0503", application.where, {e.what()}));
    return std::nullopt;
  }
}

LinkedAlone link_alone(const ig_syntax& syntax, const ig_plugin& plugin, const Surroundings& surroundings,
                       const std::string& dependencies, Library& library, DiagnosticSink& sink) {
  const auto own = read_case_dependencies(dependencies, syntax.id, {}, sink);
  if (!own) return {};
  std::string alias = syntax.id;
  Dialect dialect = surround(syntax, plugin, surroundings, *own, {}, alias, library);
  LinkedAlone out{link(std::move(dialect), library, sink, LinkMode::parts)};
  if (out.linked != nullptr) out.position = out.linked->position(alias).value();
  return out;
}

std::string run_case(const Page& page, const Case& one, const std::string& file, const Surroundings& surroundings,
                     Library& library, CaseDetail detail) {
  if (one.file) return run_import_case(page, one, file, library);
  DiagnosticList said;
  Application application{page.syntax, one.before->text, {}, {}, {file, one.before->line, 0}};
  const auto take = [&](const std::optional<Fence>& fence, auto& text, Location& at) {
    if (!fence) return;
    text = fence->text;
    at = {file, fence->line, 0};
  };
  take(one.previous, application.previous, application.previous_at);
  take(one.ahead, application.ahead, application.ahead_at);
  take(one.dependencies, application.dependencies, application.dependencies_at);
  Json expected = parse_json(one.after->text, {file, one.after->line, 0}, said);
  std::vector<std::string> keys;
  if (expected.is_object()) collect_erased(expected, keys, application.erased);
  const std::optional<std::string> after = apply(application, surroundings, library, said);

  std::string out;
  if (after && !expected.is_null()) {
    const Json got = Json::parse(*after);
    drop_erased(expected, &got);
    out = detail == CaseDetail::whole ? json_difference(expected, got) : first_differences(expected, got);
  }
  std::vector<std::string> codes, wanted;
  for (const Diagnostic& d : said.all) {
    const bool is_host = d.code.starts_with("IG-");
    if (!is_host) codes.push_back(d.code);
    if (is_host && d.severity == Severity::error) out += fault_text(d);
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
  if (!one.accepts_any_code && wanted != codes) {
    const auto list = [](const std::vector<std::string>& all) {
      return all.empty() ? std::string("none") : fmt::format("{}", fmt::join(all, " "));
    };
    out += fmt::format("  diagnostics: expected {}, got {}\n", list(wanted), list(codes));
  }
  if (!out.empty() && after && detail == CaseDetail::whole) out += "  the document after the build:\n" + *after + "\n";
  return out;
}

}  // namespace isogloss
