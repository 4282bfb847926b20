// Comments: ( … ), not nested, anywhere in a block; ; on controls that read it as the start of a comment, and // on
// controls that know it. Elsewhere ; is the end-of-block character of a listing and ends the block. Files for such a
// control hold remarks after semicolons all the same, so plain text there is not a block.
#include <algorithm>
#include <array>
#include <string>

#include <isogloss/cnc/scan.hpp>
#include <isogloss/sdk.hpp>

namespace iso {

using namespace ig::cnc;

namespace {

enum class Semicolon { comment, end_of_block };
enum class Slashes { none, comment };

struct IsoCommentSyntax {
  static constexpr auto spec =
      ig::syntax("IsoCommentSyntax", "Reads comments: ( … ) and, by option, ; and // to the end of the line.")
          .before("FlagSyntax", "WordSyntax")
          .scans("(;/");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "ISO-0111",
                     "the comment that starts here has no closing parenthesis: the rest of the block is skipped"),
      ig::diagnostic(IG_WARNING, "ISO-0399",
                     "the text after ; is read as a comment, but the control ends the block there: use parentheses"),
  };

  ig::Choice<Semicolon> semicolon{"semicolon", "comment|end-of-block", "comment",
                                  "What ; means: a comment to the end of the line, or the end of the block."};
  ig::Choice<Slashes> slashes{"slashes", "none|comment", "none",
                              "What // means: two block skips, or a comment to the end of the line; the latter needs "
                              "this syntax before BlockSkipSyntax."};
  ig::Out<ig::Symbol> symbol{"Comment.Symbol"};
  ig::TextField text_{"Comment.Text", ig::read | ig::write};
  ig::Name parenthesis{"("};
  ig::Name semicolon_name{";"};
  ig::Name slashes_name{"//"};
  ig::Signal several{"Comment.~Several", ig::read | ig::write | ig::wake};
  ig::Signal remark_reported{"Comment.~SaidRemark", ig::read | ig::write, ig::Life::modal};
  std::string joined;

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (text[position] == ';') return after_semicolon(b, text, position);
    if (text[position] == '/') return after_slashes(b, text, position);
    // The block may be long and hold thousands of comments, so none of them searches the whole block.
    const std::size_t close = text.find(')', position);
    const std::size_t end = block_end(text.substr(0, close), position);
    if (close == std::string_view::npos || end != close) {
      b.report(ig::diag("ISO-0111"), ig::Where::columns(position, end));
      add(b, parenthesis, piece(text, position + 1, end));
      return end;
    }
    add(b, parenthesis, piece(text, position + 1, close));
    return close + 1;
  }

  ig::Status restart(ig::Block&) {
    joined.clear();
    return ig::Status::unchanged;
  }

  /// Sets the texts of all comments of the block at once, because each text that is set takes memory of its own.
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
    if (is_remark(text, next)) return remark(b, text, position, next);
    b.flow(IG_FLOW_SPLIT, next);
    return next;
  }

  std::size_t remark(ig::Block& b, std::string_view text, std::size_t position, std::size_t begin) {
    const std::size_t end = block_end(text, begin);
    if (!b.is_raised(remark_reported)) b.report(ig::diag("ISO-0399"), ig::Where::columns(position, end));
    b.raise(remark_reported);
    add(b, semicolon_name, trim(piece(text, begin, end)));
    return end;
  }

  /// True for text that is neither a word nor a statement nor a character that begins a block.
  static bool is_remark(std::string_view text, std::size_t position) {
    const char first = text[position];
    if (!is_letter(first)) return std::string_view("#[(/;%<:").find(first) == std::string_view::npos;
    const std::size_t letters_end = skip_while(text, position, is_letter);
    const char next = at(text, skip_blanks(text, letters_end));
    const std::size_t letters = letters_end - position;
    const bool has_value = is_digit(next) || std::string_view("#[").find(next) != std::string_view::npos;
    if (letters == 1) return is_letter(next);
    const bool is_zero_as_letter = letters == 2 && to_upper(text[position + 1]) == 'O';
    return !has_value || !(is_zero_as_letter || begins_statement(piece(text, position, letters_end)));
  }

  /// The first two letters identify the statements of macros.
  static bool begins_statement(std::string_view word) {
    constexpr std::array<std::string_view, 10> statements{"IF", "WH", "GO", "DO", "EN", "TH", "DP", "BP", "PO", "PC"};
    const std::array<char, 2> begin{to_upper(word[0]), to_upper(word[1])};
    return std::find(statements.begin(), statements.end(), std::string_view(begin.data(), 2)) != statements.end();
  }

  /// Several comments of a block become one text, joined by blanks, under the symbol of the first.
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

const ig::Register<IsoCommentSyntax> iso_comment_syntax;

}  // namespace
}  // namespace iso
