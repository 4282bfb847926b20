#include "docs/site.hpp"

#include "new/names.hpp"

namespace isogloss::cli::docs {

Site::Site(const Reference& reference, Format format) : reference_(reference), format_(format) {
  for (const Part& part : reference.parts) {
    const std::string file = addresses_.add(Kind::part, part.id, "pages", snake_case(part.id)).file;
    if (!part.cases.empty()) addresses_.add_file(file + ".cases");
  }
  for (const ShownDialect& dialect : reference.dialects)
    addresses_.add(Kind::dialect, dialect.name, "dialects", dialect.name);
  for (const ShownMachine& machine : reference.machines)
    addresses_.add(Kind::machine, machine.name, "machines", machine.name);
  for (const Json& plugin : reference.plugins) {
    const std::string name = text_of(plugin, "Name");
    addresses_.add(Kind::plugin, name, "plugins", name);
  }
  for (const Json& field : reference.fields) {
    const std::string path = text_of(field, "Path");
    addresses_.add_on("fields/" + file_stem(section_of_field(path)), Kind::field, path);
  }
  for (const Json& diagnostic : reference.diagnostics) {
    const std::string code = text_of(diagnostic, "Code");
    addresses_.add_on("diagnostics/" + file_stem(prefix_of_code(code)), Kind::diagnostic, code);
  }
  for (const auto& [code, answers] : reference.codes) addresses_.add_on("codes", Kind::code, code);
}

std::unique_ptr<Page> Site::page(const std::string& file, const std::string& title) const {
  return format_ == Format::html ? html_page(file, title, addresses_) : markdown_page(file, title, addresses_);
}

void Site::add(const Page& page) { files_[page.file() + (format_ == Format::html ? ".html" : ".md")] = page.whole(); }

void Site::add_text(Page& page, const std::string& part, const std::string& markdown) {
  for (std::string& link : page.page_text(markdown)) dead_links_.push_back({part, std::move(link)});
}

Markup fact(const Page& page, std::string_view label, const Markup& value) { return page.text(label) + ": " + value; }

std::string section_of_field(const std::string& path) { return path.substr(0, path.find_first_of(".[")); }

std::string prefix_of_code(const std::string& code) { return code.substr(0, code.find('-')); }

}  // namespace isogloss::cli::docs
