/// Statements of files in MACRO format: assignments, IF, CASE, loops, GOTO, ALARM and MSG. The scanner takes a
/// statement as a whole, over several lines where it is not ended before; build() executes it on its text. It is asked
/// at the beginning of each block, and so also tells which format the block's program has.
#include "macro/macro_execution.hpp"
#include "macro/macro_shared.hpp"

namespace syntec {

using namespace ig::cnc;

namespace {

struct SyntecMacroStatement {
  static constexpr auto spec =
      ig::syntax("SyntecMacroStatementSyntax", "Executes the statements of programs in MACRO format.")
          .before("SyntecMacroFormatSyntax", "TapeBoundarySyntax", "HeadIndexSyntax", "MacroStatementSyntax",
                  "FlagSyntax", "WordSyntax")
          .scans(every_byte.data())
          .scans_ahead();
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SYN-0041", "'{0}' is not executed: {1} is missing"),
      ig::diagnostic(IG_ERROR, "SYN-0042", "N{0} is not found, so the jump is not executed: {1}"),
      ig::diagnostic(IG_ERROR, "SYN-0043", "'{0}' is not executed: it belongs to no {1} before it"),
      ig::diagnostic(IG_ERROR, "SYN-0044", "this statement has no end: write the {0} that belongs to it"),
      ig::diagnostic(IG_ERROR, "SYN-0045",
                     "the statement is not executed: IF, CASE and loops may be nested {0} levels deep"),
      ig::diagnostic(IG_ERROR, "SYN-0047", "alarm {0}: {1}"),
      ig::diagnostic(IG_NOTE, "SYN-0048", "the program shows: {0}"),
      ig::diagnostic(IG_WARNING, "SYN-0049",
                     "{0} acts on signals or files of the machine, which are not here: it is ignored"),
      ig::diagnostic(IG_ERROR, "SYN-0051",
                     "'{0}' stands behind other words: it is not executed; end their block with ;"),
      ig::diagnostic(
          IG_ERROR, "SYN-0052",
          "line {0} has no ; at its end: the control reads it and this line as one block, here they are two"),
      ig::diagnostic(IG_ERROR, "SYN-0055", "the loop is skipped: with BY 0 it would never end"),
      ig::diagnostic(
          IG_ERROR, "SYN-0081",
          "nothing is assigned: the text takes {0} variables from {1} on, beyond the last one of their range"),
      ig::diagnostic(IG_ERROR, "SYN-0058", "'{0}' is not a sequence number: the jump is not executed"),
  };

  FormatField format_{ig::read | ig::write};
  SharedScan scan_;
  MacroExecution execution_;
  ig::Signal statement_{"Parsing.~MacroText", ig::read | ig::write | ig::wake};
  ig::Signal words_{"Parsing.~MacroWords", ig::read | ig::write};
  ig::Signal entered_{"ProgramFormat.~Entered", ig::read | ig::write, ig::Life::frame};
  ig::Signal head_{"Parsing.~MacroHead", ig::read | ig::write};
  ig::Out<ig::Symbol> comment_symbol_{"Comment.Symbol"};
  ig::TextField comment_{"Comment.Text", ig::write};
  ig::Name brackets_{"(*"};
  ig::Signal text_ended_{"Source.~End", ig::read | ig::wake};

