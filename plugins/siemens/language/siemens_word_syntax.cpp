// Words: X10, G1, CR=5, X=AC(10), X=R1*2, and assignments R1=5, NAME=3. Reads on over all words that follow each other
// and hands them to the host in one call. Values are computed while the block is read, so that the syntaxes after this
// one see plain words.
#include "language/array_values.hpp"
#include "language/system_assignment.hpp"
#include "language/word_fields.hpp"
#include "modes/axis_modes.hpp"

namespace siemens {

using namespace ig::cnc;
namespace {

using ig::cnc::at;
using ig::cnc::piece;
using ig::cnc::skip_blanks;

constexpr bool is_number_part(char c) { return is_digit(c) || c == '.' || c == '+' || c == '-'; }
constexpr bool begins_number(char c) { return is_number_part(c); }

struct SiemensWord {
  static constexpr auto spec = ig::syntax("SiemensWordSyntax", "Words, codes and assignments of the Siemens language.")
                                   .after("HeadIndexSyntax", "SiemensStatementSyntax")
                                   .before("ParameterizedFlagSyntax")
                                   .scans("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$0123456789+-.,=");
  static constexpr std::array diagnostics{
      ig::diagnostic(IG_ERROR, "SIE-0115",
                     "'{0}' has no address before it, so nothing is executed for it: write its address"),
      ig::diagnostic(IG_ERROR, "SIE-0121", "'{0}' has no number: write its value, or remove the address"),
      ig::diagnostic(IG_WARNING, "SIE-0122",
                     "{0} stands more than once in this block, and the last one is used: remove the others"),
      ig::diagnostic(IG_ERROR, "SIE-0123",
                     "'{0}' is not a number, so the word is not executed: use one decimal point and no comma"),
      ig::diagnostic(IG_ERROR, "SIE-0125", "'{0}' is not a valid code and is not executed: check its number"),
      ig::diagnostic(IG_ERROR, "SIE-0127",
                     "'{0}' has no value, so nothing is assigned: write an equals sign and the value"),
      ig::diagnostic(IG_ERROR, "SIE-0128",
                     "{1} is not possible with {0}: the word is executed as if {1} were not there"),
      ig::diagnostic(IG_ERROR, "SIE-0131", "{0} with an index is not executed: write the address without an index"),
      ig::diagnostic(IG_WARNING, "SIE-0132", "T={0} is used as a tool name: write it in quotation marks"),
      ig::diagnostic(IG_WARNING, "SIE-0292",
                     "{0} moves the axis with the path of its block, not with a feed of its own"),
      ig::diagnostic(IG_ERROR, "SIE-0305",
                     "EXECSTRING is not executed with {0}: its text holds words and assignments of one block"),
      ig::diagnostic(IG_ERROR, "SIE-0320",
                     "CTABDEF in line {0} has no CTABEND, so nothing has moved since: write CTABEND after the curve"),
  };

  WordFields fields_;
  AxisModes modes_{ig::write};
  ig::TextField tool_name_{"ToolName.Text", ig::write, {ig::Life::block, "", "T=\"…\" of this block."}};
  Environment environment_;
  ig::IntegerOption master_{"master-spindle", "1", {1, 31}, "The spindle of S and M3; S1= and M1= name one."};

  /// Words that follow each other, until one host call takes them.
  struct Run {
    std::array<ig_word, 32> words;
    std::uint32_t count = 0;
  };

  std::size_t scan(ig::Block& b, std::string_view text, std::size_t position) {
    const char first = text[position];
    if (!is_name_start(first) && first != '$') return without_address(b, text, position);
    Run run;
    std::size_t next = position, end = position;
    do {
      const std::size_t behind = item(b, text, next, run);
      if (behind == next) break;  // for another scanner
      end = behind;
      next = skip_blanks(text, end);
    } while (next < text.size() && (is_name_start(text[next]) || text[next] == '$'));
    give(b, run);
    return end;
  }

 private:
  static ig::Where columns(std::size_t begin, std::size_t end) { return ig::Where::columns(begin, end); }

  void give(ig::Block& b, Run& run) const {
    if (defines_curve() && !ends_program(b, run)) run.count = 0;
    if (run.count > 0) b.set_words(run.words.data(), run.count);
    run.count = 0;
  }
  /// Between CTABDEF and CTABEND, where words are points of a curve: they move nothing and stay for no later block.
  bool defines_curve() const { return environment_.store().curve_begins != 0; }
  bool ends_program(ig::Block& b, const Run& run) const {
    for (std::uint32_t i = 0; i < run.count; ++i)
      for (const std::uint32_t m : {2u, 17u, 30u})
        if (run.words[i].field == fields_.code('M', m)) {
          b.report(ig::diag("SIE-0320"), columns(run.words[i].begin, run.words[i].end),
                   static_cast<double>(environment_.store().curve_begins));
          environment_.store().curve_begins = 0;
          return true;
        }
    return false;
  }
  void set_mode(ig::Block& b, std::size_t word, ig::Symbol mode) const {
    if (!defines_curve()) modes_.set(b, word, mode);
  }

