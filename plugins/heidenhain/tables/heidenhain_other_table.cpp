// Tables of a TNC of which the machine takes nothing: pocket tables and pallet tables. They are recognised so that a
// folder of them is explained.
#include <isogloss/sdk.hpp>

#include "tables/table_head.hpp"

namespace heidenhain {

namespace {

struct OtherTable {
  TableKind kind;
  const char* row;
  const char* why;
};
constexpr OtherTable other_tables[] = {
    {TableKind::pockets, "pocket of the magazine", "where a tool is kept has no effect on its path"},
    {TableKind::pallets, "row of a pallet table", "the programs of pallets are run one at a time"},
};

struct HeidenhainOtherTable {
  static constexpr auto spec =
      ig::importer("HeidenhainOtherTable", "Pocket and pallet tables of a TNC, of which nothing is read.")
          .files("*.tch *.p")
          .fills("IsoCoordinateTable");

  static unsigned recognise(std::string_view text, std::string_view) {
    return other_table(read_table_head(text, true).kind) == nullptr ? 0 : 90;
  }

  void read(ig::Import& file) const {
    const TableHead head = read_table_head(file.text(), false);
    const OtherTable* const other = other_table(head.kind);
    if (other == nullptr) return file.report(ig::diag("HEI-0301"), head.names_begin, head.names_end);
    for (ig::TextLines::Iterator line(file.text(), head.names_begin); ++line != file.lines().end();) {
      const std::string_view row = without_blanks(line->text);
      if (row.starts_with("[END]")) return;
      if (!row.empty() && row.front() != ';')
        file.unused(other->row, other->why, line->begin, line->begin + line->text.size());
    }
  }

 private:
  static const OtherTable* other_table(TableKind kind) {
    for (const OtherTable& other : other_tables)
      if (other.kind == kind) return &other;
    return nullptr;
  }
};

const ig::Register<HeidenhainOtherTable> heidenhain_other_table;

}  // namespace
}  // namespace heidenhain
