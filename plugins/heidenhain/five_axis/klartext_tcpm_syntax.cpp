// FUNCTION TCPM and FUNCTION RESET TCPM: the tip of the tool is led while the rotary axes turn, as under M128 and M129.
#include <isogloss/cnc/tool_kinematics.hpp>

#include "language/block_words.hpp"
#include "language/klartext_values.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextTcpm {
  static constexpr auto spec = ig::syntax("KlartextTcpmSyntax", "FUNCTION TCPM: tool centre point control.")
                                   .after("KlartextBlockNumberSyntax", "KlartextCommentSyntax")
                                   .before("KlartextUnknownSyntax", "ToolCenterPointSyntax", "ToolHeightOffsetSyntax")
                                   .scans("Ff");

  Values values_;
  ig::Call tip_{{"G43.4"}, "H[]", ig::write};
  ig::Previous<std::int64_t> offset_id_{"ToolHeightCompensation.OffsetId"};
  ig::Call length_{{"G43"}, "", ig::write};
  ToolCenterMode mode_;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    if (!stands_first(text, position)) return position;
    const std::size_t tcpm = keyword(text, position, "FUNCTION TCPM");
    const std::size_t no_tcpm = keyword(text, position, "FUNCTION RESET TCPM");
    if (tcpm == position && no_tcpm == position) return position;
    const std::size_t end = statement_end(text, position);
    if (!values_.is_indexing()) lead_tip(b, text.substr(0, end), position, std::max(tcpm, no_tcpm), tcpm != position);
    return end;
  }

 private:
  void lead_tip(ig::Block& b, std::string_view text, std::size_t begin, std::size_t i, bool starts) const {
    if (starts || mode_.is_on(b)) put_code(b, starts ? tip_.code(0) : length_.code(0), begin, i);
    // Without a TOOL CALL before it the tool in the spindle is used; its length is not known.
    if (starts && !b.has(offset_id_)) put_code(b, tip_.word(0, 'H'), begin, i);
    const std::size_t after = i;
    if (starts)
      for (const std::string_view words : {"F TCP", "F CONT", "AXIS POS", "PATHCTRL AXIS", "REFPNT TIP-TIP"})
        if (const std::size_t next = skip(text, i), behind = keyword(text, next, words); behind != next) i = behind;
    i = skip(text, i);
    if (!starts || i >= text.size()) {
      if (!starts && i < text.size())
        b.report(ig::diag("HEI-0105"), ig::Where::columns(after, text.size()), trim(text.substr(after)),
                 std::string_view("FUNCTION RESET TCPM"));
      return;
    }
    b.report(ig::diag("HEI-0171"), where_of_line(text, i), rest_of_line(text, i),
             std::string_view("the words of rotary axes are positions of the axes, as after M128"));
  }
};

const ig::Register<KlartextTcpm> klartext_tcpm_syntax;

}  // namespace
}  // namespace heidenhain