  ig::Status restart(ig::Block&) {
    execution_.restart();
    scan_->restart();
    open_line_ = 0;
    is_done_ = false;
    return ig::Status::unchanged;
  }

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (!b.is_in_turn() || b.is_raised(statement_)) return position;
    if (!format_.is_known(b)) {  // only a file that a call enters behind its mark may be of the other format
      if (b.is_raised(entered_)) return position;
      b.raise(entered_);
    }
    const ig::Flow& flow = execution_.environment.flow;
    if (!b.is_raised(head_)) {
      b.raise(head_);
      head_end_ = 0;
      if (!flow.is_indexing()) scan_->enter(b, flow, format_);
    }
    if (!format_.is_macro(b)) return position;
    StatementCollector& statement = scan_->statement;
    if (is_done_) {
      statement.clear();
      is_done_ = false;
    }
    const bool goes_on = statement.is_begun();
    if (!goes_on && scan_->comment.is_open) return go_on_with_comment(b, text, position);
    if (!goes_on && (b.is_raised(words_) || !is_head(text, position))) return later(b, text, position);
    if (!goes_on) {
      statement.clear();
      const char c = text[position];
      const bool is_number = to_upper(c) == 'N' && is_digit(at(text, skip_blanks(text, position + 1)));
      if (is_number || c == '/' || c == ';' || c == '%' || c == '(') return position;
      const Keyword k = statement_at(text, position);
      report_unended(b, text, position);
      if (k == Keyword::none) return words(b, text, position);
      keyword_ = k;
      place_ = flow.here(b);
      scan_->statement_line = place_.line;
      if (flow.is_indexing())
        execution_.structure.note(b, k, piece(text, position, std::max(label_end(text, position), position)));
    }
    const std::size_t end = statement.add(text, position, keyword_, scan_->comment);
    if (statement.is_complete()) {
      is_done_ = true;
      b.raise(statement_);
      const std::size_t next = skip_blanks(text, end);
      const bool is_last = is_block_end(text, next) || (text[next] == '/' && at(text, next + 1) == '/');
      if (!is_last) b.flow(IG_FLOW_SPLIT, end);
    } else if (statement.text().size() > longest) {
      scan_->end_program(b, ig::to_view(execution_.environment.flow.frame(b).file));
    }
    return end;
  }

  ig::Status build(ig::Block& b) {
    if (b.is_raised(text_ended_)) scan_->end_program(b, ig::to_view(execution_.environment.flow.frame(b).file));
    if (!b.is_raised(statement_)) return ig::Status::unchanged;
    const StatementCollector& statement = scan_->statement;
    execution_.execute(b, {keyword_, {statement.text(), statement.offset()}, statement.begin(), place_});
    return ig::Status::changed;
  }

 private:
  static constexpr std::size_t longest = 65'535;

  /// Do only blanks, block skips, comments and the sequence number stand before the position? Each byte is looked at
  /// once, however often a block is asked.
  bool is_head(std::string_view text, std::size_t position) {
    head_end_ = skip_head(text, head_end_, position);
    return head_end_ >= position;
  }

  /// A comment over several lines is one of each of them.
  std::size_t go_on_with_comment(ig::Block& b, std::string_view text, std::size_t position) {
    const std::size_t close = text.find("*)", position);
    scan_->comment.is_open = close == std::string_view::npos;
    const std::size_t end = scan_->comment.is_open ? block_end(text, position) : close;
    b.set(comment_symbol_, brackets_);
    b.set_text(comment_, trim(piece(text, position, end)));
    return scan_->comment.is_open ? end : close + 2;
  }

  /// The block of words of the line before has no ; , and this line goes on.
  void report_unended(ig::Block& b, std::string_view text, std::size_t position) {
    if (open_line_ == 0) return;
    const std::uint32_t line = std::exchange(open_line_, 0u);
    if (execution_.environment.flow.here(b).frame != open_frame_) return;
    b.report(ig::diag("SYN-0052"), ig::Where::columns(position, block_end(text, position)), static_cast<double>(line));
  }

  /// A block of words, which other scanners read: its text without comments is for them.
  std::size_t words(ig::Block& b, std::string_view text, std::size_t position) {
    StatementCollector block;
    MacroComment comment;
    block.add(text, position, Keyword::none, comment);
    scan_->begin_words(block.text());
    b.raise(words_);
    if (!block.is_complete() && !comment.is_open) {
      const ig_place here = execution_.environment.flow.here(b);
      open_line_ = here.line;
      open_frame_ = here.frame;
    }
    return position;
  }

  /// A variable behind other words is no value of one of them.
  std::size_t later(ig::Block& b, std::string_view text, std::size_t position) const {
    if (text[position] != '#' && text[position] != '@') return position;
    const std::size_t end = words_end(text, position);
    b.report(ig::diag("SYN-0051"), ig::Where::columns(position, end), trim(piece(text, position, end)));
    return end;
  }

  Keyword keyword_ = Keyword::none;
  ig_place place_{};
  bool is_done_ = false;
  std::size_t head_end_ = 0;  // of the block that has raised head_
  std::uint32_t open_line_ = 0;
  std::uint64_t open_frame_ = 0;
};

const ig::Register<SyntecMacroStatement> syntec_macro_statement_syntax;

}  // namespace
}  // namespace syntec
