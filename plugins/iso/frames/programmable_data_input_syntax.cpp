/// G10: the program writes the control's tables: work offsets (L2, L20) and tool offsets (L10 to L13). Under G90 the
/// words replace the values in the table, under G91 they are added. A signal tells the syntaxes that read the tables,
/// and they read again in the same block. Between G10 L50 and G11 the words are parameters of the control, after G10 L3
/// tool life data: they are taken, so that they are not executed as a motion or a tool change.
#include <isogloss/cnc/rotary_offset.hpp>
#include <isogloss/cnc/whole_number.hpp>
#include <isogloss/cnc/work_offset_id.hpp>
#include <isogloss/cnc/work_origin.hpp>
#include <isogloss/sdk.hpp>

#include "motion/further_axis_order.hpp"

namespace iso {

using namespace ig::cnc;

namespace {

enum class ToolColumns { geometry_wear, wear_geometry };
enum class L2Rows { to_g59, all_sets };

struct ProgrammableDataInput {
  static constexpr auto spec = ig::syntax("ProgrammableDataInputSyntax", "G10 writes work offsets and tool offsets.")
                                   .after("ParameterizedFlagSyntax", "UnitModeSyntax", "PositioningModeSyntax")
                                   .before("ToolChangeSyntax", "ToolHeightOffsetSyntax", "IsoCoordinateOffsetSyntax",
                                           "IncrementalResolveSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0220", "G10 L{0} is not executed: the table keeps its values"),
      ig::diagnostic(IG_ERROR, "ISO-0221", "G10 without {0}: the table keeps its values"),
      ig::diagnostic(IG_ERROR, "ISO-0222", "G10 L{0} P{1}: the table has no such row and keeps its values"),
      ig::diagnostic(IG_WARNING, "ISO-0371", "{0} belongs to a parameter of the control, which is not written"),
      ig::diagnostic(IG_ERROR, "ISO-0544",
                     "{0} beside G10 L{1} is not executed, because this table has no such value: remove the word"),
  };

