#include "run/explain_rows.hpp"

#include <algorithm>

#include "dialect/row_checks.hpp"

namespace isogloss {

std::vector<ExplainedAnswer> ExplainedRows::answers(const ig_syntax& syntax) const {
  std::vector<ExplainedAnswer> out;
  for (std::uint32_t i = 0; i < syntax.service_count; ++i)
    for (const Provision& p : provisions_)
      if (p.service == syntax.services[i].id)
        out.push_back({p.service, linked_.dependencies[p.dependencies.front()].element.alias});
  return out;
}

std::vector<ExplainedRow> ExplainedRows::since(const Chain& chain, std::size_t first,
                                               std::optional<std::uint16_t> syntax) const {
  std::vector<ExplainedRow> out;
  for (std::size_t i = first; i < chain.answered_rows.size(); ++i) {
    const Chain::AnsweredRow& row = chain.answered_rows[i];
    if (syntax && row.syntax != *syntax) continue;
    const LinkedDependency& dependency = linked_.dependencies[row.dependency];
    ExplainedRow one{dependency.element.alias, row.row, place_of(dependency, row.row)};
    if (std::find(out.begin(), out.end(), one) == out.end()) out.push_back(std::move(one));
  }
  return out;
}

void ExplainedRows::add_from_start(const Chain& chain, std::uint16_t syntax, std::vector<ExplainedRow>& rows) const {
  for (const Chain::AnsweredRow& row : chain.rows_at_start) {
    if (row.syntax != syntax) continue;
    const LinkedDependency& dependency = linked_.dependencies[row.dependency];
    ExplainedRow one{dependency.element.alias, row.row, place_of(dependency, row.row)};
    if (one.where.file.empty() || std::find(rows.begin(), rows.end(), one) != rows.end()) continue;
    rows.push_back(std::move(one));
  }
}

/// Where the row stands: in a file of this run, or in the dialect or machine.
Location ExplainedRows::place_of(const LinkedDependency& dependency, const std::string& row) const {
  Location out;
  const auto look = [&](const DependencyElement& element) {
    for (const TableRow& one : element.rows)
      if (key_of(*dependency.dependency, one) == row) out = one.where;
  };
  look(dependency.element);
  for (const DependencyElement& given : given_)
    if (given.alias == dependency.element.alias) look(given);
  return out;
}

std::string wakes_on(const ig_syntax& syntax) {
  std::string out;
  for (std::uint32_t i = 0; i < syntax.field_count; ++i) {
    const ig_field_decl& d = syntax.fields[i];
    if ((d.access & (IG_WAKE | IG_WAKE_WHILE)) == 0) continue;
    if (!out.empty()) out += ", ";
    out += d.path;
    if ((d.access & IG_WAKE_WHILE) != 0 && d.wake_value != nullptr) out += std::string("=") + d.wake_value;
  }
  return out;
}

}  // namespace isogloss
