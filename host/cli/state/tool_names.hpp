/// The names by which a program calls tools, and the numbers that stand for them in the run.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "isogloss/engine/exporter.hpp"
#include "isogloss/engine/linker.hpp"

namespace isogloss::cli {

class ToolNames : public Exporter {
 public:
  void begin(Document& initial, const SymbolTable& symbols) override;
  bool block(Document& document, const SymbolTable& symbols) override;
  bool end() override { return true; }

  /// Empty: the program calls this tool by its number.
  std::string of(std::int64_t number) const;
  /// The same names as rows of the table that answers for them, so that another run gives them the same numbers; empty
  /// where there are no names, or no such table.
  std::optional<DependencyElement> rows(const LinkedDialect& linked) const;

 private:
  ig_field name_ = IG_NO_FIELD, number_ = IG_NO_FIELD;
  std::map<std::int64_t, std::string> names_;
};

}  // namespace isogloss::cli
