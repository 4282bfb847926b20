// Macro statements: assignments, IF, GOTO, WHILE, alarms, output. The scanner takes the statement as a whole, so that
// no part of it is read as a word; build() executes it on the text, which is quicker than keeping parsed expressions.
#include <string>

#include "macro_environment.hpp"
#include "scan_util.hpp"

namespace fanuc {
namespace {

using iso::at;
using iso::equals_ignoring_case;
using iso::is_digit;
using iso::is_letter;
using iso::piece;
using iso::skip_blanks;
using iso::skip_while;
using iso::to_upper;

enum class Word : std::uint8_t { none, if_, then, while_, do_, end, go_to, output, set_name, foreign };

struct Keyword {
  std::string_view name;
  Word word;
};
constexpr std::array keywords{
    Keyword{"IF", Word::if_},        Keyword{"THEN", Word::then},      Keyword{"WHILE", Word::while_},
    Keyword{"DO", Word::do_},        Keyword{"END", Word::end},        Keyword{"GOTO", Word::go_to},
    Keyword{"DPRNT", Word::output},  Keyword{"BPRNT", Word::output},   Keyword{"POPEN", Word::output},
    Keyword{"PCLOS", Word::output},  Keyword{"SETVN", Word::set_name}, Keyword{"ELSE", Word::foreign},
    Keyword{"ENDIF", Word::foreign}, Keyword{"RETURN", Word::foreign}, Keyword{"CALL", Word::foreign}};

struct FanucMacroStatement {
  static constexpr auto spec =
      ig::syntax("FanucMacroStatementSyntax", "Macro statements: assignments, IF, WHILE, GOTO, alarms and output.")
          .after("IsoCommentSyntax", "HeadIndexSyntax", "ProgramNumberSyntax")
          .before("WordSyntax")
          .scans("#IWDEGTOBPSRCiwdegtobpsrc");

  ig::IntegerOption loops_{"loops", "3", {1, 99}, "The largest number of DO and END."};
  MacroEnvironment environment_;
  ig::Signal statement_{"Parsing.~MacroStatement", ig::read | ig::write | ig::wake};
  ig::Out<std::int64_t> variable_{"Vars.Variable", {ig::Life::block, "", "Number of the variable that was assigned."}};
  ig::Out<double> value_{"Vars.Value", {ig::Life::block, "", "What was assigned; absent: null."}};
  ig::Out<ig::Symbol> stop_{"ProgramStop.Term"};
  ig::Name message_stop_{"#3006"};

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    const Word word = begins(text, position);
    if (word == Word::none) return position;
    const bool stands_first = iso::stands_first(text, position);
    has_comment_ = false;
    const std::size_t end = statement_end(text, position, has_comment_);
    if (word == Word::foreign || !stands_first) {
      if (word == Word::foreign)
        iso::leave(b, IG_LEFT_STATEMENT, piece(text, position, end), position, end);
      else
        b.report(macro_diag("FAN-0125"), ig::Where::columns(position, end), piece(text, position, end));
      return end;
    }
    if (environment_.flow.is_indexing()) {
      if (word == Word::end) say_label(b, text, position);
      return end;
    }
    begin_ = position;
    end_ = end;
    if (word == Word::if_)
      if (const std::size_t words = words_behind_then(text, position, end); words != 0)
        return scan_words(b, text, position, words, end);
    b.raise(statement_);
    return end;
  }

