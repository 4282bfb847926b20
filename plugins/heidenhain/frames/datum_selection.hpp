/// The datum table in force, and the words that a row of it makes for cycle 7.
#pragma once

#include <isogloss/provenance.hpp>
#include <isogloss/sdk.hpp>

#include "frames/datum_tables.hpp"
#include "language/klartext_values.hpp"
#include "language/program_unit.hpp"

namespace heidenhain {

using namespace ig::cnc;

/// A member of the syntax that reads SEL TABLE and cycle 7. Positions are byte offsets into the text, which ends with
/// the statement; `begin` is where the statement or the word begins.
class DatumSelection {
 public:
  /// SEL TABLE "TNC:\TABLES\ZERO.D": the end of the statement; `begin` for another one.
  std::size_t select_table(ig::Block& b, const Values& values, std::string_view text, std::size_t begin) const;

  /// The row whose number stands at `i`, of the table in force or of `table`: its values become words of the first code
  /// of `datum`, as those of CYCL DEF 7.1 X+60. Returns the position after the number.
  std::size_t put_row(ig::Block& b, const Values& values, std::string_view text, std::size_t begin, std::size_t i,
                      std::string_view table, const ig::Call& datum) const;

  /// "ZERO.D" TABLINE5, after TRANS DATUM TABLE; the name may be left out.
  void put_named_row(ig::Block& b, const Values& values, std::string_view text, std::size_t begin, std::size_t i,
                     const ig::Call& datum) const;

 private:
  /// A table that the machine lacks is selected, too, so that no row of another one is taken for one of its rows.
  void select(ig::Block& b, std::string_view path, ig::Where where) const;
  /// Nothing, and reported, without a row.
  const DatumRow* row(ig::Block& b, double number, std::string_view path, ig::Where where) const;

  ig::Out<ig::Symbol> selected_{"DatumTable.Name", {ig::Life::modal, "", "The table that SEL TABLE has selected."}};
  ig::TextField row_{
      "DatumTable.Row", ig::write, {ig::Life::block, "", "The row of a datum table that this block uses."}};
  ig::Service<DatumTables> tables_{datum_table_service, ig::Need::optional, "The datum tables of the machine."};
  ig::AnsweredRows answered_{datum_table_service};
  ProgramUnit unit_;
};

}  // namespace heidenhain