  void add(ig::Block& b, Run& run, ig_field field, std::size_t begin, std::size_t end, double value,
           std::string_view name) const {
    if (run.count == run.words.size()) give(b, run);
    bool again = false;
    for (std::uint32_t i = 0; i < run.count; ++i) again = again || run.words[i].field == field;
    ig_value before;
    if (again || (begin > 0 && b.get(field, before))) {
      give(b, run);
      b.report(ig::diag("SIE-0122"), columns(begin, end), name);
    }
    run.words[run.count++] = {field, column(begin), column(end), {.number = value + 0.0}, 0, 0};
  }

  /// ID=1 and IDS=1 begin a synchronized action, which SiemensCallSyntax says.
  static bool is_action_number(std::string_view text, std::size_t begin) {
    const std::size_t end = skip_name(text, begin);
    const std::string_view name = piece(text, begin, end);
    return (equals_ignoring_case(name, "ID") || equals_ignoring_case(name, "IDS")) &&
           at(text, skip_blanks(text, end)) == '=';
  }

  std::size_t item(ig::Block& b, std::string_view text, std::size_t begin, Run& run) {
    const char c = to_upper(text[begin]);
    const std::size_t second = begin + 1;
    const char d = at(text, second);
    if (environment_.store().has_macros() && !is_expanded_ && c != '$' && !environment_.flow.is_indexing())
      if (const std::size_t end = skip_name(text, begin); at(text, skip_blanks(text, end)) != '=')
        if (const std::string* const macro = environment_.store().macro(upper(piece(text, begin, end))))
          return expand(b, text, begin, end, *macro, run);
    if (is_action_number(text, begin)) return begin;
    if (c == '$' || c == '_' || is_name_start(d)) return named(b, text, begin, run);
    if (c == 'R' && (is_digit(d) || d == '[')) return assignment(b, text, begin, run);
    if (is_digit(d) && is_assigned_variable(b, text, begin)) return assignment(b, text, begin, run);
    const std::size_t number = skip_blanks(text, second);
    const char v = at(text, number);
    if (v == '=' && at(text, number + 1) != '=') return valued(b, text, begin, second, number + 1, run);
    if (v == '[') return named(b, text, begin, run);
    if (!begins_number(v)) return empty_word(b, text, begin);
    if (c == 'G' || c == 'M') return code(b, text, begin, number, run);
    if (c == 'N' || (c == 'L' && is_digit(v))) return begin;
    const ig::Decimal n = ig::read_decimal(text, number);
    if (!n.ok) return refuse(b, ig::diag("SIE-0121"), text, begin, skip_while(text, number, is_number_part));
    std::size_t end = n.end;
    double value = n.value;
    if (const char behind = at(text, end); !(is_letter(behind) || is_blank(behind) || behind == '\0'))
      if (const std::size_t equals = skip_blanks(text, end); at(text, equals) == '=' && !n.has_point)
        return valued(b, text, begin, end, equals + 1, run);
    if (at(text, end) == '.' || at(text, end) == ',')
      return refuse(b, ig::diag("SIE-0123"), text, begin,
                    skip_while(text, end, [](char o) { return is_digit(o) || o == '.' || o == ','; }));
    if (const std::size_t equals = skip_blanks(text, end);
        !n.has_point && at(text, equals) == '=' && at(text, equals + 1) != '=')
      return valued(b, text, begin, end, equals + 1, run);
    if (equals_ignoring_case(text.substr(end, 2), "EX")) {
      Expression e(b, environment_, text, number);
      const auto computed = e.number();
      if (!computed) return std::max(e.position(), end);
      value = *computed;
      end = e.position();
    }
    word(b, run, std::string_view(&c, 1), fields_.letter(c), begin, end, value);
    return end;
  }

