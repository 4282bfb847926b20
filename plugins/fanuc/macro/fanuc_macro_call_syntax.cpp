// Macro calls: G65 once, G66 after each block that moves, G66.1 for each block, and the codes that parameters assign to
// macros. The scanner reads the arguments itself, because words have another meaning in a call: I J K may be there ten
// times.
#include "macro/code_fields.hpp"
#include "macro/macro_arguments.hpp"
#include "macro/macro_environment.hpp"
#include "macro/macro_program_call.hpp"

namespace fanuc {

using namespace ig::cnc;

namespace {

enum class IjkSets { automatic, one };
enum class OwnBlock { calls, waits };

constexpr std::uint32_t largest_number = 99'999'999;

struct FanucMacroCall {
  static constexpr auto spec =
      ig::syntax("FanucMacroCallSyntax", "Macro calls: G65, G66, G66.1, and codes bound to macros by parameters.")
          .after("FlagSyntax")
          .before("WordSyntax")
          .scans("GMgm");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "FAN-0161", "{0} has no P with the number of a program: no macro is called"),
      ig::diagnostic(IG_ERROR, "FAN-0162",
                     "{0} P{1} is not a program number, so no macro is called: write 1 to 99999999"),
      ig::diagnostic(IG_ERROR, "FAN-0163", "'{0}' is not an argument of a macro call: it is not passed"),
      ig::diagnostic(IG_ERROR, "FAN-0164", "this call has more than ten sets of I J K: '{0}' is not passed"),
      ig::diagnostic(IG_ERROR, "FAN-0167",
                     "{0} L{1} is not a number of calls: write a whole number from 0 to 99999999"),
      ig::diagnostic(IG_ERROR, "FAN-0171",
                     "this G66 is not executed: {0} modal calls are in force, and the control nests {1} macro calls"),
      ig::diagnostic(IG_WARNING, "FAN-0172", "{0} has L0, so the macro is not called: leave L out for one call"),
      ig::diagnostic(IG_WARNING, "FAN-0174", "{0} stands more than once in this call: the last one counts"),
  };

  ig::Choice<IjkSets> ijk_sets_{"ijk-sets", "automatic|one", "automatic",
                                "A second I, J or K begins the next set, #7 #8 #9, or replaces the first one."};
  ig::IntegerOption nesting_{"nesting", "5", {1, 99}, "How deep the control lets macro calls nest."};
  ig::Choice<OwnBlock> own_block_{"each-block-call", "calls|waits", "calls",
                                  "Whether the block of G66.1 itself calls the macro, with its arguments."};
  CodeFields codes_;
  MacroEnvironment environment_;
  ig::Config bound_{"isogloss.code-call/1", ig::Need::optional, "The programs that codes call."};
  ArgumentUnits units_;
  ig::Signal call_{"Parsing.~MacroCall", ig::read | ig::write | ig::wake};
  ig::Signal modal_{"MacroCall.~Modal", ig::write, ig::Life::modal};

