#include "dialect/idle_rows.hpp"

#include <algorithm>
#include <tuple>

#include "isogloss_provenance.h"

namespace isogloss::cli {

namespace {

struct IdleCell {
  Location where;
  std::string name;
};

/// "1302" where no cell of the row has a meaning; "1320.Value" where only that one has none.
std::vector<IdleCell> idle_cells(const Chain& chain, std::size_t dependency, const ig_dependency& declared,
                                 const TableRow& row) {
  const auto key = std::find_if(row.attributes.begin(), row.attributes.end(),
                                [&](const Attribute& a) { return a.name == declared.row_key; });
  if (key == row.attributes.end()) return {};
  const auto has_meaning = [&](const char* column) {
    return chain.meaning_of(dependency, key->value, column).has_value();
  };
  std::vector<IdleCell> idle;
  for (const Attribute& cell : row.attributes)
    if (&cell != &*key && !has_meaning(cell.name.c_str())) idle.push_back({cell.where, key->value + "." + cell.name});
  // Where some column has a meaning, the column is wrong and not the name of the row.
  for (std::uint32_t c = 0; c < declared.column_count; ++c)
    if (has_meaning(declared.columns[c].name)) return idle;
  return idle.empty() ? idle : std::vector<IdleCell>{{row.where, key->value}};
}

}  // namespace

std::vector<Diagnostic> idle_rows(const LinkedDialect& linked, const Chain& chain) {
  std::vector<Diagnostic> out;
  for (const Provision& meanings : provisions(linked)) {
    if (meanings.service != IG_ROW_MEANING_SERVICE) continue;
    for (const std::size_t i : meanings.dependencies) {
      const LinkedDependency& table = linked.dependencies[i];
      std::vector<IdleCell> idle;
      for (const TableRow& row : table.element.rows) {
        std::vector<IdleCell> cells = idle_cells(chain, i, *table.dependency, row);
        idle.insert(idle.end(), cells.begin(), cells.end());
      }
      if (idle.empty()) continue;
      // In the order of the file: rows that a machine changes stand where its dialect has them.
      std::stable_sort(idle.begin(), idle.end(), [](const IdleCell& a, const IdleCell& b) {
        return std::tie(a.where.file, a.where.line, a.where.column) <
               std::tie(b.where.file, b.where.line, b.where.column);
      });
      std::vector<std::string> names;
      for (const IdleCell& cell : idle) names.push_back(cell.name);
      out.push_back(host_diagnostic("IG-0613", idle.front().where, {table.element.alias, listed(names, 8)}));
    }
  }
  return out;
}

}  // namespace isogloss::cli
