// What the search box finds, as a script: a page from disk may not read other files.
#include "docs/site.hpp"

namespace isogloss::cli::docs {

namespace {

/// JSON inside of a script; '<' is escaped, should the script ever stand in a page.
std::string script_text(const Json& json) {
  std::string out;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
    out += c == '<' ? "\\u003c" : std::string(1, c);
  return out;
}

}  // namespace

void write_names(Site& site) {
  const Reference& r = site.reference();
  std::string out = "// Name, page, what it is.\nvar isogloss_names = [\n";
  const auto add = [&](Kind kind, const std::string& name, const std::string& what) {
    const Address& address = *site.addresses().find(kind, name);
    out += script_text(Json::array({name, relative_link("", address, ".html"), what})) + ",\n";
  };
  for (const Part& part : r.parts) add(Kind::part, part.id, text_of(part.declaration, "Summary"));
  for (const auto& [name, code] : r.codes) add(Kind::code, name, code.is_word ? "word" : "code");
  for (const ShownDialect& d : r.dialects) add(Kind::dialect, d.name, "dialect");
  for (const ShownMachine& m : r.machines) add(Kind::machine, m.name, "machine");
  for (const Json& p : r.plugins) add(Kind::plugin, text_of(p, "Name"), "plugin");
  for (const Json& d : r.diagnostics) add(Kind::diagnostic, text_of(d, "Code"), text_of(d, "Text"));
  for (const Json& f : r.fields) add(Kind::field, text_of(f, "Path"), "field");
  site.add_file("names.js", out + "];\n");
}

}  // namespace isogloss::cli::docs
