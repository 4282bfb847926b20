#include "isogloss/engine/needs.hpp"

#include <algorithm>
#include <set>

#include "dialect/row_checks.hpp"

namespace isogloss {

namespace {

/// The last row of this name: of several files it is the one whose values hold.
Location place_of(const LinkedDependency& d, std::string_view row) {
  const auto is_row = [&](const TableRow& r) { return key_of(*d.dependency, r) == row; };
  const auto last = std::find_if(d.element.rows.rbegin(), d.element.rows.rend(), is_row);
  return last == d.element.rows.rend() ? Location{} : last->where;
}

using Names = std::set<std::string, std::less<>>;

/// What blocks read, from the first one on: what the chain reads before it is no need of the program.
struct Reads : Exporter {
  explicit Reads(const LinkedDialect& dialect)
      : linked(dialect), rows(dialect.dependencies.size()), given(dialect.dependencies.size()) {}

  void listen(Chain& working) {
    chain = &working;
    chain->listen_to_rows();
  }
  void begin(Document&, const SymbolTable&) override {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      DependencyTable* const table = chain->table(linked.dependencies[i].element.alias);
      given[i].insert(table->rows().begin(), table->rows().end());
    }
    chain->row_asked = [this](std::size_t dependency, std::string_view row) {
      if (!rows[dependency].contains(row)) rows[dependency].emplace(row);
    };
  }
  bool block(Document&, const SymbolTable&) override { return true; }
  bool end() override { return true; }

  const LinkedDialect& linked;
  Chain* chain = nullptr;
  std::vector<Names> rows;   ///< by dependency: those that were read
  std::vector<Names> given;  ///< and those that the table had before the program wrote any
};

}  // namespace

ProgramNeeds find_needs(const LinkedDialect& linked, Source& source, const std::string& name, RunOptions options,
                        DiagnosticSink& sink) {
  ProgramNeeds out;
  Reads reads(linked);
  options.prepare = [&](Chain& chain) { reads.listen(chain); };
  options.called = [&](std::string_view program, const std::string& file) {
    out.programs.push_back({std::string(program), file});
  };
  run(linked, source, name, options, {&reads}, sink);
  for (std::size_t i = 0; i < reads.rows.size(); ++i)
    for (const std::string& row : reads.rows[i])
      out.rows.push_back({linked.dependencies[i].element.alias, row, reads.given[i].contains(row),
                          place_of(linked.dependencies[i], row)});
  return out;
}

}  // namespace isogloss
