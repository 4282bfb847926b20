#include "dialect/dropped_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace isogloss::cli {

namespace {

constexpr std::string_view flags_of_text = "Parsing.Flags.", words_of_text = "Parsing.";

/// "G20" of Parsing.Flags.G20, "X" of Parsing.X; empty: no code and no word of a program.
std::string dropped_name(const FieldInfo& field) {
  const std::string& path = field.path;
  if (field.hidden || field.previous_of != IG_NO_FIELD || !path.starts_with(words_of_text)) return {};
  const std::string name = path.substr(path.starts_with(flags_of_text) ? flags_of_text.size() : words_of_text.size());
  // A word of a code goes with the code.
  return name.empty() || name[0] == '~' || name.find('.') != std::string::npos ? std::string() : name;
}

std::set<std::string> taken_by(const LinkedDialect& linked, const LinkedSyntax& syntax) {
  std::set<std::string> out;
  for (ig_field f = 0; f < linked.layout.fields.size(); ++f)
    if ((syntax.may_take[f >> 6] >> (f & 63) & 1) != 0)
      if (std::string name = dropped_name(linked.layout.fields[f]); !name.empty()) out.insert(std::move(name));
  return out;
}

std::set<std::string> taken_by(const LinkedDialect& linked) {
  std::set<std::string> out;
  for (const LinkedSyntax& syntax : linked.chain) out.merge(taken_by(linked, syntax));
  return out;
}

}  // namespace

std::vector<Diagnostic> dropped_words(const LinkedDialect& linked, Session& session) {
  std::vector<Diagnostic> out;
  const Dialect& dialect = linked.dialect;
  const auto removes = [&](const AppliedEdit& edit) {
    return edit.dialect == dialect.name && !edit.of_dependency && (edit.kind == "Remove" || edit.kind == "Replace");
  };
  if (dialect.ancestors.empty() || std::none_of(dialect.edits.begin(), dialect.edits.end(), removes)) return out;
  DiagnosticList unheard;
  const std::unique_ptr<LinkedDialect> base = session.link(dialect.ancestors.front(), {}, unheard);
  if (base == nullptr) return out;
  const std::set<std::string> taken = taken_by(linked);
  for (const AppliedEdit& edit : dialect.edits) {
    if (!removes(edit)) continue;
    const auto removed = std::find_if(base->chain.begin(), base->chain.end(),
                                      [&](const LinkedSyntax& s) { return s.element.alias == edit.anchor; });
    if (removed == base->chain.end()) continue;
    std::vector<std::string> lost;
    for (const std::string& name : taken_by(*base, *removed))
      if (!taken.contains(name)) lost.push_back(name);
    if (!lost.empty())
      out.push_back(host_diagnostic("IG-0611", edit.where, {listed(lost, 8), edit.anchor, base->dialect.name}));
  }
  return out;
}

}  // namespace isogloss::cli
