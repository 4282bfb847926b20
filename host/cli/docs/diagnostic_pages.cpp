// Diagnostics by code: text, explanation, example, and the pages that name them.
#include <set>

#include "docs/site.hpp"

namespace isogloss::cli::docs {

namespace {

/// The parts on whose pages each code stands.
std::map<std::string, std::set<std::string>> mentions(const Site& site) {
  std::map<std::string, std::set<std::string>> out;
  for (const Part& part : site.reference().parts)
    for (const std::string* const text : {&part.page, &part.cases})
      for (std::size_t at = 0; (at = text->find('-', at)) != std::string::npos; ++at) {
        std::size_t begin = at, end = at + 1;
        while (begin > 0 && (*text)[begin - 1] >= 'A' && (*text)[begin - 1] <= 'Z') --begin;
        while (end < text->size() && (*text)[end] >= '0' && (*text)[end] <= '9') ++end;
        const std::string code = text->substr(begin, end - begin);
        if (site.addresses().find(Kind::diagnostic, code) != nullptr) out[code].insert(part.id);
      }
  return out;
}

}  // namespace

void write_diagnostics(Site& site) {
  const auto named_on = mentions(site);
  std::map<std::string, std::unique_ptr<Page>> pages;
  const auto all = site.page("diagnostics", "Diagnostics");
  std::vector<Row> rows;
  for (const Json& d : site.reference().diagnostics) {
    const std::string code = text_of(d, "Code"), prefix = prefix_of_code(code), severity = text_of(d, "Severity");
    const Address& address = *site.addresses().find(Kind::diagnostic, code);
    std::unique_ptr<Page>& page = pages[address.file];
    if (page == nullptr) page = site.page(address.file, "Diagnostics " + prefix);
    page->heading(2, page->text(code), address.anchor);
    page->paragraph(page->text(severity + ": ") + page->prose(text_of(d, "Text")));
    // Explanations of plugins are parts of their pages.
    if (const std::string why = text_of(d, "Explanation"); !why.empty()) site.add_text(*page, code, why);
    std::vector<Markup> facts;
    if (const std::string example = text_of(d, "Example"); !example.empty())
      facts.push_back(fact(*page, "Example", page->code(example)));
    facts.push_back(fact(*page, "Reported by", page->text(text_of(d, "Plugin"))));
    if (const auto found = named_on.find(code); found != named_on.end())
      facts.push_back(fact(*page, "Pages", page->names(Kind::part, {found->second.begin(), found->second.end()})));
    page->list(facts);
    rows.push_back({{all->name(Kind::diagnostic, code), all->text(severity), all->prose(text_of(d, "Text"))}});
  }
  all->table({"Code", "Severity", "Text"}, rows);
  site.add(*all);
  for (const auto& [file, page] : pages) site.add(*page);
}

}  // namespace isogloss::cli::docs
