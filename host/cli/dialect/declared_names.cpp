#include "dialect/declared_names.hpp"

#include <algorithm>
#include <set>
#include <span>

namespace isogloss::cli {

namespace {

/// What can be written by something that is installed.
class Writable {
 public:
  Writable(const LinkedDialect& linked, const Library& library) {
    for (const FieldInfo& info : standard_fields()) paths_.insert(info.path);
    for (const ListInfo& list : standard_lists())
      for (const FieldInfo& info : list.fields) paths_.insert(list.path + "[]." + info.path);
    for (const LoadedPlugin& loaded : library.plugins())
      for (const ig_syntax* const syntax : std::span(loaded.plugin->syntaxes, loaded.plugin->syntax_count))
        for (const ig_field_decl& field : std::span(syntax->fields, syntax->field_count))
          if ((field.access & (IG_WRITE | IG_TAKE)) != 0 && (field.access & IG_PATTERN) == 0) paths_.insert(field.path);
    // What a pattern writes is known of the syntaxes of this chain.
    for (const LinkedSyntax& s : linked.chain)
      for (ig_field f = 0; f < linked.layout.fields.size(); ++f)
        if ((s.may_write[f >> 6] >> (f & 63) & 1) != 0) paths_.insert(linked.layout.fields[f].path);
    for (const auto& [field, value] : linked.initial) paths_.insert(linked.layout.fields[field].path);
  }
  bool has(const std::string& path) const { return paths_.contains(path); }
  std::vector<std::string> all() const { return {paths_.begin(), paths_.end()}; }

 private:
  std::set<std::string> paths_;
};

/// What is near to another name is a slip; what is not may belong to a plugin that is not installed.
void add_slip(Diagnostic d, const std::string& near, const std::string& otherwise, std::vector<Diagnostic>& out) {
  d.hint = near.empty() ? otherwise : "did you mean " + near + "?";
  if (!near.empty()) d.severity = Severity::warning;
  out.push_back(std::move(d));
}

void look_at_neighbours(const LinkedSyntax& s, Library& library, std::vector<Diagnostic>& out) {
  const auto look = [&](const char* const* names, const char* where) {
    for (; names != nullptr && *names != nullptr; ++names) {
      if (library.syntax(*names) != nullptr) continue;
      library.load_all();
      if (library.syntax(*names) != nullptr) continue;
      add_slip(host_diagnostic("IG-0177", s.element.where, {s.element.alias, where, *names}),
               nearest_name(*names, library.syntax_ids()), "isogloss list syntaxes names those that are there", out);
    }
  };
  look(s.syntax->after, "after");
  look(s.syntax->before, "before");
}

/// Words and codes come from programs, and Source from the host; what is required has a writer, or the chain is not
/// linked.
bool needs_a_writer(const ig_field_decl& field) {
  const bool is_read = (field.access & (IG_READ | IG_PREVIOUS)) != 0 && (field.access & (IG_WRITE | IG_TAKE)) == 0;
  return is_read && (field.access & (IG_PATTERN | IG_REQUIRED)) == 0 &&
         !std::string_view(field.path).starts_with("Parsing.") && !std::string_view(field.path).starts_with("Source.");
}

void look_at_fields(const LinkedDialect& linked, Library& library, std::vector<Diagnostic>& out) {
  Writable writable(linked, library);
  bool has_all = false;
  for (const LinkedSyntax& s : linked.chain)
    for (const ig_field_decl& field : std::span(s.syntax->fields, s.syntax->field_count)) {
      if (!needs_a_writer(field) || writable.has(field.path)) continue;
      if (!has_all) {
        library.load_all();
        writable = Writable(linked, library);
        has_all = true;
        if (writable.has(field.path)) continue;
      }
      add_slip(host_diagnostic("IG-0178", s.element.where, {s.element.alias, field.path}),
               nearest_name(field.path, writable.all()), "isogloss list fields names those that are there", out);
    }
}

void look_at_options(const std::string& owner, const Location& where, std::span<const ig_option_decl> options,
                     std::vector<Diagnostic>& out) {
  for (const ig_option_decl& option : options) {
    std::string small(option.name);
    for (char& c : small)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (small != option.name)
      out.push_back(host_diagnostic("IG-0179", where, {option.name, owner}, "its author may call it " + small));
  }
}

}  // namespace

std::vector<Diagnostic> unanswered_names(const LinkedDialect& linked, Library& library) {
  std::vector<Diagnostic> out;
  for (const LinkedSyntax& s : linked.chain) {
    look_at_neighbours(s, library, out);
    look_at_options(s.element.alias, s.element.where, {s.syntax->options, s.syntax->option_count}, out);
  }
  look_at_fields(linked, library, out);
  return out;
}

}  // namespace isogloss::cli
