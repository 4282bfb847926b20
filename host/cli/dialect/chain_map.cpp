#include "dialect/chain_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace isogloss::cli {

namespace {

using Mask = std::vector<std::uint64_t>;

bool names_it(const char* const* list, std::string_view id) {
  for (; list != nullptr && *list != nullptr; ++list)
    if (id == *list) return true;
  return false;
}

std::vector<std::string> paths(const Layout& layout, const Mask& mask) {
  std::vector<std::string> out;
  for (ig_field f = 0; f < layout.fields.size(); ++f)
    if ((mask[f >> 6] >> (f & 63) & 1) != 0) out.push_back(layout.fields[f].path);
  return out;
}

std::string code_of(const FieldInfo& field) {
  constexpr std::string_view parsing = "Parsing.", flags = "Parsing.Flags.";
  const bool is_flag = field.path.starts_with(flags);
  return field.path.substr(is_flag ? flags.size() : field.path.starts_with(parsing) ? parsing.size() : 0);
}

/// The fields that syntaxes hand to each other: neither words and codes, which scanners write for all, nor copies.
Mask handed(const Layout& layout) {
  Mask out((layout.fields.size() + 63) / 64);
  for (ig_field f = 0; f < layout.fields.size(); ++f) {
    const FieldInfo& field = layout.fields[f];
    if (field.type != IG_CODE && field.life != IG_LIFE_WORD && field.previous_of == IG_NO_FIELD)
      out[f >> 6] |= std::uint64_t{1} << (f & 63);
  }
  return out;
}

Mask codes(const Layout& layout) {
  Mask out((layout.fields.size() + 63) / 64);
  for (ig_field f = 0; f < layout.fields.size(); ++f)
    if (layout.fields[f].type == IG_CODE) out[f >> 6] |= std::uint64_t{1} << (f & 63);
  return out;
}

Mask both(const Mask& a, const Mask& b, const Mask& c) {
  Mask out(a.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = a[i] & b[i] & c[i];
  return out;
}

bool is_empty(const Mask& mask) {
  return std::all_of(mask.begin(), mask.end(), [](std::uint64_t w) { return w == 0; });
}

Json declared_names(const LinkedDialect& linked, const std::vector<Relation>& all, std::uint32_t position,
                    bool following) {
  Json out = Json::array();
  for (const Relation& r : all)
    if (r.kind == Relation::Kind::declared && (following ? r.first : r.second) == position)
      out.push_back(linked.chain[following ? r.second : r.first].element.alias);
  return out;
}

/// Each field that the syntax writes and the later syntaxes that read it.
Json written_fields(const LinkedDialect& linked, std::uint32_t position, const Mask& handed_on) {
  Json out = Json::array();
  const LinkedSyntax& s = linked.chain[position];
  for (ig_field f = 0; f < linked.layout.fields.size(); ++f) {
    if (((s.may_write[f >> 6] & handed_on[f >> 6]) >> (f & 63) & 1) == 0) continue;
    Json readers = Json::array();
    for (std::uint32_t later = position + 1; later < linked.chain.size(); ++later)
      if ((linked.chain[later].may_read[f >> 6] >> (f & 63) & 1) != 0)
        readers.push_back(linked.chain[later].element.alias);
    if (!readers.empty()) out.push_back({{"Field", linked.layout.fields[f].path}, {"For", std::move(readers)}});
  }
  return out;
}

}  // namespace

std::string short_place(const Location& where) {
  return fmt::format("{}:{}", std::filesystem::path(where.file).filename().string(), where.line);
}

std::vector<std::string> taken_codes(const LinkedSyntax& s, const Layout& layout) {
  std::vector<std::string> out;
  for (ig_field f = 0; f < layout.fields.size(); ++f)
    if (layout.fields[f].type == IG_CODE && (s.may_take[f >> 6] >> (f & 63) & 1) != 0)
      out.push_back(code_of(layout.fields[f]));
  return out;
}

const AppliedEdit* placing_edit(const Dialect& dialect, const std::string& alias) {
  const auto places = [&](const AppliedEdit& edit) {
    return !edit.of_dependency && std::find(edit.elements.begin(), edit.elements.end(), alias) != edit.elements.end();
  };
  const auto last = std::find_if(dialect.edits.rbegin(), dialect.edits.rend(), places);
  return last == dialect.edits.rend() ? nullptr : &*last;
}

std::vector<Relation> relations(const LinkedDialect& linked) {
  std::vector<Relation> out;
  const Mask handed_on = handed(linked.layout), of_codes = codes(linked.layout);
  for (std::uint32_t a = 0; a < linked.chain.size(); ++a)
    for (std::uint32_t b = a + 1; b < linked.chain.size(); ++b) {
      const LinkedSyntax &first = linked.chain[a], &second = linked.chain[b];
      std::vector<std::string> by;
      if (names_it(first.syntax->before, second.syntax->id)) by.push_back(first.element.alias);
      if (names_it(second.syntax->after, first.syntax->id)) by.push_back(second.element.alias);
      if (!by.empty()) out.push_back({Relation::Kind::declared, a, b, std::move(by)});
      const Mask fields = both(first.may_write, second.may_read, handed_on);
      if (!is_empty(fields)) out.push_back({Relation::Kind::field, a, b, paths(linked.layout, fields)});
      const Mask shared = both(first.may_take, second.may_take, of_codes);
      if (is_empty(shared)) continue;
      std::vector<std::string> names;
      for (ig_field f = 0; f < linked.layout.fields.size(); ++f)
        if ((shared[f >> 6] >> (f & 63) & 1) != 0) names.push_back(code_of(linked.layout.fields[f]));
      out.push_back({Relation::Kind::code, a, b, std::move(names)});
    }
  return out;
}

Json describe_chain(const LinkedDialect& linked) {
  const std::vector<Relation> all = relations(linked);
  const Mask handed_on = handed(linked.layout);
  Json out{{"Dialect", linked.dialect.name},
           {"File", linked.dialect.file.string()},
           {"Extends", linked.dialect.ancestors},
           {"Stages", Json::array()}};
  Json& stages = out["Stages"];
  for (std::uint32_t i = 0; i < linked.chain.size(); ++i) {
    const LinkedSyntax& s = linked.chain[i];
    const std::string stage(to_string(s.element.stage));
    if (stages.empty() || stages.back()["Stage"] != stage)
      stages.push_back({{"Stage", stage}, {"Syntaxes", Json::array()}});
    stages.back()["Syntaxes"].push_back({{"Position", i + 1},
                                         {"As", s.element.alias},
                                         {"Syntax", s.element.syntax},
                                         {"Plugin", s.plugin->name},
                                         {"File", s.element.where.file},
                                         {"Line", s.element.where.line},
                                         {"After", declared_names(linked, all, i, false)},
                                         {"Before", declared_names(linked, all, i, true)},
                                         {"Takes", taken_codes(s, linked.layout)},
                                         {"Writes", written_fields(linked, i, handed_on)}});
  }
  return out;
}

}  // namespace isogloss::cli
