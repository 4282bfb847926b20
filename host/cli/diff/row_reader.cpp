#include "diff/row_reader.hpp"

#include <fmt/format.h>

namespace isogloss::cli::parting {

namespace {

std::string copy_of(ig_text text) { return {text.data, text.size}; }

std::string nine_digits(double value) { return fmt::format("{:.9g}", value); }

std::string unit_of(const ig_column_decl& column) {
  return column.unit != nullptr && column.is_text == 0 ? column.unit : "";
}

}  // namespace

std::shared_ptr<const RowText> RowReader::read(std::size_t dependency, const std::string& row) {
  const ig_dependency& declared = *linked_.dependencies[dependency].dependency;
  DependencyTable* const table = chain_->table(linked_.dependencies[dependency].element.alias);
  Known& known = known_[{dependency, row}];
  if (known.text == nullptr)
    for (std::uint32_t c = 0; c < declared.column_count; ++c)
      known.meanings.push_back(chain_->meaning_of(dependency, row, declared.columns[c].name));
  std::vector<std::string> cells(declared.column_count);
  for (std::uint32_t c = 0; table != nullptr && c < declared.column_count; ++c) {
    if (declared.columns[c].is_text != 0)
      cells[c] = table->text(row, c);
    else if (const std::optional<double> value = table->value(row, c))
      cells[c] = fmt::format("{}", *value);
  }
  if (known.text != nullptr && known.cells == cells) return known.text;
  known.cells = std::move(cells);
  known.text = text_of(dependency, row, known);
  return known.text;
}

std::shared_ptr<const RowText> RowReader::text_of(std::size_t dependency, const std::string& row,
                                                  const Known& known) const {
  const ig_dependency& declared = *linked_.dependencies[dependency].dependency;
  auto out = std::make_shared<RowText>();
  for (std::uint32_t c = 0; c < declared.column_count; ++c) {
    if (known.cells[c].empty()) continue;
    const std::optional<ig_row_meaning>& meaning = known.meanings[c];
    RowCell cell{declared.columns[c].name, known.cells[c], known.cells[c], unit_of(declared.columns[c]), 1};
    if (meaning) {
      out->title = copy_of(meaning->title);
      out->prefix = copy_of(meaning->prefix);
      cell.unit = copy_of(meaning->unit);
      cell.scale = meaning->scale != 0 ? meaning->scale : 1;
    }
    if (declared.columns[c].is_text == 0) cell.shown = nine_digits(std::stod(cell.given) * cell.scale);
    if (!cell.unit.empty()) cell.shown += " " + cell.unit;
    out->cells.push_back(std::move(cell));
  }
  const bool has_one_value =
      out->cells.size() == 1 && declared.column_count > 0 && out->cells[0].column == declared.columns[0].name;
  if (out->title.empty()) out->name = linked_.dependencies[dependency].element.alias + " ";
  out->name += out->prefix + row;
  for (const RowCell& cell : out->cells)
    out->value += (out->value.empty() ? "" : " ") + (has_one_value ? std::string() : cell.column + "=") + cell.shown;
  return out;
}

}  // namespace isogloss::cli::parting
