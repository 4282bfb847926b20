// Comments: ; to the end of the line, and the structure block * - text. A comment that stands first is the whole block,
// including the lines that ~ adds to it. The mark ~ itself separates words.
#include <string>

#include "language/klartext_text.hpp"

namespace heidenhain {

using namespace ig::cnc;

namespace {

struct KlartextComment {
  static constexpr auto spec = ig::syntax("KlartextCommentSyntax", "Reads comments ; and structure blocks *.")
                                   .after("KlartextBlockNumberSyntax")
                                   .scans(";*~");

  ig::Out<ig::Symbol> symbol_{"Comment.Symbol"};
  ig::TextField text_{"Comment.Text", ig::write};
  ig::Name semicolon_{";"}, star_{"*"};
  std::string joined_;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (text[position] == '~') return continues(text, position) ? position + 1 : position;
    const bool is_first = stands_first(text, position);
    if (text[position] == '*' && !is_first) return position;
    const std::size_t end = is_first ? text.size() : comment_end(text, position);
    if (!b.is_fresh(symbol_)) {
      b.set(symbol_, text[position] == '*' ? star_ : semicolon_);
      b.set_text(text_, without_marks(piece(text, position + 1, end)));
    }
    return end;
  }

 private:
  static bool continues(std::string_view text, std::size_t position) {
    const std::size_t next = skip_blanks(text, position + 1);
    return next >= text.size() || is_line_end(text[next]) || text[next] == ';';
  }

  /// The lines that ~ joins, as one text.
  std::string_view without_marks(std::string_view text) {
    text = trim(text);
    if (text.find('\n') == std::string_view::npos) return text;
    joined_.clear();
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (!is_line_end(text[i])) {
        joined_ += text[i];
        continue;
      }
      while (!joined_.empty() && is_space(joined_.back())) joined_.pop_back();
      joined_ += ' ';
      while (i + 1 < text.size() && is_space(text[i + 1])) ++i;
    }
    return joined_;
  }
};

const ig::Register<KlartextComment> klartext_comment_syntax;

}  // namespace
}  // namespace heidenhain
