/// G56 H and G53 of an Okuma: tool length compensation along Z. G56 adds the length of row H (geometry and wear), G53
/// and H0 end it.
#include <cmath>

#include <isogloss/cnc/tool_dimension.hpp>
#include <isogloss/cnc/whole_number.hpp>
#include <isogloss/sdk.hpp>

namespace fanuc {

using namespace ig::cnc;

namespace {

struct OkumaToolLength {
  static constexpr auto spec =
      ig::syntax("OkumaToolLengthSyntax", "G56 H and G53 of an Okuma: tool length compensation along Z.")
          .after("ParameterizedFlagSyntax")
          .before("ToolHeightOffsetSyntax", "ProgramXyzSyntax", "McXyzSyntax", "CannedCycleResolveSyntax",
                  "NotExecutedSyntax");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "FAN-0251",
                     "G56 names no tool of the table by its H, so the previous tool length stays in force"),
      ig::diagnostic(IG_WARNING, "FAN-0255", "H{0} without G56 is not executed, so the length of H{1} stays in force"),
  };

  ig::Call start_{{"G56"}, "H[]"};
  ig::Codes end_{"G53"};
  ig::Codes others_{{"G43", "G44", "G49"}, ig::read};
  ig::Word h_{"Parsing.H", ig::take | ig::wake, ""};
  ig::Out<ig::Symbol> term_{"ToolHeightCompensation.Term"};
  ig::Out<std::int64_t> offset_id_{"ToolHeightCompensation.OffsetId"};
  ig::Out<double> offset_{"ToolHeightCompensation.Offset_mm"};
  ig::Transform frame_{"ToolHeightCompensation"};
  ig::Service<ig_tool_offset_1> table_{"isogloss.tool-offset/1", ig::Need::required, "Length geometry and wear."};
  ig::Name g56_{"G56"}, g49_{"G49"};

  ig::Status restart(ig::Block& b) {
    if (!b.is(term_, g56_)) return ig::Status::unchanged;
    b.set_translation(frame_, {0, 0, b.get_or(offset_, 0.0)});
    return ig::Status::changed;
  }

  ig::Status build(ig::Block& b) {
    const bool ends = b.take(end_).has_value();
    const auto call = b.take(start_);
    if (call) {
      const auto row = whole_number((*call)['H'].value_or(-1));
      const auto length = row == 0 ? std::optional(0.0)
                          : row    ? tool_dimension(table_, *row, ToolDimension::length)
                                   : std::nullopt;
      if (length && std::isfinite(*length)) {
        b.set(offset_id_, *row);
        compensate(b, g56_, *length);
      } else {
        b.report(ig::diag("FAN-0251"), ig::Where::word(start_.code(call->row)));
      }
    } else if (ends) {
      compensate(b, g49_, 0);
    }
    const auto h = b.is(term_, g56_) && !b.find(others_) ? b.take(h_) : std::nullopt;
    if (h)
      b.report(ig::diag("FAN-0255"), ig::Where::word(h_.id()), *h,
               static_cast<double>(b.get_or(offset_id_, std::int64_t{0})));
    return call || ends || h ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  void compensate(ig::Block& b, ig::Symbol term, double length) const {
    b.set(term_, term);
    b.set(offset_, length);
    b.set_translation(frame_, {0, 0, length});
  }
};

const ig::Register<OkumaToolLength> okuma_tool_length_syntax;

}  // namespace
}  // namespace fanuc