  /// The words for which a name stands (DEFINE); a name for a call is SiemensCallSyntax's. What an address opens is
  /// closed behind the name: DEFINE LEFT AS X= and LEFT 10.
  std::size_t expand(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end, const std::string& macro,
                     Run& run) {
    const ExpandedText as(text, begin, end, macro);
    std::size_t next = skip_blanks(as.text(), begin);
    if (next >= as.macro_end() || (!is_name_start(as.text()[next]) && as.text()[next] != '$')) {
      b.report(ig::diag("SIE-0288"), columns(begin, end), std::string_view(macro));
      return end;
    }
    const std::size_t start = next;
    is_expanded_ = true;
    while (next < as.macro_end()) {
      const std::size_t first = run.count, behind = item(b, as.text(), next, run);
      if (behind == next) break;
      for (std::size_t i = std::min<std::size_t>(first, run.count); i < run.count; ++i) {
        run.words[i].begin = column(begin);
        run.words[i].end = column(end);
      }
      next = skip_blanks(as.text(), behind);
      if (next < as.macro_end() && !is_name_start(as.text()[next]) && as.text()[next] != '$') break;
    }
    is_expanded_ = false;
    if (next == start) return begin;
    if (next < as.macro_end()) {
      b.report(ig::diag("SIE-0288"), columns(begin, end), std::string_view(macro));
      return end;
    }
    return as.original(next);
  }

  void word(ig::Block& b, Run& run, std::string_view name, ig_field field, std::size_t begin, std::size_t end,
            double value) const {
    if (field == IG_NO_FIELD) {
      if (!defines_curve()) leave(b, IG_LEFT_WORD, name, begin, end);
    } else {
      add(b, run, field, begin, end, value, name);
    }
  }

  static std::size_t refuse(ig::Block& b, ig::DiagnosticCode diagnostic, std::string_view text, std::size_t begin,
                            std::size_t end) {
    b.report(diagnostic, columns(begin, end), piece(text, begin, end));
    return end;
  }
  static std::size_t empty_word(ig::Block& b, std::string_view text, std::size_t begin) {
    return refuse(b, ig::diag("SIE-0121"), text, begin, begin + 1);
  }

  // ---- G and M

