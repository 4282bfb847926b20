// Labels, jumps, branches and loops. The scanner reads the statement as a whole; build() executes it. Which ELSE and
// ENDIF belong to an IF is known from labels that the index gives them: ENDIF@12 ends the IF of line 12.
#include "flow/branch_index.hpp"
#include "flow/flow_jumps.hpp"
#include "flow/flow_loops.hpp"
#include "flow/repeated_section.hpp"

namespace siemens {

using namespace ig::cnc;

namespace {

using Word = FlowWord;
using ig::cnc::at;
using ig::cnc::piece;
using ig::cnc::skip_blanks;

struct SiemensFlow {
  static constexpr auto spec =
      ig::syntax("SiemensFlowSyntax", "Labels, GOTO, IF, CASE, FOR, WHILE, LOOP, REPEAT, RET and M17.")
          .after("HeadIndexSyntax")
          .before("SiemensWordSyntax", "ProgramEndSyntax")
          .scans("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_:")
          .scans_ahead();
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0142", "the statement is not closed: write the {0} that belongs to it"),
      ig::diagnostic(IG_ERROR, "SIE-0143",
                     "loops are nested deeper than {0} levels, so the run ends: close each loop before the next"),
      ig::diagnostic(IG_ERROR, "SIE-0145",
                     "{0} has no {1} before it: it is not executed; check the pairs of statements"),
      ig::diagnostic(IG_WARNING, "SIE-0146",
                     "this end may not belong to the {0} of line {1}: leave a loop only through its end"),
      ig::diagnostic(IG_ERROR, "SIE-0147", "the section is not repeated, because its label {0} is not found: {1}"),
      ig::diagnostic(IG_WARNING, "SIE-0309",
                     "P={0} is not a whole number from 1: the section is repeated this often: {1}"),
      ig::diagnostic(IG_WARNING, "SIE-0395",
                     "the label {0} stands more than once in this program, and a jump goes to the nearest one in its "
                     "direction: give each label its own name"),
      ig::diagnostic(IG_ERROR, "SIE-0306", "{0} is not executed: RET takes one label or block number, given as a text"),
  };

  Environment environment_;
  ig::Signal statement_{"Parsing.~FlowStatement", ig::read | ig::write | ig::wake};
  /// No block without a move for cutter radius compensation: the control makes no block of it.
  ig::Signal macro_statement_{"Parsing.~MacroStatement", ig::write};
  ig::TextField label_{"Label.Name", ig::read | ig::write | ig::wake, {ig::Life::block, "", "The block's label."}};
  ig::In<std::int64_t> number_{"Source.N"};
  ig::Signal numbers_end_{"SiemensFlow.~NumbersEnd", ig::write | ig::wake_while, ig::Life::modal};
  ig::Codes returns_{"RET", "M17"};
  ig::Codes ends_{{"M02", "M30"}, ig::take | ig::wake};
  ig::Out<ig::Symbol> returned_{"SubProgramReturn.Term"};
  ig::Out<ig::Symbol> end_{"ProgramEnd.Term"};

  ig::Status restart(ig::Block&) {
    branches_.restart();
    stack_.clear();
    if (!environment_.flow.is_indexing()) environment_.store().restart();
    return ig::Status::unchanged;
  }

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (text[position] == ':') return main_block(b, text, position);
    const std::size_t end = skip_short_name(text, position);
    // The control requires two letters first; programs write L1: as well.
    if (end - position < 2 || (is_digit(text[position + 1]) && at(text, end) != ':')) return position;
    const std::size_t behind = skip_blanks(text, end);
    if (at(text, behind) == ':' && at(text, behind + 1) != '=') {
      const std::string name = upper(piece(text, position, end));
      b.set_text(label_, name);
      environment_.flow.label(b, name);
      label_begin_ = position;
      label_end_ = end;
      return behind + 1;
    }
    const bool returns_to = at(text, behind) == '(' && equals_ignoring_case(piece(text, position, end), "RET");
    const bool is_section = equals_ignoring_case(piece(text, position, end), "CALL") && is_word(text, behind, "BLOCK");
    const Word word = returns_to ? Word::ret : is_section ? Word::block : flow_word(piece(text, position, end));
    if (word == Word::none || (at(text, behind) == '=' && at(text, behind + 1) != '=')) return position;
    if (!b.is_in_turn()) return position;
    if (environment_.flow.is_indexing()) branches_.note(b, word, text, end);
    word_ = word;
    begin_ = position;
    behind_ = is_section ? skip_name(text, behind) : end;
    end_statement_ = statement_text_end(text, position);
    b.raise(statement_);
    b.raise(macro_statement_);
    return statement_end(text, position);
  }

