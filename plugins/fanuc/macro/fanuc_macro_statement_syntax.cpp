// Macro statements: assignments, IF, GOTO, WHILE, alarms, output. The scanner takes the statement as a whole, so that
// no part of it is read as a word; build() executes it on the text, which is quicker than keeping parsed expressions.
#include <isogloss_flow.h>

#include <string>
#include <utility>

#include "macro/macro_environment.hpp"
#include "macro/macro_loops.hpp"
#include "macro/macro_output.hpp"
#include "macro/macro_statement_text.hpp"

namespace fanuc {

using namespace ig::cnc;
namespace {

enum class Governs { statement, rest_of_block };

struct FanucMacroStatement {
  static constexpr auto spec =
      ig::syntax("FanucMacroStatementSyntax", "Macro statements: assignments, IF, WHILE, GOTO, alarms and output.")
          .after("IsoCommentSyntax", "HeadIndexSyntax", "ProgramNumberSyntax")
          .before("WordSyntax")
          .scans("[#IWDEGTOBPSRCiwdegtobpsrc");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "FAN-0121", "{0} is read-only on this control: nothing is assigned"),
      ig::diagnostic(IG_ERROR, "FAN-0122", "the tables of this run have no row for {0}: nothing is written"),
      ig::diagnostic(IG_ERROR, "FAN-0123", "'{0}' does not belong here: the statement is not executed"),
      ig::diagnostic(IG_ERROR, "FAN-0124", "the statement has no =: nothing is assigned"),
      ig::diagnostic(IG_ERROR, "FAN-0125",
                     "the macro statement '{0}' follows other words: it is not executed; give it its own block"),
      ig::diagnostic(IG_ERROR, "FAN-0131", "{0} is incomplete: {1} is missing; nothing is executed"),
      ig::diagnostic(IG_ERROR, "FAN-0132", "'{0}' is not a valid sequence number: the jump is not executed"),
      ig::diagnostic(IG_ERROR, "FAN-0133", "N{0} is not found, so the jump is not executed: {1}"),
      ig::diagnostic(IG_ERROR, "FAN-0134", "{0}{1} is not executed: loops are numbered from 1 to {2}"),
      ig::diagnostic(IG_ERROR, "FAN-0135", "END{0} of this loop is not found, so the loop is not skipped: {1}"),
      ig::diagnostic(IG_ERROR, "FAN-0136", "END{0} belongs to no open DO{0}: the run continues after END{0}"),
      ig::diagnostic(IG_ERROR, "FAN-0137", "END{0} crosses the loop DO{1} of line {2}: end the inner loop first"),
      ig::diagnostic(IG_ERROR, "FAN-0138", "DO{0} stands inside DO{0} of line {1}: give the inner loop another number"),
      ig::diagnostic(IG_ERROR, "FAN-0139", "alarm {0}: {1}"),
      ig::diagnostic(IG_NOTE, "FAN-0140", "the program stops and shows: {0}"),
      ig::diagnostic(IG_WARNING, "FAN-0143",
                     "words follow THEN, where the control permits only a macro statement: they are executed here"),
      ig::diagnostic(IG_ERROR, "FAN-0144",
                     "DO{0} has no END{0} before its program ends: the blocks after DO{0} are run once"),
      ig::diagnostic(IG_WARNING, "FAN-0173",
                     "the program waits for #{0}, whose state is not known here: the wait loop is skipped"),
  };

