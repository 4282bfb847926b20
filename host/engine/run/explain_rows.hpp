/// Who answers a syntax of an explained block: the dependencies that it asks, and the rows of their tables.
#pragma once

#include <optional>

#include "isogloss/engine/explain.hpp"

namespace isogloss {

class ExplainedRows {
 public:
  /// `given`: the tables of this run. Both arguments outlive this.
  ExplainedRows(const LinkedDialect& linked, const std::vector<DependencyElement>& given)
      : linked_(linked), given_(given), provisions_(provisions(linked)) {}

  std::vector<ExplainedAnswer> answers(const ig_syntax& syntax) const;
  /// The rows that have answered in this block since there were `first` of them; only those that this syntax has asked.
  std::vector<ExplainedRow> since(const Chain& chain, std::size_t first,
                                  std::optional<std::uint16_t> syntax = std::nullopt) const;
  /// Adds the rows that have answered the syntax when the chain was created: their values hold in each block. A row of
  /// the table itself, as of a dialect without a machine, tells nothing.
  void add_from_start(const Chain& chain, std::uint16_t syntax, std::vector<ExplainedRow>& rows) const;

 private:
  Location place_of(const LinkedDependency& dependency, const std::string& row) const;

  const LinkedDialect& linked_;
  const std::vector<DependencyElement>& given_;
  std::vector<Provision> provisions_;
};

/// The fields that call the syntax, "Parsing.Flags.…, Parsing.…".
std::string wakes_on(const ig_syntax& syntax);

}  // namespace isogloss
