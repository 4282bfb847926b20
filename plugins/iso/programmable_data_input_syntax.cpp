/// G10: the program writes the control's tables: work offsets (L2, L20) and tool offsets (L10 to L13). Under G90 the
/// words replace what stands in the table, under G91 they are added. The syntaxes that read the tables hear of it by a
/// signal and ask again in the same block.
#include <array>

#include "diagnostics.hpp"
#include "whole_number.hpp"
#include "work_offset_id.hpp"

namespace iso {
namespace {

struct ProgrammableDataInput {
  static constexpr auto spec =
      ig::syntax("ProgrammableDataInputSyntax", "G10 writes work offsets and tool offsets.")
          .after("ParameterizedFlagSyntax", "UnitModeSyntax", "PositioningModeSyntax")
          .before("ToolHeightOffsetSyntax", "IsoCoordinateOffsetSyntax", "IncrementalResolveSyntax");

  ig::Call g10_{{"G10"}, "L[] P[] R X Y Z"};
  ig::In<ig::Symbol> positioning_{"PositioningMode.Term"};
  ig::Signal offsets_changed_{"CoordinateOffset.~TableChanged", ig::write};
  ig::Signal tools_changed_{"ToolHeightCompensation.~TableChanged", ig::write};
  ig::Service<ig_work_offset_1> offsets_{"isogloss.work-offset/1", ig::Need::required, "Written by L2 and L20."};
  ig::Service<ig_tool_offset_1> tools_{"isogloss.tool-offset/1", ig::Need::optional, "Written by L10 to L13."};
  ig::Name g91_{"G91"};

  ig::Status build(ig::Block& b) {
    const auto words = b.take(g10_);
    if (!words) return ig::Status::unchanged;
    const auto where = ig::Where::word(g10_.code(0));
    const auto table = (*words)['L'], row = (*words)['P'];
    if (!table || !row) {
      b.report(diag("ISO-0221"), where, std::string_view(table ? "P" : "L"));
      return ig::Status::changed;
    }
    if (*table == 2 || *table == 20) {
      write_offset(b, *words, where);
    } else if (tools_ && *table >= 10 && *table <= 13 && whole_number(*table)) {
      write_tool(b, *words, where);
    } else {
      b.report(diag("ISO-0220"), where, *table);
    }
    return ig::Status::changed;
  }

 private:
  void write_offset(ig::Block& b, const ig::Words& words, ig::Where where) const {
    const double table = *words['L'], row = *words['P'];
    const WorkOffsetId id = table == 2 ? WorkOffsetId::basic(row) : WorkOffsetId::additional(row);
    double offset[3] = {0, 0, 0};
    const bool known = !id.text().empty() && offsets_->get(offsets_->self, ig::to_text(id.text()), offset) != 0;
    if (id.text().empty() || (table == 20 && !known)) {
      b.report(diag("ISO-0222"), where, table, row);
      return;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto word = words["XYZ"[axis]];
      if (word) offset[axis] = b.is(positioning_, g91_) ? offset[axis] + *word : *word;
    }
    offsets_->set(offsets_->self, ig::to_text(id.text()), offset);
    b.raise(offsets_changed_);
  }

  void write_tool(ig::Block& b, const ig::Words& words, ig::Where where) const {
    const auto column = static_cast<std::uint32_t>(*words['L'] - 10);
    const auto row = whole_number(*words['P']);
    const auto value = words['R'];
    if (!row || *row == 0) {
      b.report(diag("ISO-0222"), where, *words['L'], *words['P']);
      return;
    }
    if (!value) {
      b.report(diag("ISO-0221"), where, std::string_view("R"));
      return;
    }
    double mm = 0;
    if (b.is(positioning_, g91_)) tools_->get(tools_->self, *row, column, &mm);
    tools_->set(tools_->self, *row, column, mm + *value);
    b.raise(tools_changed_);
  }
};

const ig::Register<ProgrammableDataInput> registered;

}  // namespace
}  // namespace iso
