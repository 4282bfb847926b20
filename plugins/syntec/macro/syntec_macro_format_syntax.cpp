/// Files in MACRO format: the mark %@MACRO, comments, and the end of a block, after which another one may stand on the
/// line.
#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

#include "macro/macro_shared.hpp"

namespace syntec {

using namespace ig::cnc;

namespace {

struct SyntecMacroFormat {
  static constexpr auto spec =
      ig::syntax("SyntecMacroFormatSyntax", "Recognises files in MACRO format, their comments and their line ends.")
          .after("SyntecMacroStatementSyntax")
          .before("TapeBoundarySyntax", "BlockSkipSyntax", "IsoCommentSyntax", "WordSyntax", "FlagSyntax")
          .scans("%(/;")
          .scans_ahead();
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_NOTE, "SYN-0065", "'{0}' is the title of the program and is not executed"),
      ig::diagnostic(IG_ERROR, "SYN-0054",
                     "'{0}' is not executed: in MACRO format ( ) groups a calculation, and comments are // or (* *)"),
  };

  FormatField format_{ig::read | ig::write};
  ig::TextField mark_{"TapeBoundary.Text", ig::read | ig::write};
  ig::Out<ig::Symbol> symbol_{"Comment.Symbol"};
  ig::TextField comment_{"Comment.Text", ig::write};
  ig::Name slashes_{"//"}, brackets_{"(*"};
  ig::Flow flow_;
  SharedScan scan_;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (text[position] == '%')
      if (const std::size_t end = mark_end(text, position); end > position) return begin_macro(b, text, position, end);
    if (!format_.is_macro(b) || !b.is_in_turn()) return position;
    const char c = text[position], next = at(text, position + 1);
    if (c == ';') return end_of_block(b, text, position);
    if (c == '/' && next == '/') return comment(b, slashes_, text, position, block_end(text, position), 0);
    if (c != '(') return position;
    if (next != '*') return stray_bracket(b, text, position);
    const std::size_t close = text.find("*)", position + 2);
    scan_->comment = {close == std::string_view::npos, flow_.here(b).line};
    if (scan_->comment.is_open) return comment(b, brackets_, text, position, block_end(text, position), 0);
    return comment(b, brackets_, text, position, close + 2, 2);
  }

 private:
  static std::size_t mark_end(std::string_view text, std::size_t position) {
    constexpr std::string_view mark = "@MACRO";
    if (text.find_first_not_of(" \t") != position) return position;
    const std::size_t name = skip_blanks(text, position + 1);
    const std::size_t end = std::min(name + mark.size(), text.size());
    return !equals_ignoring_case(piece(text, name, end), mark) || is_letter(at(text, end)) ? position : end;
  }

  /// The rest of the line is the title of the program.
  std::size_t begin_macro(ig::Block& b, std::string_view text, std::size_t position, std::size_t end) {
    if (!b.is_in_turn()) return position;
    scan_->begin_macro(b, flow_, format_);
    b.set_text(mark_, piece(text, position, end));
    const std::size_t title = skip_blanks(text, end), line_end = block_end(text, title);
    if (title >= line_end || (text[title] == '/' && at(text, title + 1) == '/')) return end;
    b.report(ig::diag("SYN-0065"), ig::Where::columns(title, line_end), trim(piece(text, title, line_end)));
    return line_end;
  }

  std::size_t comment(ig::Block& b, const ig::Name& opened_by, std::string_view text, std::size_t begin,
                      std::size_t end, std::size_t closing) const {
    if (!b.is_fresh(symbol_)) {
      b.set(symbol_, opened_by);
      b.set_text(comment_, trim(piece(text, begin + 2, end - closing)));
    }
    return end;
  }

  static std::size_t end_of_block(ig::Block& b, std::string_view text, std::size_t position) {
    const std::size_t next = skip_blanks(text, position + 1);
    const bool is_last = is_block_end(text, next) || (text[next] == '/' && at(text, next + 1) == '/');
    if (!is_last) b.flow(IG_FLOW_SPLIT, position + 1);
    return position + 1;
  }

  static std::size_t stray_bracket(ig::Block& b, std::string_view text, std::size_t position) {
    std::size_t end = position;
    while (!is_block_end(text, end) && text[end] != ';' && text[end] != ')') ++end;
    if (at(text, end) == ')') ++end;
    b.report(ig::diag("SYN-0054"), ig::Where::columns(position, end), piece(text, position, end));
    return end;
  }
};

const ig::Register<SyntecMacroFormat> syntec_macro_format_syntax;

}  // namespace
}  // namespace syntec
