#include "dialect_files.hpp"

#include "outputs.hpp"

namespace isogloss::cli {

std::vector<std::string> files_of_parts(const Dialect& dialect) {
  std::vector<std::string> out{dialect.file.string()};
  for (const ChainElement& element : dialect.chain) out.push_back(element.where.file);
  for (const InitialField& field : dialect.initial) out.push_back(field.where.file);
  for (const DependencyElement& table : dialect.dependencies) {
    out.push_back(table.where.file);
    out.push_back(table.source_file);
    for (const TableRow& row : table.rows) out.push_back(row.where.file);
  }
  return out;
}

std::vector<std::string> files_of_dialect(const Dialect& dialect) {
  std::vector<std::string> out = files_of_parts(dialect);
  if (dialect.is_machine)
    for (std::string& file : files_of_machine(dialect.file.string())) out.push_back(std::move(file));
  return out;
}

}  // namespace isogloss::cli
