// ; opens a comment, up to the end of the line. Round brackets do not enclose comments here.
#include <isogloss/cnc/scan.hpp>

namespace siemens {

using namespace ig::cnc;

namespace {

struct SiemensComment {
  static constexpr auto spec = ig::syntax("SiemensCommentSyntax", "Reads comments: ; to the end of the line.")
                                   .before("SiemensFlowSyntax", "SiemensWordSyntax")
                                   .scans(";");

  ig::Out<ig::Symbol> symbol_{"Comment.Symbol"};
  ig::TextField text_{"Comment.Text", ig::write};
  ig::Name semicolon_{";"};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) const {
    const std::size_t end = block_end(text, position);
    b.set(symbol_, semicolon_);
    b.set_text(text_, trim(ig::cnc::piece(text, position + 1, end)));
    return end;
  }
};

const ig::Register<SiemensComment> siemens_comment_syntax;

}  // namespace
}  // namespace siemens
