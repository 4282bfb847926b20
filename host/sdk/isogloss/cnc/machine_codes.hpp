/// Codes, cycles and programs that the builder of one machine has added, as the user has declared them.
#pragma once

#include <isogloss_machine_code.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "isogloss/cnc/scan.hpp"
#include "isogloss/provenance.hpp"
#include "isogloss/sdk.hpp"

namespace ig::cnc {

inline const Diagnostics machine_code_diagnostics{
    diagnostic(IG_ERROR, "ISO-0570", "{0} is not executed, because MachineCodes refuses it: {1}",
               "The row of this code says does=\"refused\", for the reason that the message repeats.",
               "M131 (and a row M131 that refuses it)"),
    diagnostic(IG_NOTE, "ISO-0573", "the program {0} is not found and does nothing, as MachineCodes wants it",
               "The table says unknown-programs=\"nothing\". What the program would do is missing from the path.",
               "L9810 (and no such program)"),
    diagnostic(IG_ERROR, "ISO-0575",
               "the words of {0} are not passed to its program: this dialect has no arguments of codes",
               "The row says arguments=\"passed\". Only controls with macro calls like G65 pass the words of a code.",
               "M310 A5 (on a control without macros, and a row M310 that demands arguments)"),
    diagnostic(
        IG_ERROR, "ISO-0574", "the row {0} of MachineCodes acts as codes, so the call of {1} does nothing",
        "A row of a program that is called like this does nothing, calls another program, goes to a position, or "
        "is refused.",
        "M98 P9020 (and a row O9020 with does=\"codes\")"),
    diagnostic(IG_ERROR, "ISO-0600", "{0} sets {1} from {2}, for which the program writes no number: {1} is unchanged",
               "The row of this code takes a value from a word or an argument that the block does not have.",
               "M131 (and a row M131 with fields=\"Dwell.Time={P}\")"),
    diagnostic(IG_ERROR, "ISO-0601",
               "{0} has set fields in this block already: write the second one in a block of its own",
               "The fields of a block have one value each. The values of the first code stay.", "M131 P1 M131 P2"),
    diagnostic(IG_ERROR, "ISO-0603",
               "{0} does not set {1}, which another code has set in this block: write the second one in a block of its "
               "own",
               "The fields of a block have one value each. The value of the first code stays.",
               "M131 M132 (and rows of both with fields=\"Coolant.Mode=FLOOD\")"),
};

/// How the words of a G or M code that calls a program are passed to it.
enum class CodeArguments { none, passed, demanded };
inline CodeArguments arguments_of(const ig_machine_code& row) {
  const bool has_it = row.struct_size >= offsetof(ig_machine_code, arguments) + sizeof row.arguments;
  return has_it && row.does == IG_CODE_CALLS ? static_cast<CodeArguments>(std::min(row.arguments, 2u))
                                             : CodeArguments::none;
}
/// Reports a row that demands arguments where the dialect has no variables for them.
inline void report_lost_arguments(Block& b, const ig_machine_code& row, Where where) {
  if (arguments_of(row) == CodeArguments::demanded) b.report(diag("ISO-0575"), where, to_view(row.name));
}

/// A member of each syntax that reads codes: what the service isogloss.machine-code/1 says of them.
class MachineCodes {
 public:
  MachineCodes() : holds_any_(table_ && table_->find(table_->self, {nullptr, 0}) != nullptr) {}

  /// nullptr: the user has said nothing about the code.
  const ig_machine_code* find(std::string_view name) const {
    return holds_any_ ? table_->find(table_->self, to_text(name)) : nullptr;
  }
  bool holds_any() const { return holds_any_; }

  /// The row of the family that answers for a code or program without a row and without a meaning on the control.
  const ig_machine_code* family(std::string_view name) const {
    const bool is_known = holds_any_ && table_->struct_size >= offsetof(ig_machine_code_1, find_family) + sizeof(void*);
    return is_known ? table_->find_family(table_->self, to_text(name)) : nullptr;
  }
  /// A call of a program that is not found does nothing.
  bool ignores_unknown_programs() const { return table_ && table_->unknown_programs == 1; }

