/// What the syntaxes of the language share: the variables, the place in the program, and the known data of the machine.
#pragma once

#include <array>
#include <string>
#include <utility>

#include <isogloss/cnc/axis_names.hpp>
#include <isogloss/cnc/scan.hpp>
#include <isogloss/flow.hpp>
#include <isogloss/sdk.hpp>

#include "language/macro_table.hpp"
#include "language/system_data.hpp"
#include "language/upper.hpp"
#include "language/variable_store.hpp"

namespace siemens {

using namespace ig::cnc;

/// A block in which the name from `begin` to `end` is replaced by its DEFINE text. Columns before `begin` do not
/// change.
class ExpandedText {
 public:
  ExpandedText(std::string_view text, std::size_t begin, std::size_t end, std::string_view by)
      : begin_(begin), end_(end), macro_end_(begin + by.size()) {
    text_.append(text.substr(0, begin)).append(by).append(text.substr(end));
  }
  std::string_view text() const { return text_; }
  std::size_t macro_end() const { return macro_end_; }
  /// The position in the original text for a position in the expanded text.
  std::size_t original(std::size_t position) const {
    return position <= begin_ ? position : std::max(position, macro_end_) - macro_end_ + end_;
  }
  /// In the original text: what lies in the name's text has the columns of the name.
  ig::Where columns(std::size_t begin, std::size_t end) const {
    const std::size_t first = begin < macro_end_ ? std::min(begin, begin_) : original(begin);
    return ig::Where::columns(first, std::max(first, original(end)));
  }

 private:
  std::string text_;
  std::size_t begin_, end_, macro_end_;
};

/// Raised from the first block on that has given words another meaning than their text alone: DEFINE, or CTABDEF. Only
/// an instance that has executed this block knows which, so lines are no longer scanned ahead.
class OtherMeaning {
 public:
  explicit OtherMeaning(ig::Access access) : signal_("SiemensWords.~OtherMeaning", access, ig::Life::modal) {}
  void raise(ig::Block& b) const { b.raise(signal_); }
  bool is_raised(const ig::Block& b) const { return b.is_raised(signal_); }

 private:
  ig::Signal signal_;
};

class Environment {
 public:
  ig::Flow flow;
  SystemData system;
  AxisNames axes;  ///< the names by which this machine calls X Y Z A B C and others

  VariableStore& store() const { return const_cast<VariableStore&>(*store_.operator->()); }

  /// Reports a missing name once for the run, an array without its indices.
  void report_name(ig::Block& b, ig::DiagnosticCode diagnostic, const ig::Where& where, const std::string& name) const {
    if (!b.is_in_turn()) return;
    const std::string base = name.substr(0, name.find('['));
    if (store().is_first_report(std::string(diagnostic.code) + '\n' + base))
      b.report(diagnostic, where, std::string_view(base));
  }

  /// SIE-0308, in the called program: its call gives more values than it has parameters. Once for each calling line.
  void report_values_beyond(ig::Block& b, const ig::Where& where, std::size_t values, std::size_t parameters) const {
    const ig_frame f = flow.frame(b);
    if (f.depth > 0 && values > parameters)
      report_once(b, ig::diag("SIE-0308"), where, f.call_line, static_cast<double>(f.call_line), ig::to_view(f.program),
                  static_cast<double>(values), static_cast<double>(parameters));
  }

  /// Call it before variables are read or written in a block.
  void enter(ig::Block& b) const {
    if (!b.is_in_turn()) return;
    store().enter(flow.frame(b).id);
    for (const VariableStore::NotGivenBack& v : std::exchange(store().not_given_back, {}))
      report_not_stored(b, ig::Where::block(), v.name, v.value, v.outcome);
  }

  /// A variable has been read: tells which row of the table has given its value, where anybody asks.
  void note_row(ig::Block& b, const std::string& name) const {
    if (!rows_.is_heard() || store().find_own(name) != nullptr) return;
    const std::string* const row = store().rows.of(name);
    const std::string* const of_array = row == nullptr ? store().rows.of(name.substr(0, name.find('['))) : nullptr;
    if (row != nullptr || of_array != nullptr) rows_.add(b, row != nullptr ? *row : *of_array);
  }

  /// A variable has been read or written by its name in capitals, "R5" or "DEPTH[2]", where anybody asks.
  void note_read(ig::Block& b, const std::string& name, const Value& value) const {
    if (used_.is_heard())
      value.is_text() ? used_.read(b, name, value.text, scope(b, name))
                      : used_.read(b, name, value.number, scope(b, name));
  }
  void note_write(ig::Block& b, const std::string& name, const Value& value) const {
    if (used_.is_heard())
      value.is_text() ? used_.wrote(b, name, value.text, scope(b, name))
                      : used_.wrote(b, name, value.number, scope(b, name));
  }

