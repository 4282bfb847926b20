// What is not wrong, but has no effect or can never happen: `lint` reports it, a run does not pay for it.
#include <algorithm>

#include <fmt/format.h>

#include "isogloss/engine/linker.hpp"

namespace isogloss {

namespace {

std::string file_and_line(const Location& w) { return fmt::format("{}:{}", w.file, w.line); }

/// Calls `act` with each field that wakes the syntax; `act` returns true to stop.
template <class Act>
bool any_wake(const LinkedSyntax& s, Act act) {
  for (std::uint32_t i = 0; i < s.syntax->field_count; ++i) {
    if ((s.syntax->fields[i].access & (IG_WAKE | IG_WAKE_WHILE)) == 0) continue;
    if ((s.syntax->fields[i].access & IG_PATTERN) == 0) {
      if (act(s.ids[i])) return true;
    } else if (i < s.expansions.size() && std::any_of(s.expansions[i].begin(), s.expansions[i].end(), act)) {
      return true;
    }
  }
  return false;
}

/// What some part of the chain that can act may write.
class Written {
 public:
  explicit Written(const LinkedDialect& linked) : linked_(linked), fields_((linked.layout.fields.size() + 63) / 64) {
    // The host itself says where a block comes from, and raises the end of a program.
    for (const FieldInfo& info : standard_fields())
      if (const auto f = linked.layout.find(info.path); f && info.path.starts_with("Source."))
        fields_[*f >> 6] |= std::uint64_t{1} << (*f & 63);
    for (const auto& [field, value] : linked.initial) fields_[field >> 6] |= std::uint64_t{1} << (field & 63);
  }
  void add(const LinkedSyntax& s) {
    for (std::size_t w = 0; w < fields_.size(); ++w) fields_[w] |= s.may_write[w];
    for (std::uint32_t i = 0; i < s.syntax->field_count; ++i)
      if ((s.syntax->fields[i].access & IG_WRITE) != 0 && s.ids[i] != IG_NO_FIELD && is_record_field(s.ids[i]))
        lists_.push_back(list_of(s.ids[i]));
  }
  bool has(ig_field f) const {
    if (f == IG_NO_FIELD) return false;
    if (is_record_field(f)) return std::find(lists_.begin(), lists_.end(), list_of(f)) != lists_.end();
    const ig_field of = linked_.layout.fields[f].previous_of;
    const ig_field field = of == IG_NO_FIELD ? f : of;
    return (fields_[field >> 6] >> (field & 63) & 1) != 0;
  }

