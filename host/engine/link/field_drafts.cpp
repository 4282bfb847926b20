// The fields of the dialect: those of the standard sections, and what the syntaxes declare, each field once.
#include <algorithm>
#include <array>

#include "link/link_steps.hpp"

namespace isogloss {

namespace {

constexpr std::string_view words_section = "Parsing.";
constexpr std::string_view flags_section = "Parsing.Flags.";

ig_life default_life(std::string_view path, ig_type type) {
  if (type == IG_TRANSFORM) return IG_LIFE_MODAL;
  if (type == IG_SWITCH || type == IG_TEXT) return IG_LIFE_BLOCK;
  return path.starts_with(words_section) ? IG_LIFE_WORD : IG_LIFE_BLOCK;
}

}  // namespace

const char* type_name(ig_type type) {
  static constexpr std::array names{"nothing", "number", "integer",   "boolean", "name",
                                    "text",    "code",   "transform", "switch"};
  return type < names.size() ? names[type] : "nothing";
}

std::string_view FieldDrafts::canonical(std::string_view path) const {
  if (!path.starts_with(flags_section)) return path;
  const auto owner = owners_.find(path.substr(flags_section.size()));
  return owner == owners_.end() ? path : owner->second;
}

void FieldDrafts::add_owner(std::string_view path) {
  if (path.starts_with(words_section) && !path.starts_with(flags_section))
    owners_.emplace(path.substr(words_section.size()), path);
}

void FieldDrafts::collect_owners() {
  for (const LinkedSyntax& s : linking_.out.chain)
    for (std::uint32_t i = 0; i < s.syntax->field_count; ++i) {
      const ig_field_decl& decl = s.syntax->fields[i];
      if (decl.type != IG_CODE) continue;
      if ((decl.access & IG_PATTERN) == 0) {
        add_owner(decl.path);
        continue;
      }
      for (const FieldPattern& p : patterns(s, decl)) {
        if (!p.is_literal()) continue;
        add_owner(p.path());
        if (!p.path().starts_with(words_section))
          linking_.report("IG-0243", s.element.where, {s.element.alias, p.path()});
      }
    }
}

void FieldDrafts::collect() {
  std::size_t declarations = 0;
  for (const LinkedSyntax& s : linking_.out.chain) declarations += s.syntax->field_count;
  declared_.reserve(declarations);
  drafts_.reserve(declarations / 2);  // most fields are declared several times
  draft_of_.reserve(declarations / 2);
  for (const FieldInfo& info : standard_fields()) add_draft(info.path, {info, "the standard sections"});
  linking_.out.layout.lists = standard_lists();
  collect_owners();
  for (const LinkedSyntax& s : linking_.out.chain)
    for (std::uint32_t i = 0; i < s.syntax->field_count; ++i) {
      const ig_field_decl& decl = s.syntax->fields[i];
      if ((decl.access & IG_PATTERN) == 0) {
        declared_.push_back(declare(s, decl, decl.path));
        continue;
      }
      declared_.push_back(IG_NO_FIELD);
      for (const FieldPattern& p : patterns(s, decl))
        if (p.is_literal()) declare(s, decl, p.path());
    }
}

/// Read once, since paths of fields are views of them.
const std::vector<FieldPattern>& FieldDrafts::patterns(const LinkedSyntax& s, const ig_field_decl& decl) {
  const auto [where, added] = patterns_.try_emplace({&s, &decl});
  if (!added) return where->second;
  if (*decl.path != '@') return where->second = parse_patterns(decl.path);
  for (std::uint32_t i = 0; i < s.syntax->option_count; ++i)
    if (std::string_view(decl.path).substr(1) == s.syntax->options[i].name) {
      where->second = parse_patterns(s.options[i].text);
      break;
    }
  return where->second;
}

std::uint32_t FieldDrafts::add_draft(std::string_view path, Draft draft) {
  const auto number = static_cast<std::uint32_t>(drafts_.size());
  draft_of_.emplace(path, number);
  drafts_.push_back(std::move(draft));
  return number;
}

/// The number of the draft, or the id of a record's field.
std::uint32_t FieldDrafts::declare(const LinkedSyntax& s, const ig_field_decl& decl, std::string_view written) {
  const std::size_t brackets = written.find("[].");
  if (brackets != std::string_view::npos)
    return declare_record(s, decl, written.substr(0, brackets), written.substr(brackets + 3));
  const std::string_view path = canonical(written);
  const auto where = draft_of_.find(path);
  const std::uint32_t number =
      where != draft_of_.end()
          ? where->second
          : add_draft(path, {{std::string(path), decl.type,
                              decl.life == IG_LIFE_STANDARD ? default_life(path, decl.type) : decl.life, decl.unit,
                              decl.doc, decl.type == IG_SWITCH, IG_NO_FIELD},
                             s.element.alias});
  Draft& known = drafts_[number];
  if (decl.type == IG_TEXT && is_carried(decl.life))
    linking_.report("IG-0222", s.element.where, {s.element.alias, std::string(path)});
  const bool same_life = decl.life == IG_LIFE_STANDARD || known.info.life == decl.life;
  if (known.info.type != decl.type || !same_life)
    linking_.report("IG-0209", s.element.where,
                    {s.element.alias, std::string(path), type_name(decl.type), std::string(known.declared_by),
                     type_name(known.info.type)},
                    same_life ? "" : "their lives differ");
  if (known.info.unit.empty() && *decl.unit != '\0') known.info.unit = decl.unit;
  if (known.info.doc.empty() && *decl.doc != '\0') known.info.doc = decl.doc;
  known.has_previous |= (decl.access & IG_PREVIOUS) != 0;
  return number;
}

ig_field FieldDrafts::declare_record(const LinkedSyntax& s, const ig_field_decl& decl, std::string_view list,
                                     std::string_view path) {
  auto& lists = linking_.out.layout.lists;
  auto l = std::find_if(lists.begin(), lists.end(), [&](const ListInfo& info) { return info.path == list; });
  if (l == lists.end()) {
    lists.push_back({std::string(list), {}});
    l = lists.end() - 1;
  }
  auto f = std::find_if(l->fields.begin(), l->fields.end(), [&](const FieldInfo& i) { return i.path == path; });
  if (f == l->fields.end()) {
    l->fields.push_back({std::string(path), decl.type, IG_LIFE_BLOCK, decl.unit, decl.doc, false, IG_NO_FIELD});
    f = l->fields.end() - 1;
  } else if (f->type != decl.type) {
    linking_.report("IG-0209", s.element.where,
                    {s.element.alias, std::string(list) + "[]." + std::string(path), type_name(decl.type),
                     "another syntax", type_name(f->type)});
  }
  return record_field(static_cast<std::size_t>(l - lists.begin()), static_cast<std::size_t>(f - l->fields.begin()));
}

}  // namespace isogloss
