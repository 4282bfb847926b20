#include "frames/datum_selection.hpp"

#include <cmath>

namespace heidenhain {

namespace {

const ig::Diagnostics datum_table_diagnostics{
    ig::diagnostic(IG_ERROR, "HEI-0173",
                   "datum {0} is not set, because the datum table is not known: the previous shift stays in force",
                   "CYCL DEF 7.1 #n uses the shift of a row in a table of the control. HeidenhainDatums holds the "
                   "tables; HeidenhainDatumTable reads the files of the control.",
                   "5 CYCL DEF 7.1 #5"),
    ig::diagnostic(IG_ERROR, "HEI-0365",
                   "the machine has no datum table {0}, so rows of it cannot be used: import the file of the control",
                   "The names of the tables are those of their files, without folders.", "5 SEL TABLE \"ZERO.D\""),
    ig::diagnostic(IG_ERROR, "HEI-0366",
                   "datum table {1} has no row {0}, so the previous shift stays in force: check the number of the row",
                   "Rows are whole numbers from 0. Row 0 is a row as any other.", "5 CYCL DEF 7.1 #77"),
    ig::diagnostic(IG_ERROR, "HEI-0367",
                   "datum {0} is not set, because none of {1} datum tables is selected: program SEL TABLE before it",
                   "The operator of a control activates a table. The option standard of HeidenhainDatums names the "
                   "table that is in force before SEL TABLE.",
                   "5 CYCL DEF 7.1 #5 (and rows of two tables)"),
};

}  // namespace

void DatumSelection::select(ig::Block& b, std::string_view path, ig::Where where) const {
  const DatumTables::Table* const table = tables_ ? tables_->find(path) : nullptr;
  b.set(selected_, b.symbol(table != nullptr ? std::string_view(table->name) : path));
  if (table == nullptr) b.report(ig::diag("HEI-0365"), where, path);
}

const DatumRow* DatumSelection::row(ig::Block& b, double number, std::string_view path, ig::Where where) const {
  const std::string_view name = path.empty() ? b.text(b.get_or(selected_, ig::Symbol{})) : path;
  const DatumTables::Table* const table = !tables_ ? nullptr : name.empty() ? tables_->standard() : tables_->find(name);
  if (table == nullptr) {
    const bool is_open = tables_ && tables_->size() > 1 && name.empty();
    if (is_open)
      b.report(ig::diag("HEI-0367"), where, number, static_cast<double>(tables_->size()));
    else
      b.report(ig::diag("HEI-0173"), where, number);
    return nullptr;
  }
  const bool is_number = number >= 0 && number < 1e9 && number == std::floor(number);
  const auto found = is_number ? table->rows.find(static_cast<std::int64_t>(number)) : table->rows.end();
  if (found == table->rows.end()) {
    b.report(ig::diag("HEI-0366"), where, number, std::string_view(table->name));
    return nullptr;
  }
  b.set_text(row_, table->name + "#" + std::to_string(found->first));
  return &found->second;
}

}  // namespace heidenhain