  FanucMacroCall() { environment_.store().settings.call_nesting = static_cast<std::uint32_t>(nesting_); }

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    const ig::Decimal number = ig::read_decimal(text, skip_blanks(text, position + 1));
    const auto index = number.ok ? CodeFields::index_of(number.value) : std::nullopt;
    if (!index) return position;
    if (environment_.flow.is_indexing()) return block_end(text, position);
    const char letter = to_upper(text[position]);
    begin_ = position;
    code_end_ = number.end;
    code_.fill('\0');
    const std::string_view code = name_of(letter, *index);
    const bool is_g65 = code == "G65", each_block = code == "G66.1", is_modal = code == "G66" || each_block;
    if (b.is_raised(call_)) {
      b.report(ig::diag("FAN-0170"), ig::Where::columns(position, number.end), code);
      return block_end(text, position);
    }
    is_modal_ = is_modal;
    name_.clear();
    each_block_ = each_block;
    if (!is_g65 && !is_modal) {
      const auto program = bound_.number(code);
      if (!program || environment_.is_in_bound_program(b)) {
        codes_.set(b, letter, *index, position, number.end);
        return number.end;
      }
      program_ = std::fabs(*program);
      is_modal_ = *program < 0;
      tag_bits_ = called_by_code;
      if (program_ < first_macro) {
        tag_bits_ |= shares_locals;
        b.raise(call_);
        return number.end;
      }
      has_program_ = true;
    } else {
      has_program_ = false;
      tag_bits_ = 0;
    }
    return arguments(b, text, number.end);
  }

  ig::Status build(ig::Block& b) {
    if (!b.is_raised(call_)) return ig::Status::unchanged;
    environment_.enter(b);
    const auto where = ig::Where::columns(begin_, end_);
    if ((tag_bits_ & shares_locals) != 0) {
      call_program(b, environment_.flow, called(), 1, tag_bits_, ig::Where::columns(begin_, code_end_));
      return ig::Status::changed;
    }
    const std::string_view code(code_.data());
    if (!has_program_) {
      b.report(ig::diag("FAN-0161"), where, code);
    } else if (name_.empty() && (program_ < 1 || program_ > largest_number || program_ != std::floor(program_))) {
      b.report(ig::diag("FAN-0162"), where, code, program_);
    } else if (repeats_ < 0 || repeats_ > largest_number || repeats_ != std::floor(repeats_)) {
      b.report(ig::diag("FAN-0167"), where, code, repeats_);
    } else if (repeats_ == 0) {
      b.report(ig::diag("FAN-0172"), where, code);
    } else if (is_modal_) {
      keep_modal_call(b, where);
    } else {
      call_macro(b, where, false);
    }
    return ig::Status::changed;
  }

 private:
  static constexpr double first_macro = 9010;  ///< M codes call O9001 to O9009 like subprograms

  /// Each modal call in force adds one level for the macros of the calls before it.
  void keep_modal_call(ig::Block& b, ig::Where where) {
    MacroStore& store = environment_.store();
    std::vector<MacroStore::ModalCall>& calls = store.modal_calls();
    if (static_cast<std::int64_t>(store.depth() + calls.size()) >= nesting_) {
      b.report(ig::diag("FAN-0171"), where, static_cast<double>(calls.size()), static_cast<double>(nesting_));
      b.alarm();
      return;
    }
    calls.push_back({called(), static_cast<std::int64_t>(repeats_), arguments_, each_block_});
    b.raise(modal_);
    if (each_block_ && own_block_ == OwnBlock::calls) call_macro(b, where, true);
  }

  void call_macro(ig::Block& b, ig::Where where, bool is_modal) {
    MacroStore& store = environment_.store();
    say_deep_call(b, store, where);
    const std::uint64_t tag = store.enter(arguments_, is_modal);
    const ig::Flow::Answer answer =
        ask_program(b, environment_.flow, called(), static_cast<std::int64_t>(repeats_), tag | tag_bits_, where);
    if (is_modal)
      settle_modal(store, answer);
    else if (!answer.is_done())
      store.leave_last();
  }

  CalledProgram called() const { return {name_.empty() ? static_cast<std::int64_t>(program_) : 0, name_}; }

  std::string_view name_of(char letter, std::size_t index) {
    std::size_t size = 0;
    code_[size++] = letter;
    if (index < 100) code_[size++] = '0';
    char* last = std::to_chars(code_.data() + size, code_.data() + code_.size(), index / 10).ptr;
    if (index % 10 != 0) {
      *last++ = '.';
      *last++ = static_cast<char>('0' + index % 10);
    }
    return {code_.data(), static_cast<std::size_t>(last - code_.data())};
  }

  std::size_t arguments(ig::Block& b, std::string_view text, std::size_t position) {
    environment_.enter(b);
    arguments_ = MacroStore::no_locals();
    repeats_ = 1;
    set_ = 0;
    last_of_set_ = 0;
    seen_ = 0;
    end_ = position;
    for (;;) {
      const std::size_t begin = next_word(text, end_);
      if (begin >= text.size()) break;
      end_ = argument(b, text, begin);
    }
    b.raise(call_);
    return end_;
  }

  /// The position after blanks and after comments that words follow; the end of the text where no word follows.
  static std::size_t next_word(std::string_view text, std::size_t position) {
    for (std::size_t i = position;;) {
      i = skip_blanks(text, i);
      const char c = at(text, i);
      if (c != '(') return i >= text.size() || c == ';' || c == '\r' || c == '\n' ? text.size() : i;
      i = skip_bracketed(text, i);
    }
  }

  /// Reads one argument; returns its end.
  std::size_t argument(ig::Block& b, std::string_view text, std::size_t begin) {
    const char letter = to_upper(text[begin]);
    const unsigned index = letter_index(letter);
    const std::size_t at_value = skip_blanks(text, begin + 1);
    const ig::Decimal literal = ig::read_decimal(text, at_value);
    MacroValue value{literal.value, Kind::number};
    std::size_t end = literal.end;
    if (letter == '<' && tag_bits_ == 0) {
      end = skip_bracketed(text, begin);
      if (end > begin + 2 && text[end - 1] == '>') {
        has_program_ = true;
        name_ = piece(text, begin, end);
        return end;
      }
    }
    if (index >= 26) {
      end = skip_while(text, begin + 1, [](char c) { return !is_letter(c) && c != '(' && c != ';'; });
      return refuse(b, text, begin, end);
    }
    if (!literal.ok) {
      const std::optional<MacroValue> computed = expression(b, text, begin, at_value, end);
      if (!computed) return end;
      value = *computed;
    }
    const bool comes_in_sets = letter >= 'I' && letter <= 'K' && ijk_sets_ != IjkSets::one;
    if ((seen_ >> index & 1u) != 0 && !comes_in_sets)
      b.report(ig::diag("FAN-0174"), ig::Where::columns(begin, end), std::string_view(&letter, 1));
    seen_ |= 1u << index;
    if (letter == 'P' || letter == 'L') {
      if (value.is_null()) return end;
      if (letter == 'L') {
        repeats_ = value.number;
      } else {
        has_program_ = true;
        program_ = value.number;
        name_.clear();
      }
      return end;
    }
    if (variable_of[index] == 0) return refuse(b, text, begin, end);
    const std::uint32_t variable = variable_for(letter);
    if (variable > last_local) {
      b.report(ig::diag("FAN-0164"), ig::Where::columns(begin, end), piece(text, begin, end));
      return end;
    }
    if (literal.ok && !literal.has_point) value.number = units_.counted(b, letter, literal.value, begin, end);
    arguments_[variable] = value.is_null() ? MacroStore::null : value.number + 0.0;
    return end;
  }

  static std::size_t refuse(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end) {
    end = std::max(end, begin + 1);
    b.report(ig::diag("FAN-0163"), ig::Where::columns(begin, end), piece(text, begin, end));
    return end;
  }

  /// I, J and K come in this order; a letter out of order begins the next set.
  std::uint32_t variable_for(char letter) {
    const std::uint32_t first = variable_of[letter_index(letter)];
    if (letter < 'I' || letter > 'K' || ijk_sets_ == IjkSets::one) return first;
    if (letter <= last_of_set_) ++set_;
    last_of_set_ = letter;
    return first + 3 * set_;
  }

  std::optional<MacroValue> expression(ig::Block& b, std::string_view text, std::size_t begin, std::size_t position,
                                       std::size_t& end) {
    bool negative = false;
    for (char c = at(text, position); c == '-' || c == '+' || is_blank(c); c = at(text, ++position))
      negative ^= c == '-';
    const Outcome o = evaluate_operand(text, position, environment_.rules(), environment_.reader(b));
    if (!o.ok()) {
      environment_.report(b, o, text);
      end = std::max({skip_expression(text, position), o.end, o.fault_end, begin + 1});
      return std::nullopt;
    }
    end = o.end;
    if (o.value.is_null()) return o.value;
    return MacroValue{negative ? -o.value.number : o.value.number, Kind::number};
  }

  // What scan() has read, for build().
  std::size_t begin_ = 0, code_end_ = 0, end_ = 0;
  std::array<char, 16> code_{};
  std::string name_;  // <PART>; empty where the program has a number
  bool is_modal_ = false, each_block_ = false, has_program_ = false;
  double program_ = 0, repeats_ = 1;
  std::uint64_t tag_bits_ = 0;
  MacroStore::Locals arguments_ = MacroStore::no_locals();
  std::uint32_t set_ = 0, seen_ = 0;  // sets of I J K; letters read
  char last_of_set_ = 0;
};

const ig::Register<FanucMacroCall> fanuc_macro_call_syntax;

}  // namespace
}  // namespace fanuc
