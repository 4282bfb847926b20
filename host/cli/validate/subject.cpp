#include "validate/subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>

namespace isogloss::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_stands = 8;   // of one syntax
constexpr std::size_t most_fields = 64;  // of one syntax, patterns included

std::string title_of(const std::string& text) {
  const std::size_t begin = text.find_first_not_of("# ");
  return begin == std::string::npos ? std::string() : text.substr(begin, text.find_first_of("\r\n", begin) - begin);
}

Json parsed(const std::optional<Fence>& fence) {
  Json out = fence ? Json::parse(fence->text, nullptr, false) : Json();
  return out.is_object() ? out : Json();
}

}  // namespace

Subject::Subject(Examination& e) : session_(e.options.common) {
  if (!session_.library().load_file(e.file)) {
    for (const RefusedPlugin& r : session_.library().refused())
      if (r.file == e.file) throw std::runtime_error(r.reason + " [" + r.code + "]");
    throw std::runtime_error("the library was not loaded");
  }
  // Its copy among the installed plugins is refused, since a plugin of this name is there.
  session_.library().load_all();
  loaded_ = &session_.library().plugins().front();
  plugin_ = loaded_->plugin;
  DiagnosticList said;
  surroundings_.is_named = !e.options.dialect.empty();
  surroundings_.dialect =
      surroundings_.is_named ? session_.read(e.options.dialect, said) : session_.reader().read(default_dialect, said);
  if (surroundings_.is_named && !surroundings_.dialect)
    throw std::runtime_error("the dialect " + e.options.dialect +
                             " cannot be read: " + (said.all.empty() ? "" : said.all.front().message));
}

void Subject::add_own_dependencies() {
  if (!surroundings_.dialect || surroundings_.is_named) return;
  for (std::uint32_t i = 0; i < plugin_->dependency_count; ++i) {
    const ig_dependency& d = *plugin_->dependencies[i];
    const bool needs_option = std::any_of(d.options, d.options + d.option_count,
                                          [](const ig_option_decl& o) { return o.fallback == nullptr; });
    std::vector<DependencyElement>& all = surroundings_.dialect->dependencies;
    const bool is_there = std::any_of(all.begin(), all.end(), [&](const DependencyElement& e) { return e.id == d.id; });
    if (!needs_option && !is_there) all.push_back({d.id, d.id, {}, {}, {}, {}});
  }
}

void Subject::remove_services() {
  if (!surroundings_.dialect) return;
  surroundings_.dialect->dependencies.clear();
  std::erase_if(surroundings_.dialect->chain, [&](const ChainElement& e) {
    const ig_syntax* const syntax = session_.library().syntax(e.syntax);
    return syntax != nullptr && requires_service(*syntax);
  });
}

bool requires_service(const ig_syntax& syntax) {
  return std::any_of(syntax.services, syntax.services + syntax.service_count,
                     [](const ig_service_decl& s) { return s.is_optional == 0; });
}

std::vector<PageText> pages_of(const Subject& subject, const ValidateOptions& options) {
  std::vector<PageText> out;
  std::set<std::string> ids;
  const auto add = [&](const char* id, const char* page, const char* cases) {
    ids.insert(id);
    if (page != nullptr) out.push_back({id, page});
    if (cases != nullptr) out.push_back({std::string(id) + ".cases", cases});
  };
  for (const ig_syntax* s : subject.syntaxes()) add(s->id, s->page, s->cases);
  for (std::uint32_t i = 0; i < subject.plugin().importer_count; ++i)
    add(subject.plugin().importers[i]->id, subject.plugin().importers[i]->page, subject.plugin().importers[i]->cases);
  if (options.pages.empty()) return out;
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(options.pages))
    if (entry.path().extension() == ".md") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<PageText> given;
  std::string error;
  for (const fs::path& file : files)
    if (std::optional<std::string> text = read_text(file.string(), error); text && ids.contains(title_of(*text)))
      given.push_back({file.string(), std::move(*text)});
  // The files are newer than what the last build embedded.
  std::erase_if(out, [&](const PageText& embedded) {
    return std::any_of(given.begin(), given.end(),
                       [&](const PageText& g) { return title_of(g.text) == title_of(embedded.text); });
  });
  out.insert(out.end(), given.begin(), given.end());
  return out;
}

