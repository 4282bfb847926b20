// Macro calls: G65 once, G66 after each block that moves, and the codes that parameters bind to macros. The scanner
// reads the arguments itself, since a call gives words another meaning: I J K may stand there ten times.
#include "code_fields.hpp"
#include "macro_environment.hpp"
#include "macro_program_call.hpp"

namespace fanuc {
namespace {

enum class IjkSets { automatic, one };

/// The variable of each address, A to Z; 0: no argument.
constexpr std::array<std::uint8_t, 26> variable_of{1, 2, 3, 7,  8,  9,  0,  11, 4,  5,  6,  0,  13,
                                                   0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
constexpr std::uint32_t largest_number = 99'999'999;

struct FanucMacroCall {
  static constexpr auto spec =
      ig::syntax("FanucMacroCallSyntax", "Macro calls: G65, G66, and codes bound to macros by parameters.")
          .after("FlagSyntax")
          .before("WordSyntax")
          .scans("GMgm");

  ig::Choice<IjkSets> ijk_sets_{"ijk-sets", "automatic|one", "automatic",
                                "A second I, J or K is the next set, #7 #8 #9, or the first one again."};
  ig::IntegerOption nesting_{"nesting", "5", {1, 99}, "Macro calls inside each other that the control permits."};
  CodeFields codes_;
  MacroEnvironment environment_;
  ig::Config bound_{"isogloss.code-call/1", ig::Need::optional, "Which codes call which programs."};
  ig::Config number_format_{"isogloss.number-format/1", ig::Need::optional, "What arguments without a point count."};
  ig::In<ig::Symbol> system_{"Unit.System"};
  ig::Name inch_{"Inch"};
  ig::Signal call_{"Parsing.~MacroCall", ig::read | ig::write | ig::wake};
  ig::Signal modal_{"MacroCall.~Modal", ig::write, ig::Life::modal};

  FanucMacroCall() { environment_.store().settings.call_nesting = static_cast<std::uint32_t>(nesting_); }

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    const ig::Decimal number = ig::read_decimal(text, iso::skip_blanks(text, position + 1));
    const auto index = number.ok ? CodeFields::index_of(number.value) : std::nullopt;
    if (!index) return position;
    if (environment_.flow.is_indexing()) return iso::block_end(text, position);
    const char letter = iso::to_upper(text[position]);
    begin_ = position;
    code_end_ = number.end;
    code_.fill('\0');
    const std::string_view code = name_of(letter, *index);
    const bool is_g65 = code == "G65";
    is_modal_ = code == "G66";
    if (!is_g65 && !is_modal_) {
      const auto program = bound_.number(code);
      if (!program || is_in_bound_program(b)) {
        codes_.set(b, letter, *index, position, number.end);
        return number.end;
      }
      program_ = *program;
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
      call_program(b, environment_.flow, static_cast<std::int64_t>(program_), 1, tag_bits_,
                   ig::Where::columns(begin_, code_end_));
      return ig::Status::changed;
    }
    MacroStore& store = environment_.store();
    const std::string_view code(code_.data());
    if (!has_program_) {
      b.report(macro_diag("FAN-0161"), where, code);
    } else if (program_ < 1 || program_ > largest_number || program_ != std::floor(program_)) {
      b.report(macro_diag("FAN-0162"), where, code, program_);
    } else if (repeats_ < 0 || repeats_ > largest_number || repeats_ != std::floor(repeats_)) {
      b.report(macro_diag("FAN-0167"), where, code, repeats_);
    } else if (is_modal_) {
      keep_modal_call(b, where);
    } else if (repeats_ > 0) {
      say_deep_call(b, store, where);
      const std::uint64_t tag = store.enter(arguments_);
      if (!call_program(b, environment_.flow, static_cast<std::int64_t>(program_), static_cast<std::int64_t>(repeats_),
                        tag | tag_bits_, where))
        store.leave_last();
    }
    return ig::Status::changed;
  }

 private:
  static constexpr double first_macro = 9010;  ///< O9001 to O9009 are called by M codes like subprograms

  /// Each call in force is one level more for the macros of those before it.
  void keep_modal_call(ig::Block& b, ig::Where where) {
    MacroStore& store = environment_.store();
    std::vector<MacroStore::ModalCall>& calls = store.modal_calls();
    if (static_cast<std::int64_t>(store.depth() + calls.size()) >= nesting_) {
      b.report(macro_diag("FAN-0171"), where, static_cast<double>(calls.size()), static_cast<double>(nesting_));
      b.alarm();
      return;
    }
    calls.push_back({static_cast<std::int64_t>(program_), static_cast<std::int64_t>(repeats_), arguments_});
    b.raise(modal_);
  }

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

  /// A program that a code called sees all codes as they are.
  bool is_in_bound_program(const ig::Block& b) const {
    const ig_frame frame = environment_.flow.frame(b);
    for (std::uint32_t level = 1; level <= frame.depth; ++level)
      if (const auto at = environment_.flow.frame(b, level); at && (at->tag & called_by_code) != 0) return true;
    return false;
  }

  std::size_t arguments(ig::Block& b, std::string_view text, std::size_t position) {
    environment_.enter(b);
    arguments_ = MacroStore::no_locals();
    repeats_ = 1;
    set_ = 0;
    last_of_set_ = 0;
    end_ = position;
    for (;;) {
      const std::size_t begin = next_word(text, end_);
      if (begin >= text.size()) break;
      end_ = argument(b, text, begin);
    }
    b.raise(call_);
    return end_;
  }

  /// Past blanks, and past comments that words follow; the end of the text where none do.
  static std::size_t next_word(std::string_view text, std::size_t position) {
    for (std::size_t i = position;;) {
      i = iso::skip_blanks(text, i);
      const char c = iso::at(text, i);
      if (c != '(') return i >= text.size() || c == ';' || c == '\r' || c == '\n' ? text.size() : i;
      i = iso::skip_bracketed(text, i);
    }
  }

  /// One argument; its end.
  std::size_t argument(ig::Block& b, std::string_view text, std::size_t begin) {
    const char letter = iso::to_upper(text[begin]);
    const unsigned index = iso::letter_index(letter);
    const std::size_t at_value = iso::skip_blanks(text, begin + 1);
    const ig::Decimal literal = ig::read_decimal(text, at_value);
    MacroValue value{literal.value, Kind::number};
    std::size_t end = literal.end;
    if (index >= 26) {
      end = iso::skip_while(text, begin + 1, [](char c) { return !iso::is_letter(c) && c != '(' && c != ';'; });
      return refuse(b, text, begin, end);
    }
    if (!literal.ok) {
      const std::optional<MacroValue> computed = expression(b, text, begin, at_value, end);
      if (!computed) return end;
      value = *computed;
    }
    if (letter == 'P' || letter == 'L') {
      if (value.is_null()) return end;
      if (letter == 'L') {
        repeats_ = value.number;
      } else {
        has_program_ = true;
        program_ = value.number;
      }
      return end;
    }
    if (variable_of[index] == 0) return refuse(b, text, begin, end);
    const std::uint32_t variable = variable_for(letter);
    if (variable > last_local) {
      b.report(macro_diag("FAN-0164"), ig::Where::columns(begin, end), iso::piece(text, begin, end));
      return end;
    }
    if (literal.ok && !literal.has_point) value.number = counted(b, letter, literal.value, begin, end);
    arguments_[variable] = value.is_null() ? MacroStore::null : value.number + 0.0;
    return end;
  }

  static std::size_t refuse(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end) {
    end = std::max(end, begin + 1);
    b.report(macro_diag("FAN-0163"), ig::Where::columns(begin, end), iso::piece(text, begin, end));
    return end;
  }

  /// I J K stand in this order; one that comes too late begins the next set.
  std::uint32_t variable_for(char letter) {
    const std::uint32_t first = variable_of[iso::letter_index(letter)];
    if (letter < 'I' || letter > 'K' || ijk_sets_ == IjkSets::one) return first;
    if (letter <= last_of_set_) ++set_;
    last_of_set_ = letter;
    return first + 3 * set_;
  }

  std::optional<MacroValue> expression(ig::Block& b, std::string_view text, std::size_t begin, std::size_t position,
                                       std::size_t& end) {
    bool negative = false;
    for (char c = iso::at(text, position); c == '-' || c == '+' || iso::is_blank(c); c = iso::at(text, ++position))
      negative ^= c == '-';
    const Outcome o =
        evaluate_operand(text, position, environment_.rules(),
                         [&](std::uint32_t number, MacroValue& out) { return environment_.read(b, number, out); });
    if (!o.ok()) {
      environment_.report(b, o, text);
      end = std::max({iso::skip_expression(text, position), o.end, o.fault_end, begin + 1});
      return std::nullopt;
    }
    end = o.end;
    if (o.value.is_null()) return o.value;
    return MacroValue{negative ? -o.value.number : o.value.number, Kind::number};
  }

  /// Lengths and angles without a point count increments, unless the control is set otherwise.
  double counted(ig::Block& b, char letter, double number, std::size_t begin, std::size_t end) const {
    if (number == 0 || std::string_view("ABCIJKQRUVWXYZ").find(letter) == std::string_view::npos) return number;
    double value = number;
    if (number_format_.number("CalculatorDecimalPoint").value_or(1) == 0) {
      const bool is_angle = letter >= 'A' && letter <= 'C';
      const bool is_inch = !is_angle && b.is(system_, inch_);
      const double increment = number_format_
                                   .number(is_angle  ? "AngleIncrement_deg"
                                           : is_inch ? "LengthIncrement_inch"
                                                     : "LengthIncrement_mm")
                                   .value_or(is_inch ? 0.0001 : 0.001);
      value = number / std::round(1 / increment);
    }
    b.report(macro_diag("FAN-0166"), ig::Where::columns(begin, end), std::string_view(&letter, 1), number, value);
    return value;
  }

  // What scan() read, for build().
  std::size_t begin_ = 0, code_end_ = 0, end_ = 0;
  std::array<char, 16> code_{};
  bool is_modal_ = false, has_program_ = false;
  double program_ = 0, repeats_ = 1;
  std::uint64_t tag_bits_ = 0;
  MacroStore::Locals arguments_ = MacroStore::no_locals();
  std::uint32_t set_ = 0;
  char last_of_set_ = 0;
};

const ig::Register<FanucMacroCall> registered;

}  // namespace
}  // namespace fanuc