  /// Every element of an array has got this value.
  void note_fill(ig::Block& b, const std::string& array, const Value& value) const {
    if (!used_.is_heard()) return;
    const Variable* const filled = store().find(array);
    if (filled == nullptr || filled->sizes.empty()) return note_write(b, array, value);
    for (std::size_t i = 0; i < std::min<std::size_t>(filled->size(), 10'000); ++i)
      note_write(b, array + filled->indices_of(i), value);
  }
  /// VAR parameters of the program that this block leaves: its caller's variables get their values.
  void note_given_back(ig::Block& b) const {
    if (!used_.is_heard()) return;
    for (const VariableStore::GivenBack& v : store().given_back()) {
      const std::uint64_t caller = v.is_own ? v.frame : 0;
      v.value.is_text() ? used_.wrote(b, v.name, v.value.text, caller) : used_.wrote(b, v.name, v.value.number, caller);
    }
  }
  /// A condition, as the program writes it, has been examined; or a reason in words.
  const ig::ExaminedConditions& examined() const { return examined_; }

  /// Reports why an assignment has not been executed.
  void report_not_stored(ig::Block& b, const ig::Where& where, const std::string& name, const Value& value,
                         Stored outcome) const;

  /// The text of a macro: by DEFINE in the program or, which the block then shows, of the table SiemensMacros.
  const std::string* macro(ig::Block& b, const std::string& name) const {
    if (!b.is_in_turn()) return nullptr;
    if (const std::string* const own = store().macro(name)) return own;
    const MachineMacro* const macro = macros_.find(name);
    if (macro != nullptr) record_.add(b, name, *macro);
    return macro != nullptr ? &macro->text : nullptr;
  }
  bool has_macro(const std::string& name) const {
    return store().macro(name) != nullptr || macros_.find(name) != nullptr;
  }
  bool has_macros() const { return store().has_macros() || macros_.holds_any(); }

  /// As long as it lives, the text that is read is this one, and not the program's own line.
  class Reading {
   public:
    Reading(Environment& environment, const ExpandedText& text) : environment_(environment) {
      environment_.expanded_ = &text;
    }
    ~Reading() { environment_.expanded_ = nullptr; }
    Reading(const Reading&) = delete;
    Reading& operator=(const Reading&) = delete;

   private:
    Environment& environment_;
  };
  bool is_expanded() const { return expanded_ != nullptr; }
  /// The column in the program's own line.
  std::size_t written(std::size_t at) const { return expanded_ == nullptr ? at : expanded_->original(at); }
  /// Where a diagnostic of the text that is read belongs.
  ig::Where columns(std::size_t begin, std::size_t end) const {
    return expanded_ == nullptr ? ig::Where::columns(begin, end) : expanded_->columns(begin, end);
  }
  /// Reports a diagnostic once for each place of the text, however often a loop or a subprogram comes there again.
  template <class... Args>
  void report_once(ig::Block& b, ig::DiagnosticCode diagnostic, const ig::Where& where, std::size_t column,
                   const Args&... args) const {
    if (!b.is_in_turn()) return;
    const ig_frame f = flow.frame(b);
    const ig_place here = flow.here(b);
    std::string place = std::string(diagnostic.code) + '\n';
    place += ig::to_view(f.file);
    for (const std::uint64_t n : {here.offset, std::uint64_t{here.line}, static_cast<std::uint64_t>(column)})
      place.append(1, '\n').append(std::to_string(n));
    if (store().is_first_report(place)) b.report(diagnostic, where, args...);
  }

 private:
  /// Variables that a program has defined are its own.
  std::uint64_t scope(ig::Block& b, const std::string& name) const {
    const bool is_own =
        store().find_own(name) != nullptr || store().find_own(name.substr(0, name.find('['))) != nullptr;
    return is_own ? flow.frame(b).id : 0;
  }

  ig::Service<VariableStore> store_{variable_service, ig::Need::required, "The variables."};
  ig::AnsweredRows rows_{variable_service};
  ig::UsedVariables used_;
  ig::ExaminedConditions examined_;
  Macros macros_;
  MacroRecord record_;
  const ExpandedText* expanded_ = nullptr;
};

/// The position where the statement ends: at a comment (a ; inside a string is none) or at the end of the block.
constexpr std::size_t statement_end(std::string_view text, std::size_t position) {
  bool quoted = false;
  for (; position < text.size() && text[position] != '\r' && text[position] != '\n'; ++position) {
    if (text[position] == '"') quoted = !quoted;
    if (text[position] == ';' && !quoted) break;
  }
  return position;
}
/// The same without the blanks before it.
constexpr std::size_t statement_text_end(std::string_view text, std::size_t position) {
  std::size_t end = statement_end(text, position);
  while (end > position && is_blank(text[end - 1])) --end;
  return end;
}

/// The position past the round bracket that closes the one at `position`; strings may hold brackets. The end of the
/// statement where no bracket closes it.
constexpr std::size_t skip_call(std::string_view text, std::size_t position) {
  std::size_t depth = 0;
  bool quoted = false;
  for (; position < text.size() && text[position] != '\r' && text[position] != '\n'; ++position) {
    const char c = text[position];
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == ';') return position;
    if (c == '(') ++depth;
    if (c == ')' && --depth == 0) return position + 1;
  }
  return position;
}

}  // namespace siemens
