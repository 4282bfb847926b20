#include "frames/datum_selection.hpp"

#include <cmath>

#include "language/block_words.hpp"
#include "language/file_name.hpp"

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
  answered_.add(b, found->second.name);
  b.set_text(row_, table->name + "#" + std::to_string(found->first));
  return &found->second;
}

std::size_t DatumSelection::select_table(ig::Block& b, const Values& values, std::string_view text,
                                         std::size_t begin) const {
  const std::size_t i = keyword(text, begin, "SEL TABLE");
  if (i == begin) return begin;
  const std::size_t end = statement_end(text, begin);
  if (values.is_indexing()) return end;
  const auto path = file_name_at(b, values, text.substr(0, end), skip(text, i));
  const auto where = where_of_line(text, begin);
  if (path && path->empty())
    b.report(ig::diag("HEI-0104"), where, std::string_view("SEL TABLE"), std::string_view("the name of the table"));
  else if (path)
    select(b, *path, where);
  return end;
}

std::size_t DatumSelection::put_row(ig::Block& b, const Values& values, std::string_view text, std::size_t begin,
                                    std::size_t i, std::string_view table, const ig::Call& datum) const {
  const Value number = values.read(b, text, skip(text, i));
  if (!number.ok) {
    b.report(ig::diag("HEI-0104"), where_of_line(text, begin), std::string_view("CYCL DEF 7"),
             std::string_view("the row of the datum table"));
    return text.size();
  }
  const DatumRow* const found = row(b, number.number, table, ig::Where::columns(begin, number.end));
  if (found == nullptr) return number.end;
  put_code(b, datum.code(0), begin, number.end);
  for (std::size_t axis = 0; axis < found->value.size(); ++axis)
    if ((found->mask >> axis & 1u) != 0)
      put_word(b, datum.row(0)[axis], begin, number.end, found->value[axis] / (axis < 3 ? unit_.in_mm(b) : 1));
  return number.end;
}

void DatumSelection::put_named_row(ig::Block& b, const Values& values, std::string_view text, std::size_t begin,
                                   std::size_t i, const ig::Call& datum) const {
  std::string_view file;
  if (at(text, i) == '"') {
    const std::size_t close = std::min(text.find('"', i + 1), text.size());
    file = trim(piece(text, i + 1, close));
    i = skip(text, std::min(close + 1, text.size()));
  }
  if (i == text.size())
    return b.report(ig::diag("HEI-0104"), where_of_line(text, begin), std::string_view("TRANS DATUM TABLE"),
                    std::string_view("TABLINE, the row of the datum table,"));
  const std::size_t line = glued(text, i, "TABLINE");
  if (line == i) return report_not_a_word(b, text, i, "TRANS DATUM TABLE");
  const std::size_t rest = skip(text, put_row(b, values, text, begin, line, file, datum));
  if (rest < text.size()) report_not_a_word(b, text, rest, "TRANS DATUM TABLE");
}

}  // namespace heidenhain
