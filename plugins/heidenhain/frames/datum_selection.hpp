/// The datum table in force, and the words that a row of it makes for cycle 7.
#pragma once

#include <isogloss/sdk.hpp>

#include "frames/datum_tables.hpp"
#include "language/program_unit.hpp"

namespace heidenhain {

/// A member of the syntax that reads SEL TABLE and cycle 7. `where` is the word or statement, for diagnostics.
class DatumSelection {
 public:
  /// SEL TABLE "ZERO.D"; a table that the machine lacks is selected, too, so that no row of another one is taken for
  /// one of its rows.
  void select(ig::Block& b, std::string_view path, ig::Where where) const;

  /// The row of the table in force, or of the table `path` where there is one. Nothing, and reported, without a row.
  const DatumRow* row(ig::Block& b, double number, std::string_view path, ig::Where where) const;

  /// The value of an axis, 0 to 5 for X Y Z A B C, in the unit of the program.
  double value(const ig::Block& b, const DatumRow& row, std::size_t axis) const {
    return axis < 3 ? row.value[axis] / unit_.in_mm(b) : row.value[axis];
  }

 private:
  ig::Out<ig::Symbol> selected_{"DatumTable.Name", {ig::Life::modal, "", "The table that SEL TABLE has selected."}};
  ig::TextField row_{
      "DatumTable.Row", ig::write, {ig::Life::block, "", "The row of a datum table that this block uses."}};
  ig::Service<DatumTables> tables_{datum_table_service, ig::Need::optional, "The datum tables of the machine."};
  ProgramUnit unit_;
};

}  // namespace heidenhain
