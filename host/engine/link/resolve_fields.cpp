// From declarations to ids: what a syntax gets for each field that it declares, and what it may do with it.
#include <array>
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

/// The fields that patterns may match. A chain has hundreds of patterns and more than a thousand fields, so each looks
/// only at those that end like it, or have its type.
class Matchable {
 public:
  explicit Matchable(const Layout& layout) {
    for (ig_field f = 0; f < layout.fields.size(); ++f) {
      const FieldInfo& info = layout.fields[f];
      if (info.hidden || info.path.empty()) continue;
      of_type_[info.type].push_back(f);
      by_ending_[static_cast<unsigned char>(info.path.back())].push_back(f);
    }
  }
  /// In the order of their ids; some of them have another type.
  const std::vector<ig_field>& near(const FieldPattern& pattern, ig_type type) {
    return pattern.last() != '\0' ? by_ending_[static_cast<unsigned char>(pattern.last())] : of_type_[type];
  }

 private:
  std::map<ig_type, std::vector<ig_field>> of_type_;
  std::array<std::vector<ig_field>, 256> by_ending_;
};

std::vector<ig_field> expand(Linking& linking, FieldDrafts& drafts, Matchable& matchable, const LinkedSyntax& s,
                             const ig_field_decl& decl) {
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
    for (const ig_field f : matchable.near(pattern, decl.type)) {
      const FieldInfo& info = layout.fields[f];
      if (info.type != decl.type || !pattern.matches(info.path, info.unit)) continue;
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
  Matchable matchable(linking.out.layout);
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
        s.expansions[i] = expand(linking, drafts, matchable, s, decl);
      } else {
        const auto [same, is_new] = known.try_emplace({decl.path, decl.type});
        if (is_new) same->second = expand(linking, drafts, matchable, s, decl);
        s.expansions[i] = same->second;
      }
      for (const ig_field f : s.expansions[i]) permit(s, decl.access, f);
    }
  }
}

}  // namespace isogloss