  ig::Status build(ig::Block& b) {
    bool any = leave(b);
    if (b.is_raised(statement_) && end_statement_ <= b.source().size()) {
      environment_.enter(b);
      stack_.enter(environment_.flow.frame(b));
      execute(b, {word_, b.source().substr(0, end_statement_), begin_, behind_, environment_.flow.here(b).line});
      any = true;
    }
    if (b.is_fresh(label_)) {
      report_second(b, b.text(label_));
      sections_.end(b, b.text(label_));
    }
    if (b.is_fresh(number_)) sections_.end(b, "N" + std::to_string(b.get_or(number_, std::int64_t{0})));
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  /// :100 is a main block: a sequence number to which programs jump as to N100.
  std::size_t main_block(ig::Block& b, std::string_view text, std::size_t position) const {
    const std::size_t end = skip_digits(text, position + 1);
    if (end == position + 1 || !stands_first(text, position)) return position;
    environment_.flow.label(b, "N" + std::string(piece(text, position + 1, end)));
    return end;
  }

  /// ENDLABEL may end several sections of a program.
  void report_second(ig::Block& b, std::string_view name) const {
    if (name == "ENDLABEL" || environment_.flow.here(b).line == 0) return;  // a case of a page is in no program
    const auto is_there = [&](ig_search where) { return environment_.flow.has_label(b, name, where); };
    if (!is_there(IG_SEARCH_FORWARD) && !is_there(IG_SEARCH_BACKWARD)) return;
    const ig_frame program = environment_.flow.frame(b);
    std::string place = "SIE-0395\n";
    place.append(ig::to_view(program.file)).append(1, '\n').append(ig::to_view(program.program));
    place.append(1, '\n').append(name);
    if (environment_.store().is_first_report(place))
      b.report(ig::diag("SIE-0395"), ig::Where::columns(label_begin_, label_end_), name);
  }

  // ---- One statement

  void execute(ig::Block& b, const FlowStatement& s) {
    switch (s.word) {
      case Word::if_: return execute_if(b, s);
      case Word::else_:
        if (s.ends_here(b)) jump_behind(b, environment_, s, "ENDIF");
        return;
      case Word::endif: s.ends_here(b); return;
      case Word::while_: return loops_.begin_while(b, s);
      case Word::for_: return loops_.begin_for(b, s);
      case Word::loop: return loops_.begin(b, s, LoopKind::loop);
      case Word::repeat:
        if (skip_blanks(s.text, s.behind) >= s.text.size()) return loops_.begin(b, s, LoopKind::until);
        return sections_.repeat(b, s);
      case Word::block:
      case Word::repeatb: return sections_.repeat(b, s);
      case Word::endwhile: return loops_.end(b, s, LoopKind::while_);
      case Word::endfor: return loops_.end(b, s, LoopKind::for_);
      case Word::endloop: return loops_.end(b, s, LoopKind::loop);
      case Word::until: return loops_.until(b, s);
      case Word::go: jumps_.go(b, s.text, s.begin); return;
      case Word::case_: return jumps_.by_case(b, s.text, s.begin, s.behind);
      case Word::ret: return return_to(b, s);
      case Word::none: return;
    }
  }

  void execute_if(ig::Block& b, const FlowStatement& s) {
    std::size_t after = 0;
    const auto holds = condition(b, environment_, s, after);
    if (!holds) {
      // Neither branch is known to be the right one: both are skipped.
      if (!has_jump(s.text, s.behind)) jump_behind(b, environment_, s, "ENDIF");
      return;
    }
    if (flow_word(piece(s.text, after, skip_name(s.text, after))) == Word::go)
      return jumps_.by_conditions(b, s.text, after, *holds);
    if (!ends(b, s.text, after) || *holds) return;
    if (environment_.flow.jump(b, BranchIndex::named("ELSE@", s.line), IG_SEARCH_FORWARD, IG_GO_BEHIND).is_not_found())
      jump_behind(b, environment_, s, "ENDIF");
  }

  // ---- RET, M17, and M2 and M30 of a subprogram

  bool leave(ig::Block& b) const {
    const bool ends_main = b.find(ends_).has_value();
    const bool is_inside = environment_.flow.frame(b).depth > 0;
    const auto code = b.find(returns_);
    if (!code && !(ends_main && is_inside)) return false;
    if (code) b.take(returns_);
    if (is_inside) {
      b.set(returned_, code ? returns_.name(*code) : ends_.name(*b.take(ends_)));
      leave_subprogram(b);
    } else {
      b.set(end_, returns_.name(*code));
      b.end_program();
    }
    return true;
  }

  /// RET("LABEL"): returns to that block of the caller. The further parameters, such as the number of levels, are not
  /// executed.
  void return_to(ig::Block& b, const FlowStatement& s) {
    const std::string_view text = s.text;
    const std::size_t open = skip_blanks(text, s.behind);
    const auto refuse = [&] { b.report(ig::diag("SIE-0306"), s.where(), text.substr(s.begin)); };
    if (at(text, skip_blanks(text, open + 1)) == ',') return refuse();
    Expression e(b, environment_, text, open + 1);
    const auto label = e.value();
    if (!label) return;
    const std::size_t close = skip_blanks(text, e.position());
    if (!label->is_text() || at(text, close) != ')') return refuse();
    if (!ends(b, text, close + 1)) return;
    if (environment_.flow.frame(b).depth == 0) {
      b.set(end_, b.symbol("RET"));
      b.end_program();
      return;
    }
    std::string name = upper(trim(label->text));
    drop_zeros(name);
    b.set(returned_, b.symbol("RET"));
    environment_.note_given_back(b);
    const ig::Flow::Answer answer = environment_.flow.leave(b, name);
    if (!answer.is_not_found()) return;
    b.report(ig::diag("SIE-0149"), columns(text, open), std::string_view(name), answer.reason);
    environment_.flow.leave(b);
  }

  /// Returns to the block after the call, or to the pattern of holes that called.
  void leave_subprogram(ig::Block& b) const {
    environment_.enter(b);
    environment_.note_given_back(b);
    const std::vector<PatternCall>& patterns = environment_.store().patterns;
    const std::uint64_t tag = environment_.flow.frame(b).tag;
    environment_.report_values_beyond(b, ig::Where::block(), environment_.store().take_unread(tag), 0);
    const bool is_of_pattern = !patterns.empty() && tag != 0 && patterns.back().tag == tag && patterns.back().is_open();
    environment_.flow.leave(b, is_of_pattern ? std::string_view(patterns.back().label) : std::string_view());
  }

  BranchIndex branches_{environment_};  // used while the program is indexed
  LoopStack stack_;
  FlowLoops loops_{environment_, stack_};
  RepeatedSections sections_{environment_, stack_, numbers_end_};
  Jumps jumps_{environment_, stack_};
  Word word_ = Word::none;  // the word that scan() has found
  std::size_t begin_ = 0, behind_ = 0, end_statement_ = 0;
  std::size_t label_begin_ = 0, label_end_ = 0;
};

const ig::Register<SiemensFlow> siemens_flow_syntax;

}  // namespace
}  // namespace siemens
