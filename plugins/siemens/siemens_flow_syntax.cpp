// Labels, jumps, branches and loops. The scanner takes the statement as a whole; build() executes it. Which ELSE and
// ENDIF belong to an IF is known by names that they get while the program is indexed: ENDIF@12 ends the IF of line 12.
#include "loop_stack.hpp"
#include "siemens_expression.hpp"

namespace siemens {
namespace {

using iso::at;
using iso::piece;
using iso::skip_blanks;

enum class Word : std::uint8_t {
  none,
  if_,
  else_,
  endif,
  while_,
  endwhile,
  for_,
  endfor,
  loop,
  endloop,
  repeat,
  repeatb,
  until,
  go,
  case_
};

struct SiemensFlow {
  static constexpr auto spec =
      ig::syntax("SiemensFlowSyntax", "Labels, GOTO, IF, CASE, FOR, WHILE, LOOP, REPEAT, RET and M17.")
          .after("HeadIndexSyntax")
          .before("SiemensWordSyntax", "ProgramEndSyntax")
          .scans("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_:");

  Environment environment_;
  ig::Signal statement_{"Parsing.~FlowStatement", ig::read | ig::write | ig::wake};
  ig::TextField label_{"Label.Name", ig::read | ig::write | ig::wake, {ig::Life::block, "", "The block's label."}};
  ig::Codes returns_{"RET", "M17"};
  ig::Codes ends_{{"M02", "M30"}, ig::take | ig::wake};
  ig::Out<ig::Symbol> returned_{"SubProgramReturn.Term"};
  ig::Out<ig::Symbol> end_{"ProgramEnd.Term"};

  ig::Status restart(ig::Block&) {
    open_.clear();
    loops_.clear();
    if (!environment_.flow.is_indexing()) environment_.store().restart();
    return ig::Status::unchanged;
  }

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (text[position] == ':') return main_block(b, text, position);
    const std::size_t end = skip_name(text, position);
    // The control wants two letters first; L1: is written, too.
    if (end - position < 2 || (iso::is_digit(text[position + 1]) && at(text, end) != ':')) return position;
    const std::size_t behind = skip_blanks(text, end);
    if (at(text, behind) == ':' && at(text, behind + 1) != '=') {
      const std::string name = upper(piece(text, position, end));
      b.set_text(label_, name);
      environment_.flow.label(b, name);
      return behind + 1;
    }
    const Word word = word_of(piece(text, position, end));
    if (word == Word::none || (at(text, behind) == '=' && at(text, behind + 1) != '=')) return position;
    if (environment_.flow.is_indexing()) index(b, word, text, end);
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
    if (b.is_fresh(label_)) end_section(b);
    return any ? ig::Status::changed : ig::Status::unchanged;
  }

 private:
  static Word word_of(std::string_view name) {
    struct Known {
      std::string_view name;
      Word word;
    };
    static constexpr Known known[] = {
        {"IF", Word::if_},        {"ELSE", Word::else_},        {"ENDIF", Word::endif},
        {"WHILE", Word::while_},  {"ENDWHILE", Word::endwhile}, {"FOR", Word::for_},
        {"ENDFOR", Word::endfor}, {"LOOP", Word::loop},         {"ENDLOOP", Word::endloop},
        {"REPEAT", Word::repeat}, {"REPEATB", Word::repeatb},   {"UNTIL", Word::until},
        {"GOTO", Word::go},       {"GOTOF", Word::go},          {"GOTOB", Word::go},
        {"GOTOC", Word::go},      {"GOTOS", Word::go},          {"CASE", Word::case_}};
    if (name.size() > 8 || name.size() < 2) return Word::none;
    for (const Known& k : known)
      if (iso::equals_ignoring_case(name, k.name)) return k.word;
    return Word::none;
  }

  /// :100 is a main block: a sequence number to which programs jump as to N100.
  std::size_t main_block(ig::Block& b, std::string_view text, std::size_t position) const {
    const std::size_t end = iso::skip_digits(text, position + 1);
    if (end == position + 1 || !iso::stands_first(text, position)) return position;
    environment_.flow.label(b, "N" + std::string(piece(text, position + 1, end)));
    return end;
  }

