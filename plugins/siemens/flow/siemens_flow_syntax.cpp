// Labels, jumps, branches and loops. The scanner reads the statement as a whole; build() executes it. Which ELSE and
// ENDIF belong to an IF is known from labels that the index gives them: ENDIF@12 ends the IF of line 12.
#include "flow/branch_index.hpp"
#include "flow/flow_jumps.hpp"

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
          .scans("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_:");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0142", "the statement is not closed: write the {0} that belongs to it"),
      ig::diagnostic(IG_ERROR, "SIE-0143",
                     "loops are nested deeper than {0} levels, so the run ends: close each loop before the next"),
      ig::diagnostic(IG_ERROR, "SIE-0145",
                     "{0} has no {1} before it: it is not executed; check the pairs of statements"),
      ig::diagnostic(IG_WARNING, "SIE-0146",
                     "this end may not belong to the {0} of line {1}: leave a loop only through its end"),
      ig::diagnostic(IG_ERROR, "SIE-0147", "the section is not repeated, because its label {0} is not found: {1}"),
      ig::diagnostic(IG_ERROR, "SIE-0306", "{0} is not executed: RET takes one label or block number, given as a text"),
  };

  Environment environment_;
  ig::Signal statement_{"Parsing.~FlowStatement", ig::read | ig::write | ig::wake};
  ig::TextField label_{"Label.Name", ig::read | ig::write | ig::wake, {ig::Life::block, "", "The block's label."}};
  ig::In<std::int64_t> number_{"Source.N"};
  ig::Signal numbers_end_{"SiemensFlow.~NumbersEnd", ig::write | ig::wake_while, ig::Life::modal};
  ig::Codes returns_{"RET", "M17"};
  ig::Codes ends_{{"M02", "M30"}, ig::take | ig::wake};
  ig::Out<ig::Symbol> returned_{"SubProgramReturn.Term"};
  ig::Out<ig::Symbol> end_{"ProgramEnd.Term"};

  ig::Status restart(ig::Block&) {
    branches_.restart();
    loops_.clear();
    if (!environment_.flow.is_indexing()) environment_.store().restart();
    return ig::Status::unchanged;
  }

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (text[position] == ':') return main_block(b, text, position);
    const std::size_t end = skip_name(text, position);
    // The control requires two letters first; programs write L1: as well.
    if (end - position < 2 || (is_digit(text[position + 1]) && at(text, end) != ':')) return position;
    const std::size_t behind = skip_blanks(text, end);
    if (at(text, behind) == ':' && at(text, behind + 1) != '=') {
      const std::string name = upper(piece(text, position, end));
      b.set_text(label_, name);
      environment_.flow.label(b, name);
      return behind + 1;
    }
    const bool returns_to = at(text, behind) == '(' && equals_ignoring_case(piece(text, position, end), "RET");
    const Word word = returns_to ? Word::ret : flow_word(piece(text, position, end));
    if (word == Word::none || (at(text, behind) == '=' && at(text, behind + 1) != '=')) return position;
    if (environment_.flow.is_indexing()) branches_.note(b, word, text, end);
    word_ = word;
    begin_ = position;
    behind_ = end;
    end_statement_ = statement_text_end(text, position);
    b.raise(statement_);
    return statement_end(text, position);
  }

  ig::Status build(ig::Block& b) {
    bool any = leave(b);
    if (b.is_raised(statement_) && end_statement_ <= b.source().size()) {
      environment_.enter(b);
      loops_.enter(environment_.flow.frame(b));
      execute(b, b.source().substr(0, end_statement_));
      any = true;
    }
    if (b.is_fresh(label_)) end_section(b, b.text(label_));
    if (b.is_fresh(number_)) end_section(b, "N" + std::to_string(b.get_or(number_, std::int64_t{0})));
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

  std::int64_t line_of(const ig::Block& b) const { return environment_.flow.here(b).line; }

  // ---- One statement

  void execute(ig::Block& b, std::string_view text) {
    const std::int64_t line = line_of(b);
    switch (word_) {
      case Word::if_: return execute_if(b, text, line);
      case Word::else_:
        if (ends(b, text, behind_)) jump_behind(b, text, "ENDIF@", "ENDIF", line);
        return;
      case Word::endif: ends(b, text, behind_); return;
      case Word::while_: return execute_while(b, text, line);
      case Word::for_: return execute_for(b, text, line);
      case Word::loop: return begin(b, text, LoopKind::loop, line);
      case Word::repeat:
      case Word::repeatb: return execute_repeat(b, text, line);
      case Word::endwhile: return end_loop(b, text, LoopKind::while_, "WHILE");
      case Word::endfor: return end_loop(b, text, LoopKind::for_, "FOR");
      case Word::endloop: return end_loop(b, text, LoopKind::loop, "LOOP");
      case Word::until: return execute_until(b, text);
      case Word::go: jumps_.go(b, text, begin_); return;
      case Word::case_: return jumps_.by_case(b, text, begin_, behind_);
      case Word::ret: return return_to(b, text);
      case Word::none: return;
    }
  }

  /// The value of the condition after the word; `after` receives the position where it ends. Programs also write WHILE
  /// (…) DO.
  std::optional<bool> condition(ig::Block& b, std::string_view text, std::size_t& after) const {
    Expression e(b, environment_, text, behind_);
    const auto holds = e.truth();
    after = skip_blanks(text, e.position());
    return holds;
  }

  void execute_if(ig::Block& b, std::string_view text, std::int64_t line) {
    std::size_t after = 0;
    const auto holds = condition(b, text, after);
    const bool jumps_here = after < text.size() && flow_word(piece(text, after, skip_name(text, after))) == Word::go;
    if (!holds) {
      // Neither branch is known to be the right one: both are skipped.
      if (!has_jump(text, behind_)) jump_behind(b, text, "ENDIF@", "ENDIF", line);
      return;
    }
    if (jumps_here) return jumps_.by_conditions(b, text, after, *holds);
    if (!ends(b, text, after) || *holds) return;
    if (jump(b, BranchIndex::named("ELSE@", line), IG_SEARCH_FORWARD).is_not_found())
      jump_behind(b, text, "ENDIF@", "ENDIF", line);
  }

  ig::Flow::Answer jump(ig::Block& b, std::string_view label, ig_search search) const {
    return environment_.flow.jump(b, label, search, IG_GO_BEHIND);
  }
  void jump_behind(ig::Block& b, std::string_view text, std::string_view prefix, std::string_view word,
                   std::int64_t line) const {
    const ig::Flow::Answer answer = jump(b, BranchIndex::named(prefix, line), IG_SEARCH_FORWARD);
    if (answer.is_not_found()) b.report(ig::diag("SIE-0142"), columns(text, begin_), word);
  }

  std::uint64_t frame(const ig::Block& b) const { return environment_.flow.frame(b).id; }

  /// The loop that begins at this line, entered where it is not running yet; null where loops are nested too deeply.
  Loop* begun(ig::Block& b, std::string_view text, LoopKind kind, std::int64_t line) {
    const ig_frame f = environment_.flow.frame(b);
    if (Loop* const loop = loops_.at_line(f.id, line, kind)) {
      loop->jumped = false;
      return loop;
    }
    Loop loop{
        .kind = kind, .frame = f.id, .pass = f.pass, .line = line, .place = environment_.flow.here(b), .until = {}};
    if (!loops_.push(std::move(loop))) {
      b.report(ig::diag("SIE-0143"), columns(text, begin_), static_cast<double>(LoopStack::deepest));
      b.end_program();
      return nullptr;
    }
    if (kind != LoopKind::until &&
        !environment_.flow.has_label(b, BranchIndex::named(end_of(kind) + "@", line), IG_SEARCH_FORWARD))
      b.report(ig::diag("SIE-0142"), columns(text, begin_), std::string_view(end_of(kind)));
    return loops_.innermost(f.id);
  }
  static std::string end_of(LoopKind kind) {
    return kind == LoopKind::while_ ? "ENDWHILE" : kind == LoopKind::for_ ? "ENDFOR" : "ENDLOOP";
  }
  void begin(ig::Block& b, std::string_view text, LoopKind kind, std::int64_t line) {
    if (ends(b, text, behind_)) begun(b, text, kind, line);
  }

  void execute_while(ig::Block& b, std::string_view text, std::int64_t line) {
    std::size_t after = 0;
    const auto holds = condition(b, text, after);
    if (holds && is_word(text, after, "DO")) after = skip_name(text, after);
    if (holds && !ends(b, text, after)) return leave_loop(b, text, LoopKind::while_, line, "ENDWHILE");
    if (!holds || !*holds) return leave_loop(b, text, LoopKind::while_, line, "ENDWHILE");
    begun(b, text, LoopKind::while_, line);
  }
  void leave_loop(ig::Block& b, std::string_view text, LoopKind kind, std::int64_t line, std::string_view end) {
    if (loops_.at_line(frame(b), line, kind) != nullptr) loops_.pop();
    jump_behind(b, text, std::string(end) + "@", end, line);
  }

  /// FOR i=1 TO 10: the variable increases in steps of 1; the pass with the end value is made, too.
  void execute_for(ig::Block& b, std::string_view text, std::int64_t line) {
    Expression e(b, environment_, text, skip_blanks(text, behind_));
    const auto variable = e.reference();
    if (!variable) return leave_loop(b, text, LoopKind::for_, line, "ENDFOR");
    std::size_t next = skip_blanks(text, e.position());
    Expression first(b, environment_, text, next + 1);
    const auto from = at(text, next) == '=' ? first.number() : std::nullopt;
    if (from) next = skip_blanks(text, first.position());
    Expression last(b, environment_, text, next + 2);
    const bool is_complete = from && is_word(text, next, "TO");
    const auto to = is_complete ? last.number() : std::nullopt;
    if (!is_complete && (at(text, next) != '=' || from)) b.report(ig::diag("SIE-0144"), columns(text, begin_));
    if (!to || !ends(b, text, last.position())) return leave_loop(b, text, LoopKind::for_, line, "ENDFOR");
    Loop* const running = loops_.at_line(frame(b), line, LoopKind::for_);
    const bool goes_on = running != nullptr && running->goes_on;
    double value = *from;
    if (goes_on) {
      Expression now(b, environment_, text, variable->begin);
      value = now.number().value_or(*to) + 1;
      running->goes_on = false;
    }
    if (!set(b, *variable, value)) {
      b.report(ig::diag("SIE-0124"), columns(text, variable->begin), std::string_view(variable->name));
      return leave_loop(b, text, LoopKind::for_, line, "ENDFOR");
    }
    if (value > *to) return leave_loop(b, text, LoopKind::for_, line, "ENDFOR");
    begun(b, text, LoopKind::for_, line);
  }
  bool set(const ig::Block&, const Expression::Reference& to, double value) const {
    VariableStore& store = environment_.store();
    if (to.is_r) {
      *store.r(to.r) = {value, true};
      return true;
    }
    Variable* const v = store.find(to.name);
    if (v == nullptr || v->value.is_text()) return false;
    v->value.number = v->value.type == Type::integer ? std::round(value) : value;
    return true;
  }

  void end_loop(ig::Block& b, std::string_view text, LoopKind kind, std::string_view word) {
    if (!ends(b, text, behind_)) return;
    bool doubtful = false;
    Loop* const loop = loops_.ending(frame(b), line_of(b), kind, doubtful);
    if (loop == nullptr) {
      b.report(ig::diag("SIE-0145"), columns(text, begin_), text.substr(begin_), word);
      return;
    }
    if (doubtful) b.report(ig::diag("SIE-0146"), columns(text, begin_), word, static_cast<double>(loop->line));
    loop->goes_on = true;
    environment_.flow.go_to(b, loop->place);
  }

  void execute_until(ig::Block& b, std::string_view text) {
    bool doubtful = false;
    Loop* const loop = loops_.ending(frame(b), line_of(b), LoopKind::until, doubtful);
    if (loop == nullptr) {
      b.report(ig::diag("SIE-0145"), columns(text, begin_), std::string_view("UNTIL"), std::string_view("REPEAT"));
      return;
    }
    std::size_t after = 0;
    const auto holds = condition(b, text, after);
    if (!holds || *holds || !ends(b, text, after))
      loops_.pop();
    else
      environment_.flow.go_to(b, loop->place);
  }

  // ---- REPEAT of a section

  void execute_repeat(ig::Block& b, std::string_view text, std::int64_t line) {
    const std::size_t name = skip_blanks(text, behind_);
    if (name >= text.size() && word_ == Word::repeat) return begin(b, text, LoopKind::until, line);
    const ig_frame f = environment_.flow.frame(b);
    Loop* section = loops_.at_line(f.id, line, LoopKind::section);
    if (section == nullptr) {
      Loop found{.kind = LoopKind::section,
                 .frame = f.id,
                 .pass = f.pass,
                 .line = line,
                 .place = environment_.flow.here(b),
                 .left = 1,
                 .until = "ENDLABEL"};
      std::size_t next = skip_name(text, name);
      first_label_ = upper(piece(text, name, next));
      drop_zeros(first_label_);
      next = skip_blanks(text, next);
      if (word_ == Word::repeatb) {
        found.until = first_label_;
      } else if (is_name_start(at(text, next)) && !is_word(text, next, "P")) {
        const std::size_t last = skip_name(text, next);
        found.until = upper(piece(text, next, last));
        drop_zeros(found.until);
        next = skip_blanks(text, last);
      }
      if (is_word(text, next, "P") && at(text, skip_blanks(text, next + 1)) == '=') {
        Expression e(b, environment_, text, skip_blanks(text, next + 1) + 1);
        const auto times = e.number();
        if (!times) return;
        found.left = *times;
        next = e.position();
      }
      if (first_label_.empty()) {
        b.report(ig::diag("SIE-0141"), columns(text, name), text.substr(std::min(name, text.size())));
        return;
      }
      if (!ends(b, text, next)) return;
      if (found.until[0] == 'N') b.raise(numbers_end_);
      found.until += ' ' + first_label_;  // "END BEGIN"
      if (!loops_.push(std::move(found))) {
        b.report(ig::diag("SIE-0143"), columns(text, begin_), static_cast<double>(LoopStack::deepest));
        b.end_program();
        return;
      }
      section = loops_.innermost(f.id);
    }
    if (section->left < 1) {
      loops_.pop();
      return;
    }
    section->left -= 1;
    const std::string from = section->until.substr(section->until.find(' ') + 1);
    if (!environment_.flow.jump(b, from, IG_SEARCH_BACKWARD).is_not_found()) return;
    const ig::Flow::Answer ahead = environment_.flow.jump(b, from, IG_SEARCH_FORWARD);
    if (!ahead.is_not_found()) return;
    b.report(ig::diag("SIE-0147"), columns(text, begin_), std::string_view(from), ahead.reason);
    loops_.pop();
  }

  /// Ends the pass of a repeated section at its end label or number.
  void end_section(ig::Block& b, std::string_view label) {
    loops_.enter(environment_.flow.frame(b));
    const Loop* const section = loops_.innermost(frame(b));
    if (section == nullptr || section->kind != LoopKind::section) return;
    const std::string_view until = section->until;
    if (until.substr(0, until.find(' ')) == label) environment_.flow.go_to(b, section->place);
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
  void return_to(ig::Block& b, std::string_view text) {
    const std::size_t open = skip_blanks(text, behind_);
    const auto refuse = [&] { b.report(ig::diag("SIE-0306"), columns(text, begin_), text.substr(begin_)); };
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
    const ig::Flow::Answer answer = environment_.flow.leave(b, name);
    if (!answer.is_not_found()) return;
    b.report(ig::diag("SIE-0149"), columns(text, open), std::string_view(name), answer.reason);
    environment_.flow.leave(b);
  }

  /// Returns to the block after the call, or to the pattern of holes that called.
  void leave_subprogram(ig::Block& b) const {
    const std::vector<PatternCall>& patterns = environment_.store().patterns;
    const std::uint64_t tag = environment_.flow.frame(b).tag;
    const bool is_of_pattern = !patterns.empty() && tag != 0 && patterns.back().tag == tag && patterns.back().is_open();
    environment_.flow.leave(b, is_of_pattern ? std::string_view(patterns.back().label) : std::string_view());
  }

  BranchIndex branches_{environment_};  // used while the program is indexed
  LoopStack loops_;
  Jumps jumps_{environment_, loops_};
  Word word_ = Word::none;  // the word that scan() has found
  std::size_t begin_ = 0, behind_ = 0, end_statement_ = 0;
  std::string first_label_;
};

const ig::Register<SiemensFlow> siemens_flow_syntax;

}  // namespace
}  // namespace siemens
