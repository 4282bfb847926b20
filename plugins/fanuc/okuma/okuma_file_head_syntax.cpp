/// `$PART.MIN%`: the line that an Okuma writes before a program, with its name in the control's memory.
#include <isogloss/cnc/scan.hpp>

namespace fanuc {

using namespace ig::cnc;

namespace {

struct OkumaFileHead {
  static constexpr auto spec = ig::syntax("OkumaFileHeadSyntax", "Reads the line $NAME% before a program.")
                                   .before("IsoCommentSyntax", "WordSyntax", "FlagSyntax")
                                   .scans("$");

  std::size_t scan(ig::Block&, std::string_view text, std::size_t position) const {
    if (text.find_first_not_of(" \t") != position) return position;
    const std::size_t end = block_end(text, position);
    const std::string_view line = trim(ig::cnc::piece(text, position, end));
    return line.find('%') + 1 == line.size() ? end : position;  // text after the name is not part of it
  }
};

const ig::Register<OkumaFileHead> okuma_file_head_syntax;

}  // namespace
}  // namespace fanuc