  ig::Status build(ig::Block& b) {
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
  struct Loop {
    std::int64_t number;
    ig_place place;
    bool jumped;  ///< a GOTO came since: it may have left the loop
  };

  static Word keyword(std::string_view text, std::size_t position, std::size_t& end) {
    end = skip_while(text, position, is_letter);
    const std::string_view word = piece(text, position, end);
    for (const Keyword& k : keywords)
      if (equals_ignoring_case(word, k.name)) return k.word;
    return Word::none;
  }

  static Word begins(std::string_view text, std::size_t position) {
    const char c = text[position];
    if (c == '#') return Word::set_name;  // any statement of its own
    const char second = at(text, position + 1);
    if (to_upper(c) == 'O' && !is_letter(second))
      return iso::begins_o_word(text, position) && iso::stands_first(text, position) ? Word::foreign : Word::none;
    if (!is_letter(second)) return Word::none;
    std::size_t end = 0;
    const Word word = keyword(text, position, end);
    if (word == Word::none || iso::stands_first(text, position)) return word;
    const char next = at(text, skip_blanks(text, end));  // a name behind words is a statement with its value only
    return next == '[' || next == '#' || is_digit(next) ? word : Word::none;
  }

  /// To the semicolon behind it, without the comments there; the parentheses of #3000=1(ALARM TEXT) belong to the
  /// statement. `inner`: a comment stands inside it.
  static std::size_t statement_end(std::string_view text, std::size_t position, bool& inner) {
    const std::size_t block = skip_while(text, position, [](char c) { return c != ';' && c != '\r' && c != '\n'; });
    const std::string_view statement = text.substr(0, block);
    std::size_t end = position + 1;
    bool behind_comment = false;
    for (std::size_t i = position; i < block;) {
      if (statement[i] == '(') {
        const std::size_t close = iso::skip_bracketed(statement, i);
        if (!behind_comment && has_message(piece(statement, position, i)))
          end = close;
        else
          behind_comment = true;
        i = close;
        continue;
      }
      if (!iso::is_blank(statement[i])) {
        end = i + 1;
        inner |= behind_comment;
      }
      ++i;
    }
    return end;
  }

  /// The statement with blanks for its comments, so that columns stay.
  void blank_comments(std::string_view text) {
    blanked_.assign(text);
    for (std::size_t i = begin_; i < blanked_.size(); ++i)
      if (blanked_[i] == '(') {
        const std::size_t close = iso::skip_bracketed(text, i);
        std::fill(blanked_.begin() + static_cast<std::ptrdiff_t>(i),
                  blanked_.begin() + static_cast<std::ptrdiff_t>(close), ' ');
        i = close - 1;
      }
  }
  static bool has_message(std::string_view statement) {
    return statement.find("#3000") != std::string_view::npos || statement.find("#3006") != std::string_view::npos;
  }

  void say_label(ig::Block& b, std::string_view text, std::size_t position) const {
    std::int64_t number = 0;
    if (!loop_number(text, position + 3, number)) return;
    const std::string name = "END" + std::to_string(number);
    environment_.flow.label(b, name);
  }
  static bool loop_number(std::string_view text, std::size_t position, std::int64_t& number) {
    const std::size_t digits = skip_blanks(text, position);
    const std::size_t end = iso::skip_digits(text, digits);
    if (end == digits || end - digits > 9) return false;
    number = 0;
    for (std::size_t i = digits; i < end; ++i) number = number * 10 + (text[i] - '0');
    return true;
  }

  Outcome evaluate_at(ig::Block& b, std::string_view text, std::size_t position) const {
    const Outcome o = evaluate(text, position, environment_.rules(), [&](std::uint32_t number, MacroValue& out) {
      return environment_.read(b, number, out);
    });
    if (!o.ok()) {
      environment_.report(b, o, text);
    } else if (environment_.has_deep_brackets(o)) {
      environment_.warn_of_depth(b, o, position, o.end);
    }
    return o;
  }

  // ---- IF … THEN words

  /// Where the words behind THEN begin; 0 where no words stand there.
  static std::size_t words_behind_then(std::string_view text, std::size_t position, std::size_t end) {
    const std::string_view statement = text.substr(0, end);
    for (std::size_t i = position + 2; i < end;) {
      if (statement[i] == '[') {
        i = iso::skip_bracketed(statement, i);
        continue;
      }
      std::size_t word_end = 0;
      if (is_letter(statement[i]) && keyword(statement, i, word_end) == Word::then) {
        const std::size_t next = skip_blanks(statement, word_end);
        if (next >= end || statement[next] == '#') return 0;
        std::size_t unused = 0;
        return is_letter(statement[next]) && keyword(statement, next, unused) == Word::none ? next : 0;
      }
      i = is_letter(statement[i]) ? skip_while(statement, i, is_letter) : i + 1;
    }
    return 0;
  }

  std::size_t scan_words(ig::Block& b, std::string_view text, std::size_t position, std::size_t words,
                         std::size_t end) {
    environment_.enter(b);
    std::size_t after = 0;
    const std::optional<bool> holds = condition(b, text.substr(0, end), position, "IF", after);
    if (!holds || !*holds) return end;
    b.report(macro_diag("FAN-0143"), ig::Where::columns(words, end));
    return words;
  }

  // ---- one statement

  void execute(ig::Block& b, std::string_view text, std::size_t position) {
    if (text[position] == '#') return assign(b, text, position);
    std::size_t behind = 0;
    switch (keyword(text, position, behind)) {
      case Word::if_: return execute_if(b, text, position);
      case Word::while_: return execute_while(b, text, position);
      case Word::do_: return execute_do(b, text, position, position);
      case Word::end: return execute_end(b, text, position);
      case Word::go_to: return execute_go_to(b, text, position, behind);
      case Word::output: return put_out(b, text, position, behind);
      case Word::set_name: b.report(macro_diag("FAN-0141"), columns(text, position), text.substr(position)); return;
      default: incomplete(b, text, position, text.substr(position), "IF");
    }
  }

  static ig::Where columns(std::string_view text, std::size_t position) {
    return ig::Where::columns(position, std::max(text.size(), position + 1));
  }
  static void incomplete(ig::Block& b, std::string_view text, std::size_t position, std::string_view what,
                         std::string_view missing) {
    b.report(macro_diag("FAN-0131"), columns(text, position), what, missing);
  }
  /// False, and said, when something stands behind the statement.
  static bool ends(ig::Block& b, std::string_view text, std::size_t position) {
    const std::size_t rest = skip_blanks(text, position);
    if (rest >= text.size()) return true;
    b.report(macro_diag("FAN-0123"), ig::Where::columns(rest, text.size()), text.substr(rest));
    return false;
  }

  /// Nothing where it has no answer, which is said. `after`: behind it.
  std::optional<bool> condition(ig::Block& b, std::string_view text, std::size_t position, std::string_view what,
                                std::size_t& after) const {
    const std::size_t bracket = skip_blanks(text, position + what.size());
    if (at(text, bracket) != '[') {
      incomplete(b, text, position, what, "[");
      return std::nullopt;
    }
    const Outcome o = evaluate_at(b, text, bracket);
    if (!o.ok()) return std::nullopt;
    after = skip_blanks(text, o.end);
    if (o.value.kind != Kind::truth && !environment_.rules().truth_is_number) {
      b.report(macro_diag("FAN-0116"), ig::Where::columns(bracket, o.end), piece(text, bracket, o.end));
      return std::nullopt;
    }
    return o.value.number != 0;
  }

  void execute_if(ig::Block& b, std::string_view text, std::size_t position) {
    std::size_t after = 0;
    const std::optional<bool> holds = condition(b, text, position, "IF", after);
    if (!holds) return;
    std::size_t behind = 0;
    const Word next = is_letter(at(text, after)) ? keyword(text, after, behind) : Word::none;
    if (next == Word::go_to) {
      if (*holds) execute_go_to(b, text, after, behind);
      return;
    }
    if (next != Word::then) {
      if (after < text.size())
        b.report(macro_diag("FAN-0123"), ig::Where::columns(after, text.size()), text.substr(after));
      else
        incomplete(b, text, position, "IF", "GOTO or THEN");
      return;
    }
    const std::size_t statement = skip_blanks(text, behind);
    if (statement >= text.size()) return incomplete(b, text, position, "THEN", "the statement");
    const Word inner = is_letter(text[statement]) ? keyword(text, statement, behind) : Word::none;
    const bool is_plain = text[statement] == '#' || inner == Word::go_to || inner == Word::output;
    if (!is_plain) {
      b.report(macro_diag("FAN-0123"), ig::Where::columns(statement, text.size()), text.substr(statement));
    } else if (*holds) {
      execute(b, text, statement);
    }
  }

  // ---- assignment

  void assign(ig::Block& b, std::string_view text, std::size_t position) {
    const Outcome target =
        evaluate_reference(text, position, environment_.rules(),
                           [&](std::uint32_t number, MacroValue& out) { return environment_.read(b, number, out); });
    if (!target.ok()) return environment_.report(b, target, text);
    const auto number = static_cast<std::uint32_t>(target.value.number);
    const std::size_t equals = skip_blanks(text, target.end);
    if (at(text, equals) != '=') {
      b.report(macro_diag("FAN-0124"), columns(text, position));
      return;
    }
    const Outcome o = evaluate_at(b, text, equals + 1);
    if (!o.ok()) return;
    MacroValue value = o.value;
    if (value.kind == Kind::truth) {
      if (!environment_.rules().truth_is_number) {
        const std::size_t begin = skip_blanks(text, equals + 1);
        b.report(macro_diag("FAN-0115"), ig::Where::columns(begin, o.end), piece(text, begin, o.end));
        return;
      }
      value.kind = Kind::number;
    }
    if (number == 3000 || number == 3006) return message(b, text, position, number, value, o.end);
    if (!ends(b, text, o.end)) return;
    using Written = MacroEnvironment::Written;
    const auto where = ig::Where::columns(position, target.end);
    const std::string_view name = piece(text, position, target.end);
    switch (environment_.write(b, number, value)) {
      case Written::done: break;
      case Written::no_variable: b.report(macro_diag("FAN-0109"), where, name); return;
      case Written::read_only: b.report(macro_diag("FAN-0121"), where, name); return;
      default: b.report(macro_diag("FAN-0122"), where, name); return;
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
      words = iso::trim(piece(text, open + 1, close == std::string_view::npos ? text.size() : close));
      open = close == std::string_view::npos ? text.size() : close + 1;
    }
    if (!ends(b, text, open)) return;
    if (words.empty()) words = "(no text)";
    if (number == 3006) {
      b.report(macro_diag("FAN-0140"), columns(text, position), words);
      b.set(stop_, message_stop_);
      return;
    }
    const bool is_own = value.number >= 0 && value.number <= 200;
    b.report(macro_diag("FAN-0139"), columns(text, position), is_own ? 3000 + value.number : value.number, words);
    b.alarm();
  }

  // ---- flow

  void execute_go_to(ig::Block& b, std::string_view text, std::size_t position, std::size_t behind) {
    const std::size_t target = skip_blanks(text, behind);
    if (target >= text.size()) return incomplete(b, text, position, "GOTO", "the sequence number");
    const Outcome o = evaluate_at(b, text, target);
    if (!o.ok() || !ends(b, text, o.end)) return;
    const double n = o.value.number;
    if (o.value.kind != Kind::number || !(n >= 0 && n <= 99'999'999) || n != std::floor(n)) {
      b.report(macro_diag("FAN-0132"), ig::Where::columns(target, o.end), piece(text, target, o.end));
      return;
    }
    std::array<char, 24> name{'N'};
    char* const end = std::to_chars(name.data() + 1, name.data() + name.size(), static_cast<std::int64_t>(n)).ptr;
    const std::string_view label(name.data(), static_cast<std::size_t>(end - name.data()));
    const ig::Flow::Answer answer = environment_.flow.jump(b, label);
    if (answer.is_not_found())
      b.report(macro_diag("FAN-0133"), ig::Where::columns(target, o.end), label.substr(1), answer.reason);
    for (Loop& loop : own_loops(b)) loop.jumped = true;
  }

  /// The loops of the present frame; those of frames that ended are gone.
  std::span<Loop> own_loops(const ig::Block& b) {
    const ig_frame frame = environment_.flow.frame(b);
    if (frame.id != loop_frame_ || frame.pass != loop_pass_) enter_frame(b, frame);
    const auto first =
        std::find_if(loops_here_.begin(), loops_here_.end(), [&](const Loop& l) { return l.place.frame == frame.id; });
    return {first, loops_here_.end()};
  }
  void enter_frame(const ig::Block& b, const ig_frame& frame) {
    const auto is_open = [&](std::uint64_t id) {
      for (std::uint32_t level = 0; level <= frame.depth; ++level)
        if (const auto open = environment_.flow.frame(b, level); open && open->id == id) return true;
      return false;
    };
    std::erase_if(loops_here_, [&](const Loop& l) {
      return !is_open(l.place.frame) ||
             (l.place.frame == frame.id && frame.pass != loop_pass_ && frame.id == loop_frame_);
    });
    loop_frame_ = frame.id;
    loop_pass_ = frame.pass;
  }

  void execute_while(ig::Block& b, std::string_view text, std::size_t position) {
    std::size_t after = 0;
    const std::optional<bool> holds = condition(b, text, position, "WHILE", after);
    if (!holds) return;
    std::size_t behind = 0;
    if (!is_letter(at(text, after)) || keyword(text, after, behind) != Word::do_)
      return incomplete(b, text, position, "WHILE", "DO");
    if (*holds) return execute_do(b, text, position, after);
    const auto number = loop_number(b, text, after, 2);
    if (!number) return;
    leave_loop(b, *number);
    const ig::Flow::Answer answer = environment_.flow.jump(b, end_label(*number), IG_SEARCH_FORWARD, IG_GO_BEHIND);
    if (answer.is_not_found())
      b.report(macro_diag("FAN-0135"), columns(text, after), static_cast<double>(*number), answer.reason);
  }

  std::string_view end_label(std::int64_t number) {
    char* const end = std::to_chars(label_.data() + 3, label_.data() + label_.size(), number).ptr;
    return {label_.data(), static_cast<std::size_t>(end - label_.data())};
  }

  /// The number behind DO (2 letters) or END (3) at `position`; nothing, and said, where it is none.
  std::optional<std::int64_t> loop_number(ig::Block& b, std::string_view text, std::size_t position,
                                          std::size_t letters) const {
    std::int64_t number = 0;
    const std::string_view word = letters == 2 ? "DO" : "END";
    if (!loop_number(text, position + letters, number)) {
      incomplete(b, text, position, word, "its number");
      return std::nullopt;
    }
    const std::size_t digits = skip_blanks(text, position + letters);
    if (!ends(b, text, iso::skip_digits(text, digits))) return std::nullopt;
    if (number < 1 || number > loops_) {
      b.report(macro_diag("FAN-0134"), columns(text, position), word, static_cast<double>(number),
               static_cast<double>(loops_));
      return std::nullopt;
    }
    return number;
  }

  /// Takes the loop of this number, and those inside it, off.
  void leave_loop(const ig::Block& b, std::int64_t number) {
    const std::span<Loop> open = own_loops(b);
    for (std::size_t i = 0; i < open.size(); ++i)
      if (open[i].number == number) {
        loops_here_.erase(loops_here_.end() - static_cast<std::ptrdiff_t>(open.size() - i), loops_here_.end());
        return;
      }
  }

  /// WHILE […] DO m that holds, and DO m alone. `position`: of the block's statement, `at_do`: of DO.
  void execute_do(ig::Block& b, std::string_view text, std::size_t position, std::size_t at_do) {
    const auto number = loop_number(b, text, at_do, 2);
    if (!number) return;
    const ig_place place = environment_.flow.here(b);
    std::span<Loop> open = own_loops(b);
    if (!open.empty() && open.back().number == *number && open.back().place.offset == place.offset) {
      open.back().jumped = false;  // the next pass
      return;
    }
    for (const Loop& loop : open) {
      if (loop.number != *number) continue;
      if (!loop.jumped && loop.place.offset != place.offset)
        b.report(macro_diag("FAN-0138"), columns(text, position), static_cast<double>(*number),
                 static_cast<double>(loop.place.line));
      leave_loop(b, *number);
      break;
    }
    loops_here_.push_back({*number, place, false});
  }

  void execute_end(ig::Block& b, std::string_view text, std::size_t position) {
    const auto number = loop_number(b, text, position, 3);
    if (!number) return;
    std::span<Loop> open = own_loops(b);
    while (!open.empty() && open.back().number != *number) {
      const Loop inner = open.back();
      const bool is_open = std::any_of(open.begin(), open.end(), [&](const Loop& l) { return l.number == *number; });
      if (!is_open) break;
      if (!inner.jumped)
        b.report(macro_diag("FAN-0137"), columns(text, position), static_cast<double>(*number),
                 static_cast<double>(inner.number), static_cast<double>(inner.place.line));
      loops_here_.pop_back();
      open = own_loops(b);
    }
    if (open.empty() || open.back().number != *number) {
      b.report(macro_diag("FAN-0136"), columns(text, position), static_cast<double>(*number));
      return;
    }
    environment_.flow.go_to(b, open.back().place);
  }

  // ---- output

  void put_out(ig::Block& b, std::string_view text, std::size_t position, std::size_t behind) {
    const std::string_view word = piece(text, position, behind);
    const std::size_t bracket = skip_blanks(text, behind);
    if (!equals_ignoring_case(word, "DPRNT")) {
      b.report(macro_diag("FAN-0141"), columns(text, position), text.substr(position));
      return;
    }
    if (at(text, bracket) != '[' || iso::skip_bracketed(text, bracket) < text.size() || text.back() != ']') {
      b.report(macro_diag("FAN-0142"), columns(text, position), word, text.substr(bracket));
      return;
    }
    std::string line;
    for (std::size_t i = bracket + 1; i + 1 < text.size();) {
      if (text[i] != '#') {
        line += text[i] == '*' ? ' ' : text[i];
        ++i;
        continue;
      }
      const std::size_t next = put_variable(b, text, i, line);
      if (next == 0) {
        b.report(macro_diag("FAN-0142"), ig::Where::columns(i, text.size()), word, text.substr(i));
        return;
      }
      i = next;
    }
    b.report(macro_diag("FAN-0141"), columns(text, position), std::string_view(line));
  }

  /// #1[43]: four digits before, three behind the point. 0: it is written wrong.
  std::size_t put_variable(ig::Block& b, std::string_view text, std::size_t position, std::string& line) const {
    const Outcome o =
        evaluate_operand(text, position, environment_.rules(),
                         [&](std::uint32_t number, MacroValue& out) { return environment_.read(b, number, out); });
    if (!o.ok()) {
      environment_.report(b, o, text);
      return 0;
    }
    const std::size_t open = skip_blanks(text, o.end);
    if (at(text, open) != '[' || !is_digit(at(text, open + 1)) || !is_digit(at(text, open + 2)) ||
        at(text, open + 3) != ']')
      return 0;
    if (o.value.is_null()) return open + 4;
    std::array<char, 400> digits{};
    const auto printed = std::to_chars(digits.data(), digits.data() + digits.size(), o.value.number,
                                       std::chars_format::fixed, text[open + 2] - '0');
    line.append(digits.data(), printed.ptr);
    return open + 4;
  }

  std::size_t begin_ = 0, end_ = 0;  // of the statement that scan() found
  bool has_comment_ = false;         // inside it
  std::string blanked_;
  std::vector<Loop> loops_here_;  // by frame, outer ones first
  std::uint64_t loop_frame_ = 0;
  std::uint32_t loop_pass_ = 1;
  std::array<char, 24> label_{'E', 'N', 'D'};
};

const ig::Register<FanucMacroStatement> registered;

}  // namespace
}  // namespace fanuc
