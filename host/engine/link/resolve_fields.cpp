// From declarations to ids: what a syntax gets for each field that it declares, and what it may do with it.
#include <map>

#include "link/link_steps.hpp"

namespace isogloss {

namespace {

/// From what the drafts declared to an id.
ig_field resolve(const FieldIds& ids, const ig_field_decl& decl, std::uint32_t declared) {
  if (is_record_field(declared)) return declared;  // or a pattern's IG_NO_FIELD
  return (decl.access & IG_PREVIOUS) != 0 ? ids.of_previous[declared] : ids.of[declared];
}

std::string_view unit_of(const Layout& layout, const FieldDrafts& drafts, std::string_view path) {
  const std::optional<ig_field> f = layout.find(drafts.canonical(path));
  return f ? std::string_view(layout.fields[*f].unit) : std::string_view();
}

std::string similar_field(const Layout& layout, const std::string& path) {
  std::vector<std::string> paths;
  for (const FieldInfo& field : layout.fields)
    if (!field.hidden) paths.push_back(field.path);
  return did_you_mean(nearest_name(path, paths));
}

/// Only for options that the dialect writes: a default may be for other chains.
void report_unmet(Linking& linking, const LinkedSyntax& s, std::string_view option, const std::string& pattern) {
  for (const Attribute& given : s.element.options)
    if (given.name == option) linking.report("IG-0244", given.where, {s.element.alias, given.name, pattern});
}

std::vector<ig_field> expand(Linking& linking, FieldDrafts& drafts, const LinkedSyntax& s, const ig_field_decl& decl) {
  const Layout& layout = linking.out.layout;
  std::vector<ig_field> out;
  std::vector<bool> in(layout.fields.size());
  const auto add = [&](ig_field f) {
    if (!in[f]) out.push_back(f);
    in[f] = true;
  };
  for (const FieldPattern& pattern : drafts.patterns(s, decl)) {
    if (pattern.is_literal()) {
      const std::optional<ig_field> f = layout.find(drafts.canonical(pattern.path()));
      if (f && layout.fields[*f].type == decl.type)
        add(*f);
      else
        linking.report("IG-0214", s.element.where, {pattern.path()}, similar_field(layout, pattern.path()));
      continue;
    }
    bool is_met = false;
    for (ig_field f = 0; f < in.size(); ++f) {
      const FieldInfo& info = layout.fields[f];
      if (info.hidden || info.type != decl.type || !pattern.may_match(info.path)) continue;
      if (!pattern.matches(info.path, info.unit)) continue;
      if (!pattern.owner_unit().empty() && unit_of(layout, drafts, pattern.owner(info.path)) != pattern.owner_unit())
        continue;
      add(f);
      is_met = true;
    }
    if (!is_met && linking.mode == LinkMode::whole && *decl.path == '@')
      report_unmet(linking, s, std::string_view(decl.path).substr(1), pattern.path());
  }
  return out;
}

void permit(LinkedSyntax& s, std::uint32_t access, ig_field f) {
  if (f == IG_NO_FIELD || is_record_field(f)) return;
  const std::uint64_t bit = std::uint64_t{1} << (f & 63);
  if ((access & (IG_READ | IG_PREVIOUS | IG_WAKE | IG_WAKE_WHILE)) != 0) s.may_read[f >> 6] |= bit;
  if ((access & IG_WRITE) != 0) s.may_write[f >> 6] |= bit;
  if ((access & IG_TAKE) != 0) s.may_take[f >> 6] |= bit;
}

}  // namespace

void resolve_fields(Linking& linking, FieldDrafts& drafts, const FieldIds& ids) {
  const std::size_t mask_words = (linking.out.layout.fields.size() + 63) / 64;
  auto declared = drafts.declared().begin();
  // Patterns that stand in descriptors mean the same for each syntax that has them.
  std::map<std::pair<std::string_view, ig_type>, std::vector<ig_field>> known;
  for (LinkedSyntax& s : linking.out.chain) {
    s.may_read.resize(mask_words);
    s.may_write.resize(mask_words);
    s.may_take.resize(mask_words);
    s.ids.reserve(s.syntax->field_count);
    for (std::uint32_t i = 0; i < s.syntax->field_count; ++i) {
      const ig_field_decl& decl = s.syntax->fields[i];
      s.ids.push_back(resolve(ids, decl, *declared++));
      permit(s, decl.access, s.ids.back());
      if ((decl.access & IG_PATTERN) == 0) continue;
      s.expansions.resize(i + 1);
      if (*decl.path == '@') {
        s.expansions[i] = expand(linking, drafts, s, decl);
      } else {
        const auto [same, is_new] = known.try_emplace({decl.path, decl.type});
        if (is_new) same->second = expand(linking, drafts, s, decl);
        s.expansions[i] = same->second;
      }
      for (const ig_field f : s.expansions[i]) permit(s, decl.access, f);
    }
  }
}

}  // namespace isogloss