 private:
  Service<ig_machine_code_1> table_{"isogloss.machine-code/1", Need::optional, "The codes of the machine's builder."};
  bool holds_any_;
};

/// Calls each(name) for the names of MachineCode.Name.
template <class Each>
void for_each_recorded(std::string_view names, Each&& each) {
  while (!names.empty()) {
    const std::size_t end = std::min(names.find(", "), names.size());
    each(names.substr(0, end));
    names.remove_prefix(std::min(end + 2, names.size()));
  }
}

/// Calls each(path, value) for the fields that a row or the record of a block sets.
template <class Each>
void for_each_assignment(std::string_view fields, Each&& each) {
  while (!fields.empty()) {
    const std::size_t end = std::min(fields.find(';'), fields.size());
    const std::string_view one = fields.substr(0, end);
    const std::size_t equals = one.find('=');
    if (!trim(one).empty())
      each(trim(one.substr(0, equals)),
           equals == std::string_view::npos ? std::string_view() : trim(one.substr(equals + 1)));
    fields.remove_prefix(std::min(end + 1, fields.size()));
  }
}

/// {P} and {P:2}: a value that the program gives, and the one where it gives none.
struct GivenValue {
  std::string_view name, otherwise;
  static std::optional<GivenValue> read(std::string_view value) {
    if (!value.starts_with('{') || !value.ends_with('}')) return std::nullopt;
    value = value.substr(1, value.size() - 2);
    const std::size_t colon = std::min(value.find(':'), value.size());
    return GivenValue{trim(value.substr(0, colon)), trim(value.substr(std::min(colon + 1, value.size())))};
  }
};

/// The number behind a letter in the text of a code and its words, "M131 P5 Q3"; nothing where none stands there. The
/// last one counts.
struct NumbersOfWords {
  std::string_view text;
  std::optional<double> operator()(std::string_view name) const {
    std::optional<double> found;
    for (std::size_t i = 0; name.size() == 1 && i < text.size();) {
      if (text[i] == '(' || text[i] == '[') {  // what a comment or an expression holds is no word
        i = skip_bracketed(text, i);
        continue;
      }
      const bool is_wanted = to_upper(text[i]) == to_upper(name[0]);
      const ig::Decimal number = is_letter(text[i]) ? ig::read_decimal(text, skip_blanks(text, i + 1)) : ig::Decimal{};
      const bool is_word = number.ok && number.end > i + 1;
      if (is_word && is_wanted && i > 0) found = number.value;
      i = is_word ? number.end : i + 1;
    }
    return found;
  }
};

/// A member of the scanners that read codes: records in the block which rows of MachineCodes have answered.
class MachineCodeRecord {
 public:
  /// A row that refuses its code is reported at `where`. A code that stands again is recorded again where a second call
  /// or move of the block is to be reported, but not a third time, so the record of a long block stays short.
  /// `text` is what the program writes: the code, and the words that belong to it.
  void add(Block& b, const ig_machine_code& row, Where where, std::string_view text = {}) const {
    add(b, row, where, text, NumbersOfWords{text});
  }
  /// given(name) is the number that the program gives to a word or argument; nothing where it gives none.
  template <class Given>
  void add(Block& b, const ig_machine_code& row, Where where, std::string_view text, const Given& given) const {
    if (row.does == IG_CODE_SETS) add_fields(b, row, where, given);
    const bool has_row = row.struct_size >= offsetof(ig_machine_code, row) + sizeof row.row;
    rows_.add(b, has_row ? to_view(row.row) : to_view(row.name));
    add_words(b, row, text);
    const bool is_counted = row.does == IG_CODE_CALLS || row.does == IG_CODE_MOVES;
    if (times_recorded(b, to_view(row.name)) < (is_counted ? 2 : 1)) {
      append(b, name_, to_view(row.name));
      if (row.title.size > 0) append(b, title_, to_view(row.title));
    }
    const bool is_family = to_view(row.name).ends_with('*') && !trim(text).empty();
    if (row.does == IG_CODE_IS_REFUSED)
      b.report(diag("ISO-0570"), where, is_family ? trim(text).substr(0, most_shown) : to_view(row.name),
               to_view(row.text));
  }

