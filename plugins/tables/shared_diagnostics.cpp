// Diagnostics that several importers of the plugin raise, or a header of theirs: they belong to no single page.
#include <isogloss/sdk.hpp>

namespace tables {
namespace {

const ig::Diagnostics shared_diagnostics{
    ig::diagnostic(IG_WARNING, "TAB-0104", "'{0}' is no number of a tool from 1 to 99999, so this tool is left out",
                   "The number names the row of the table of tools. Give the tool a number, and import the file again.",
                   "0;98.2;10"),
    ig::diagnostic(IG_WARNING, "TAB-0105",
                   "tool {0} stands in this file twice; values of the later one replace those of the earlier",
                   "A table has one row for each number. Give one of the two tools another number.",
                   "5;98.2;10 and 5;80.;6"),
    ig::diagnostic(IG_WARNING, "TAB-0112",
                   "the file names no unit, so its lengths are read as mm: give unit=mm or unit=inch",
                   "The unit is that of the machine, or of whoever wrote the file. In a machine, write "
                   "<Backup src=\"tool.tbl\" unit=\"mm\"/>, or \"inch\".",
                   "T1 P1 Z3.5 D0.5, from a machine in inches"),
};

}  // namespace
}  // namespace tables