  ig::Call g10_{{"G10"}, "L[] P[] R X Y Z A B C"};
  ig::Codes g11_{"G11"};
  /// Raised from G10 L50 to G11.
  ig::Signal parameters_{"ProgrammableDataInput.~Parameters", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  /// Raised from G10 L3, L75 or L76 to G11.
  ig::Signal tool_data_{"ProgrammableDataInput.~ToolData", ig::read | ig::write | ig::wake_while, ig::Life::modal};
  ig::Word p_{"Parsing.P", ig::read, ""}, r_{"Parsing.R", ig::read};
  std::array<ig::Word, 5> of_tool_{ig::Word{"Parsing.T", ig::read, ""}, ig::Word{"Parsing.H", ig::read, ""},
                                   ig::Word{"Parsing.D", ig::read, ""}, ig::Word{"Parsing.L", ig::read, ""},
                                   ig::Word{"Parsing.Q", ig::read}};
  ig::Xyz positions_{"Parsing", ig::read};
  ig::Word i_{"Parsing.I", ig::read}, j_{"Parsing.J", ig::read}, k_{"Parsing.K", ig::read};
  ig::In<ig::Symbol> positioning_{"PositioningMode.Term"};
  ig::Signal offsets_changed_{"CoordinateOffset.~TableChanged", ig::write};
  ig::Signal tools_changed_{"ToolHeightCompensation.~TableChanged", ig::write};
  ig::Service<ig_work_offset_1> offsets_{"isogloss.work-offset/1", ig::Need::required, "Written by L2 and L20."};
  ig::Service<ig_tool_offset_1> tools_{"isogloss.tool-offset/1", ig::Need::optional, "Written by L10 to L13."};
  RotaryWords machine_axes_;
  NamesFurtherAxes names_further_;
  FurtherAxisOrder further_{"G10"};
  ig::Out<ig::Symbol> further_row_{"FurtherAxes.Row", {ig::Life::block, "", "The row in which G10 writes U, V and W."}};
  ig::Name g91_{"G91"};
  ig::Choice<ToolColumns> tool_columns_{
      "tool-columns", "geometry-wear|wear-geometry", "geometry-wear",
      "The columns that L10 and L11 (length) and L12 and L13 (radius) write, in this order."};
  ig::Choice<L2Rows> l2_rows_{"l2-rows", "to-G59|all-sets", "to-G59",
                              "What P of L2 counts: EXT and G54 to G59, or all sets like P of G54."};

  ig::Status build(ig::Block& b) {
    const bool ends = b.take(g11_).has_value();
    if (ends) {
      b.erase(parameters_);
      b.erase(tool_data_);
    }
    const auto words = b.take(g10_);
    if (!words) {
      const bool swallowed =
          (b.is_raised(parameters_) && swallow_parameter(b)) || (b.is_raised(tool_data_) && swallow_tool_data(b));
      return swallowed || ends ? ig::Status::changed : ig::Status::unchanged;
    }
    const auto where = ig::Where::word(g10_.code(0));
    further_.give(b);
    const auto table = (*words)['L'] == 1 ? std::optional(11.0) : (*words)['L'];  // L1: older programs
    if (!is_work_offset(table)) report_not_executed(b, *words);
    if (table && (*table == 50 || *table == 52)) b.raise(parameters_);
    if (table && (*table == 3 || *table == 75 || *table == 76)) b.raise(tool_data_);
    const bool is_offset = is_work_offset(table);
    if (is_offset && (*words)['R']) report_unused(b, 'R', *table);
    const bool is_tool = tools_ && table && *table >= 10 && *table <= 13 && whole_number(*table);
    for (const char axis : {'X', 'Y', 'Z'})
      if (is_tool && (*words)[axis]) report_unused(b, axis, *table);
    if (table && !is_offset && !is_tool) {
      b.report(ig::diag("ISO-0220"), where, *table);
    } else if (!table || !(*words)['P'] || (is_tool && !(*words)['R'])) {
      b.report(ig::diag("ISO-0221"), where, std::string_view(!table ? "L" : !(*words)['P'] ? "P" : "R"));
    } else if (!(is_offset ? write_offset(b, *words) : write_tool(b, *words, *table))) {
      b.report(ig::diag("ISO-0222"), where, *table, *(*words)['P']);
    }
    return ig::Status::changed;
  }

 private:
  static bool is_work_offset(std::optional<double> table) { return table && (*table == 2 || *table == 20); }

  void report_unused(ig::Block& b, char word, double table) const {
    b.report(ig::diag("ISO-0544"), ig::Where::word(g10_.word(0, word)), std::string_view(&word, 1), table);
  }

  /// A, B and C have no meaning beside a tool offset.
  void report_not_executed(ig::Block& b, const ig::Words& words) const {
    for (const char axis : rotary_names)
      if (words[axis]) b.report(ig::diag("ISO-0266"), ig::Where::word(g10_.word(0, axis)), b.text(words.code));
  }

  /// False when the table has no such row.
  bool write_offset(ig::Block& b, const ig::Words& words) const {
    const double row = *words['P'];
    const WorkOffsetId id = *words['L'] != 2               ? WorkOffsetId::additional(row)
                            : l2_rows_ == L2Rows::all_sets ? WorkOffsetId::of_all(row)
                                                           : WorkOffsetId::basic(row);
    auto origin = id.text().empty() ? std::nullopt : linear_origin(offsets_, id.text());
    if (!origin) return false;
    const bool adds = b.is(positioning_, g91_);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (const auto word = words["XYZ"[axis]]) (*origin)[axis] = adds ? (*origin)[axis] + *word : *word;
    b.raise(offsets_changed_);
    if (names_further_(b)) b.set(further_row_, b.symbol(id.text()));
    return set_linear_origin(offsets_, id.text(), *origin) && write_rotary(b, words, id.text());
  }

  bool write_rotary(ig::Block& b, const ig::Words& words, std::string_view id) const {
    const PartialAngles named = rotary_coordinates(b, machine_axes_, words, g10_);
    if (named.mask == 0) return true;
    auto origin = rotary_origin(offsets_, id);
    if (!origin) {
      report_not_executed(b, words);
      return true;
    }
    const bool adds = b.is(positioning_, g91_);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double to = named.value[axis] + (adds ? (*origin)[axis] : 0);
      if (named.has(axis) && machine_axes_.accept(b, axis, to, g10_.word(0, rotary_names[axis]))) (*origin)[axis] = to;
    }
    return set_rotary_origin(offsets_, id, *origin);
  }

  bool write_tool(ig::Block& b, const ig::Words& words, double table) const {
    const auto column = static_cast<std::uint32_t>(table - 10) ^ (tool_columns_ == ToolColumns::wear_geometry ? 1u : 0);
    const auto row = whole_number(*words['P']);
    if (!row || *row == 0) return false;
    double old = 0;
    if (b.is(positioning_, g91_)) tools_->get(tools_->self, *row, column, &old);
    b.raise(tools_changed_);
    return tools_->set(tools_->self, *row, column, old + *words['R']) != 0;
  }

  bool programs_position(const ig::Block& b) const {
    return b.get(positions_).mask != 0 || b.has(i_) || b.has(j_) || b.has(k_);
  }

  /// The diagnostic at G10 has reported that these data are not stored.
  bool swallow_tool_data(ig::Block& b) const {
    if (programs_position(b)) return false;
    bool any = b.take(p_).has_value();
    for (const ig::Word& word : of_tool_) any |= b.take(word).has_value();
    return b.take(r_).has_value() || any;
  }

  /// P and R of a block that programs no position.
  bool swallow_parameter(ig::Block& b) const {
    if (programs_position(b)) return false;
    bool any = false;
    for (const ig::Word* const word : {&p_, &r_}) {
      if (!b.take(*word)) continue;
      b.report(ig::diag("ISO-0371"), ig::Where::word(word->id()), std::string_view(word == &p_ ? "P" : "R"));
      any = true;
    }
    return any;
  }
};

const ig::Register<ProgrammableDataInput> programmable_data_input_syntax;

}  // namespace
}  // namespace iso