 private:
  static constexpr std::size_t most_text = 1000;  // that is kept of a block
  static constexpr std::size_t most_shown = 60;   // of a code with its words

  template <class Given>
  void add_fields(Block& b, const ig_machine_code& row, Where where, const Given& given) const {
    if (times_recorded(b, to_view(row.name)) > 0) {
      b.report(diag("ISO-0601"), where, to_view(row.name));
      return;
    }
    std::string all(b.text(fields_));
    const std::string before = all;  // what other codes of this block have set
    for_each_assignment(to_view(row.fields), [&](std::string_view path, std::string_view value) {
      std::string number;
      if (const auto from = GivenValue::read(value)) {
        const std::optional<double> written = given(from->name);
        if (written) number = shortest(*written + 0.0);
        if (!written && from->otherwise.empty())
          return b.report(diag("ISO-0600"), where, to_view(row.name), path, value);
        value = written ? std::string_view(number) : from->otherwise;
      }
      bool is_set = false;
      for_each_assignment(before, [&](std::string_view other, std::string_view) { is_set = is_set || other == path; });
      if (is_set) return b.report(diag("ISO-0603"), where, to_view(row.name), path);
      all.append(all.empty() ? "" : "; ").append(path).append("=").append(value);
    });
    b.set_text(fields_, all);
  }

  static std::string shortest(double number) {
    std::array<char, 400> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number, std::chars_format::fixed).ptr;
    return {digits.data(), end};
  }

  /// A code alone says no more than the name of its row does.
  void add_words(Block& b, const ig_machine_code& row, std::string_view text) const {
    text = trim(text);
    const bool is_family = to_view(row.name).ends_with('*');
    if (text.empty() || (!is_family && text.find_first_of(" \t\n(=,") == std::string_view::npos)) return;
    std::string words;
    const std::size_t room = most_text - std::min(most_text, b.text(words_).size());
    for (const char c : text) {
      if (words.size() >= room) return;
      const bool is_space = is_blank(c) || c == '\n' || c == '\r' || c == '~';
      if (!is_space)
        words += c;
      else if (!words.ends_with(' '))
        words += ' ';
    }
    append(b, words_, words);
  }

  int times_recorded(const Block& b, std::string_view name) const {
    int times = 0;
    for_each_recorded(b.text(name_), [&](std::string_view recorded) { times += recorded == name ? 1 : 0; });
    return times;
  }

  static void append(Block& b, const TextField& field, std::string_view text) {
    std::string all(b.text(field));
    if (!all.empty()) all += ", ";
    b.set_text(field, all += text);
  }

  TextField name_{"MachineCode.Name",
                  read | write,
                  {Life::block, "", "The codes of the machine's builder that the table MachineCodes has answered."}};
  TextField title_{"MachineCode.Title", read | write, {Life::block, "", "What the builder calls them."}};
  TextField words_{"MachineCode.Words",
                   read | write,
                   {Life::block, "", "The codes and calls as the program writes them, with their arguments."}};
  TextField fields_{"MachineCode.Fields",
                    read | write,
                    {Life::block, "", "The fields that rows of MachineCodes set in this block, and their values."}};
  AnsweredRows rows_{"isogloss.machine-code/1"};
};

/// A member of the syntaxes that execute what scanners have recorded.
class RecordedMachineCodes {
 public:
  /// Calls each(row) for the rows of the block that do this, in the order of their codes. Returns whether there are
  /// any.
  template <class Each>
  bool for_each(const Block& b, ig_machine_code_kind does, Each&& each) const {
    bool any = false;
    names_ = b.text(name_);
    for_each_recorded(names_, [&](std::string_view name) {
      const ig_machine_code* const row = codes_.find(name);
      if (row == nullptr || row->does != does) return;
      each(*row);
      any = true;
    });
    return any;
  }

 private:
  MachineCodes codes_;
  TextField name_{"MachineCode.Name",
                  read | wake,
                  {Life::block, "", "The codes of the machine's builder that the table MachineCodes has answered."}};
  mutable std::string names_;  // a copy, since a text of the block lasts no longer than until the next one is set
};

