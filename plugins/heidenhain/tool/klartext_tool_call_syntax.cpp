// TOOL CALL: the tool, its axis, its speed and feed, its length and the allowance DL. TOOL DEF names a tool that the
// magazine may fetch, or writes its length and radius into the tool table.
#include <utility>

#include <isogloss/cnc/tool_dimension.hpp>
#include <isogloss/cnc/tool_kinematics.hpp>

#include "language/block_words.hpp"
#include "language/program_unit.hpp"
#include "motion/contour_side.hpp"
#include "motion/feed_words.hpp"
#include "motion/m_functions.hpp"
#include "tool/called_tool.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextToolCall {
  static constexpr auto spec = ig::syntax("KlartextToolCallSyntax", "TOOL CALL and TOOL DEF.")
                                   .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax")
                                   .before("ToolChangeSyntax", "ToolHeightOffsetSyntax")
                                   .scans("Tt");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "HEI-0151",
                     "tool axis {0} is not supported, so the plane stays the same: program X, Y or Z"),
      ig::diagnostic(IG_WARNING, "HEI-0394",
                     "M128 or FUNCTION TCPM stays in force at TOOL CALL: manuals demand M129 before it"),
      ig::diagnostic(IG_ERROR, "HEI-0153", "tool axis {0}: the tool length is compensated along Z, not along {0}"),
  };

  Values values_;
  FeedWords feed_;
  MFunctions m_;
  ContourSide side_;
  ig::Field<double> t_{"Parsing.T", ig::write};
  ig::Field<double> s_{"Parsing.S", ig::read | ig::write};
  ig::Codes change_{{"M06"}, ig::write};
  ig::Codes planes_{{"G17", "G18", "G19"}, ig::write};
  ig::Call length_{{"G43"}, "H[]", ig::write}, tip_{{"G43.4"}, "H[]", ig::write};
  ToolCenterMode tip_mode_;
  ig::Out<double> delta_{"ToolHeightCompensation.Delta_mm",
                         {ig::Life::modal, "mm", "What the tool call adds to the length of the table."}};
  ig::Signal delta_changed_{"ToolHeightCompensation.~TableChanged", ig::write};
  ig::Out<double> radius_delta_{"RadiusCompensation.Delta_mm",
                                {ig::Life::modal, "mm", "What the tool call adds to the radius of the table."}};
  ig::Previous<std::int64_t> row_{"ToolHeightCompensation.OffsetId"};
  ProgramUnit unit_;
  CalledTools tools_;
  ig::Service<ig_tool_offset_1> table_{"isogloss.tool-offset/1", ig::Need::optional,
                                       "Radius for Q108, length for Q114; TOOL DEF writes it."};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    if (!stands_first(text, position)) return position;
    const std::size_t call = keyword(text, position, "TOOL CALL"), define = keyword(text, position, "TOOL DEF");
    if (call == position && define == position) return position;
    const std::size_t end = statement_end(text, position);
    if (values_.is_indexing()) return end;
    if (call != position)
      read_call(b, text.substr(0, end), position, call);
    else
      read_definition(b, text.substr(0, end), position, define);
    return end;
  }

 private:
  /// What a tool call adds to the length and radius of the table, in mm.
  struct Deltas {
    std::optional<double> length{}, radius{};
    bool are_given = false;  ///< DR2 alone sets both to 0 as well
  };

  void read_call(ig::Block& b, std::string_view text, std::size_t begin, std::size_t i) const {
    i = skip(text, i);
    const std::size_t tool_begin = i;
    const CalledTool tool = tools_.read(b, values_, text, i);
    const double row = tools_.present_row(b, tool, text, tool_begin, i);
    if (!tool.is_given && i >= text.size()) {
      b.report(ig::diag("HEI-0119"), ig::Where::columns(begin, text.size()), std::string_view("the tool"));
      return;
    }
    Deltas deltas;
    bool is_rapid = false;
    while ((i = skip(text, i)) < text.size()) {
      const std::size_t next = call_word(b, text, i, deltas, is_rapid);
      if (next == i) {
        report_not_a_word(b, text, i, "TOOL CALL");
        break;
      }
      i = next;
    }
    if (const auto feed = feed_.word(b)) feed_.keep(b, *feed);
    const double radius = deltas.radius.value_or(0);
    if (tool.is_given || deltas.are_given) {
      const auto counts =
          static_cast<std::int64_t>(tool.is_known ? row : static_cast<double>(b.get_or(row_, std::int64_t{0})));
      side_.change_tool(b, counts, radius != b.get_or(radius_delta_, 0.0), begin, begin + 9);
      set_deltas(b, deltas.length.value_or(0), radius);
    }
    if (!tool.is_given && deltas.are_given)
      note_parameters(b, static_cast<double>(b.get_or(row_, std::int64_t{-1})), radius);
    if (!tool.is_known) return;
    put_word(b, t_.id(), begin, begin + 9, tool.number);
    put_code(b, change_.id(0), begin, begin + 9);
    put_length(b, row, begin, begin + 9);
    note_parameters(b, row, radius);
  }

  /// Under M128 and FUNCTION TCPM the tip of the new tool is led.
  void put_length(ig::Block& b, double row, std::size_t begin, std::size_t end) const {
    const bool leads_tip = tip_mode_.is_on(b);
    if (leads_tip) b.report(ig::diag("HEI-0394"), ig::Where::columns(begin, end));
    const ig::Call& call = leads_tip ? tip_ : length_;
    put_code(b, call.code(0), begin, end);
    put_word(b, call.word(0, 'H'), begin, end, row);
  }

  std::size_t call_word(ig::Block& b, std::string_view text, std::size_t i, Deltas& deltas, bool& is_rapid) const {
    const char c = to_upper(text[i]), d = to_upper(at(text, i + 1));
    if (c == 'D' && (d == 'L' || d == 'R')) {
      const std::size_t value = to_upper(at(text, i + 2)) == '2' && d == 'R' ? i + 3 : i + 2;
      const Value v = read(b, text, value);
      deltas.are_given = true;
      if (!v.ok || value != i + 2) return v.ok ? v.end : value;
      std::optional<double>& delta = d == 'L' ? deltas.length : deltas.radius;
      if (delta) report_repeated(b, text, i, v.end);
      delta = v.number * unit_.in_mm(b);
      return v.end;
    }
    if (c == 'S') {
      const Value v = read(b, text, i + 1);
      if (v.ok && b.has(s_)) report_repeated(b, text, i, v.end);
      if (v.ok) put_word(b, s_.id(), i, v.end, v.number);
      return v.ok ? v.end : i + 1;
    }
    if (c == 'F') return feed_.scan(b, values_, text, i, is_rapid);
    if (c == 'M') return m_.scan(b, values_, text, i);
    if (!is_letter(c) || is_letter(d) || is_digit(d)) return i;
    const std::size_t axis = std::string_view("ZYX").find(c);
    if (axis < 3) put_code(b, planes_.id(axis), i, i + 1);
    if (axis == 1 || axis == 2) b.report(ig::diag("HEI-0153"), ig::Where::columns(i, i + 1), piece(text, i, i + 1));
    if (axis > 2) b.report(ig::diag("HEI-0151"), ig::Where::columns(i, i + 1), piece(text, i, i + 1));
    return i + 1;
  }
  /// A final point does not belong to the number: DL0.
  Value read(ig::Block& b, std::string_view text, std::size_t i) const {
    return values_.read(b, text, skip_blanks(text, i));
  }

  void set_deltas(ig::Block& b, double length, double radius) const {
    b.set(delta_, length);
    b.set(radius_delta_, radius);
    b.raise(delta_changed_);
  }

  /// Q108 and Q114. A tool that was never measured is 0 in the table: its parameters have no value.
  void note_parameters(ig::Block& b, double tool, double delta) const {
    QStore* const store = values_.store();
    if (store == nullptr || !table_ || !(tool >= 0 && tool < 1e9)) return;
    const auto sum = [&](ToolDimension which) {
      const double mm = tool_dimension(table_, static_cast<std::int64_t>(tool), which).value_or(0);
      return mm != 0 && std::isfinite(mm) ? mm : QStore::undefined;
    };
    const double unit = unit_.in_mm(b);  // parameters count in the unit of the program
    const double radius = (sum(ToolDimension::radius) + delta) / unit, length = sum(ToolDimension::length) / unit;
    store->set_of_tool(QStore::radius_of_tool, radius);
    store->set_of_tool(QStore::length_of_tool, length);
    if (!std::isnan(radius)) values_.note(b, QStore::radius_of_tool, radius);
    if (!std::isnan(length)) values_.note(b, QStore::length_of_tool, length);
  }

  /// TOOL DEF 5 names a tool that the magazine may fetch; TOOL DEF 5 L+100 R+5 defines it.
  void read_definition(ig::Block& b, std::string_view text, std::size_t begin, std::size_t i) const {
    i = skip(text, i);
    const CalledTool tool = tools_.read(b, values_, text, i);
    if (!tool.is_given) b.report(ig::diag("HEI-0119"), where_of_line(text, begin), std::string_view("the tool"));
    if (!tool.is_known) return;
    std::array<bool, 2> named{};
    const std::size_t words = skip(text, i);
    if (words >= text.size()) return put_word(b, t_.id(), begin, i, tool.number);
    for (i = words; i < text.size(); i = skip(text, i)) {
      const char c = to_upper(text[i]);
      const bool is_word = (c == 'L' || c == 'R') && (!is_letter(at(text, i + 1)) || to_upper(at(text, i + 1)) == 'Q');
      if (!is_word) {
        report_not_a_word(b, text, i, "TOOL DEF");
        return;
      }
      const Value v = read(b, text, i + 1);
      const std::size_t end =
          v.ok ? v.end : skip_while(text, i + 1, [](char sign) { return sign == '+' || sign == '-'; });
      const auto where = ig::Where::columns(i, end);
      if (!v.ok) {
        b.report(ig::diag("HEI-0104"), where, std::string_view("TOOL DEF"), piece(text, i, end));
      } else if (!tool.row || !define(*tool.row, c == 'L' ? 0 : 2, v.number * unit_.in_mm(b))) {
        report_not_executed(b, text, begin, "the table of tools has no such tool");
        return;
      }
      if (v.ok && std::exchange(named[c == 'L' ? 0 : 1], true)) report_repeated(b, text, i, end);
      i = end;
    }
  }

  /// Writes a length or radius into the table; tool 0 means no tool and has neither.
  bool define(double tool, std::uint32_t column, double mm) const {
    if (tool == 0 && mm == 0) return true;
    const bool is_number = table_ && tool >= 0 && tool < 1e9 && std::isfinite(mm);
    return is_number && table_->set(table_->self, static_cast<std::int64_t>(tool), column, mm) != 0;
  }
};

const ig::Register<KlartextToolCall> klartext_tool_call_syntax;

}  // namespace
}  // namespace heidenhain