std::vector<Stand> stands_of(Subject& subject, Examination& e, Missing what) {
  subject.add_own_dependencies();
  std::vector<Stand> out;
  std::vector<std::string> missing;
  const std::vector<PageText> pages = pages_of(subject, e.options);
  for (const ig_syntax* syntax : subject.syntaxes()) {
    const std::size_t first = out.size();
    const auto stand_with = [&](const std::string& dependencies) -> Stand* {
      for (std::size_t i = first; i < out.size(); ++i)
        if (out[i].dependencies == dependencies) return &out[i];
      if (out.size() - first >= most_stands) return nullptr;
      DiagnosticList said;
      e.attempt(syntax->id);
      Stand stand{syntax,
                  dependencies,
                  link_alone(*syntax, subject.plugin(), subject.surroundings(), dependencies, subject.library(), said),
                  {}};
      if (stand.alone.linked == nullptr || !creation_fault(stand.alone, {}).empty()) return nullptr;
      out.push_back(std::move(stand));
      return &out.back();
    };
    if (Stand* const own = stand_with("")) own->blocks.push_back({.name = "an empty block"});
    DiagnosticList ignored;
    for (const PageText& page : pages) {
      const Page read = read_page(page.text, page.name, ignored);
      if (read.syntax != syntax->id) continue;
      for (const Case& one : read.cases) {
        if (!one.before) continue;
        TestBlock block{
            .name = "case '" + one.heading + "'", .before = parsed(one.before), .previous = parsed(one.previous)};
        if (block.before.is_null()) continue;
        if (const auto text = block.before.find("UnparsedText"); text != block.before.end() && text->is_string()) {
          block.text = text->get<std::string>();
          if (syntax->scan != nullptr) block.before.erase(text);
        }
        if (Stand* const stand = stand_with(one.dependencies ? one.dependencies->text : ""))
          stand->blocks.push_back(std::move(block));
      }
    }
    if (out.size() == first) missing.push_back(syntax->id);
  }
  if (missing.empty() || what == Missing::is_told_elsewhere) return out;
  if (out.empty())
    e.skip("no syntax of the plugin can be linked and created, which the check 'options' explains");
  else
    e.remark(fmt::format("not looked at, since 'options' cannot link or create them: {}", fmt::join(missing, ", ")));
  return out;
}

std::vector<ig_field> fields_of(const LinkedAlone& alone) {
  const LinkedSyntax& syntax = alone.linked->chain[alone.position];
  std::vector<ig_field> out;
  const auto add = [&](ig_field f) {
    if (out.size() < most_fields && f != IG_NO_FIELD && !is_record_field(f) && f < alone.linked->layout.fields.size() &&
        std::find(out.begin(), out.end(), f) == out.end())
      out.push_back(f);
  };
  for (const ig_field f : syntax.ids) add(f);
  for (const std::vector<ig_field>& pattern : syntax.expansions)
    for (const ig_field f : pattern) add(f);
  return out;
}

const std::vector<std::string>& odd_texts() {
  using namespace std::string_literals;
  // Beginnings of characters without their ends, ends without beginnings, forms too long, and control characters.
  static const std::vector<std::string> out{
      "\xc3"s,   "A\xe2\x82"s,        "\xf0\x9f\x98"s, "\x80\xbf"s, "\xc0\xaf"s,  "\xed\xa0\x80"s, "\xff\xfe"s, "\0"s,
      "A\0B\0"s, "\x01\x1b[31m\x7f"s, "\r"s,           "\xc3("s,    "((((((((("s, "\"'\\%s%n"s,    " "s};
  return out;
}

TestBlock full_block(const LinkedAlone& alone, const std::vector<ig_field>& fields) {
  TestBlock out{.name = "a block with all declared fields"};
  std::int64_t ordinal = 0;
  for (const ig_field f : fields) {
    Assignment a{f, {}, {}};
    switch (alone.linked->layout.fields[f].type) {
      case IG_NUMBER:
      case IG_TRANSFORM: a.value.number = 1; break;
      case IG_CODE: a.value.integer = ++ordinal; break;
      case IG_SYMBOL: a.value.symbol = alone.linked->symbols.size() > 0 ? 1 : 0; break;
      case IG_TEXT: a.text = "A"; break;
      default: a.value.integer = 1;
    }
    if (alone.linked->layout.fields[f].type != IG_SYMBOL || a.value.symbol != 0)
      out.assignments.push_back(std::move(a));
  }
  return out;
}

}  // namespace isogloss::cli