 private:
  const LinkedDialect& linked_;
  std::vector<std::uint64_t> fields_;
  std::vector<std::size_t> lists_;
};

std::string wakes_of(const LinkedDialect& linked, const LinkedSyntax& s) {
  constexpr std::size_t most = 3;
  std::vector<std::string> paths;
  any_wake(s, [&](ig_field f) {
    if (f == IG_NO_FIELD) return false;
    std::string path = is_record_field(f) ? linked.layout.lists[list_of(f)].path : linked.layout.fields[f].path;
    if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(std::move(path));
    return false;
  });
  if (paths.empty()) return "anything that would wake it";
  return listed(paths, most);
}

void review_options(const std::string& alias, const ig_option_decl* declared, std::uint32_t count,
                    const std::vector<Attribute>& given, const std::vector<AppliedEdit>& edits, bool of_dependency,
                    std::vector<Diagnostic>& out) {
  for (const Attribute& option : given)
    for (std::uint32_t i = 0; i < count; ++i) {
      if (option.name != declared[i].name || declared[i].fallback == nullptr || option.value != declared[i].fallback)
        continue;
      // An edit that sets an inherited value back to the default has an effect.
      const bool resets = std::any_of(edits.begin(), edits.end(), [&](const AppliedEdit& edit) {
        return edit.of_dependency == of_dependency && edit.anchor == alias &&
               std::any_of(edit.options.begin(), edit.options.end(), [&](const AppliedEdit::Option& o) {
                 return o.given.name == option.name && o.before && o.before->value != option.value;
               });
      });
      if (!resets) out.push_back(host_diagnostic("IG-0166", option.where, {option.name, alias, option.value}));
    }
}

bool same_part(const AppliedEdit& a, const AppliedEdit& b) {
  return a.of_dependency == b.of_dependency && a.dialect == b.dialect;
}

/// Does a later edit of the same dialect take back what `edit` does to `alias`?
const AppliedEdit* undone_by(const std::vector<AppliedEdit>& edits, std::size_t edit, const std::string& alias) {
  for (std::size_t later = edit + 1; later < edits.size(); ++later)
    if (same_part(edits[edit], edits[later]) && edits[later].anchor == alias &&
        (edits[later].kind == "Remove" || edits[later].kind == "Replace"))
      return &edits[later];
  return nullptr;
}

void review_configure(const std::vector<AppliedEdit>& edits, std::size_t number, std::vector<Diagnostic>& out) {
  const AppliedEdit& edit = edits[number];
  if (edit.options.empty() && !edit.override_slot)
    out.push_back(host_diagnostic("IG-0169", edit.where, {edit.kind, edit.anchor}));
  for (const AppliedEdit::Option& option : edit.options) {
    if (!option.before) continue;
    if (option.before->value == option.given.value)
      out.push_back(
          host_diagnostic("IG-0167", option.given.where,
                          {option.given.name, edit.anchor, option.given.value, file_and_line(option.before->where)}));
    for (std::size_t earlier = 0; earlier < number; ++earlier)
      for (const AppliedEdit::Option& o : edits[earlier].options)
        if (same_part(edits[earlier], edit) && edits[earlier].anchor == edit.anchor &&
            o.given.name == option.given.name && o.given.value != option.given.value)
          out.push_back(host_diagnostic(
              "IG-0168", o.given.where,
              {fmt::format("{} of {}", o.given.name, edit.anchor), "Configure", file_and_line(option.given.where)}));
  }
}

void review_edits(const Dialect& dialect, std::vector<Diagnostic>& out) {
  for (std::size_t i = 0; i < dialect.edits.size(); ++i) {
    const AppliedEdit& edit = dialect.edits[i];
    if (edit.kind == "Configure") review_configure(dialect.edits, i, out);
    std::vector<std::string> touched = edit.elements;
    if (edit.kind == "Configure") touched.push_back(edit.anchor);
    for (const std::string& alias : touched)
      if (const AppliedEdit* const later = undone_by(dialect.edits, i, alias))
        out.push_back(
            host_diagnostic("IG-0168", edit.where,
                            {fmt::format("<{}> of {}", edit.kind, alias), later->kind, file_and_line(later->where)}));
  }
  for (const Repetition& r : dialect.repetitions)
    out.push_back(host_diagnostic("IG-0170", r.where, {r.what, file_and_line(r.first)}));
}

/// override="true" lets a syntax claim a slot, or take a code, that another one has.
void review_override(const LinkedDialect& linked, const LinkedSyntax& s, std::vector<Diagnostic>& out) {
  if (!s.element.override_slot) return;
  for (const LinkedSyntax& other : linked.chain) {
    if (&other == &s) continue;
    const char* const slot = s.syntax->exclusive_slot;
    const char* const its = other.syntax->exclusive_slot;
    if (slot != nullptr && its != nullptr && std::string_view(slot) == its) return;
    for (ig_field f = 0; f < linked.layout.fields.size(); ++f)
      if (linked.layout.fields[f].type == IG_CODE && (s.may_take[f >> 6] & other.may_take[f >> 6]) >> (f & 63) & 1)
        return;
  }
  out.push_back(host_diagnostic("IG-0171", s.element.where, {s.element.alias}));
}

}  // namespace

std::vector<std::uint32_t> never_called(const LinkedDialect& linked) {
  Written written(linked);
  std::vector<bool> acts(linked.chain.size());
  const auto is_called = [&](const LinkedSyntax& s) {
    return s.syntax->scan != nullptr || s.syntax->inspects != 0 || s.syntax->build == nullptr ||
           s.syntax->restart != nullptr || any_wake(s, [&](ig_field f) { return written.has(f); });
  };
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t i = 0; i < linked.chain.size(); ++i) {
      if (acts[i] || !is_called(linked.chain[i])) continue;
      acts[i] = true;
      written.add(linked.chain[i]);
      grows = true;
    }
  }
  std::vector<std::uint32_t> out;
  for (std::uint32_t i = 0; i < linked.chain.size(); ++i)
    if (!acts[i]) out.push_back(i);
  return out;
}

std::vector<Diagnostic> review(const LinkedDialect& linked) {
  std::vector<Diagnostic> out;
  const Dialect& dialect = linked.dialect;
  for (const std::uint32_t i : never_called(linked)) {
    const LinkedSyntax& s = linked.chain[i];
    out.push_back(host_diagnostic("IG-0165", s.element.where, {s.element.alias, wakes_of(linked, s)}));
  }
  for (const LinkedSyntax& s : linked.chain) {
    review_options(s.element.alias, s.syntax->options, s.syntax->option_count, s.element.options, dialect.edits, false,
                   out);
    review_override(linked, s, out);
  }
  for (const LinkedDependency& d : linked.dependencies)
    review_options(d.element.alias, d.dependency->options, d.dependency->option_count, d.element.options, dialect.edits,
                   true, out);
  review_edits(dialect, out);
  for (Diagnostic& d : out)
    if (const auto severity = dialect.severities.find(d.code); severity != dialect.severities.end())
      d.severity = severity->second.severity;
  return out;
}

}  // namespace isogloss