  std::int64_t line_of(const ig::Block& b) const { return environment_.flow.here(b).line; }

  // ---- While the program is indexed

  void index(ig::Block& b, Word word, std::string_view text, std::size_t behind) {
    const std::int64_t line = line_of(b);
    switch (word) {
      case Word::if_:
        if (!jumps(text, behind)) open_.push_back({Word::if_, line, 0});
        return;
      case Word::while_:
      case Word::for_:
      case Word::loop: open_.push_back({word, line, 0}); return;
      case Word::else_:
        if (open_.empty() || open_.back().word != Word::if_) return;
        environment_.flow.label(b, named("ELSE@", open_.back().line));
        open_.back().else_line = line;
        return;
      case Word::endif: close(b, Word::if_, "ENDIF@"); return;
      case Word::endwhile: close(b, Word::while_, "ENDWHILE@"); return;
      case Word::endfor: close(b, Word::for_, "ENDFOR@"); return;
      case Word::endloop: close(b, Word::loop, "ENDLOOP@"); return;
      default: return;
    }
  }
  void close(ig::Block& b, Word word, std::string_view name) {
    if (open_.empty() || open_.back().word != word) return;
    environment_.flow.label(b, named(name, open_.back().line));
    if (open_.back().else_line != 0) environment_.flow.label(b, named(name, open_.back().else_line));
    open_.pop_back();
  }
  static std::string named(std::string_view name, std::int64_t line) {
    return std::string(name).append(std::to_string(line));
  }
  /// Does a GOTO stand behind the condition?
  static bool jumps(std::string_view text, std::size_t position) {
    const std::size_t end = statement_end(text, position);
    bool quoted = false;
    for (std::size_t i = position; i + 4 <= end; ++i) {
      if (text[i] == '"') quoted = !quoted;
      if (!quoted && !is_name_part(text[i - 1]) && iso::equals_ignoring_case(text.substr(i, 4), "GOTO")) return true;
    }
    return false;
  }

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
      case Word::go: go(b, text, begin_); return;
      case Word::case_: return execute_case(b, text);
      case Word::none: return;
    }
  }

  static ig::Where columns(std::string_view text, std::size_t begin) {
    return ig::Where::columns(begin, std::max(text.size(), begin + 1));
  }
  /// False, and said, when something stands behind the statement.
  static bool ends(ig::Block& b, std::string_view text, std::size_t position) {
    const std::size_t rest = skip_blanks(text, position);
    if (rest >= text.size()) return true;
    b.report(diag("SIE-0141"), columns(text, rest), text.substr(rest));
    return false;
  }
  static bool is_word(std::string_view text, std::size_t position, std::string_view word) {
    return iso::equals_ignoring_case(piece(text, position, skip_name(text, position)), word);
  }
  /// The condition behind the word, and where reading stopped. WHILE (…) DO is written, too.
  std::optional<bool> condition(ig::Block& b, std::string_view text, std::size_t& after) const {
    Expression e(b, environment_, text, behind_);
    const auto holds = e.truth();
    after = skip_blanks(text, e.position());
    return holds;
  }

  void execute_if(ig::Block& b, std::string_view text, std::int64_t line) {
    std::size_t after = 0;
    const auto holds = condition(b, text, after);
    const bool has_jump = after < text.size() && word_of(piece(text, after, skip_name(text, after))) == Word::go;
    if (!holds) {
      // Neither branch is known to be right: both are left out.
      if (!jumps(text, behind_)) jump_behind(b, text, "ENDIF@", "ENDIF", line);
      return;
    }
    if (has_jump) {
      if (*holds) go(b, text, after);
      return;
    }
    if (!ends(b, text, after) || *holds) return;
    if (jump(b, named("ELSE@", line), IG_SEARCH_FORWARD).is_not_found()) jump_behind(b, text, "ENDIF@", "ENDIF", line);
  }

  ig::Flow::Answer jump(ig::Block& b, std::string_view label, ig_search search) const {
    return environment_.flow.jump(b, label, search, IG_GO_BEHIND);
  }
  void jump_behind(ig::Block& b, std::string_view text, std::string_view prefix, std::string_view word,
                   std::int64_t line) const {
    const ig::Flow::Answer answer = jump(b, named(prefix, line), IG_SEARCH_FORWARD);
    if (answer.is_not_found()) b.report(diag("SIE-0142"), columns(text, begin_), word);
  }

  std::uint64_t frame(const ig::Block& b) const { return environment_.flow.frame(b).id; }

  /// The loop of this line; true where its end has sent the run back to it.
  Loop* begun(ig::Block& b, std::string_view text, LoopKind kind, std::int64_t line) {
    const ig_frame f = environment_.flow.frame(b);
    if (Loop* const loop = loops_.at_line(f.id, line, kind)) {
      loop->jumped = false;
      return loop;
    }
    Loop loop{
        .kind = kind, .frame = f.id, .pass = f.pass, .line = line, .place = environment_.flow.here(b), .until = {}};
    if (!loops_.push(std::move(loop))) {
      b.report(diag("SIE-0143"), columns(text, begin_), static_cast<double>(LoopStack::deepest));
      b.end_program();
      return nullptr;
    }
    return loops_.innermost(f.id);
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

  /// FOR i=1 TO 10: the variable counts in steps of 1, the end value counts, too.
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
    if (!is_complete && (at(text, next) != '=' || from)) b.report(diag("SIE-0144"), columns(text, begin_));
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
      b.report(diag("SIE-0124"), columns(text, variable->begin), std::string_view(variable->name));
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
      b.report(diag("SIE-0145"), columns(text, begin_), text.substr(begin_), word);
      return;
    }
    if (doubtful) b.report(diag("SIE-0146"), columns(text, begin_), word, static_cast<double>(loop->line));
    loop->goes_on = true;
    environment_.flow.go_to(b, loop->place);
  }

  void execute_until(ig::Block& b, std::string_view text) {
    bool doubtful = false;
    Loop* const loop = loops_.ending(frame(b), line_of(b), LoopKind::until, doubtful);
    if (loop == nullptr) {
      b.report(diag("SIE-0145"), columns(text, begin_), std::string_view("UNTIL"), std::string_view("REPEAT"));
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
      next = skip_blanks(text, next);
      if (word_ == Word::repeatb) {
        found.until = first_label_;
      } else if (is_name_start(at(text, next)) && !is_word(text, next, "P")) {
        const std::size_t last = skip_name(text, next);
        found.until = upper(piece(text, next, last));
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
        b.report(diag("SIE-0141"), columns(text, name), text.substr(std::min(name, text.size())));
        return;
      }
      if (!ends(b, text, next)) return;
      found.until += ' ' + first_label_;  // "END BEGIN"
      if (!loops_.push(std::move(found))) {
        b.report(diag("SIE-0143"), columns(text, begin_), static_cast<double>(LoopStack::deepest));
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
    const ig::Flow::Answer answer = environment_.flow.jump(b, from, IG_SEARCH_BACKWARD);
    if (!answer.is_not_found()) return;
    const ig::Flow::Answer ahead = environment_.flow.jump(b, from, IG_SEARCH_FORWARD);
    if (!ahead.is_not_found()) return;
    b.report(diag("SIE-0147"), columns(text, begin_), std::string_view(from), ahead.reason);
    loops_.pop();
  }

  /// The label behind which the section in repetition ends.
  void end_section(ig::Block& b) {
    loops_.enter(environment_.flow.frame(b));
    const Loop* const section = loops_.innermost(frame(b));
    if (section == nullptr || section->kind != LoopKind::section) return;
    const std::string_view until = section->until;
    if (until.substr(0, until.find(' ')) == b.text(label_)) environment_.flow.go_to(b, section->place);
  }

  // ---- GOTO

  /// GOTOF LABEL at `position`; LABEL is a name, a sequence number or a text.
  void go(ig::Block& b, std::string_view text, std::size_t position) {
    const std::size_t behind = skip_name(text, position);
    const std::string kind = upper(piece(text, position, behind));
    loops_.enter(environment_.flow.frame(b));
    if (kind == "GOTOS") {
      if (ends(b, text, behind)) environment_.flow.restart(b);
      return;
    }
    const std::size_t target = skip_blanks(text, behind);
    std::size_t end = skip_name(text, target);
    std::string label = upper(piece(text, target, end));
    const Variable* const variable = label.empty() ? nullptr : environment_.store().find(label);
    const std::size_t next = skip_blanks(text, end);
    if (label.empty() || (variable != nullptr && variable->value.is_text()) ||
        text.substr(std::min(next, text.size())).starts_with("<<")) {
      Expression e(b, environment_, text, target);
      const auto name = e.value();
      if (!name) return;
      if (!name->is_text()) {
        b.report(diag("SIE-0148"), columns(text, target), text.substr(std::min(target, text.size())));
        return;
      }
      label = upper(iso::trim(name->text));
      if (label.ends_with(':')) label.pop_back();
      end = e.position();
    }
    if (iso::is_digit(label.empty() ? '0' : label[0])) {
      b.report(diag("SIE-0148"), columns(text, target), text.substr(std::min(target, text.size())));
      return;
    }
    if (!ends(b, text, end)) return;
    const bool is_number = label.size() > 1 && label[0] == 'N' && iso::skip_digits(label, 1) == label.size();
    if (is_number) label.erase(1, std::min(label.find_first_not_of('0', 1), label.size() - 1) - 1);
    const ig_search search = kind == "GOTOF"   ? ig_search{IG_SEARCH_FORWARD}
                             : kind == "GOTOB" ? ig_search{IG_SEARCH_BACKWARD}
                                               : ig_search{IG_SEARCH_AROUND};
    const ig::Flow::Answer answer = environment_.flow.jump(b, label, search);
    if (answer.is_not_found()) {
      if (kind != "GOTOC") b.report(diag("SIE-0149"), columns(text, target), std::string_view(label), answer.reason);
      return;
    }
    loops_.note_jump(frame(b));
  }

  /// CASE (x) OF 1 GOTOF A 2 GOTOF B DEFAULT GOTOF C
  void execute_case(ig::Block& b, std::string_view text) {
    Expression e(b, environment_, text, behind_);
    const auto value = e.number();
    if (!value) return;
    std::size_t next = skip_blanks(text, e.position());
    if (!is_word(text, next, "OF")) {
      b.report(diag("SIE-0144"), columns(text, begin_));
      return;
    }
    next = skip_blanks(text, next + 2);
    while (next < text.size()) {
      bool matches = is_word(text, next, "DEFAULT");
      if (matches) {
        next += 7;
      } else {
        Expression constant(b, environment_, text, next);
        const auto n = constant.number();
        if (!n) return;
        matches = *n == *value;
        next = constant.position();
      }
      next = skip_blanks(text, next);
      const std::size_t behind = skip_name(text, next);
      if (word_of(piece(text, next, behind)) != Word::go) {
        b.report(diag("SIE-0144"), columns(text, begin_));
        return;
      }
      const std::size_t label = skip_blanks(text, behind), end = skip_name(text, label);
      if (matches) return go(b, text.substr(0, end), next);
      next = skip_blanks(text, end);
    }
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
      environment_.flow.leave(b);
    } else {
      b.set(end_, returns_.name(*code));
      b.end_program();
    }
    return true;
  }

  struct Open {
    Word word;
    std::int64_t line, else_line;
  };
  std::vector<Open> open_;  // while the program is indexed
  LoopStack loops_;
  Word word_ = Word::none;  // what scan() has found
  std::size_t begin_ = 0, behind_ = 0, end_statement_ = 0;
  std::string first_label_;
};

const ig::Register<SiemensFlow> registered;

}  // namespace
}  // namespace siemens