  ig::IntegerOption loops_{"loops", "3", {1, 99}, "The largest loop number after DO and END."};
  ig::Choice<Governs> governs_{
      "if-governs", "statement|rest-of-block", "statement",
      "What the condition of IF governs: the one macro statement after THEN, or everything after the condition in the "
      "block, with or without THEN; with the latter also [condition] M99."};
  MacroEnvironment environment_;
  ig::Service<ig_flow_1> flow_{IG_FLOW_SERVICE, ig::Need::optional, "Whether a loop has its END."};
  ig::TextField program_{"Source.Program", ig::read | ig::wake};
  ig::TextField tape_{"TapeBoundary.Text", ig::read | ig::wake};
  ig::Codes program_end_{{"M02", "M30"}, ig::read | ig::wake};
  ig::Call return_{{"M99"}, "", ig::read | ig::wake};
  ig::In<double> p_{"Parsing.P"};
  ig::Signal statement_{"Parsing.~MacroStatement", ig::read | ig::write | ig::wake};
  ig::Out<std::int64_t> variable_{"Vars.Variable", {ig::Life::block, "", "Number of the variable that was assigned."}};
  ig::Out<double> value_{"Vars.Value", {ig::Life::block, "", "The value that was assigned; absent: null."}};
  ig::Out<ig::Symbol> stop_{"ProgramStop.Term"};
  ig::Name message_stop_{"#3006"};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    if (text[position] == '[') return scan_return(b, text, position);
    const Word word = statement_at(text, position);
    if (word == Word::none) return position;
    const bool is_first = stands_first(text, position);
    has_comment_ = false;
    const std::size_t end = statement_end(text, position, has_comment_);
    if (word == Word::foreign || !is_first) {
      if (word == Word::foreign)
        leave(b, IG_LEFT_STATEMENT, piece(text, position, end), position, end);
      else
        b.report(ig::diag("FAN-0125"), ig::Where::columns(position, end), piece(text, position, end));
      return end;
    }
    if (environment_.flow.is_indexing()) {
      if (word == Word::end) say_label(b, text, position);
      return end;
    }
    begin_ = position;
    end_ = end;
    if (word == Word::if_ && governs_ == Governs::rest_of_block)
      if (const std::size_t rest = governed(text, position, end); rest != 0)
        return scan_governed(b, text, position, rest, end);
    if (word == Word::if_)
      if (const std::size_t words = words_behind_then(text, position, end); words != 0)
        return scan_words(b, text, position, words, end);
    b.raise(statement_);
    return end;
  }

  ig::Status restart(ig::Block&) {
    loops_here_.clear();
    unbegun_.fill(false);
    said_output_.clear();
    wait_ = {};
    waited_.clear();
    return ig::Status::unchanged;
  }

  ig::Status build(ig::Block& b) {
    if (b.has(program_)) note_program(b);
    if (b.has(tape_) || b.find(program_end_) || b.find(return_)) end_of_program(b);
    if (!b.is_raised(statement_) || end_ > b.source().size()) return ig::Status::unchanged;
    environment_.enter(b);
    std::string_view text = b.source().substr(0, end_);
    if (has_comment_ && !has_message(text.substr(begin_))) {
      blank_comments(text);
      text = blanked_;
    }
    execute(b, text, begin_);
    return ig::Status::changed;
  }

 private:
  /// M99 P in the main program is a jump.
  void end_of_program(ig::Block& b) {
    if (b.find(return_) && b.has(p_) && environment_.flow.frame(b).depth == 0)
      note_jump(b);
    else
      loops_here_.end_frame(b, environment_.flow);
  }
  void note_jump(ig::Block& b) {
    for (MacroLoops::Loop& loop : own_loops(b)) loop.jumped = true;
  }

  /// #4115 of the main program. Another program number ends the one before it.
  void note_program(ig::Block& b) {
    loops_here_.end_frame(b, environment_.flow);
    if (environment_.flow.frame(b).depth == 0) environment_.store().main_program = program_number(b.text(program_));
  }

  /// The statement with blanks for its comments, so that columns stay.
  void blank_comments(std::string_view text) {
    blanked_.assign(text);
    for (std::size_t i = begin_; i < blanked_.size(); ++i)
      if (blanked_[i] == '(') {
        const std::size_t close = skip_bracketed(text, i);
        std::fill(blanked_.begin() + static_cast<std::ptrdiff_t>(i),
                  blanked_.begin() + static_cast<std::ptrdiff_t>(close), ' ');
        i = close - 1;
      }
  }
  void say_label(ig::Block& b, std::string_view text, std::size_t position) const {
    std::int64_t number = 0;
    if (!fanuc::loop_number(text, skip_while(text, position, is_letter), number)) return;
    const std::string name = "END" + std::to_string(number);
    environment_.flow.label(b, name);
  }
  Outcome evaluate_at(ig::Block& b, std::string_view text, std::size_t position) const {
    const Outcome o = evaluate(text, position, environment_.rules(), environment_.reader(b));
    if (!o.ok()) {
      environment_.report(b, o, text);
    } else if (environment_.has_deep_brackets(o)) {
      environment_.warn_of_depth(b, o, position, o.end);
    }
    return o;
  }

  // ---- IF … THEN words

  std::size_t scan_words(ig::Block& b, std::string_view text, std::size_t position, std::size_t words,
                         std::size_t end) {
    environment_.enter(b);
    std::size_t after = 0;
    const std::optional<bool> holds = condition(b, text.substr(0, end), position, "IF", after);
    if (!holds || !*holds) return end;
    b.report(ig::diag("FAN-0143"), ig::Where::columns(words, end));
    return words;
  }

  // ---- all that stands behind the condition

  std::size_t scan_governed(ig::Block& b, std::string_view text, std::size_t position, std::size_t rest,
                            std::size_t end) {
    environment_.enter(b);
    std::size_t after = 0;
    const std::optional<bool> holds = condition(b, text.substr(0, end), position, "IF", after);
    if (!holds || !*holds) return end;
    if (is_letter(text[rest])) return rest;
    begin_ = rest;
    end_ = assignment_end(text, rest, end);
    b.raise(statement_);
    return end_;
  }

  /// [#100 LT 10] M99: an M99 if it holds. With P10 it is a GOTO10, and so a statement.
  std::size_t scan_return(ig::Block& b, std::string_view text, std::size_t position) {
    if (governs_ != Governs::rest_of_block || !stands_first(text, position)) return position;
    bool has_comment = false;
    const std::size_t end = statement_end(text, position, has_comment);
    const std::size_t rest = skip_blanks(text, skip_bracketed(text.substr(0, end), position));
    const std::size_t behind = return_end(text.substr(0, end), rest);
    if (behind == 0) return position;
    if (environment_.flow.is_indexing()) return end;
    if (to_upper(at(text, behind)) == 'P') {
      begin_ = position;
      end_ = end;
      has_comment_ = has_comment;
      b.raise(statement_);
      return end;
    }
    environment_.enter(b);
    const Outcome o = evaluate_at(b, text.substr(0, end), position);
    return o.ok() && o.value.number != 0 ? rest : end;
  }

  void execute_return_to(ig::Block& b, std::string_view text, std::size_t position) {
    const Outcome o = evaluate_at(b, text, position);
    if (!o.ok() || o.value.number == 0) return;
    execute_go_to(b, text, position, return_end(text, skip_blanks(text, o.end)) + 1);
  }

  // ---- one statement

  void execute(ig::Block& b, std::string_view text, std::size_t position) {
    if (text[position] == '#') return assign(b, text, position);
    if (text[position] == '[') return execute_return_to(b, text, position);
    std::size_t behind = 0;
    switch (keyword_or_short(text, position, behind)) {
      case Word::if_: return execute_if(b, text, position);
      case Word::while_: return execute_while(b, text, position);
      case Word::do_: return execute_do(b, text, position, position);
      case Word::end: return execute_end(b, text, position);
      case Word::go_to: return execute_go_to(b, text, position, behind);
      case Word::output: return put_out(b, environment_, said_output_, text, position, behind);
      case Word::set_name:
        if (said_output_.is_first("SETVN"))
          b.report(ig::diag("FAN-0141"), columns(text, position), text.substr(position));
        return;
      default: incomplete(b, text, position, text.substr(position), "IF");
    }
  }

  static ig::Where columns(std::string_view text, std::size_t position) {
    return ig::Where::columns(position, std::max(text.size(), position + 1));
  }
  static void incomplete(ig::Block& b, std::string_view text, std::size_t position, std::string_view what,
                         std::string_view missing) {
    b.report(ig::diag("FAN-0131"), columns(text, position), what, missing);
  }
  /// False, and said, when something stands behind the statement.
  static bool ends(ig::Block& b, std::string_view text, std::size_t position) {
    const std::size_t rest = skip_blanks(text, position);
    if (rest >= text.size()) return true;
    b.report(ig::diag("FAN-0123"), ig::Where::columns(rest, text.size()), text.substr(rest));
    return false;
  }

  /// Nothing where it has no answer, which is said. `after`: behind it.
  std::optional<bool> condition(ig::Block& b, std::string_view text, std::size_t position, std::string_view what,
                                std::size_t& after) const {
    const std::size_t bracket = skip_blanks(text, skip_while(text, position, is_letter));
    if (at(text, bracket) != '[') {
      incomplete(b, text, position, what, "[");
      return std::nullopt;
    }
    environment_.forget_signals();
    const Outcome o = evaluate_at(b, text, bracket);
    if (!o.ok()) return std::nullopt;
    after = skip_blanks(text, o.end);
    if (o.value.kind != Kind::truth && !environment_.rules().truth_is_number) {
      b.report(ig::diag("FAN-0116"), ig::Where::columns(bracket, o.end), piece(text, bracket, o.end));
      return std::nullopt;
    }
    return o.value.number != 0;
  }

  void execute_if(ig::Block& b, std::string_view text, std::size_t position) {
    std::size_t after = 0;
    const std::optional<bool> holds = condition(b, text, position, "IF", after);
    if (!holds) return;
    std::size_t behind = 0;
    const Word next = is_letter(at(text, after)) ? keyword_or_short(text, after, behind) : Word::none;
    if (next == Word::go_to) {
      if (*holds) execute_go_to(b, text, after, behind, true);
      return;
    }
    if (next != Word::then) {
      if (after < text.size())
        b.report(ig::diag("FAN-0123"), ig::Where::columns(after, text.size()), text.substr(after));
      else
        incomplete(b, text, position, "IF", "GOTO or THEN");
      return;
    }
    const std::size_t statement = skip_blanks(text, behind);
    if (statement >= text.size()) return incomplete(b, text, position, "THEN", "the statement");
    const Word inner = is_letter(text[statement]) ? keyword_or_short(text, statement, behind) : Word::none;
    const bool is_plain = text[statement] == '#' || inner == Word::go_to || inner == Word::output;
    if (!is_plain) {
      b.report(ig::diag("FAN-0123"), ig::Where::columns(statement, text.size()), text.substr(statement));
    } else if (*holds) {
      execute(b, text, statement);
    }
  }

  // ---- assignment

  void assign(ig::Block& b, std::string_view text, std::size_t position) {
    const Outcome target = evaluate_reference(text, position, environment_.rules(), environment_.reader(b));
    if (!target.ok()) return environment_.report(b, target, text);
    const auto number = static_cast<std::uint32_t>(target.value.number);
    const std::size_t equals = skip_blanks(text, target.end);
    if (at(text, equals) != '=') {
      b.report(ig::diag("FAN-0124"), columns(text, position));
      return;
    }
    const Outcome o = evaluate_at(b, text, equals + 1);
    if (!o.ok()) return;
    MacroValue value = o.value;
    if (value.kind == Kind::truth) {
      if (!environment_.rules().truth_is_number) {
        const std::size_t begin = skip_blanks(text, equals + 1);
        b.report(ig::diag("FAN-0115"), ig::Where::columns(begin, o.end), piece(text, begin, o.end));
        return;
      }
      value.kind = Kind::number;
    }
    if (number == 3000 || number == 3006) return message(b, text, position, number, value, o.end);
    if (!ends(b, text, o.end)) return;
    using Written = MacroEnvironment::Written;
    const auto where = ig::Where::columns(position, target.end);
    const auto name = [&] { return MacroEnvironment::name_of(piece(text, position, target.end), number); };
    switch (environment_.write(b, number, value)) {
      case Written::done: break;
      case Written::no_variable: b.report(ig::diag("FAN-0109"), where, name()); return;
      case Written::read_only: b.report(ig::diag("FAN-0121"), where, name()); return;
      default: b.report(ig::diag("FAN-0122"), where, name()); return;
    }
    b.set(variable_, static_cast<std::int64_t>(number));
    if (!value.is_null()) b.set(value_, value.number);
  }

  /// #3000=1(TEXT) and #3006=1(TEXT)
  void message(ig::Block& b, std::string_view text, std::size_t position, std::uint32_t number, const MacroValue& value,
               std::size_t end) {
    std::size_t open = skip_blanks(text, end);
    std::string_view words;
    if (at(text, open) == '(') {
      const std::size_t close = text.find(')', open);
      words = trim(piece(text, open + 1, close == std::string_view::npos ? text.size() : close));
      open = close == std::string_view::npos ? text.size() : close + 1;
    }
    if (!ends(b, text, open)) return;
    if (words.empty()) words = "(no text)";
    if (number == 3006) {
      b.report(ig::diag("FAN-0140"), columns(text, position), words);
      b.set(stop_, message_stop_);
      return;
    }
    const bool is_own = value.number >= 0 && value.number <= 200;
    b.report(ig::diag("FAN-0139"), columns(text, position), is_own ? 3000 + value.number : value.number, words);
    b.alarm();
  }

  // ---- flow

  /// `by_condition`: IF was asked, and holds.
  void execute_go_to(ig::Block& b, std::string_view text, std::size_t position, std::size_t behind,
                     bool by_condition = false) {
    const bool may_wait = by_condition && asked_only_signals();
    const std::size_t target = skip_blanks(text, behind);
    if (target >= text.size()) return incomplete(b, text, position, "GOTO", "the sequence number");
    const Outcome o = evaluate_at(b, text, target);
    if (!o.ok() || !ends(b, text, o.end)) return;
    const double n = o.value.number;
    if (o.value.kind != Kind::number || !(n >= 0 && n <= 99'999'999) || n != std::floor(n)) {
      b.report(ig::diag("FAN-0132"), ig::Where::columns(target, o.end), piece(text, target, o.end));
      return;
    }
    std::array<char, 24> name{'N'};
    char* const end = std::to_chars(name.data() + 1, name.data() + name.size(), static_cast<std::int64_t>(n)).ptr;
    const std::string_view label(name.data(), static_cast<std::size_t>(end - name.data()));
    if (may_wait && lacks(b, label) && waits_again(b)) return;
    const ig::Flow::Answer answer = environment_.flow.jump(b, label);
    if (answer.is_not_found())
      b.report(ig::diag("FAN-0133"), ig::Where::columns(target, o.end), label.substr(1), answer.reason);
    note_jump(b);
  }

  std::span<MacroLoops::Loop> own_loops(ig::Block& b) { return loops_here_.own(b, environment_.flow); }

  void execute_while(ig::Block& b, std::string_view text, std::size_t position) {
    std::size_t after = 0;
    const std::optional<bool> holds = condition(b, text, position, "WHILE", after);
    if (!holds) return note_unbegun(text, position);
    std::size_t behind = 0;
    if (!is_letter(at(text, after)) || keyword(text, after, behind) != Word::do_)
      return incomplete(b, text, position, "WHILE", "DO");
    if (*holds && !(asked_only_signals() && waits_again(b))) return execute_do(b, text, position, after);
    const auto number = loop_number(b, text, after, "DO");
    if (!number) return;
    loops_here_.leave(b, environment_.flow, *number);
    const ig::Flow::Answer answer = environment_.flow.jump(b, end_label(*number), IG_SEARCH_FORWARD, IG_GO_BEHIND);
    if (answer.is_not_found())
      b.report(ig::diag("FAN-0135"), columns(text, after), static_cast<double>(*number), answer.reason);
  }

  /// The last condition read a signal of the machine, and else nothing that changes by itself.
  bool asked_only_signals() const { return environment_.signals().last != 0 && !environment_.signals().others_also; }

  /// A condition that goes back holds here with nothing written since it last did: the program waits for the machine,
  /// which is not here. True, and said, when it came so a second time: what it waits for has come.
  bool waits_again(ig::Block& b) {
    const ig_place place = environment_.flow.here(b);
    const Wait now{place.frame, place.offset, environment_.flow.frame(b).pass, environment_.store().writes()};
    if (now != wait_) {
      wait_ = now;
      return false;
    }
    wait_ = {};
    const std::uint32_t signal = environment_.signals().last;
    if (std::find(waited_.begin(), waited_.end(), signal) == waited_.end()) {
      waited_.push_back(signal);
      b.report(ig::diag("FAN-0173"), columns(b.source().substr(0, end_), begin_), static_cast<double>(signal));
    }
    return true;
  }

  /// Does no block of that name stand behind this one in the program?
  bool lacks(ig::Block& b, std::string_view label) const {
    if (!flow_) return false;
    ig_go go{};
    go.struct_size = sizeof go;
    go.kind = IG_ASK_LABEL;
    go.label = ig::to_text(label);
    go.search = IG_SEARCH_FORWARD;
    return flow_->go(b.raw(), &go) == IG_GO_NOT_FOUND;
  }

  std::string_view end_label(std::int64_t number) {
    char* const end = std::to_chars(label_.data() + 3, label_.data() + label_.size(), number).ptr;
    return {label_.data(), static_cast<std::size_t>(end - label_.data())};
  }

  /// The number behind DO or END at `position`; nothing, and said, where it is none.
  std::optional<std::int64_t> loop_number(ig::Block& b, std::string_view text, std::size_t position,
                                          std::string_view word) {
    std::int64_t number = 0;
    const std::size_t behind = skip_while(text, position, is_letter);
    if (!fanuc::loop_number(text, behind, number)) {
      incomplete(b, text, position, word, "its number");
      return std::nullopt;
    }
    const std::size_t digits = skip_blanks(text, behind);
    if (!ends(b, text, skip_digits(text, digits))) {
      if (word == "DO") note_unbegun(text, position);
      return std::nullopt;
    }
    if (number < 1 || number > loops_) {
      b.report(ig::diag("FAN-0134"), columns(text, position), word, static_cast<double>(number),
               static_cast<double>(loops_));
      return std::nullopt;
    }
    return number;
  }

  /// The loop of a faulty WHILE or DO: its END is no fault of its own.
  void note_unbegun(std::string_view text, std::size_t position) {
    for (std::size_t i = position; i + 2 < text.size(); ++i) {
      std::int64_t number = 0;
      if (equals_ignoring_case(text.substr(i, 2), "DO") && fanuc::loop_number(text, i + 2, number) && number >= 1 &&
          number < static_cast<std::int64_t>(unbegun_.size())) {
        unbegun_[static_cast<std::size_t>(number)] = true;
        return;
      }
    }
  }

  /// WHILE […] DO m that holds, and DO m alone. `position`: of the block's statement, `at_do`: of DO.
  void execute_do(ig::Block& b, std::string_view text, std::size_t position, std::size_t at_do) {
    const auto number = loop_number(b, text, at_do, "DO");
    if (!number) return;
    const ig_place place = environment_.flow.here(b);
    std::span<MacroLoops::Loop> open = own_loops(b);
    if (!open.empty() && open.back().number == *number && open.back().place.offset == place.offset) {
      open.back().jumped = false;  // the next pass
      return;
    }
    for (const MacroLoops::Loop& loop : open) {
      if (loop.number != *number) continue;
      if (!loop.jumped && loop.place.offset != place.offset)
        b.report(ig::diag("FAN-0138"), columns(text, position), static_cast<double>(*number),
                 static_cast<double>(loop.place.line));
      loops_here_.leave(b, environment_.flow, *number);
      break;
    }
    unbegun_[static_cast<std::size_t>(*number)] = false;
    loops_here_.begin(*number, place);
    if (lacks(b, end_label(*number)))
      b.report(ig::diag("FAN-0144"), columns(text, at_do), static_cast<double>(*number));
  }

  void execute_end(ig::Block& b, std::string_view text, std::size_t position) {
    const auto number = loop_number(b, text, position, "END");
    if (!number) return;
    std::span<MacroLoops::Loop> open = own_loops(b);
    while (!open.empty() && open.back().number != *number) {
      const MacroLoops::Loop inner = open.back();
      const bool is_open =
          std::any_of(open.begin(), open.end(), [&](const MacroLoops::Loop& l) { return l.number == *number; });
      if (!is_open) break;
      if (!inner.jumped)
        b.report(ig::diag("FAN-0137"), columns(text, position), static_cast<double>(*number),
                 static_cast<double>(inner.number), static_cast<double>(inner.place.line));
      loops_here_.end_innermost();
      open = own_loops(b);
    }
    if (open.empty() || open.back().number != *number) {
      if (std::exchange(unbegun_[static_cast<std::size_t>(*number)], false)) return;  // why it was not begun is said
      b.report(ig::diag("FAN-0136"), columns(text, position), static_cast<double>(*number));
      return;
    }
    environment_.flow.go_to(b, open.back().place);
  }

  std::size_t begin_ = 0, end_ = 0;  // of the statement that scan() found
  bool has_comment_ = false;         // inside it
  std::string blanked_;
  SaidOutput said_output_;
  struct Wait {
    std::uint64_t frame = 0, offset = 0;
    std::uint32_t pass = 0;
    std::uint64_t writes = ~std::uint64_t{0};
    bool operator==(const Wait&) const = default;
  };
  Wait wait_;                          // the last condition that went back
  std::vector<std::uint32_t> waited_;  // signals whose wait was said
  MacroLoops loops_here_;
  std::array<bool, 100> unbegun_{};  // by number: a faulty DO came, and was said
  std::array<char, 24> label_{'E', 'N', 'D'};
};

const ig::Register<FanucMacroStatement> fanuc_macro_statement_syntax;

}  // namespace
}  // namespace fanuc