  std::size_t code(ig::Block& b, std::string_view text, std::size_t begin, std::size_t number, Run& run) {
    const std::size_t end = skip_digits(text, number);
    const std::size_t equals = skip_blanks(text, end);
    if (at(text, equals) == '=' && at(text, equals + 1) != '=') return valued(b, text, begin, end, equals + 1, run);
    if (end == number || at(text, end) == '.')
      return refuse(b, ig::diag("SIE-0125"), text, begin, skip_while(text, number, is_number_part));
    std::uint32_t n = 0;
    for (std::size_t i = number; i < end && n < 100'000; ++i) n = n * 10 + static_cast<std::uint32_t>(text[i] - '0');
    set_code(b, run, to_upper(text[begin]), n, begin, end);
    return end;
  }

  void set_code(ig::Block& b, Run& run, char letter, std::uint32_t n, std::size_t begin, std::size_t end) const {
    const ig_field field = fields_.code(letter, n);
    if (field != IG_NO_FIELD) {
      if (run.count == run.words.size()) give(b, run);
      run.words[run.count++] = {field, column(begin), column(end), ig_value{}, 0, 0};
      return;
    }
    if (defines_curve()) return;
    std::array<char, 16> name{letter, '0'};
    const auto last = std::to_chars(name.data() + (n < 10 ? 2 : 1), name.data() + name.size(), n).ptr;
    leave(b, IG_LEFT_UNKNOWN, {name.data(), static_cast<std::size_t>(last - name.data())}, begin, end);
  }

  // ---- NAME=value

  /// A name of two characters and more, or one with an index.
  std::size_t named(ig::Block& b, std::string_view text, std::size_t begin, Run& run) {
    if (text[begin] == '$') return assignment(b, text, begin, run);
    std::size_t end = skip_name(text, begin);
    const std::size_t behind = skip_blanks(text, end);
    if (at(text, behind) == '[') return assignment(b, text, begin, run);
    if (at(text, behind) == '=' && at(text, behind + 1) != '=') {
      if (environment_.flow.is_indexing()) return block_end(text, begin);
      const std::string name = upper(piece(text, begin, end));
      environment_.enter(b);
      const bool is_variable = environment_.store().find(name) != nullptr || environment_.store().given(name);
      const bool has_number = is_digit(name.back()) && is_letter(name[0]) && skip_digits(name, 1) == name.size();
      if (!is_variable && (name == "ID" || name == "IDS")) return begin;  // a synchronized action
      if (!is_variable && (fields_.address(name) != IG_NO_FIELD || has_number))
        return valued(b, text, begin, end, behind + 1, run);
      return assignment(b, text, begin, run);
    }
    if (at(text, behind) == '(' && equals_ignoring_case(piece(text, begin, end), "EXECSTRING"))
      return execute_string(b, text, begin, behind, run);
    const ig_field field = fields_.code(upper(piece(text, begin, end)));
    if (field == IG_NO_FIELD || at(text, behind) == '(') return begin;
    if (run.count == run.words.size()) give(b, run);
    run.words[run.count++] = {field, column(begin), column(end), ig_value{}, 0, 0};
    return end;
  }

  /// EXECSTRING("R1="<<NR): the words that the text holds.
  std::size_t execute_string(ig::Block& b, std::string_view text, std::size_t begin, std::size_t open, Run& run) {
    const std::size_t end = skip_call(text, open);
    if (environment_.flow.is_indexing()) return end;
    Expression e(b, environment_, text, open + 1);
    const auto value = e.value();
    if (!value) return end;
    if (!value->is_text() || at(text, skip_blanks(text, e.position())) != ')' || is_expanded_) {
      b.report(ig::diag("SIE-0305"), columns(begin, end), trim(piece(text, open + 1, end - 1)));
      return end;
    }
    if (trim(value->text).empty()) return end;
    const std::size_t behind = expand(b, text, begin, end, value->text, run);
    if (behind != begin) return behind;
    b.report(ig::diag("SIE-0305"), columns(begin, end), std::string_view(value->text));
    return end;
  }

  /// X=…, CR=…, X1=…, M1=3, S2=500, T="DRILL": `equals` is behind the equals sign.
  std::size_t valued(ig::Block& b, std::string_view text, std::size_t begin, std::size_t name_end, std::size_t equals,
                     Run& run) {
    if (environment_.flow.is_indexing()) return block_end(text, begin);
    std::string name = upper(trim(piece(text, begin, name_end)));
    const bool has_number = name.size() > 1 && skip_digits(name, 1) == name.size();
    const std::size_t value_at = skip_blanks(text, equals);
    if (name == "T" || name == "D") return tool(b, text, begin, value_at, run, name);
    if (name[0] == 'T' && has_number) return tool_of_spindle(b, text, begin, value_at, run, name.substr(1));
    const ig::Symbol mode = take_mode(b, text, value_at);
    Expression e(b, environment_, text, mode == ig::Symbol{} ? value_at : at_bracket_);
    const auto value = e.number();
    const std::size_t end = std::max(e.position(), equals);
    if (!value) return line_end_of_fault(text, end);
    if (name[0] == 'G' || name[0] == 'M' || name[0] == 'S' || name[0] == 'H')
      if (name.size() == 1 || has_number) return extended(b, text, begin, end, name, *value, run);
    const ig_field field = fields_.address(name);
    if (mode != ig::Symbol{}) {
      const std::size_t word_index = AxisModes::index_of(name);
      if (word_index < AxisModes::words.size())
        set_mode(b, word_index, mode);
      else if (!(name == "SPOS" || name == "SPOSA") || b.text(mode) == "IC")  // an angle, whichever way it is reached
        b.report(ig::diag("SIE-0128"), columns(begin, end), std::string_view(name), b.text(mode));
    }
    word(b, run, name, field, begin, end, *value);
    return end;
  }

  /// A value that could not be read: the rest of it, up to a blank outside brackets with no operator behind it, goes
  /// with it.
  static std::size_t line_end_of_fault(std::string_view text, std::size_t position) {
    for (std::size_t end = position;;) {
      while (end < text.size() && std::string_view(" \t;\r\n").find(text[end]) == std::string_view::npos)
        end = text[end] == '(' ? std::max(skip_call(text, end), end + 1) : end + 1;
      std::size_t next = skip_blanks(text, end);
      constexpr std::string_view operators = "+-*/<>";
      if (next >= text.size() || operators.find(text[next]) == std::string_view::npos) return end;
      while (next < text.size() && operators.find(text[next]) != std::string_view::npos) ++next;
      end = skip_blanks(text, next);
      if (at(text, end) == '"') end = std::min(text.find('"', end + 1), text.size() - 1) + 1;
    }
  }

  /// AC IC DC ACP ACN before a bracket; at_bracket_ is where the bracket opens.
  ig::Symbol take_mode(ig::Block& b, std::string_view text, std::size_t position) {
    const std::size_t end = skip_name(text, position);
    const std::size_t open = skip_blanks(text, end);
    if (end == position || end - position > 3 || at(text, open) != '(') return {};
    for (const std::string_view mode : {"AC", "IC", "DC", "ACP", "ACN"})
      if (equals_ignoring_case(piece(text, position, end), mode)) {
        at_bracket_ = open;
        return b.symbol(mode);
      }
    return {};
  }

  /// G=, M=, M1=3, S1=500, H=: with a number the address of one spindle, or of an auxiliary function.
  std::size_t extended(ig::Block& b, std::string_view text, std::size_t begin, std::size_t end, const std::string& name,
                       double value, Run& run) const {
    if (defines_curve()) return end;
    const char letter = name[0];
    const bool is_master = name.size() == 1 || is_master_spindle(name.substr(1)) || (letter == 'M' && name == "M0");
    if (!is_master || letter == 'H') {
      b.report(ig::diag("SIE-0126"), columns(begin, end), trim(piece(text, begin, end)));
      return end;
    }
    if (letter == 'S') {
      word(b, run, "S", fields_.letter('S'), begin, end, value);
    } else if (value < 0 || value > 99'999 || value != std::floor(value) || (letter == 'G' && name.size() > 1)) {
      b.report(ig::diag("SIE-0125"), columns(begin, end), piece(text, begin, end));
    } else {
      set_code(b, run, letter, static_cast<std::uint32_t>(value), begin, end);
    }
    return end;
  }

  /// Of the machine, or what SETMS has named.
  bool is_master_spindle(std::string_view number) const {
    const auto named = environment_.store().master_spindle;
    return number == std::to_string(named.value_or(static_cast<std::int64_t>(master_)));
  }

  /// What stands behind =, in AC( ) or without; no value where it is a fault.
  struct Assigned {
    std::optional<double> value;
    ig::Symbol mode;
    std::size_t end;
  };
  Assigned assigned(ig::Block& b, std::string_view text, std::size_t equals) {
    const std::size_t value_at = skip_blanks(text, equals + 1);
    const ig::Symbol mode = take_mode(b, text, value_at);
    Expression e(b, environment_, text, mode == ig::Symbol{} ? value_at : at_bracket_);
    const auto value = e.number();
    const std::size_t end = std::max(e.position(), equals + 1);
    return {value, mode, value ? end : line_end_of_fault(text, end)};
  }

  std::size_t valued_as(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals,
                        const std::string& name, Run& run) {
    const Assigned a = assigned(b, text, equals);
    if (!a.value) return a.end;
    if (a.mode != ig::Symbol{} && AxisModes::index_of(name) < AxisModes::words.size())
      set_mode(b, AxisModes::index_of(name), a.mode);
    word(b, run, name, fields_.address(name), begin, a.end, *a.value);
    return a.end;
  }

  /// SPOS[2]=90 and LIMS[2]=3000 behind the index: of the master spindle, or said.
  std::size_t of_spindle(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals,
                         const std::string& indexed, Run& run) {
    const std::size_t bracket = indexed.find('[');
    const std::string name = indexed.substr(0, bracket);
    const Assigned a = assigned(b, text, equals);
    if (!a.value) return a.end;
    if (is_master_spindle(std::string_view(indexed).substr(bracket + 1, indexed.size() - bracket - 2)))
      word(b, run, name, fields_.address(name), begin, a.end, *a.value);
    else
      b.report(ig::diag("SIE-0126"), columns(begin, a.end), piece(text, begin, a.end));
    return a.end;
  }
  /// "M1" of M[1], "S2" of S[2]: an address extension that is computed. Empty: something else.
  std::string extended_name(const std::string& indexed) const {
    const bool is_extended = indexed.size() > 3 && indexed[1] == '[' && indexed.back() == ']' &&
                             std::string_view("MSH").find(indexed[0]) != std::string_view::npos &&
                             skip_digits(indexed, 2) == indexed.size() - 1;
    if (!is_extended || environment_.store().find(indexed.substr(0, 1)) != nullptr) return {};
    return indexed[0] + indexed.substr(2, indexed.size() - 3);
  }
  static bool belongs_to_spindle(std::string_view name) {
    return name.starts_with("SPOS[") || name.starts_with("SPOSA[") || name.starts_with("LIMS[");
  }

  /// T1=5 and T2="DRILL": the number behind T is the spindle.
  std::size_t tool_of_spindle(ig::Block& b, std::string_view text, std::size_t begin, std::size_t value_at, Run& run,
                              const std::string& number) const {
    if (is_master_spindle(number)) return tool(b, text, begin, value_at, run, "T");
    Expression e(b, environment_, text, value_at);
    if (!e.value()) return line_end_of_fault(text, std::max(e.position(), value_at));
    b.report(ig::diag("SIE-0126"), columns(begin, e.position()), trim(piece(text, begin, e.position())));
    return e.position();
  }

  std::size_t tool(ig::Block& b, std::string_view text, std::size_t begin, std::size_t value_at, Run& run,
                   const std::string& name) const {
    if (defines_curve()) return line_end_of_fault(text, value_at);
    const std::size_t end_of_name = skip_name(text, value_at);
    Expression e(b, environment_, text, value_at);
    // T=DRILL without quotes is written, too; the control reads a variable there [?].
    const bool is_bare_name =
        end_of_name > value_at && is_letter(text[value_at]) &&
        std::string_view("[(").find(at(text, skip_blanks(text, end_of_name))) == std::string_view::npos;
    if (is_bare_name && name == "T" &&
        environment_.store().find(upper(piece(text, value_at, end_of_name))) == nullptr &&
        !is_r(text, value_at, end_of_name)) {
      b.report(ig::diag("SIE-0132"), columns(begin, end_of_name), piece(text, value_at, end_of_name));
      b.set_text(tool_name_, piece(text, value_at, end_of_name));
      return end_of_name;
    }
    const auto value = e.value();
    if (!value) return line_end_of_fault(text, std::max(e.position(), value_at));
    if (name == "T" && !value->is_text() && is_with_point(text, value_at, e.position(), value->number)) {
      const std::string_view number = trim(piece(text, value_at, e.position()));
      b.report(ig::diag("SIE-0132"), columns(begin, value_at + number.size()), number);
      b.set_text(tool_name_, number);
    } else if (!value->is_text())
      word(b, run, name, fields_.letter(name[0]), begin, e.position(), value->number);
    else if (name == "T")
      b.set_text(tool_name_, value->text);
    else
      b.report(ig::diag("SIE-0107"), columns(begin, e.position()), piece(text, begin, e.position()));
    return e.position();
  }
  /// T=2.19: the name of a tool, as tool managements have them, and no number.
  static bool is_with_point(std::string_view text, std::size_t begin, std::size_t end, double value) {
    const ig::Decimal n = ig::read_decimal(text, begin);
    return n.ok && n.has_point && skip_blanks(text, n.end) == skip_blanks(text, end) && value != std::floor(value);
  }
  static bool is_r(std::string_view text, std::size_t begin, std::size_t end) {
    return to_upper(text[begin]) == 'R' && end > begin + 1 && skip_digits(text, begin + 1) == end;
  }

  // ---- Variables

  std::size_t assignment(ig::Block& b, std::string_view text, std::size_t begin, Run& run) {
    if (environment_.flow.is_indexing()) return block_end(text, begin);
    give(b, run);
    Expression target(b, environment_, text, begin);
    const auto reference = target.reference();
    if (!reference) return line_end_of_fault(text, std::max(target.position(), begin + 1));
    const std::size_t equals = skip_blanks(text, target.position());
    if (at(text, equals) != '=') {
      b.report(ig::diag("SIE-0127"), columns(begin, target.position()), piece(text, begin, target.position()));
      return target.position();
    }
    environment_.enter(b);
    if (reference->name.size() == 5 && reference->name.starts_with("AX["))  // AX[NAME], NAME of type AXIS
      return valued_as(b, text, begin, equals, reference->name.substr(3, 1), run);
    if (const char axis = positioning_axis(reference->name); axis != '\0') {
      if (environment_.store().say_once("POS"))
        b.report(ig::diag("SIE-0292"), columns(begin, target.position()), std::string_view(reference->name));
      return valued_as(b, text, begin, equals, std::string(1, axis), run);
    }
    if (const std::size_t name_end = axis_name_end(text, equals, reference->name); name_end != 0) {
      const std::size_t value_at = skip_blanks(text, equals + 1);
      environment_.store().find(reference->name)->value = Value::string(upper(piece(text, value_at, name_end)));
      return name_end;
    }
    if (const std::string name = extended_name(reference->name); !name.empty()) {
      const Assigned a = assigned(b, text, equals);
      return a.value ? extended(b, text, begin, a.end, name, *a.value, run) : a.end;
    }
    if (belongs_to_spindle(reference->name)) return of_spindle(b, text, begin, equals, reference->name, run);
    if (reference->name[0] == '$' && !environment_.store().given(reference->name)) {
      const auto done = SystemAssignment(environment_).run(b, text, begin, equals, reference->name);
      if (done.code) set_code(b, run, 'G', *done.code, begin, done.end);
      return done.is_fault ? line_end_of_fault(text, done.end) : done.end;
    }
    if (const Group* const group = group_named(reference->name)) return of_group(b, text, begin, equals, *group, run);
    if (const Variable* const array = array_of(reference->name);
        array != nullptr && ArrayValues::begin(text, skip_blanks(text, equals + 1), false))
      return assign_elements(b, text, begin, equals, *reference, *array);
    const bool is_unknown_array = reference->name.find('[') != std::string::npos && !array_of(reference->name);
    if (!reference->is_r && is_unknown_array && !environment_.store().given(reference->name) &&
        !changes_no_position(reference->name)) {
      const std::size_t end = statement_text_end(text, equals);
      if (defines_curve()) return end;  // PO[X]=
      if (is_of_control(reference->name))
        environment_.report_once(b, ig::diag("SIE-0131"), columns(begin, end), begin,
                                 std::string_view(reference->name));
      else
        environment_.report_name(b, ig::diag("SIE-0124"), columns(begin, target.position()), reference->name);
      return end;
    }
    if (const ig::Symbol mode = take_mode(b, text, skip_blanks(text, equals + 1)); mode != ig::Symbol{}) {
      const std::size_t end = skip_call(text, at_bracket_);  // ROTX=DC(10): an axis that the chain does not know
      environment_.report_once(b, ig::diag("SIE-0124"), columns(begin, end), begin, std::string_view(reference->name));
      return end;
    }
    Expression e(b, environment_, text, equals + 1);
    const auto value = e.value();
    const std::size_t end = std::max(e.position(), equals + 1);
    if (!value) return line_end_of_fault(text, end);
    if (is_unknown_array && changes_no_position(reference->name)) return end;
    if (belongs_to_approach(reference->name)) return end;
    assign(b, *reference, *value, begin, end);
    return end;
  }

  /// A[1]=SET(1,2,3), A[0]=REP(5).
  std::size_t assign_elements(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals,
                              const Expression::Reference& to, const Variable& array) const {
    const std::size_t bracket = to.name.find('[');
    const std::string base = to.name.substr(0, bracket);
    const auto first = array.number_of(std::string_view(to.name).substr(std::min(bracket, to.name.size())));
    const std::size_t end = skip_call(text, skip_name(text, skip_blanks(text, equals + 1)));
    if (bracket == std::string::npos || !first) {
      b.report(ig::diag("SIE-0304"), columns(begin, to.end), std::string_view(to.name),
               std::string_view(array.shown_as(base)));
      return end;
    }
    std::size_t next = skip_blanks(text, equals + 1);
    return ArrayValues(b, environment_, text).read(next, base, *first) ? next : end;
  }

  // G[8]=2 is the second code of group 8. Groups whose order the manuals agree on (Programming manual, G functions).
  struct Group {
    std::string_view name;
    std::array<std::uint32_t, 5> codes;
    std::uint32_t count;
  };
  static const Group* group_named(std::string_view name) {
    static constexpr std::array groups{Group{"G[1]", {0, 1, 2, 3}, 4},         Group{"G[6]", {17, 18, 19}, 3},
                                       Group{"G[7]", {40, 41, 42}, 3},         Group{"G[8]", {500, 54, 55, 56, 57}, 5},
                                       Group{"G[13]", {70, 71, 700, 710}, 4},  Group{"G[14]", {90, 91}, 2},
                                       Group{"G[15]", {93, 94, 95, 96, 97}, 5}};
    for (const Group& g : groups)
      if (g.name == name) return &g;
    return nullptr;
  }

  std::size_t of_group(ig::Block& b, std::string_view text, std::size_t begin, std::size_t equals, const Group& group,
                       Run& run) {
    const Assigned a = assigned(b, text, equals);
    if (!a.value) return a.end;
    const double n = *a.value;
    if (group.name == "G[8]" && n > 5 && n <= 100 && n == std::floor(n))  // G505 and on
      set_code(b, run, 'G', 499 + static_cast<std::uint32_t>(n), begin, a.end);
    else if (n >= 1 && n <= group.count && n == std::floor(n))
      set_code(b, run, 'G', group.codes[static_cast<std::size_t>(n) - 1], begin, a.end);
    else
      b.report(ig::diag("SIE-0125"), columns(begin, a.end), piece(text, begin, a.end));
    return a.end;
  }

  /// NAME=X, where NAME is of type AXIS and X no variable: where X ends, 0 where it is something else.
  std::size_t axis_name_end(std::string_view text, std::size_t equals, const std::string& name) const {
    const Variable* const target = environment_.store().find(name);
    if (target == nullptr || !target->value.is_text() || target->is_array) return 0;
    const std::size_t value_at = skip_blanks(text, equals + 1), end = skip_name(text, value_at);
    const char behind = at(text, skip_blanks(text, end));
    if (!is_name_start(at(text, value_at)) || end > value_at + 3 || behind == '(' || behind == '[' || behind == '<')
      return 0;
    return environment_.store().find(upper(piece(text, value_at, end))) == nullptr ? end : 0;
  }

  /// Z of POS[Z] and POSA[Z].
  static char positioning_axis(std::string_view name) {
    for (const std::string_view known : {"POS[", "POSA["})
      if (name.starts_with(known) && name.size() == known.size() + 2) return name[known.size()];
    return '\0';
  }

  /// X1=, where the program has defined X1.
  bool is_assigned_variable(ig::Block& b, std::string_view text, std::size_t begin) const {
    const std::size_t end = skip_name(text, begin), equals = skip_blanks(text, end);
    if (at(text, equals) != '=' || at(text, equals + 1) == '=' || environment_.flow.is_indexing()) return false;
    environment_.enter(b);
    return environment_.store().find(upper(piece(text, begin, end))) != nullptr;
  }

  /// Axes, spindles and codes by index: no variable of a machine is called so.
  static bool is_of_control(std::string_view name) {
    const std::string_view base = name.substr(0, name.find('['));
    return base.size() == 1 || base == "AX" || base.starts_with("POS") || base == "MOV" || base == "FDA";
  }

  /// Speeds and accelerations of single axes.
  static bool changes_no_position(std::string_view name) {
    for (const std::string_view known : {"FGREF[", "ACC[", "VELOLIM[", "JERKLIM[", "ACCLIMA[", "VELOLIMA[", "JERKLIMA[",
                                         "OVRA[", "FL[", "FA[", "ATOL[", "POLF["})
      if (name.starts_with(known)) return true;
    return false;
  }

  /// How far and how fast G147 to G348 approach and retract. The code says that it is not executed.
  static bool belongs_to_approach(std::string_view name) {
    for (const std::string_view known : {"DISR", "DISRP", "DISCL", "FAD"})
      if (name == known) return true;
    return false;
  }

  Variable* array_of(const std::string& element) const {
    Variable* const v = environment_.store().find(element.substr(0, element.find('[')));
    return v != nullptr && v->is_array ? v : nullptr;
  }

  void assign(ig::Block& b, const Expression::Reference& to, const Value& value, std::size_t begin,
              std::size_t end) const {
    VariableStore& store = environment_.store();
    if (to.is_r) {
      if (value.is_text())
        b.report(ig::diag("SIE-0130"), columns(begin, end), std::string_view(to.name));
      else
        *store.r(to.r) = {value.number, true};
      return;
    }
    Variable* const present = store.find(to.name);
    const Variable* const model = present != nullptr ? present : array_of(to.name);
    if (const std::size_t bracket = to.name.find('['); present == nullptr && model != nullptr &&
                                                       bracket != std::string::npos && !model->sizes.empty() &&
                                                       !model->number_of(std::string_view(to.name).substr(bracket))) {
      b.report(ig::diag("SIE-0304"), columns(begin, to.end), std::string_view(to.name),
               std::string_view(model->shown_as(to.name.substr(0, bracket))));
      return;
    }
    if (model == nullptr && store.given(to.name)) {
      if (!value.is_text()) store.give_for_run(to.name, value.number);
      return;
    }
    if (model == nullptr) {
      environment_.report_name(b, ig::diag("SIE-0124"), columns(begin, end), to.name);
      return;
    }
    auto fitting = value.as(model->value.type);
    if (!fitting)
      b.report(ig::diag("SIE-0130"), columns(begin, end), std::string_view(to.name));
    else if (present != nullptr)
      present->value = std::move(*fitting);
    else if (!store.define(to.name, std::move(*fitting)))
      b.report(ig::diag("SIE-0114"), columns(begin, end), std::string_view(to.name));
  }

  static std::size_t without_address(ig::Block& b, std::string_view text, std::size_t position) {
    const std::size_t end =
        skip_while(text, position, [](char c) { return is_number_part(c) || c == ',' || c == '='; });
    if (piece(text, position, end).find_first_of("0123456789") == std::string_view::npos) {
      leave(b, IG_LEFT_TEXT, piece(text, position, end), position, end);
      return end;
    }
    return refuse(b, ig::diag("SIE-0115"), text, position, end);
  }

  std::size_t at_bracket_ = 0;
  bool is_expanded_ = false;  // the text is what DEFINE says
};

const ig::Register<SiemensWord> siemens_word_syntax;

}  // namespace
}  // namespace siemens
