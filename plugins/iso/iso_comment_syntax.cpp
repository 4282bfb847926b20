// Comments: ( … ), not nested, anywhere in a block; the semicolon, which opens a comment on controls that read it so
// and ends the block where a listing shows the end-of-block character as one; and // where the control knows it.
#include <string>

#include "diagnostics.hpp"
#include "scan_util.hpp"

namespace iso {
namespace {

enum class Semicolon { comment, end_of_block };
enum class Slashes { none, comment };

struct IsoCommentSyntax {
  static constexpr auto spec =
      ig::syntax("IsoCommentSyntax", "Takes comments: ( … ) and, by option, ; and // to the line's end.")
          .before("FlagSyntax", "WordSyntax")
          .scans("(;/");

  ig::Choice<Semicolon> semicolon{"semicolon", "comment|end-of-block", "comment",
                                  "What ; means: a comment to the end of the line, or the end of the block."};
  ig::Choice<Slashes> slashes{"slashes", "none|comment", "none",
                              "What // means: two block skips, or a comment to the end of the line; then this syntax "
                              "stands before BlockSkipSyntax."};
  ig::Out<ig::Symbol> symbol{"Comment.Symbol"};
  ig::TextField text_{"Comment.Text", ig::read | ig::write};
  ig::Name parenthesis{"("};
  ig::Name semicolon_name{";"};
  ig::Name slashes_name{"//"};
  ig::Signal several{"Comment.~Several", ig::read | ig::write | ig::wake};
  std::string joined;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (text[position] == ';') return after_semicolon(b, text, position);
    if (text[position] == '/') return after_slashes(b, text, position);
    // The block may be long, and hold thousands of comments: none of them looks at all of it.
    const std::size_t close = text.find(')', position);
    const std::size_t end = block_end(text.substr(0, close), position);
    if (close == std::string_view::npos || end != close) {
      b.report(diag("ISO-0111"), ig::Where::columns(position, end));
      add(b, parenthesis, piece(text, position + 1, end));
      return end;
    }
    add(b, parenthesis, piece(text, position + 1, close));
    return close + 1;
  }

  /// Once for all comments of the block: each text that is set takes memory of its own.
  ig::Status build(ig::Block& b) {
    if (!b.is_raised(several)) return ig::Status::unchanged;
    b.set_text(text_, joined);
    return ig::Status::changed;
  }

 private:
  std::size_t after_slashes(ig::Block& b, std::string_view text, std::size_t position) {
    if (slashes == Slashes::none || at(text, position + 1) != '/') return position;
    const std::size_t end = block_end(text, position);
    add(b, slashes_name, trim(piece(text, position + 2, end)));
    return end;
  }

  std::size_t after_semicolon(ig::Block& b, std::string_view text, std::size_t position) {
    if (semicolon == Semicolon::comment) {
      const std::size_t end = block_end(text, position);
      add(b, semicolon_name, trim(piece(text, position + 1, end)));
      return end;
    }
    const std::size_t next = skip_blanks(text, position + 1);
    if (block_end(text.substr(0, next + 1), next) == next) return next;
    b.flow(IG_FLOW_SPLIT, next);
    return next;
  }

  /// Several comments of a block are one text, joined by blanks, under the symbol of the first.
  void add(ig::Block& b, ig::Symbol opened_by, std::string_view comment) {
    if (!b.is_fresh(symbol)) {
      b.set(symbol, opened_by);
      b.set_text(text_, comment);
      joined.clear();
      return;
    }
    if (joined.empty()) joined.assign(b.text(text_));
    joined.append(1, ' ').append(comment);
    b.raise(several);
  }
};

const ig::Register<IsoCommentSyntax> registered;

}  // namespace
}  // namespace iso
