/// Expressions of the Siemens language, read and computed in one pass over the text. Faults are reported at their
/// columns. The depth of recursion is limited by the number of brackets that are read.
#pragma once

#include <algorithm>

#include "language/siemens_environment.hpp"

namespace siemens {

using namespace ig::cnc;

class Expression {
 public:
  /// Reads `text` up to its end.
  Expression(ig::Block& b, const Environment& environment, std::string_view text, std::size_t position)
      : b_(b), environment_(environment), text_(text), at_(std::min(position, text.size())) {}

  /// The value; nothing, with a diagnostic, where the expression has none.
  std::optional<Value> value();
  std::optional<double> number();
  std::optional<bool> truth();
  /// The position where reading has stopped.
  std::size_t position() const { return at_; }

  /// R1, R[…], NAME, NAME[…], $NAME[…]: the name of a variable, with its indices computed.
  struct Reference {
    std::string name;
    std::size_t begin = 0, end = 0;
    bool is_r = false;
    std::size_t r = 0;
  };
  std::optional<Reference> reference();

 private:
  static constexpr int deepest = 40;
  static constexpr int join_priority = 9, loosest = 10;  // of operators; 1 binds first

  std::optional<Value> level(int priority);
  std::optional<Value> unary();
  std::optional<Value> operand();
  std::optional<Value> as_text();
  std::optional<Value> literal();
  std::optional<Value> of_macro(std::size_t begin, const std::string& macro);
  std::string_view take_operator(int priority);

  // ---- expression_operators.cpp

  std::optional<Value> apply(std::string_view op, const Value& l, const Value& r, std::size_t begin);

  // ---- expression_functions.cpp

  /// The value of the function whose arguments begin at the bracket at the present position.
  std::optional<Value> call(const std::string& name, std::size_t begin);

  // ---- expression_variables.cpp

  std::optional<Value> read(const Reference& r);
  /// ISVAR: whether there is a variable of that name. Nothing, with a diagnostic, for data of the machine that are not
  /// known here.
  std::optional<Value> is_variable(std::string_view called, std::size_t begin);
  /// Reads [2,C1] and adds it to `name`, each index computed and axes by their letters, and to `called` with the names
  /// that the program gives axes. False, with a diagnostic, where that is not possible.
  bool indices(std::string& name, std::string& called);

  /// In the block. What a macro's text holds has the columns of the macro's name.
  ig::Where columns(std::size_t begin, std::size_t end) const {
    return macro_name_end_ != 0 ? environment_.columns(macro_name_begin_, macro_name_end_)
                                : environment_.columns(begin, end);
  }
  char peek() const { return ig::cnc::at(text_, at_); }
  void skip_blanks() { at_ = ig::cnc::skip_blanks(text_, at_); }
  template <class... Args>
  std::nullopt_t fail(ig::DiagnosticCode diagnostic, std::size_t begin, const Args&... args) {
    if (!failed_) b_.report(diagnostic, columns(begin, std::max(at_, begin + 1)), args...);
    failed_ = true;
    return std::nullopt;
  }
  std::string_view shown(std::size_t begin) const { return ig::cnc::piece(text_, begin, std::max(at_, begin)); }

  /// A short piece of the text at `begin`, without a comment, for a diagnostic.
  std::string_view next_text(std::size_t begin) const {
    const std::string_view some = text_.substr(std::min(begin, text_.size()), 20);
    return trim(some.substr(0, some.find_first_of(";\r\n")));
  }

  ig::Block& b_;
  const Environment& environment_;
  std::string_view text_;
  std::size_t at_;
  int depth_ = 0;
  bool failed_ = false;
  std::size_t macro_name_begin_ = 0, macro_name_end_ = 0;  // not 0: in the text of a macro; they do not nest
};

}  // namespace siemens