/// The codes that a row stands for, one after the other.
template <class Each>
void for_each_code(const ig_machine_code& row, Each&& each) {
  std::string_view rest = to_view(row.codes);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    each(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
}

/// The number of M08, for controls whose codes have no decimals: nothing of G54.1, and of a number beyond 32 bits.
inline std::optional<std::uint32_t> whole_number_of_code(std::string_view code) {
  std::uint32_t number = 0;
  const char* const last = code.data() + code.size();
  const auto read = code.size() < 2 ? std::from_chars_result{last, std::errc::invalid_argument}
                                    : std::from_chars(code.data() + 1, last, number);
  return read.ec == std::errc{} && read.ptr == last ? std::optional(number) : std::nullopt;
}

/// A member of the scanners that put the codes of a row into the block.
class CodesOfMachineCodes {
 public:
  explicit CodesOfMachineCodes(const MachineCodes& machine) {
    for (std::size_t i = 0; machine.holds_any() && i < codes_.size(); ++i) {
      std::string_view name = codes_.path(i);
      for (const std::string_view prefix : {"Parsing.Flags.", "Parsing."})
        if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
      known_.emplace(name, codes_.id(i));
    }
  }

  /// A syntax of the chain knows the code with these digits: 8 and 08 are M08, 54.1 is G54.1.
  bool knows(char letter, std::string_view digits) const {
    while (digits.size() > 1 && digits.front() == '0' && is_digit(digits[1])) digits.remove_prefix(1);
    if (digits.ends_with('.')) digits.remove_suffix(1);
    if (digits.ends_with(".0")) digits.remove_suffix(2);
    std::string name(1, letter);
    if (skip_digits(digits, 0) < 2) name += '0';
    return known_.contains(name.append(digits));
  }

  /// Puts the codes of the row at these columns; one that no syntax of the chain knows is a leftover. Returns whether
  /// an unknown one is a G code.
  bool put(Block& b, const ig_machine_code& row, std::size_t begin, std::size_t end) const {
    bool is_unknown = false;
    for_each_code(row, [&](std::string_view code) {
      if (const auto known = known_.find(code); known != known_.end()) {
        b.set_word({known->second, column(begin), column(end), ig_value{}, 0, 0});
        return;
      }
      leave(b, IG_LEFT_UNKNOWN, code, begin, end);
      is_unknown = is_unknown || code.starts_with('G');
    });
    return is_unknown;
  }

 private:
  Fields codes_{"codes", "Parsing.Flags.* Parsing.*", write, "The codes that syntaxes of this chain know.", IG_CODE};
  std::map<std::string, ig_field, std::less<>> known_;
};

/// A member of the syntaxes that call programs by name or number: what MachineCodes does in place of a program.
class ProgramsOfBuilder {
 public:
  /// The row of this very program, which goes before the program itself.
  const ig_machine_code* row(std::string_view name) const { return machine_.find(name); }
  /// The row of a family, for a program that is not found.
  const ig_machine_code* family(std::string_view name) const { return machine_.family(name); }

  /// Executes a row in place of a call; call(program) calls another program and reports one that is not found, and
  /// given(name) is the number of an argument, if there is one.
  template <class Call>
  void execute(Block& b, const ig_machine_code& row, std::string_view name, Where where, Call&& call) const {
    execute(b, row, name, where, call, [](std::string_view) { return std::optional<double>(); });
  }
  template <class Call, class Given>
  void execute(Block& b, const ig_machine_code& row, std::string_view name, Where where, Call&& call,
               const Given& given) const {
    record_.add(b, row, where, name, given);
    if (row.does == IG_CODE_CALLS) call(to_view(row.program));
    if (row.does == IG_CODE_ACTS) b.report(diag("ISO-0574"), where, to_view(row.name), name);
  }
  /// True, and a note, where a program that is not found does nothing.
  bool ignores(Block& b, std::string_view name, Where where) const {
    if (!machine_.ignores_unknown_programs()) return false;
    b.report(diag("ISO-0573"), where, name);
    return true;
  }

 private:
  MachineCodes machine_;
  MachineCodeRecord record_;
};

}  // namespace ig::cnc
